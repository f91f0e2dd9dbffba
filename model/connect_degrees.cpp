#include "model/connect_degrees.hpp"

#include <algorithm>

#include "model/family.hpp"
#include "model/side_geometry.hpp"

namespace bodyline::model {
namespace {

// The degree of a patch's net along a side.
int& degree_along(Connectivity& links, const PatchSide& side) {
  PatchLinks& patch = links.patches[side.patch];
  return along_v(side.side) ? patch.net_degree_v : patch.net_degree_u;
}

// The superposition is of the abscissa's degree along u and along v, or of the rows' where each has
// shape parameters of its own (docs/families.md, section 6).
void set_own_degrees(const Patch& patch, PatchLinks& link) {
  const auto basis_u = family(patch.basis, link.degree_u);
  const auto basis_v = family(patch.basis, link.degree_v);
  link.net_degree_u = std::max(link.degree_u, basis_u->abscissa_degree());
  link.net_degree_v =
      std::max(link.degree_v, find_family(patch.basis).shape_per_row ? basis_v->bezier_degree()
                                                                     : basis_v->abscissa_degree());
}

}  // namespace

void set_net_degrees(const Model& model, Connectivity& links) {
  for (std::size_t p = 0; p < model.patches.size(); ++p)
    set_own_degrees(model.patches[p], links.patches[p]);
  for (bool changed = true; changed;) {
    changed = false;
    for (const Seam& seam : model.seams) {
      int &a = degree_along(links, seam.a), &b = degree_along(links, seam.b);
      changed = changed || a != b;
      a = b = std::max(a, b);
    }
  }
}

}  // namespace bodyline::model
