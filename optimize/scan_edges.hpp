#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "model/scan.hpp"

namespace bodyline::optimize {

/// A point of the line where a scan ends, such as the lip of a wheel arch or the lower edge of a
/// sill.
struct ScanEdge {
  Eigen::Vector3d point;    ///< mm
  Eigen::Vector3d normal;   ///< of the surface there, unit, outward
  Eigen::Vector3d outward;  ///< in the surface, square to the edge, away from the scan, unit
};

struct ScanEdgeOptions {
  int neighbours = 32;     ///< of a point, that tell whether it is at an edge; from 6 to 1000
  double widest = 80;      ///< farthest neighbour, mm: fewer points do not tell where they end
  double least_gap = 120;  ///< widest angle without neighbours that makes an edge, degrees
  double hole = 100;      ///< widest hole whose near edge is left out, since the far one counts, mm
  double sideways = 0.7;  ///< least -y of the normal: bumpers end in lips and openings of all kinds
  std::size_t most = 4000;  ///< edges, taken evenly in the order of the points
};

/// The edges beside the car of a folded scan (FoldedScan), mm: where its points end. Left out are
/// steps, behind which the surface goes on higher or lower; the near sides of holes and slots; and
/// the plane of symmetry. Points whose normal is not of unit length are no edge's. Runs on the
/// threads of oneTBB, with the same bits for any number of them. Throws std::invalid_argument when
/// there is not one normal a point, or too few or too many neighbours are asked for.
std::vector<ScanEdge> scan_edges(const model::Scan& folded, const ScanEdgeOptions& options = {});

}  // namespace bodyline::optimize
