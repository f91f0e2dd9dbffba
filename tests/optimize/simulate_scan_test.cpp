#include "optimize/simulate_scan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <set>

#include "io/read_model.hpp"
#include "model/build.hpp"
#include "optimize/body_sampler.hpp"
#include "optimize/random_pose.hpp"
#include "tests/optimize/nearest_node.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;
using testing::NearestNode;

constexpr std::size_t points = 6000;

const model::Model& car() {
  static const model::Model model = io::read_model(BODYLINE_SOURCE_DIR "/cars/template.toml");
  return model;
}

const std::vector<model::Surface>& faces() {
  static const auto surfaces = model::build(car(), model::Stage::body, model::Halves::both);
  return surfaces;
}

const NearestNode& nodes() {
  static const NearestNode all(faces());
  return all;
}

SimulateOptions clean() { return {.points = points, .noise_mm = 0.0}; }

// Distances to the plane of the nearest node, in ascending order.
std::vector<double> plane_distances(const model::Scan& scan) {
  std::vector<double> distances;
  for (const Vector3d& point : scan.points) {
    const testing::Node* const node = nodes().nearest(point);
    if (node == nullptr) continue;
    distances.push_back(std::abs(node->normal.dot(point - node->point)));
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

TEST(SimulateScan, WithoutNoiseThePointsLieOnTheBody) {
  const std::vector<double> distances = plane_distances(simulate_scan(car(), clean()));
  ASSERT_EQ(distances.size(), points);  // each has a node near
  // Nodes are up to 10 mm away; a curvature of 1/500 mm then lifts a point 0.1 mm off the plane.
  EXPECT_LT(distances[points / 2], 0.02);
  EXPECT_LT(distances[points * 99 / 100], 0.5);
}

TEST(SimulateScan, NoiseHasItsStandardDeviationAlongEveryAxis) {
  const model::Scan exact = simulate_scan(car(), clean());
  SimulateOptions options = clean();
  options.noise_mm = 2.5;
  const model::Scan noisy = simulate_scan(car(), options);
  // Both draw the same numbers.
  Vector3d squares = Vector3d::Zero();
  for (std::size_t k = 0; k < points; ++k) {
    squares += (noisy.points[k] - exact.points[k]).cwiseAbs2();
  }
  const Vector3d deviations = (squares / points).cwiseSqrt();
  // The deviation of a measured standard deviation is its own over sqrt(2 n).
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(deviations[c], 2.5, 5.0 * 2.5 / std::sqrt(2.0 * points));
  }
}

TEST(SimulateScan, NormalsAreThoseOfTheBody) {
  const model::Scan scan = simulate_scan(car(), clean());
  ASSERT_EQ(scan.normals.size(), points);
  std::size_t alike = 0;
  for (std::size_t k = 0; k < points; ++k) {
    EXPECT_NEAR(scan.normals[k].norm(), 1.0, 1e-12);
    alike += scan.normals[k].dot(nodes().nearest(scan.points[k])->normal) > 0.98;
  }
  EXPECT_GT(alike, points * 98 / 100);
}

double face_area(const model::Surface& face) {
  constexpr int cells = 60;
  double area = 0.0;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const model::SurfaceJet jet = model::jet(face, (i + 0.5) / cells, (j + 0.5) / cells, 1);
      area += jet.d[1].cross(jet.d[2]).norm() / (cells * cells);
    }
  }
  return area;
}

// Every face gets its share of the points, and so does the half of every face with u < 0.5.
TEST(BodySampler, PointsAreUniformByArea) {
  constexpr int draws = 100'000;
  const BodySampler sampler(faces());
  model::Random random(4);
  std::vector<int> counts(faces().size());
  for (int k = 0; k < draws; ++k) ++counts[sampler.next(random).face];
  std::vector<double> areas;
  for (const model::Surface& face : faces()) areas.push_back(face_area(face));
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  for (std::size_t f = 0; f < areas.size(); ++f) {
    const double part = areas[f] / total;
    EXPECT_NEAR(counts[f], draws * part, 5.0 * std::sqrt(draws * part * (1 - part)) + 1.0)
        << faces()[f].name;
  }
}

// A face whose area element grows from 1 at u = 0 to 9 at u = 1.
TEST(BodySampler, PointsAreUniformByAreaWithinAFace) {
  model::Surface face;
  face.name = "wedge";
  face.degree_u = face.degree_v = 1;
  face.net = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 9, 0}};
  constexpr int draws = 50'000;
  const BodySampler sampler({face});
  model::Random random(4);
  int first_half = 0;
  for (int k = 0; k < draws; ++k) first_half += sampler.next(random).u < 0.5;
  const double part = 3.0 / 10.0;  // (1 + 5) / 2 of (1 + 9), each over half the width
  EXPECT_NEAR(first_half, draws * part, 5.0 * std::sqrt(draws * part * (1 - part)));
}

TEST(BodySampler, FacesWithoutAreaAreRefused) {
  model::Surface point;
  point.degree_u = point.degree_v = 1;
  point.net.assign(4, Vector3d::Ones());
  EXPECT_THROW(BodySampler({point}), std::invalid_argument);
}

