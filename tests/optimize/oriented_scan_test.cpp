// Scans folded to the left half, with normals that point outward.

#include <gtest/gtest.h>

#include <cmath>

#include "io/read_model.hpp"
#include "optimize/folded_scan.hpp"
#include "optimize/orient_normals.hpp"
#include "optimize/simulate_scan.hpp"

namespace bodyline::optimize {
namespace {

model::Model start_model() { return io::read_model(BODYLINE_SOURCE_DIR "/cars/template.toml"); }

SimulateOptions scanner() {
  SimulateOptions options;
  options.points = 40000;
  options.outliers = 0.1;
  return options;
}

TEST(FoldedScan, RefusesPointsThatAreNotFinite) {
  model::Scan scan;
  scan.points = {{0, 0, 0}, {0, NAN, 0}};
  EXPECT_THROW(folded_scan(scan, {}, 2), std::invalid_argument);
}

TEST(FoldedScan, TellsWhichPointsItMirrored) {
  const FoldedScan folded = folded_scan({{{1, 2, 3}, {1, -2, 3}, {1, 0, 3}}, {}}, {}, 3);
  EXPECT_EQ(folded.mirrored, (std::vector<char>{1, 0, 0}));
  for (const Eigen::Vector3d& point : folded.scan.points) EXPECT_LE(point.y(), 0.0);
}

TEST(OrientedScan, HasUnitNormalsAlsoWhereTheFileHasNone) {
  model::Scan scan = simulate_scan(start_model(), scanner());
  for (std::size_t k = 0; k < scan.normals.size(); k += 7) {
    if (k % 2 == 0)
      scan.normals[k].setZero();
    else
      scan.normals[k].setConstant(NAN);
  }
  const model::Scan oriented = oriented_scan(scan, {}, start_model(), 5000);
  for (const Eigen::Vector3d& normal : oriented.normals) EXPECT_NEAR(normal.norm(), 1.0, 1e-12);
}

TEST(OrientedScan, TurnsNormalsOutwardHoweverTheyStand) {
  SimulateOptions options = scanner();
  options.outliers = 0.0;
  options.points = 5000;
  const model::Scan outward = simulate_scan(start_model(), options);
  const auto expect_outward = [&](const model::Scan& given) {
    const model::Scan oriented = oriented_scan(given, {}, start_model(), options.points);
    std::size_t alike = 0;
    for (std::size_t k = 0; k < oriented.normals.size(); ++k)
      alike += oriented.normals[k].dot(outward.normals[k]) > 0.0;
    // Of points beside the joints, where the whole patch is turned otherwise than the body.
    EXPECT_GT(alike, 99 * oriented.normals.size() / 100);
  };
  model::Scan given = outward;
  expect_outward(given);
  for (Eigen::Vector3d& normal : given.normals) normal *= -1.0;
  expect_outward(given);
  for (std::size_t k = 0; k < given.normals.size(); k += 2) given.normals[k] *= -1.0;
  expect_outward(given);
  given.normals.clear();
  expect_outward(given);
}

}  // namespace
}  // namespace bodyline::optimize
