#pragma once

#include <array>
#include <vector>

#include "io/export_sides.hpp"
#include "io/mesh.hpp"

namespace bodyline::io {

/// Cells of a face's grid along u and along v.
using GridCounts = std::array<int, 2>;

/// Counts that one face needs by itself: from the normal part of its second derivatives, the bend
/// of its sides and the turn of its normal.
GridCounts needed_counts(const model::Surface& surface, const MeshOptions& options);

/// Raises the counts until the two faces along every shared curve agree.
void agree_counts(std::vector<GridCounts>& counts, const SideGraph& graph);

}  // namespace bodyline::io
