#include <gtest/gtest.h>

#include "model/surface.hpp"
#include "tests/kernels/faces.hpp"

namespace bodyline::test {
namespace {

// Instruction sets differ in fused operations and in the order of sums.
constexpr double relative = 1e-12;

class Agreement : public testing::TestWithParam<std::tuple<std::pair<int, int>, bool>> {
 protected:
  int degree_u = std::get<0>(GetParam()).first, degree_v = std::get<0>(GetParam()).second;
  model::FaceTables tables{degree_u, degree_v, 8, model::Range::whole, std::get<1>(GetParam())};
  const model::Kernels& baseline = model::kernels(model::Isa::baseline);

  double largest(const std::vector<double>& x) {
    double most = 0.0;
    for (const double value : x) most = std::max(most, std::abs(value));
    return most;
  }
};

TEST_P(Agreement, OfInstructionSets) {
  for (const bool folded : {false, true}) {
    const Face face = wavy_face(tables, 11, folded ? 1.0 : 0.0);
    for (const Energy energy : {Energy::area, Energy::bending, Energy::variation, Energy::fold}) {
      const auto expected = energy_pullback(baseline, face, energy);
      const double scale = largest(expected.second);
      for (const model::Isa isa : available_sets()) {
        const auto got = energy_pullback(model::kernels(isa), face, energy);
        EXPECT_NEAR(got.first, expected.first, relative * std::abs(expected.first))
            << isa_text(isa);
        for (std::size_t k = 0; k < got.second.size(); ++k) {
          EXPECT_NEAR(got.second[k], expected.second[k], relative * scale)
              << energy_name(energy) << isa_text(isa);
        }
      }
    }
  }
}

TEST_P(Agreement, OfJetsWithTheDefinitionOfTheBasis) {
  const Face face = wavy_face(tables, 12);
  const std::vector<double> expected = reference_jets(face);
  for (const model::Isa isa : available_sets()) {
    for (int order = 1; order <= 3; ++order) {
      const int entries = 3 * model::jet_index(0, order) + 3;
      std::vector<double> jets(entries * 64 + 1, -7.0);
      model::kernels(isa).jets(tables.rule(), face.net.data(), face.blend.data(), order,
                               jets.data());
      EXPECT_EQ(jets.back(), -7.0) << "written past the end";
      for (int k = 0; k < entries * 64; ++k) {
        // A derivative of order q is a difference of values times about degree^q.
        const double scale = std::pow(std::max(degree_u, degree_v), order);
        ASSERT_NEAR(jets[k], expected[k], 1e-14 * scale)
            << isa_text(isa) << " order " << order << " at " << k;
      }
    }
  }
}

TEST_P(Agreement, OfCurvatureWithItsDefinition) {
  const Face face = wavy_face(tables, 13);
  const std::vector<double> jets = reference_jets(face);
  for (const model::Isa isa : available_sets()) {
    std::vector<double> mean(64), gauss(64);
    model::kernels(isa).curvature(tables.rule(), face.net.data(), face.blend.data(), mean.data(),
                                  gauss.data());
    for (int k = 0; k < 64; ++k) {
      const auto [h, kappa] = reference_curvature(jets, 8, k / 8, k % 8);
      EXPECT_NEAR(mean[k], h, relative * (1.0 + std::abs(h)));
      EXPECT_NEAR(gauss[k], kappa, relative * (1.0 + std::abs(kappa)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Agreement,
                         testing::Combine(testing::ValuesIn(tested_degrees()), testing::Bool()));

TEST(Dispatch, RefusesWhatIsNotAvailable) {
  for (const model::Isa isa : {model::Isa::baseline, model::Isa::avx2, model::Isa::avx512}) {
    if (model::isa_available(isa)) {
      EXPECT_NO_THROW(model::kernels(isa));
    } else {
      EXPECT_THROW(model::kernels(isa), std::invalid_argument);
    }
  }
  EXPECT_TRUE(model::isa_available(model::Isa::baseline));
}

TEST(Dispatch, ObeysTheEnvironmentWhereItCan) {
  for (const model::Isa isa : available_sets()) {
    setenv("BODYLINE_ISA", isa_text(isa).c_str(), 1);
    EXPECT_EQ(model::best_isa(), isa);
  }
  setenv("BODYLINE_ISA", "nonsense", 1);
  EXPECT_EQ(model::best_isa(), available_sets().back());
  unsetenv("BODYLINE_ISA");
  EXPECT_EQ(model::best_isa(), available_sets().back());
}

}  // namespace
}  // namespace bodyline::test
