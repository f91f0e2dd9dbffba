#include "model/parameters.hpp"

namespace bodyline::model {
namespace {

// Calls visit(parameter, number) for every number of a model, const or not.
template <class ModelType, class Visit>
void visit_numbers(ModelType& model, const ParameterLayout& layout, const Visit& visit) {
  for (int c = 0; c < int(model.curves.size()); ++c) {
    auto& points = model.curves[c].points;
    for (int k = 0; k < int(points.size()); ++k) {
      for (int axis = 0; axis < 3; ++axis) visit(layout.point(c, k) + axis, points[k][axis]);
    }
  }
  for (int p = 0; p < int(model.patches.size()); ++p) {
    auto& patch = model.patches[p];
    for (int k = 0; k < int(patch.shape_u.size()); ++k)
      visit(layout.shape_u(p, k), patch.shape_u[k]);
    for (int k = 0; k < int(patch.shape_v.size()); ++k)
      visit(layout.shape_v(p, k), patch.shape_v[k]);
    for (int k = 0; k < 2; ++k) {
      visit(layout.cut(p) + k, patch.cut_u[k]);
      visit(layout.cut(p) + 2 + k, patch.cut_v[k]);
    }
  }
  for (int j = 0; j < int(model.joints.size()); ++j) {
    auto& joint = model.joints[j];
    for (int side = 0; side < 2; ++side) {
      visit(layout.fullness(j, side), joint.fullness[side]);
      for (int end = 0; end < 2; ++end) visit(layout.lean(j, side, end), joint.lean[side][end]);
    }
  }
}

}  // namespace

ParameterLayout::ParameterLayout(const Model& model) {
  int next = 0;
  for (const Curve& curve : model.curves) {
    curves_.push_back(next);
    next += 3 * int(curve.points.size());
  }
  first_shape_ = next;
  for (const Patch& patch : model.patches) {
    shapes_.push_back(next);
    shape_u_counts_.push_back(int(patch.shape_u.size()));
    next += int(patch.shape_u.size() + patch.shape_v.size());
  }
  cuts_ = next;
  fullness_ = cuts_ + 4 * int(model.patches.size());
  leans_ = fullness_ + 2 * int(model.joints.size());
  size_ = leans_ + 4 * int(model.joints.size());
}

ParameterKind ParameterLayout::kind(int parameter) const {
  if (parameter < first_shape_) return ParameterKind::curve;
  if (parameter < cuts_) return ParameterKind::shape;
  if (parameter < fullness_) return ParameterKind::cut;
  return parameter < leans_ ? ParameterKind::fullness : ParameterKind::lean;
}

std::vector<std::string> parameter_names(const Model& model, const ParameterLayout& layout) {
  std::vector<std::string> names(layout.size());
  const auto index = [](int k) { return std::string("[").append(std::to_string(k)).append("]"); };
  for (int c = 0; c < int(model.curves.size()); ++c) {
    for (int k = 0; k < int(model.curves[c].points.size()); ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        names[layout.point(c, k) + axis] =
            "curve." + model.curves[c].name + index(k) + "." + "xyz"[axis];
      }
    }
  }
  const char* const cut_names[4] = {"u_lo", "u_hi", "v_lo", "v_hi"};
  for (int p = 0; p < int(model.patches.size()); ++p) {
    const Patch& patch = model.patches[p];
    for (int k = 0; k < int(patch.shape_u.size()); ++k) {
      names[layout.shape_u(p, k)] = "shape." + patch.name + ".u" + index(k);
    }
    for (int k = 0; k < int(patch.shape_v.size()); ++k) {
      names[layout.shape_v(p, k)] = "shape." + patch.name + ".v" + index(k);
    }
    for (int k = 0; k < 4; ++k) names[layout.cut(p) + k] = "cut." + patch.name + "." + cut_names[k];
  }
  for (int j = 0; j < int(model.joints.size()); ++j) {
    for (int side = 0; side < 2; ++side) {
      const std::string end_name = model.joints[j].name + (side == 0 ? ".a" : ".b");
      names[layout.fullness(j, side)] = "fullness." + end_name;
      for (int end = 0; end < 2; ++end)
        names[layout.lean(j, side, end)] = "lean." + end_name + index(end);
    }
  }
  return names;
}

Eigen::VectorXd to_parameters(const Model& model, const ParameterLayout& layout) {
  Eigen::VectorXd parameters(layout.size());
  visit_numbers(model, layout,
                [&](int parameter, double number) { parameters[parameter] = number; });
  return parameters;
}

void set_parameters(Model& model, const ParameterLayout& layout,
                    const Eigen::VectorXd& parameters) {
  visit_numbers(model, layout,
                [&](int parameter, double& number) { number = parameters[parameter]; });
}

}  // namespace bodyline::model