TEST(SimulateScan, ThePoseTakesTheScanToTheModel) {
  SimulateOptions options = clean();
  options.pose = random_pose(3);
  const model::Scan posed = simulate_scan(car(), options);
  const model::Scan plain = simulate_scan(car(), clean());
  ASSERT_EQ(posed.points.size(), points);
  for (std::size_t k = 0; k < points; ++k) {
    const Vector3d back = model::to_model(options.pose, posed.points[k]);
    EXPECT_LT((back - plain.points[k]).norm(), 1e-8);  // rounding of some metres
    EXPECT_LT((options.pose.rotation * posed.normals[k] - plain.normals[k]).norm(), 1e-12);
  }
  EXPECT_GT((posed.points[0] - plain.points[0]).norm(), 100.0);
}

TEST(SimulateScan, TheSameSeedGivesTheSameBits) {
  SimulateOptions options = clean();
  options.outliers = 0.2;
  options.missing = Missing::holes;
  const model::Scan once = simulate_scan(car(), options), again = simulate_scan(car(), options);
  EXPECT_EQ(once.points, again.points);
  EXPECT_EQ(once.normals, again.normals);
  options.seed = 2;
  EXPECT_NE(once.points, simulate_scan(car(), options).points);
}

TEST(SimulateScan, OutliersAreTheirPartAndFillTheirBox) {
  const model::Scan plain = simulate_scan(car(), clean());
  SimulateOptions options = clean();
  options.outliers = 0.25;
  const model::Scan scan = simulate_scan(car(), options);
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : plain.points) box.extend(point);
  const Vector3d growth = 0.1 * box.sizes();
  const Eigen::AlignedBox3d larger(box.min() - growth, box.max() + growth);
  std::size_t moved = 0, outside = 0;
  for (std::size_t k = 0; k < points; ++k) {
    moved += scan.points[k] != plain.points[k];
    outside += !box.contains(scan.points[k]);
    EXPECT_TRUE(larger.contains(scan.points[k]));
  }
  EXPECT_EQ(moved, points / 4);
  const double part = 1.0 - std::pow(1.2, -3.0);
  EXPECT_NEAR(double(outside), part * double(moved),
              5.0 * std::sqrt(part * (1 - part) * double(moved)));
}

TEST(SimulateScan, WithTheLeftMissingNoPointHasNegativeY) {
  SimulateOptions options{.points = points, .noise_mm = 30.0, .outliers = 0.1};
  options.missing = Missing::left;
  const model::Scan scan = simulate_scan(car(), options);
  for (const Vector3d& point : scan.points) EXPECT_GE(point.y(), 0.0);
  EXPECT_EQ(scan.normals.size(), scan.points.size());
  EXPECT_NEAR(double(scan.points.size()), points / 2.0, 5.0 * std::sqrt(points / 4.0));
}

TEST(SimulateScan, HolesTakeHalfOfThePointsAndLeaveTheOthersAsTheyAre) {
  const model::Scan whole = simulate_scan(car(), clean());
  SimulateOptions options = clean();
  options.missing = Missing::holes;
  const model::Scan scan = simulate_scan(car(), options);
  EXPECT_LE(scan.points.size(), points / 2);
  EXPECT_GT(scan.points.size(), points * 2 / 5);  // the last hole is not larger than a tenth
  const auto less = [](const Vector3d& a, const Vector3d& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  const std::set<Vector3d, decltype(less)> all(whole.points.begin(), whole.points.end());
  for (const Vector3d& point : scan.points) EXPECT_TRUE(all.contains(point));
}

std::string refusal(const SimulateOptions& options) {
  try {
    simulate_scan(car(), options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SimulateScan, OptionsOutOfBoundsAreRefused) {
  using ::testing::HasSubstr;
  const double nan = std::nan("");
  for (const std::size_t count : {0UL, 99UL, 50'000'001UL}) {
    EXPECT_THAT(refusal({.points = count}), HasSubstr("not with " + std::to_string(count)));
  }
  for (const double noise : {-1.0, 1001.0, nan}) {
    EXPECT_THAT(refusal({.noise_mm = noise}), HasSubstr("noise"));
  }
  for (const double part : {-0.1, 0.95, nan}) {
    EXPECT_THAT(refusal({.outliers = part}), HasSubstr("outliers"));
  }
  model::Pose mirror, flat, far;
  mirror.rotation(0, 0) = -1.0;
  flat.scale = 0.0;
  far.translation.x() = nan;
  EXPECT_THAT(refusal({.pose = mirror}), HasSubstr("not a rotation"));
  EXPECT_THAT(refusal({.pose = flat}), HasSubstr("scale"));
  EXPECT_THAT(refusal({.pose = far}), HasSubstr("translation"));
}

TEST(RandomPose, IsARotationThatTheSeedGives) {
  std::set<double> scales;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const model::Pose pose = random_pose(seed);
    EXPECT_TRUE((pose.rotation.transpose() * pose.rotation).isIdentity(1e-14));
    EXPECT_GT(pose.rotation.determinant(), 0.0);
    EXPECT_LE(pose.translation.cwiseAbs().maxCoeff(), 5000.0);
    EXPECT_EQ(pose.rotation, random_pose(seed).rotation);
    scales.insert(pose.scale);
  }
  EXPECT_EQ(scales, (std::set<double>{1.0, 10.0, 25.4, 1000.0}));
  EXPECT_NE(random_pose(1).rotation, random_pose(2).rotation);
}

}  // namespace
}  // namespace bodyline::optimize
