#include "explore/ranks.hpp"

#include <cstdlib>

namespace bodyline::explore {

int launched_rank() {
  // Open MPI's mpirun; PMIx (Slurm, PRRTE, Flux); PMI (Slurm, Hydra).
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"}) {
    if (const char* const rank = std::getenv(name)) return std::atoi(rank);
  }
  return -1;
}

}  // namespace bodyline::explore
