#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace bodyline::explore {

using Bytes = std::vector<std::byte>;

/// What one process of a parallel run sent another.
struct RankMessage {
  int from = 0;
  Bytes bytes;
};

/// The processes of a parallel run, its ranks, and messages between them. Messages from one rank
/// to another arrive in the order in which they were sent. For the thread that made it. All
/// functions throw std::runtime_error with one sentence when another rank is lost.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;  ///< of this process, from 0
  virtual int size() const = 0;
  /// From rank 0 to all: every rank calls it, and it returns what rank 0 gave.
  virtual Bytes broadcast(Bytes bytes) = 0;
  /// Returns at once.
  virtual void send(int to, Bytes bytes) = 0;
  /// A message that has arrived, if there is one.
  virtual std::optional<RankMessage> receive() = 0;
  /// Ends the run when ranks are lost: the destructor waits for all, this does not.
  virtual void abandon() = 0;
};

/// This process's rank as its launcher (mpirun, srun) says, or -1 when none started it. Costs
/// nothing.
int launched_rank();

/// The ranks of a run that a launcher started; null without one, and in a program that is built
/// without MPI. At most once in a process.
std::unique_ptr<Ranks> launched_ranks();

}  // namespace bodyline::explore
