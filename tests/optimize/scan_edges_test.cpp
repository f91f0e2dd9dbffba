// Where a scan ends beside the car.

#include "optimize/scan_edges.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include "optimize/folded_scan.hpp"
#include "optimize/simulate_scan.hpp"
#include "tests/optimize/car_nets.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr double spacing = 8.0;                       // of the points, mm
constexpr double edge_error = 2.0;                    // so many spacings, for the points are random
constexpr double middle_x = 750.0, middle_z = 300.0;  // of a plate, mm

/// Points of upright plates at y = `side`, where `inside` says, at the depth that it says.
template <class Inside>
model::Scan plate(const Inside& inside, double side = -800.0) {
  constexpr double length = 2.0 * middle_x, height = 2.0 * middle_z;
  std::mt19937 random(5);
  const auto uniform = [&](double most) {
    return most * double(random()) / double(std::mt19937::max());
  };
  model::Scan scan;
  for (int k = 0; k < int(length * height / (spacing * spacing)); ++k) {
    const double x = uniform(length), z = uniform(height);
    const std::optional<double> depth = inside(x, z);
    if (!depth) continue;
    scan.points.emplace_back(x, side + *depth, z);
    scan.normals.emplace_back(0.0, -1.0, 0.0);
  }
  return scan;
}

/// Distances of edges that face into a circle, from it.
struct Round {
  int count = 0;
  double farthest = 0.0;
};

Round edges_around(const std::vector<ScanEdge>& edges, double radius) {
  Round found;
  for (const ScanEdge& edge : edges) {
    const Vector3d to_middle(middle_x - edge.point.x(), 0.0, middle_z - edge.point.z());
    if (to_middle.norm() > radius + 40.0) continue;
    ++found.count;
    found.farthest = std::max(found.farthest, std::abs(to_middle.norm() - radius));
    EXPECT_GT(to_middle.normalized().dot(edge.outward), 0.6);
  }
  return found;
}

auto with_hole(double radius) {
  return [=](double x, double z) -> std::optional<double> {
    if (std::hypot(x - middle_x, z - middle_z) < radius) return std::nullopt;
    return 0.0;
  };
}

TEST(ScanEdges, LieWhereThePointsEnd) {
  constexpr double radius = 150.0;
  const Round found = edges_around(scan_edges(plate(with_hole(radius))), radius);
  EXPECT_GT(found.count, 2.0 * std::numbers::pi * radius / (2.0 * spacing));
  EXPECT_LT(found.farthest, edge_error * spacing);
}

TEST(ScanEdges, LeaveOutTheNearSideOfASlotThatIsNarrow) {
  const auto slot = [](double, double z) -> std::optional<double> {
    if (z > 200.0 && z < 260.0) return std::nullopt;
    return 0.0;
  };
  int at_slot = 0, below = 0;
  for (const ScanEdge& edge : scan_edges(plate(slot))) {
    if (edge.outward.z() > -0.7) continue;
    at_slot += edge.point.z() > 180.0;
    below += edge.point.z() < 40.0;
  }
  EXPECT_GT(at_slot, 20);  // the plate goes on below for more than a hole's width
  EXPECT_GT(below, 20);
  ScanEdgeOptions wide;
  wide.hole = 350.0;
  int still = 0;
  for (const ScanEdge& edge : scan_edges(plate(slot), wide))
    still += edge.outward.z() < -0.7 && edge.point.z() > 180.0;
  EXPECT_LT(still, at_slot / 10);
}

TEST(ScanEdges, AreNoneAtAStep) {
  const auto step = [](double, double z) -> std::optional<double> {
    return z < 250.0 ? 30.0 : 0.0;
  };
  int at_step = 0, around = 0;
  for (const ScanEdge& edge : scan_edges(plate(step))) {
    const bool near = std::abs(edge.point.z() - 250.0) < 100.0;
    const bool inner = edge.point.x() > 100.0 && edge.point.x() < 1400.0;
    (near && inner ? at_step : around) += 1;
  }
  EXPECT_EQ(at_step, 0);
  EXPECT_GT(around, 100);
}

TEST(ScanEdges, AreNoneOnASurfaceWithoutEnd) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  model::Scan ball;
  for (int k = 0; k < 20000; ++k) {
    Vector3d out(normal(random), -std::abs(normal(random)), normal(random));
    ball.normals.push_back(out.normalized());
    ball.points.push_back(500.0 * ball.normals.back());
  }
  EXPECT_TRUE(scan_edges(ball).empty());
}

TEST(ScanEdges, AreNoneWhereNormalsPointAcrossTheCarTooLittleOrInwards) {
  for (const Vector3d& normal : {Vector3d(0.9, -0.436, 0.0), Vector3d(0.0, 1.0, 0.0)}) {
    model::Scan scan = plate(with_hole(150.0));
    EXPECT_FALSE(scan_edges(scan).empty());
    for (Vector3d& own : scan.normals) own = normal;
    EXPECT_TRUE(scan_edges(scan).empty()) << normal.transpose();
  }
}

TEST(ScanEdges, AreNoneAtThePlaneOfSymmetry) {
  EXPECT_TRUE(scan_edges(plate(with_hole(150.0), -5.0)).empty());
}

