#include <gtest/gtest.h>

#include "tests/kernels/faces.hpp"

namespace bodyline::test {
namespace {

constexpr double relative = 1e-10;
// A coordinate whose contributions cancel keeps the rounding error of the largest ones.
constexpr double rounding = 1e-14;

struct Case {
  int degree_u, degree_v, nodes;
  model::Range range;
  bool blend;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto& [u, v] : tested_degrees()) {
    all.push_back({u, v, 8, model::Range::whole, false});
    all.push_back({u, v, 8, model::Range::whole, true});
  }
  for (const bool blend : {false, true}) {
    all.push_back({3, 3, 8, model::Range::half_u, blend});
    all.push_back({5, 3, 8, model::Range::half_v, blend});
    all.push_back({3, 6, 16, model::Range::half_u, blend});
    all.push_back({3, 3, 16, model::Range::whole, blend});
    all.push_back({6, 6, 16, model::Range::half_v, blend});
    all.push_back({4, 2, 24, model::Range::whole, blend});
  }
  return all;
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
  const Case& c = info.param;
  constexpr const char* ranges[] = {"whole", "half_u", "half_v"};
  return "degrees_" + std::to_string(c.degree_u) + "_" + std::to_string(c.degree_v) + "_nodes_" +
         std::to_string(c.nodes) + "_" + ranges[static_cast<int>(c.range)] +
         (c.blend ? "_blend" : "");
}

class Pullback : public testing::TestWithParam<Case> {
 protected:
  const Case& c = GetParam();
  model::FaceTables tables{c.degree_u, c.degree_v, c.nodes, c.range, c.blend};

  void expect_complex_step(const Face& face, Energy energy) {
    const double value = reference_energy(face, energy);
    const std::vector<double> gradient = reference_gradient(face, energy);
    ASSERT_NE(value, 0.0);
    double largest = 0.0;
    for (const double x : gradient) largest = std::max(largest, std::abs(x));
    for (const model::Isa isa : available_sets()) {
      const auto [got_value, got] = energy_pullback(model::kernels(isa), face, energy);
      EXPECT_NEAR(got_value, value, relative * std::abs(value)) << isa_text(isa);
      ASSERT_EQ(got.size(), gradient.size());
      for (std::size_t k = 0; k < got.size(); ++k) {
        ASSERT_NE(gradient[k], 0.0);
        EXPECT_NEAR(got[k], gradient[k], relative * std::abs(gradient[k]) + rounding * largest)
            << energy_name(energy) << " " << isa_text(isa) << " coordinate " << k;
      }
    }
  }
};

TEST_P(Pullback, OfAreaIsTheComplexStep) {
  expect_complex_step(wavy_face(tables, 1), Energy::area);
}
TEST_P(Pullback, OfBendingIsTheComplexStep) {
  expect_complex_step(wavy_face(tables, 2), Energy::bending);
}
TEST_P(Pullback, OfVariationIsTheComplexStep) {
  expect_complex_step(wavy_face(tables, 3), Energy::variation);
}
TEST_P(Pullback, OfFoldIsTheComplexStep) {
  expect_complex_step(wavy_face(tables, 4, 1.0), Energy::fold);
}

TEST_P(Pullback, ReturnsTheValueOfTheValueKernel) {
  const Face face = wavy_face(tables, 5, 1.0);
  for (const model::Isa isa : available_sets()) {
    for (const Energy energy : {Energy::area, Energy::bending, Energy::variation, Energy::fold}) {
      const double value = energy_value(model::kernels(isa), face, energy);
      EXPECT_NEAR(energy_pullback(model::kernels(isa), face, energy).first, value, 1e-14 * value)
          << energy_name(energy) << " " << isa_text(isa);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Faces, Pullback, testing::ValuesIn(cases()), case_name);

TEST(PullbackSeed, ScalesWhatIsAdded) {
  const model::FaceTables tables(3, 3, 8, model::Range::whole, true);
  const Face face = wavy_face(tables, 6, 1.0);
  for (const model::Isa isa : available_sets()) {
    for (const Energy energy : {Energy::area, Energy::bending, Energy::variation, Energy::fold}) {
      const auto once = energy_pullback(model::kernels(isa), face, energy);
      const auto scaled = energy_pullback(model::kernels(isa), face, energy, -2.5);
      EXPECT_EQ(scaled.first, once.first);
      for (std::size_t k = 0; k < once.second.size(); ++k) {
        EXPECT_NEAR(scaled.second[k], -2.5 * once.second[k], relative * std::abs(once.second[k]));
      }
    }
  }
}

TEST(PullbackSeed, IsAddedToWhatIsThere) {
  const model::FaceTables tables(4, 3, 8, model::Range::whole, true);
  const Face face = wavy_face(tables, 7);
  const std::vector<double> gradient =
      energy_pullback(model::kernels(model::Isa::baseline), face, Energy::area).second;
  for (const model::Isa isa : available_sets()) {
    std::vector<double> net_bar(face.net.size(), 10.0);
    double blend_bar[3] = {10.0, 10.0, 10.0};
    model::kernels(isa).area_pullback(tables.rule(), face.net.data(), face.blend.data(), 1.0,
                                      net_bar.data(), blend_bar);
    for (std::size_t k = 0; k < net_bar.size(); ++k)
      EXPECT_NEAR(net_bar[k] - 10.0, gradient[k], 1e-13);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(blend_bar[k] - 10.0, gradient[net_bar.size() + k], 1e-13);
  }
}

}  // namespace
}  // namespace bodyline::test
