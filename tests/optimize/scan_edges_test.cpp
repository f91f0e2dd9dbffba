// Where a scan ends beside the car.

#include "optimize/scan_edges.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <random>

#include "optimize/folded_scan.hpp"
#include "optimize/rim_samples.hpp"
#include "optimize/simulate_scan.hpp"
#include "tests/optimize/car_nets.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr double spacing = 8.0;  // of the points, mm
constexpr double told = 2.0;     // so many spacings an edge may be off, for the points are random

/// Points of upright plates beside the car, where `inside` says, at the depth that it says.
template <class Inside>
model::Scan plate(const Inside& inside) {
  constexpr double length = 1500.0, height = 600.0, side = -800.0;
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
    const Vector3d to_middle(750.0 - edge.point.x(), 0.0, 300.0 - edge.point.z());
    if (to_middle.norm() > radius + 40.0) continue;
    ++found.count;
    found.farthest = std::max(found.farthest, std::abs(to_middle.norm() - radius));
    EXPECT_GT(to_middle.normalized().dot(edge.outward), 0.6);
  }
  return found;
}

auto with_hole(double radius) {
  return [=](double x, double z) -> std::optional<double> {
    if (std::hypot(x - 750.0, z - 300.0) < radius) return std::nullopt;
    return 0.0;
  };
}

TEST(ScanEdges, LieWhereThePointsEnd) {
  constexpr double radius = 150.0;
  const Round found = edges_around(scan_edges(plate(with_hole(radius))), radius);
  EXPECT_GT(found.count, 2.0 * 3.14 * radius / (2.0 * spacing));
  EXPECT_LT(found.farthest, told * spacing);
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

TEST(ScanEdges, AreNoneOfVeryFewPoints) {
  for (const int count : {0, 1, 2, 5, 31}) {
    model::Scan scan;
    for (int k = 0; k < count; ++k) {
      scan.points.emplace_back(0.0, -800.0, 0.0);  // all at one place
      scan.normals.emplace_back(0.0, -1.0, 0.0);
    }
    EXPECT_TRUE(scan_edges(scan).empty()) << count;
  }
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
  std::vector<RimSample> rims;
  const auto& faces = car.context->plan.faces(car.stage);
  const auto sides = rims_of(car.context->plan, car.stage);
  for (int f = 0; f < int(sides.size()); ++f) {
    for (const model::Side side : model::all_sides) {
      if (!sides[f][int(side)]) continue;
      const auto own = rim_samples({f, side}, faces[f], car.nets() + 3 * faces[f].net, 200);
      rims.insert(rims.end(), own.begin(), own.end());
    }
  }
  ASSERT_GT(edges.size(), 300U);
  std::size_t on_rims = 0;
  for (const ScanEdge& edge : edges) on_rims += off_rims(rims, edge.point) < told * spacing;
  EXPECT_GT(double(on_rims), 0.95 * double(edges.size()));
  // Rims of transitions are no sample's.
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
