#include "model/dimension.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "model/bernstein.hpp"
#include "model/gregory_blend.hpp"
#include "model/measures_furthest.hpp"
#include "model/measures_wheelbase.hpp"
#include "model/net_surface.hpp"
#include "model/suggest.hpp"

namespace bodyline::model {
namespace {

constexpr const char* names[] = {"length",         "width",         "height", "wheelbase",
                                 "front_overhang", "rear_overhang", "rake"};

// Adds factor * (derivative of a coordinate of the face's point by its net).
void add_point_slopes(const Face& face, double u, double v, int axis, double factor,
                      DimensionValue& sum) {
  const BernsteinJet in_u = bernstein(face.degree_u, u), in_v = bernstein(face.degree_v, v);
  for (int i = 0; i <= face.degree_u; ++i) {
    for (int j = 0; j <= face.degree_v; ++j) {
      const int number = 3 * (face.net + i * (face.degree_v + 1) + j) + axis;
      sum.slopes.push_back({number, factor * in_u.d[0][i] * in_v.d[0][j]});
    }
  }
  if (face.blend >= 0) sum.slopes.push_back({3 * face.blend + axis, factor * blend_jet(u, v)[0]});
}

// Adds factor * the coordinate of the body's extreme point.
void add_extreme(const BodyPlan& plan, Stage stage, const double* nets, int axis, double sign,
                 double factor, DimensionValue& sum) {
  const Furthest point = furthest_point(net_surfaces(plan, stage, nets), axis, sign);
  sum.value += factor * point.value;
  add_point_slopes(plan.faces(stage)[point.face], point.u, point.v, axis, factor, sum);
}

// Adds factor * the centre of an arch along x.
void add_arch(const std::vector<std::vector<int>>& arch, const double* nets, double factor,
              DimensionValue& sum) {
  ArchCurves curves;
  for (const std::vector<int>& indices : arch) {
    curves.emplace_back();
    for (const int index : indices) curves.back().emplace_back(nets + 3 * index);
  }
  ArchPullback pullback;
  const std::optional<ArchCircle> circle = arch_circle(curves, &pullback);
  if (!circle) throw std::invalid_argument("a wheel arch of the body is no part of a circle");
  sum.value += factor * circle->x;
  for (std::size_t c = 0; c < arch.size(); ++c) {
    for (std::size_t k = 0; k < arch[c].size(); ++k) {
      for (int axis = 0; axis < 3; ++axis)
        sum.slopes.push_back({3 * arch[c][k] + axis, factor * pullback.of[0][c][k][axis]});
    }
  }
}

// The angle from the vertical of the chord between the middles of u = 0 and u = 1.
DimensionValue measure_rake(const Face& face, const double* nets) {
  const Surface surface = net_surface(face, nets);
  const Eigen::Vector3d chord = jet(surface, 1.0, 0.5, 0).d[0] - jet(surface, 0.0, 0.5, 0).d[0];
  constexpr double degrees = 180.0 / std::numbers::pi;
  const double dx = chord.x(), dz = chord.z(), squared = dx * dx + dz * dz;
  DimensionValue rake{degrees * std::atan2(std::abs(dx), std::abs(dz)), {}};
  const double by_x = degrees * std::copysign(std::abs(dz), dx) / squared;
  const double by_z = -degrees * std::copysign(std::abs(dx), dz) / squared;
  for (const double end : {0.0, 1.0}) {
    const double sign = end > 0.0 ? 1.0 : -1.0;
    add_point_slopes(face, end, 0.5, 0, sign * by_x, rake);
    add_point_slopes(face, end, 0.5, 2, sign * by_z, rake);
  }
  return rake;
}

// The index in all nets of each point of a curve, by a patch whose side runs along it.
std::vector<int> curve_points(const Model& model, const BodyPlan& plan, int curve) {
  std::vector<int> indices;
  for (std::size_t p = 0; p < model.patches.size() && indices.empty(); ++p) {
    const PatchStep& step = plan.patches[p];
    for (const Side side : all_sides) {
      const SideCurve& along = model.patches[p].sides[int(side)];
      if (along.curve != curve || along.mirrored || !indices.empty()) continue;
      SideWalk walk = side_walk(side, step.degree_u, step.degree_v);
      if (along.reversed) walk = reversed(walk);
      for (int k = 0; k < walk.count; ++k)
        indices.push_back(step.base_net + walk.start + k * walk.step);
    }
  }
  return indices;
}

std::vector<std::vector<int>> arch_points(const Model& model, const BodyPlan& plan,
                                          const WheelArch& arch) {
  std::vector<std::vector<int>> curves;
  for (const int curve : arch.curves) curves.push_back(curve_points(model, plan, curve));
  return curves;
}

}  // namespace

std::string dimension_name(const Model& model, const Dimension& dimension) {
  std::string name = names[int(dimension.kind)];
  if (dimension.kind == DimensionKind::rake) name += "." + model.patches[dimension.patch].name;
  return name;
}

std::vector<Dimension> dimensions_of(const Model& model) {
  std::vector<Dimension> dimensions{
      {DimensionKind::length}, {DimensionKind::width}, {DimensionKind::height}};
  if (wheelbase(model)) {
    for (const DimensionKind kind :
         {DimensionKind::wheelbase, DimensionKind::front_overhang, DimensionKind::rear_overhang})
      dimensions.push_back({kind});
  }
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    if (model.patches[p].central) dimensions.push_back({DimensionKind::rake, int(p)});
  }
  return dimensions;
}

Dimension dimension_of(const Model& model, const std::string& name) {
  std::vector<std::string> known;
  for (const Dimension& dimension : dimensions_of(model)) {
    known.push_back(dimension_name(model, dimension));
    if (known.back() == name) return dimension;
  }
  throw std::invalid_argument("the model has no dimension '" + name + "'; the nearest is '" +
                              nearest_name(name, known) + "'");
}

DimensionMeter::DimensionMeter(const Model& model, const BodyPlan& plan, Stage stage)
    : plan_(&plan),
      stage_(stage),
      arches_{arch_points(model, plan, model.front_arch),
              arch_points(model, plan, model.rear_arch)} {}

DimensionValue DimensionMeter::measure(const Dimension& dimension, const double* nets) const {
  DimensionValue sum;
  const auto extreme = [&](int axis, double sign, double factor) {
    add_extreme(*plan_, stage_, nets, axis, sign, factor, sum);
  };
  switch (dimension.kind) {
    case DimensionKind::length:
      extreme(0, 1.0, 1.0);
      extreme(0, -1.0, -1.0);
      break;
    case DimensionKind::width:
      extreme(1, -1.0, -2.0);  // the left half lies at y < 0
      break;
    case DimensionKind::height:
      extreme(2, 1.0, 1.0);
      extreme(2, -1.0, -1.0);
      break;
    case DimensionKind::wheelbase:
      add_arch(arches_[1], nets, 1.0, sum);
      add_arch(arches_[0], nets, -1.0, sum);
      break;
    case DimensionKind::front_overhang:
      add_arch(arches_[0], nets, 1.0, sum);
      extreme(0, -1.0, -1.0);
      break;
    case DimensionKind::rear_overhang:
      extreme(0, 1.0, 1.0);
      add_arch(arches_[1], nets, -1.0, sum);
      break;
    case DimensionKind::rake:
      return measure_rake(plan_->base_faces[dimension.patch], nets);
  }
  return sum;
}

}  // namespace bodyline::model
