#include "optimize/rim_samples.hpp"

#include "model/kernels.hpp"
#include "optimize/foot_columns.hpp"

namespace bodyline::optimize {

using Eigen::Vector3d;

std::vector<std::array<bool, 4>> rims_of(const model::BodyPlan& plan, model::Stage stage) {
  std::vector<std::array<bool, 4>> rims(plan.faces(stage).size(), {false, false, false, false});
  for (std::size_t p = 0; p < plan.links.patches.size(); ++p) {
    for (const model::Side side : model::all_sides) {
      rims[p][int(side)] = plan.links.patches[p].sides[int(side)].role == model::SideRole::free;
    }
  }
  return rims;
}

std::vector<Rim> rim_list(const model::BodyPlan& plan, model::Stage stage) {
  std::vector<Rim> list;
  const auto rims = rims_of(plan, stage);
  for (int f = 0; f < int(rims.size()); ++f) {
    for (const model::Side side : model::all_sides)
      if (rims[std::size_t(f)][int(side)]) list.push_back({f, side});
  }
  return list;
}

std::vector<RimSample> rim_samples(const Rim& rim, const model::Face& face, const double* net,
                                   int count) {
  // Steps away from the rim and along it give the directions; a patch is smooth on that scale.
  constexpr double step = 1e-4;
  const bool along_v = model::along_v(rim.side);
  const double end = rim.side == model::Side::u1 || rim.side == model::Side::v1 ? 1.0 : 0.0;
  const double inward = end > 0.0 ? -step : step;
  FootColumns columns(3 * count);
  for (int k = 0; k < 3 * count; ++k) {
    const int number = k / 3;
    const double t = (number + 0.5) / count + (k % 3 == 2 ? step : 0.0);
    const double across = end + (k % 3 == 1 ? inward : 0.0);
    columns.u(k) = along_v ? across : t;
    columns.v(k) = along_v ? t : across;
  }
  model::kernels(model::best_isa())
      .foot_points(face.degree_u, face.degree_v, net, nullptr, 0, columns.arrays());
  std::vector<RimSample> samples(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    RimSample& sample = samples[std::size_t(k)];
    sample.rim = rim;
    sample.t = (k + 0.5) / count;
    sample.u = columns.u(3 * k);
    sample.v = columns.v(3 * k);
    sample.position = columns.foot(3 * k);
    sample.normal = (face.inward ? -1.0 : 1.0) * columns.normal(3 * k);
    sample.outward = (sample.position - columns.foot(3 * k + 1)).normalized();
    sample.along = (columns.foot(3 * k + 2) - sample.position) / step;
  }
  return samples;
}

}  // namespace bodyline::optimize
