#include "model/variables.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "model/family.hpp"
#include "model/side_geometry.hpp"
#include "model/suggest.hpp"
#include "model/tie_classes.hpp"

namespace bodyline::model {
namespace {

void tie_curves(const Model& model, const Connectivity& links, const ParameterLayout& layout,
                TieClasses& ties) {
  // Curve ends in one vertex are one point.
  std::vector<int> first(links.vertex_count, -1);
  for (int c = 0; c < int(model.curves.size()); ++c) {
    const int last = int(model.curves[c].points.size()) - 1;
    for (int end = 0; end < 2; ++end) {
      const int point = layout.point(c, end == 0 ? 0 : last);
      int& known = first[links.curve_vertices[c][end]];
      if (known < 0) {
        known = point;
        continue;
      }
      for (int axis = 0; axis < 3; ++axis) ties.tie(known + axis, point + axis, 1.0);
    }
  }
  // A curve across a central patch is its own mirror image.
  for (const Patch& patch : model.patches) {
    if (!patch.central) continue;
    for (Side side : {Side::u0, Side::u1}) {
      const int c = patch.sides[static_cast<int>(side)].curve;
      const int n = int(model.curves[c].points.size()) - 1;
      for (int j = 0; 2 * j <= n; ++j) {
        for (int axis = 0; axis < 3; ++axis) {
          ties.tie(layout.point(c, j) + axis, layout.point(c, n - j) + axis,
                   axis == 1 ? -1.0 : 1.0);
        }
      }
    }
  }
}

void tie_patches(const Model& model, const Connectivity& links, const ParameterLayout& layout,
                 TieClasses& ties) {
  for (int p = 0; p < int(model.patches.size()); ++p) {
    const Patch& patch = model.patches[p];
    if (patch.central) {
      ties.tie(layout.cut(p) + 2, layout.cut(p) + 3, -1.0);
      const auto basis = family(patch.basis, links.patches[p].degree_v);
      for (int k = 0; k < int(patch.shape_v.size()); ++k)
        ties.tie(layout.shape_v(p, k), layout.shape_v(p, mirrored_shape(*basis, k)), 1.0);
    }
    for (Side side : all_sides) {
      if (!side_is_cut(model, links, p, side)) ties.fix(layout.cut(p) + static_cast<int>(side));
    }
  }
  for (int s = 0; s < int(model.seams.size()); ++s) {
    const Seam& seam = model.seams[s];
    const int a = layout.cut(seam.a.patch) + (along_v(seam.a.side) ? 2 : 0);
    const int b = layout.cut(seam.b.patch) + (along_v(seam.b.side) ? 2 : 0);
    for (int end = 0; end < 2; ++end) {
      if (links.seams[s].b_reversed) {
        ties.tie(a + end, b + 1 - end, -1.0);
      } else {
        ties.tie(a + end, b + end, 1.0);
      }
    }
  }
  for (int j = 0; j < int(model.joints.size()); ++j) {
    for (int side = 0; side < 2; ++side) {
      for (int end = 0; end < 2; ++end) {
        if (!lean_allowed(model, links, j, side, end)) ties.fix(layout.lean(j, side, end));
      }
    }
  }
}

// Where a family's basis is positive and a body may have it, by shape parameter.
std::vector<ShapeRange> all_shape_ranges(const Model& model, const Connectivity& links,
                                         const ParameterLayout& layout) {
  std::vector<ShapeRange> ranges(layout.size());
  const auto range = [](const AnyBasis& basis, int k) {
    const ShapeRange positive = basis.shape_range(k % basis.shape_count()),
                     body = basis.body_range(k % basis.shape_count());
    return ShapeRange{std::max(positive.lower, body.lower), std::min(positive.upper, body.upper)};
  };
  for (int p = 0; p < int(model.patches.size()); ++p) {
    const Patch& patch = model.patches[p];
    const auto basis_u = family(patch.basis, links.patches[p].degree_u);
    const auto basis_v = family(patch.basis, links.patches[p].degree_v);
    for (int k = 0; k < int(patch.shape_u.size()); ++k)
      ranges[layout.shape_u(p, k)] = range(*basis_u, k);
    for (int k = 0; k < int(patch.shape_v.size()); ++k)
      ranges[layout.shape_v(p, k)] = range(*basis_v, k);
  }
  return ranges;
}

void set_bounds(const std::vector<ShapeRange>& shape_ranges, const ParameterLayout& layout,
                const Eigen::VectorXd& values, const VariableBounds& bounds,
                std::vector<Variable>& variables) {
  for (Variable& variable : variables) {
    const int parameter = variable.ties.front().parameter;
    const double value = values[parameter];
    switch (variable.kind) {
      case ParameterKind::curve:
        variable.lower = -std::numeric_limits<double>::infinity();
        variable.upper = std::numeric_limits<double>::infinity();
        break;
      case ParameterKind::shape:
        // The paper itself leaves the range; a value outside widens it.
        variable.lower = std::min(shape_ranges[parameter].lower, value);
        variable.upper = std::max(shape_ranges[parameter].upper, value);
        break;
      case ParameterKind::cut: {
        const bool low = (parameter - layout.cut(0)) % 2 == 0;
        variable.lower = low ? bounds.min_cut : 1.0 - bounds.max_cut;
        variable.upper = low ? bounds.max_cut : 1.0 - bounds.min_cut;
        break;
      }
      case ParameterKind::fullness:
        variable.lower = bounds.min_fullness;
        variable.upper = bounds.max_fullness;
        break;
      case ParameterKind::lean:
        variable.lower = bounds.min_lean;
        variable.upper = bounds.max_lean;
        break;
    }
  }
}

}  // namespace

VariableMap::VariableMap(const Model& model, const Connectivity& links,
                         const VariableBounds& bounds)
    : layout_(model), names_(model::parameter_names(model, layout_)), owner_(layout_.size(), -1) {
  const Eigen::VectorXd values = to_parameters(model, layout_);
  TieClasses ties(layout_.size());
  tie_curves(model, links, layout_, ties);
  tie_patches(model, links, layout_, ties);
  for (int parameter = 0; parameter < layout_.size(); ++parameter) {
    const TieClasses::Place place = ties.place(parameter);
    if (place.fixed) continue;
    if (place.root == parameter) {
      owner_[parameter] = int(variables_.size());
      Variable& variable = variables_.emplace_back();
      variable.name = names_[parameter];
      variable.kind = layout_.kind(parameter);
    } else {
      owner_[parameter] = owner_[place.root];
    }
    // The offset keeps the given numbers, to the last bit where both are equal.
    const double factor = place.factor;
    const double offset = values[parameter] == factor * values[place.root]
                              ? 0.0
                              : values[parameter] - factor * values[place.root];
    variables_[owner_[parameter]].ties.push_back({parameter, factor, offset});
  }
  set_bounds(all_shape_ranges(model, links, layout_), layout_, values, bounds, variables_);
}

std::vector<int> VariableMap::select(std::span<const std::string> patterns) const {
  std::vector<char> chosen(variables_.size(), 0);
  for (const std::string& pattern : patterns) {
    bool any = false, fixed = false;
    for (int parameter = 0; parameter < layout_.size(); ++parameter) {
      if (!name_matches(pattern, names_[parameter])) continue;
      if (owner_[parameter] < 0) {
        fixed = true;
        continue;
      }
      chosen[owner_[parameter]] = 1;
      any = true;
    }
    if (!any && fixed) {
      throw std::invalid_argument(
          "\"" + pattern +
          "\" is fixed: a cut where no joint is, a lean away from a seam, or a "
          "coordinate in the symmetry plane");
    }
    if (!any) {
      throw std::invalid_argument("no variable matches \"" + pattern +
                                  "\"; the nearest name is \"" + nearest_name(pattern, names_) +
                                  "\"");
    }
  }
  std::vector<int> selected;
  for (int k = 0; k < count(); ++k) {
    if (chosen[k]) selected.push_back(k);
  }
  return selected;
}

}  // namespace bodyline::model
