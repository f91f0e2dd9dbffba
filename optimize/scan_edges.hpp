#pragma once

#include <vector>

#include "model/scan.hpp"

namespace bodyline::optimize {

/// A point of the line where a scan ends, such as the lip of a wheel arch or the lower edge of a
/// sill.
struct ScanEdge {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;   ///< of the surface there, unit, outward
  Eigen::Vector3d outward;  ///< in the surface, square to the edge, away from the scan, unit
};

struct ScanEdgeOptions {
  int neighbours = 32;     ///< of a point, that tell whether it is at an edge
  double least_gap = 120;  ///< between them, as the point sees them, degrees
  double hole = 100;      ///< widest hole whose near edge is left out, since the far one counts, mm
  double sideways = 0.7;  ///< least y of the normal: bumpers end in lips and openings of all kinds
  std::size_t most = 4000;  ///< edges, taken evenly
};

/// The edges beside the car of a folded scan (FoldedScan) with normals: where it ends, neither at a
/// step, behind which the surface goes on higher or lower, nor at a crease between two surfaces
/// that are turned alike, nor at the plane of symmetry. Runs on the threads of oneTBB, with the
/// same bits for any number of them.
std::vector<ScanEdge> scan_edges(const model::Scan& folded, const ScanEdgeOptions& options = {});

}  // namespace bodyline::optimize