TEST(ScanEdges, AreNoneAlongACreaseThatTurnsALittle) {
  const double slope = std::tan(30.0 * std::numbers::pi / 180.0);
  model::Scan scan = plate([&](double, double z) -> std::optional<double> {
    return z < middle_z ? 0.0 : slope * (z - middle_z);
  });
  for (std::size_t k = 0; k < scan.points.size(); ++k)
    if (scan.points[k].z() > middle_z) scan.normals[k] = Vector3d(0.0, -1.0, slope).normalized();
  for (const ScanEdge& edge : scan_edges(scan)) {
    const bool inner = edge.point.x() > 100.0 && edge.point.x() < 2.0 * middle_x - 100.0;
    EXPECT_FALSE(inner && std::abs(edge.point.z() - middle_z) < 100.0);
  }
}

TEST(ScanEdges, AreNoneOfVeryFewPoints) {
  for (const bool spread : {false, true}) {
    for (const int count : {0, 1, 2, 5}) {
      model::Scan scan;
      for (int k = 0; k < count; ++k) {
        scan.points.emplace_back(spread ? 10.0 * k * k : 0.0, -800.0, spread ? 10.0 * k : 0.0);
        scan.normals.emplace_back(0.0, -1.0, 0.0);
      }
      EXPECT_TRUE(scan_edges(scan).empty()) << count;
    }
  }
}

TEST(ScanEdges, AreNoneWherePointsAreTooFarApartToTell) {
  const model::Scan scan = plate(with_hole(150.0));
  model::Scan sparse;
  for (std::size_t k = 0; k < scan.points.size(); k += 16) {
    sparse.points.push_back(scan.points[k]);
    sparse.normals.push_back(scan.normals[k]);
  }
  EXPECT_TRUE(scan_edges(sparse).empty());
  ScanEdgeOptions options;
  options.widest = 1000.0;
  EXPECT_FALSE(scan_edges(sparse, options).empty());
}

TEST(ScanEdges, LeaveOutPointsWithoutAUsableNormal) {
  model::Scan scan = plate(with_hole(150.0));
  const std::size_t all = scan_edges(scan).size();
  constexpr double inf = std::numeric_limits<double>::infinity();
  const std::array<Vector3d, 4> unusable{Vector3d::Zero(), Vector3d::Constant(inf),
                                         Vector3d::Constant(inf - inf), Vector3d(0, -20, 0)};
  for (std::size_t k = 0; k < scan.normals.size(); k += 9)
    scan.normals[k] = unusable[(k / 9) % unusable.size()];
  const std::vector<ScanEdge> edges = scan_edges(scan);
  EXPECT_GT(edges.size(), all / 2);
  for (const ScanEdge& edge : edges) {
    EXPECT_TRUE(edge.point.allFinite() && edge.outward.allFinite());
    EXPECT_NEAR(edge.normal.norm(), 1.0, 1e-9);
  }
}

TEST(ScanEdges, RefuseAScanWithoutNormalsAndNumbersOfNeighboursThatMakeNoSense) {
  model::Scan scan = plate(with_hole(150.0));
  for (const int neighbours : {-1, 0, 5, 1001, std::numeric_limits<int>::max()}) {
    ScanEdgeOptions options;
    options.neighbours = neighbours;
    EXPECT_THROW(scan_edges(scan, options), std::invalid_argument) << neighbours;
  }
  scan.normals.clear();
  EXPECT_THROW(scan_edges(scan), std::invalid_argument);
}

/// The distance of the nearest point of a rim.
double off_rims(const std::vector<RimSample>& rims, const Vector3d& point) {
  double least = 1e9;
  for (const RimSample& rim : rims) least = std::min(least, (rim.position - point).norm());
  return least;
}

TEST(ScanEdges, OfAScannedBodyAreItsRims) {
  const CarNets car(model::Stage::body);
  SimulateOptions scanner;
  scanner.points = 200000;
  const model::Scan scan = folded_scan(simulate_scan(car.car, scanner), {}, scanner.points).scan;
  const std::vector<ScanEdge> edges = scan_edges(scan);
  const std::vector<RimSample> rims = samples_of_rims(car, 200);
  ASSERT_GT(edges.size(), 300U);
  std::size_t on_rims = 0;  // not all: those of transitions are no sample's
  for (const ScanEdge& edge : edges) on_rims += off_rims(rims, edge.point) < edge_error * spacing;
  EXPECT_GT(double(on_rims), 0.95 * double(edges.size()));
  for (const RimSample& rim : rims) {
    if (std::abs(rim.normal.y()) < 0.8) continue;
    double least = 1e9;
    for (const ScanEdge& edge : edges) least = std::min(least, (edge.point - rim.position).norm());
    EXPECT_LT(least, 6.0 * spacing);
  }
}

TEST(ScanEdges, HaveTheSameBitsForAnyNumberOfThreads) {
  const model::Scan scan = plate(with_hole(120.0));
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return scan_edges(scan);
  };
  const auto one = with_threads(1), five = with_threads(5);
  ASSERT_EQ(one.size(), five.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].point, five[k].point);
    EXPECT_EQ(one[k].normal, five[k].normal);
    EXPECT_EQ(one[k].outward, five[k].outward);
  }
}

TEST(ScanEdges, AreAtMostAsManyAsAskedFor) {
  ScanEdgeOptions few;
  few.most = 20;
  EXPECT_EQ(scan_edges(plate(with_hole(150.0)), few).size(), 20U);
}

}  // namespace
}  // namespace bodyline::optimize
