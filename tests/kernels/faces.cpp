#include "tests/kernels/faces.hpp"

#include <Eigen/LU>
#include <random>

#include "model/bernstein.hpp"

namespace bodyline::test {
namespace {

Eigen::MatrixXd inverse_basis(int degree) {
  Eigen::MatrixXd basis(degree + 1, degree + 1);
  for (int k = 0; k <= degree; ++k) {
    const model::BernsteinJet b = model::bernstein(degree, double(k) / degree);
    for (int i = 0; i <= degree; ++i) basis(k, i) = b.d[0][i];
  }
  return basis.inverse();
}

}  // namespace

Face wavy_face(const model::FaceTables& tables, unsigned seed, double fold) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-0.04, 0.04);
  const int degree_u = tables.rule().degree_u, degree_v = tables.rule().degree_v;
  Face face{&tables, {}, {0.3, -0.2, 0.4}};
  for (int i = 0; i <= degree_u; ++i) {
    for (int j = 0; j <= degree_v; ++j) {
      const double u = double(i) / degree_u, v = double(j) / degree_v;
      face.net.push_back((u - 0.5) * (1.0 - 3.0 * fold * v) + 0.1 * v * v + noise(random));
      face.net.push_back(0.7 * v - 0.2 * u * v + noise(random));
      face.net.push_back(0.5 * u * u - 0.3 * v * v + 0.2 * u * v + noise(random));
    }
  }
  return face;
}

std::vector<double> interpolated_net(int degree_u, int degree_v,
                                     const std::vector<double>& values) {
  const Eigen::MatrixXd to_u = inverse_basis(degree_u), to_v = inverse_basis(degree_v);
  std::vector<double> net(values.size());
  for (int c = 0; c < 3; ++c) {
    Eigen::MatrixXd samples(degree_u + 1, degree_v + 1);
    for (int i = 0; i <= degree_u; ++i) {
      for (int j = 0; j <= degree_v; ++j) samples(i, j) = values[(i * (degree_v + 1) + j) * 3 + c];
    }
    const Eigen::MatrixXd points = to_u * samples * to_v.transpose();
    for (int i = 0; i <= degree_u; ++i) {
      for (int j = 0; j <= degree_v; ++j) net[(i * (degree_v + 1) + j) * 3 + c] = points(i, j);
    }
  }
  return net;
}

std::vector<model::Isa> available_sets() {
  std::vector<model::Isa> sets;
  for (const model::Isa isa : {model::Isa::baseline, model::Isa::avx2, model::Isa::avx512}) {
    if (model::isa_available(isa)) sets.push_back(isa);
  }
  return sets;
}

std::string isa_text(model::Isa isa) { return model::kernels(isa).name; }

double energy_value(const model::Kernels& kernels, const Face& face, Energy energy) {
  const model::FaceRule& rule = face.tables->rule();
  switch (energy) {
    case Energy::area:
      return kernels.area(rule, face.net.data(), face.blend.data());
    case Energy::bending:
      return kernels.bending(rule, face.net.data(), face.blend.data());
    case Energy::variation:
      return kernels.variation(rule, face.net.data(), face.blend.data());
    case Energy::fold:
      return kernels.fold(rule, face.net.data(), face.blend.data(), {});
  }
  return 0.0;
}

std::pair<double, std::vector<double>> energy_pullback(const model::Kernels& kernels,
                                                       const Face& face, Energy energy,
                                                       double seed) {
  const model::FaceRule& rule = face.tables->rule();
  std::vector<double> bar(face.net.size() + 3);
  double *net_bar = bar.data(), *blend_bar = bar.data() + face.net.size();
  double value = 0.0;
  if (energy == Energy::fold) {
    value = kernels.fold_pullback(rule, face.net.data(), face.blend.data(), {}, seed, net_bar,
                                  blend_bar);
  } else {
    const model::Kernels::Pullback pullback = energy == Energy::area ? kernels.area_pullback
                                              : energy == Energy::bending
                                                  ? kernels.bending_pullback
                                                  : kernels.variation_pullback;
    value = pullback(rule, face.net.data(), face.blend.data(), seed, net_bar, blend_bar);
  }
  if (rule.blend == nullptr) bar.resize(face.net.size());
  return {value, bar};
}

const std::vector<std::pair<int, int>>& tested_degrees() {
  static const std::vector<std::pair<int, int>> degrees = {
      {3, 3}, {5, 3}, {3, 5}, {6, 3}, {3, 6}, {6, 6}, {4, 3},  {3, 4},  {2, 2},   {4, 4},
      {5, 5}, {1, 2}, {2, 1}, {7, 2}, {3, 9}, {9, 9}, {11, 3}, {3, 11}, {10, 11}, {12, 12}};
  return degrees;
}

}  // namespace bodyline::test
