#include <gtest/gtest.h>

#include <cmath>

#include "check_models.hpp"
#include "model/check_findings.hpp"

/// Folded faces are found, and only they.
namespace bodyline::testing {
namespace {

constexpr double rounding_deg =
    1e-6;  // angles near 0 and 180 are as exact as the square root of rounding

// A strip whose tangents turn from +degrees to -degrees against the level.
model::Surface vault(double degrees) {
  const double slope = std::tan(degrees * 3.14159265358979323846 / 180.0);
  model::Surface surface;
  surface.degree_u = 2;
  surface.degree_v = 1;
  surface.net = {{-1, 0, 0}, {-1, 1, 0}, {0, 0, slope}, {0, 1, slope}, {1, 0, 0}, {1, 1, 0}};
  return surface;
}

TEST(CheckFold, MeasuresTheTurnOfAVault) {
  for (const double degrees : {0.0, 10.0, 45.0, 89.0}) {
    const model::FoldCheck check = model::check_fold(vault(degrees));
    EXPECT_NEAR(check.max_turn_deg, degrees, rounding_deg);
    EXPECT_FALSE(check.folded);
  }
}

TEST(CheckFold, FindsASmallFoldBetweenTheSamples) {
  // x' = -1.5 over + 12 (u - 1/2)^2 near the middle: turned back for 1/200 of the length.
  constexpr double over = 5e-5, rise = 0.1;
  model::Surface surface;
  surface.degree_u = 3;
  surface.degree_v = 1;
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1 + over, 0, rise),
                                   Eigen::Vector3d(-over, 0, -rise), Eigen::Vector3d(1, 0, 0)}) {
    surface.net.push_back(p);
    surface.net.push_back(p + Eigen::Vector3d(0, 1, 0));
  }
  EXPECT_TRUE(model::check_fold(surface, 7).folded);
}

TEST(CheckFold, PassesOverTheDegeneratePointOfATriangle) {
  model::Surface triangle;
  triangle.degree_u = triangle.degree_v = 1;
  triangle.net = {{0, 0, 0}, {1, 2, 0}, {2, 0, 0}, {1, 2, 0}};
  const model::FoldCheck check = model::check_fold(triangle);
  EXPECT_NEAR(check.max_turn_deg, 0.0, rounding_deg);
  EXPECT_FALSE(check.folded);
}

TEST(CheckFold, CallsAFaceWithoutNormalsFolded) {
  model::Surface line;
  line.degree_u = line.degree_v = 1;
  line.net = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  EXPECT_TRUE(model::check_fold(line).folded);
}

TEST(CheckFold, FindsTheFoldsOfModel1AsPrinted) {
  const model::BodyCheck check = model::check_body(load_car("model1"));
  std::vector<std::string> folded;
  for (const model::FaceCheck& face : check.faces) {
    if (face.stage == model::Stage::base && face.fold.folded) folded.push_back(face.name);
  }
  EXPECT_EQ(folded, (std::vector<std::string>{"side_window", "door_lower"}));
  // Known from samples to be at least 146 and 127 degrees; the refined worst is a little more.
  constexpr double refined_deg = 3.0;
  EXPECT_NEAR(face_of(check, "side_window", model::Stage::base).fold.max_turn_deg,
              146.0 + 0.5 * refined_deg, 0.5 * refined_deg);
  EXPECT_NEAR(face_of(check, "door_lower", model::Stage::base).fold.max_turn_deg,
              127.0 + 0.5 * refined_deg, 0.5 * refined_deg);
}

TEST(CheckFold, HasNothingToSayOfTheOtherCars) {
  for (const char* name : {"template", "model2"}) {
    for (const model::FaceCheck& face : model::check_body(load_car(name)).faces) {
      EXPECT_FALSE(face.fold.folded) << name << " " << face.name;
    }
  }
}

}  // namespace
}  // namespace bodyline::testing
