#include <algorithm>
#include <string>

#include "check_models.hpp"

namespace bodyline::testing {
namespace {

using Eigen::Vector3d;
using model::Side;

constexpr int left_patch = 4;

// What a box is made from; a plain box has no random part.
struct BoxPlan {
  std::array<int, 4>
      strip_degree{};  // of the ring's edges: front and rear alike, top and bottom alike
  int cross_degree = 2;
  double wobble = 0.0;  // mm, of every point
  std::mt19937* random = nullptr;

  double between(double low, double high) const {
    return random ? std::uniform_real_distribution<double>(low, high)(*random) : 0.5 * (low + high);
  }
  bool coin() const { return random && (*random)() % 2 == 0; }
  Vector3d moved(const Vector3d& p) const {
    return p +
           Vector3d(between(-wobble, wobble), between(-wobble, wobble), between(-wobble, wobble));
  }
};

Vector3d mirrored(const Vector3d& p) { return {p.x(), -p.y(), p.z()}; }

model::Curve line(const BoxPlan& plan, const std::string& name, int degree, const Vector3d& from,
                  const Vector3d& to) {
  model::Curve curve{name, {from}, ""};
  for (int j = 1; j < degree; ++j) {
    curve.points.push_back(plan.moved(from + (double(j) / degree) * (to - from)));
  }
  curve.points.push_back(to);
  return curve;
}

// A curve across the middle, its own mirror image.
model::Curve cross(const BoxPlan& plan, const std::string& name, const Vector3d& left) {
  model::Curve curve = line(plan, name, plan.cross_degree, left, mirrored(left));
  const int n = plan.cross_degree;
  for (int j = 0; 2 * j <= n; ++j) {
    if (2 * j == n) curve.points[j].y() = 0.0;
    curve.points[n - j] = mirrored(curve.points[j]);
  }
  return curve;
}

std::vector<double> plain_shape(int degree) {
  std::vector<double> shape;
  for (int k = 0; k < degree - 1; ++k) {
    double binomial = 1.0;
    for (int i = 0; i < std::min(k, degree - 2 - k); ++i)
      binomial *= double(degree - 1 - i) / (i + 1);
    shape.push_back(binomial);
  }
  return shape;
}

void set_shape(const BoxPlan& plan, int degree, bool symmetric, std::vector<double>& shape) {
  shape = plain_shape(degree);
  for (double& value : shape) value += plan.random ? plan.between(-0.5, 0.5) : 0.0;
  for (std::size_t k = 0; symmetric && 2 * k < shape.size(); ++k)
    shape[shape.size() - 1 - k] = shape[k];
}

std::array<double, 2> random_cut(const BoxPlan& plan) {
  return {plan.between(0.05, 0.15), 1.0 - plan.between(0.05, 0.15)};
}

model::SideCurve use(int curve, bool reversed, bool is_image = false) {
  return {curve, reversed, is_image};
}

// Curves 0 to 3 cross the middle at the ring's corners, curves 4 to 7 run from corner k to k + 1 on
// the left.
void add_curves(const BoxPlan& plan, model::Model& box) {
  constexpr double half_width = 800.0;
  const std::array<Vector3d, 4> plain{Vector3d(0, -half_width, 200), Vector3d(0, -half_width, 1200),
                                      Vector3d(2000, -half_width, 1200),
                                      Vector3d(2000, -half_width, 200)};
  std::array<Vector3d, 4> corner;
  for (int k = 0; k < 4; ++k) corner[k] = plan.moved(plain[k]);
  for (int k = 0; k < 4; ++k)
    box.curves.push_back(cross(plan, "cross_" + std::to_string(k), corner[k]));
  for (int k = 0; k < 4; ++k) {
    box.curves.push_back(line(plan, "edge_" + std::to_string(k), plan.strip_degree[k], corner[k],
                              corner[(k + 1) % 4]));
  }
}

void add_patches(const BoxPlan& plan, model::Model& box) {
  const std::array<const char*, 4> names{"front", "top", "rear", "bottom"};
  for (int k = 0; k < 4; ++k) {
    model::Patch patch;
    patch.name = names[k];
    patch.central = true;
    patch.sides = {use(k, false), use((k + 1) % 4, false), use(4 + k, false),
                   use(4 + k, false, true)};
    set_shape(plan, plan.strip_degree[k], false, patch.shape_u);
    set_shape(plan, plan.cross_degree, true, patch.shape_v);
    patch.cut_u = random_cut(plan);
    const double cut = plan.between(0.05, 0.15);
    patch.cut_v = {cut, 1.0 - cut};
    box.patches.push_back(patch);
  }
  model::Patch side;
  side.name = "side";
  side.sides = {use(4, false), use(6, true), use(7, true), use(5, false)};
  set_shape(plan, plan.strip_degree[1], false, side.shape_u);
  set_shape(plan, plan.strip_degree[0], false, side.shape_v);
  side.cut_u = random_cut(plan);
  side.cut_v = random_cut(plan);
  box.patches.push_back(side);
}

void add_joint(const BoxPlan& plan, model::Model& box, int curve, model::PatchSide a,
               model::PatchSide b) {
  if (plan.coin()) std::swap(a, b);
  model::Joint joint;
  joint.name = box.curves[curve].name;
  joint.a = a;
  joint.b = b;
  joint.fullness = {plan.between(0.8, 2.2), plan.between(0.8, 2.2)};
  box.joints.push_back(joint);
}

void add_joints(const BoxPlan& plan, model::Model& box) {
  const std::array<Side, 4> side_of_edge{Side::u0, Side::v1, Side::u1, Side::v0};
  for (int k = 0; k < 4; ++k) {
    add_joint(plan, box, k, {(k + 3) % 4, Side::u1}, {k, Side::u0});
    add_joint(plan, box, 4 + k, {k, Side::v0}, {left_patch, side_of_edge[k]});
  }
  for (int k = 0; k < 4; ++k) {
    model::Corner corner{"corner_" + std::to_string(k), {(k + 3) % 4, k, left_patch}, -1};
    if (plan.random) corner.apex = corner.patches[(*plan.random)() % 3];
    box.corners.push_back(corner);
  }
}

// Turns a curve round without moving anything.
void turn_round(model::Model& box, int curve) {
  std::reverse(box.curves[curve].points.begin(), box.curves[curve].points.end());
  for (model::Patch& patch : box.patches) {
    for (model::SideCurve& side : patch.sides) {
      if (side.curve == curve) side.reversed = !side.reversed;
    }
  }
}

model::Model make_box(const BoxPlan& plan) {
  model::Model box;
  box.name = "box";
  add_curves(plan, box);
  add_patches(plan, box);
  add_joints(plan, box);
  for (int k = 4; k < 8; ++k) {
    if (plan.coin()) turn_round(box, k);
  }
  return box;
}

}  // namespace

model::Model random_box(std::mt19937& random) {
  const auto degree = [&] { return std::uniform_int_distribution<int>(2, 5)(random); };
  BoxPlan plan;
  const int upright = degree(), lengthwise = degree();
  plan.strip_degree = {upright, lengthwise, upright, lengthwise};
  plan.cross_degree = degree();
  plan.wobble = 60.0;
  plan.random = &random;
  return make_box(plan);
}

model::Model plain_box() {
  BoxPlan plan;
  plan.strip_degree = {2, 2, 2, 2};
  return make_box(plan);
}

}  // namespace bodyline::testing
