#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <numbers>

#include "strokes/boundary_loop.hpp"
#include "strokes/close_loop.hpp"
#include "strokes/find_boundary.hpp"
#include "strokes/merge_sides.hpp"
#include "strokes/order_loop.hpp"
#include "tests/strokes/stroke_samples.hpp"

namespace bodyline::strokes {
namespace {

using test::line;
using test::rectangle;

// Sums and differences of lengths up to 1000 mm.
constexpr double rounding_mm = 1e-10;

std::vector<Points> shuffled(const std::vector<Points>& loop, std::uint64_t seed) {
  model::Random random(seed);
  std::vector<Points> result = loop;
  for (std::size_t k = result.size(); k-- > 1;) std::swap(result[k], result[random.below(k + 1)]);
  for (Points& points : result)
    if (random.uniform() < 0.5) std::reverse(points.begin(), points.end());
  return result;
}

double sum_of_gaps(const std::vector<Points>& loop) {
  double sum = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
    sum += (loop[k].back() - loop[(k + 1) % loop.size()].front()).norm();
  return sum;
}

TEST(OrderLoop, FindsTheLoopWhateverOrderAndDirectionIsGiven) {
  Points corners;
  for (int k = 0; k < 7; ++k) corners.emplace_back(100 * std::cos(k), 60 * std::sin(k), 5.0 * k);
  std::vector<Points> loop;
  for (int k = 0; k < 7; ++k) loop.push_back(line(corners[k], corners[(k + 1) % 7], 4));
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto given = shuffled(loop, seed);
    EXPECT_LE(sum_of_gaps(ordered(given, order_loop(given))), rounding_mm) << seed;
  }
}

TEST(OrderLoop, FollowsTheNearestEndWhenThereAreMany) {
  std::vector<Points> loop;
  for (int k = 0; k < 14; ++k) {
    const auto at = [](int i) {
      return Eigen::Vector3d(100 * std::cos(0.45 * i), 100 * std::sin(0.45 * i), 0);
    };
    loop.push_back(line(at(k), at((k + 1) % 14), 3));
  }
  const auto given = shuffled(loop, 3);
  EXPECT_LE(sum_of_gaps(ordered(given, order_loop(given))), rounding_mm);
}

TEST(CloseLoop, CornersAreMiddlesOfTheGapsAndTheMovesFadeLinearly) {
  std::vector<Points> loop = rectangle(100, 60, 5);
  loop[0].back() += Eigen::Vector3d(0, 0, 4);
  const std::vector<Points> before = loop;
  const LoopClosure closure = close_loop(loop, 10.0);
  EXPECT_DOUBLE_EQ(closure.largest_gap, 4.0);
  EXPECT_EQ(loop[0].back(), Eigen::Vector3d(100, 0, 2));
  EXPECT_EQ(loop[1].front(), loop[0].back());
  for (std::size_t k = 0; k < 5; ++k) {
    const double t = chord_parameters(before[1])[k];
    const Eigen::Vector3d moved = before[1][k] + (1.0 - t) * Eigen::Vector3d(0, 0, 2);
    EXPECT_LE((loop[1][k] - moved).norm(), rounding_mm) << k;
  }
}

TEST(CloseLoop, OvershootingSidesAreTrimmedWhereTheyCross) {
  std::vector<Points> loop = rectangle(100, 60, 11);
  loop[0].push_back({115, 0, 0});                    // beyond the corner (100, 0)
  loop[1].insert(loop[1].begin(), {100, -12, 0.5});  // and the next side from below it
  const LoopClosure closure = close_loop(loop, 1.0);
  EXPECT_EQ(closure.crossings, 1);
  EXPECT_LE((loop[0].back() - Eigen::Vector3d(100, 0, 0)).norm(), 0.5);
  for (const Points& side : loop)
    for (const Eigen::Vector3d& p : side) EXPECT_TRUE(p.x() <= 100.5 && p.y() >= -0.5);
}

TEST(MergeSides, JoinsThePairWithTheLeastAngle) {
  // Fig. 10: five curves A to E, of which B and C run on almost straight.
  const Points corners{{0, 0, 0}, {100, 0, 0}, {110, 40, 0}, {112, 80, 0}, {0, 80, 0}};
  std::vector<Points> loop;
  for (int k = 0; k < 5; ++k) loop.push_back(line(corners[k], corners[(k + 1) % 5], 5));
  merge_sides(loop);
  ASSERT_EQ(loop.size(), 4u);
  EXPECT_EQ(loop[1].front(), corners[1]);
  EXPECT_EQ(loop[1].back(), corners[3]);
  EXPECT_EQ(loop[1].size(), 9u) << "the point shared by both is there once";
}

TEST(MergeSides, EqualAnglesGoToThePairWithTheShortest) {
  // All corners of this pentagon turn by 72 degrees; its third side is the shortest.
  std::array<Eigen::Vector2d, 5> along;
  for (int k = 0; k < 5; ++k)
    along[k] = {std::cos(k * 0.4 * std::numbers::pi), std::sin(k * 0.4 * std::numbers::pi)};
  Eigen::Matrix2d last;
  last << along[3], along[4];
  std::array<double, 5> length{60.0, 80.0, 50.0, 0.0, 0.0};
  const Eigen::Vector2d rest =
      -last.inverse() * (length[0] * along[0] + length[1] * along[1] + length[2] * along[2]);
  length[3] = rest[0], length[4] = rest[1];
  ASSERT_GT(std::min(length[3], length[4]), length[2]);
  std::vector<Points> loop;
  Eigen::Vector2d at(0, 0);
  for (int k = 0; k < 5; ++k) {
    const Eigen::Vector2d next = at + length[k] * along[k];
    loop.push_back(line({at.x(), at.y(), 0}, {next.x(), next.y(), 0}, 3));
    at = next;
  }
  const Points second = loop[1], third = loop[2];
  merge_sides(loop);
  ASSERT_EQ(loop.size(), 4u);
  EXPECT_EQ(loop[1].front(), second.front());
  EXPECT_EQ(loop[1].back(), third.back());
}

TEST(MergeSides, ThreeStayThree) {
  std::vector<Points> loop(3, line({0, 0, 0}, {1, 0, 0}, 2));
  merge_sides(loop);
  EXPECT_EQ(loop.size(), 3u);
}

std::vector<model::Stroke> named(const std::vector<Points>& all) {
  std::vector<model::Stroke> strokes;
  for (const Points& points : all)
    strokes.push_back({"s" + std::to_string(strokes.size()), points});
  return strokes;
}

TEST(FindBoundary, IsTheLoopAroundTheOtherStrokes) {
  std::vector<Points> all = rectangle(1000, 600, 12);
  for (const auto& inner : rectangle(300, 200, 7)) {  // a closed rectangle inside
    all.insert(all.begin(), inner);
    for (auto& p : all.front()) p += Eigen::Vector3d(200, 150, 30);
  }
  all.push_back(line({100, 20, 5}, {900, 580, 9}, 20));
  all[4].front() += Eigen::Vector3d(-30, 0, 6);  // the outer corners gape, the inner ones do not
  const auto found = find_boundary(all, 5.0);
  ASSERT_TRUE(found);
  std::vector<int> members = *found;
  std::sort(members.begin(), members.end());
  EXPECT_EQ(members, (std::vector<int>{4, 5, 6, 7}));
}

TEST(FindBoundary, CountsSidesThatOvershootTheirCorners) {
  std::vector<Points> all = rectangle(1000, 600, 12);
  for (Points& side : all) {
    const Eigen::Vector3d along = (side.back() - side.front()).normalized();
    side.insert(side.begin(), side.front() - 80.0 * along);
    side.push_back(side.back() + 80.0 * along);
  }
  EXPECT_TRUE(find_boundary(all, 5.0));
}

TEST(FindBoundary, OfARectangleAmongManyStrokesThatCrossAndEndOnIt) {
  std::vector<Points> all = rectangle(1000, 600, 12);
  for (int k = 1; k <= 60; ++k) {
    all.push_back(line({1000.0 * k / 61.0, 0, 0}, {1000.0 * k / 61.0, 600, 0}, 9));
    all.push_back(line({0, 600.0 * k / 61.0, 0}, {1000, 600.0 * k / 61.0, 0}, 9));
  }
  auto found = find_boundary(all, 5.0);
  ASSERT_TRUE(found);
  std::sort(found->begin(), found->end());
  EXPECT_EQ(*found, (std::vector<int>{0, 1, 2, 3}));
}

TEST(FindBoundary, NoneWhereOneSideIsMissing) {
  std::vector<Points> all = rectangle(1000, 600, 12);
  all.pop_back();
  EXPECT_FALSE(find_boundary(all, 5.0));
}

TEST(BoundaryLoop, NamedStrokesAreTakenEvenIfALargerLoopExists) {
  std::vector<model::Stroke> strokes = named(rectangle(1000, 600, 12));
  for (const Points& inner : rectangle(300, 200, 7)) strokes.push_back({"Boundary inner", inner});
  EXPECT_EQ(boundary_loop(strokes, {}, 5.0).members, (std::vector<int>{4, 5, 6, 7}));
  EXPECT_EQ(boundary_loop(strokes, {"s*"}, 5.0).members, (std::vector<int>{0, 1, 2, 3}));
}

TEST(BoundaryLoop, IsOneAndTheSameWhateverOrderAndDirectionIsGiven) {
  const std::vector<Points> loop = rectangle(1000, 600, 12);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto sides = boundary_loop(named(shuffled(loop, seed)), {}, 5.0).sides;
    Points polygon;
    for (const Points& side : sides) polygon.insert(polygon.end(), side.begin(), side.end());
    EXPECT_NEAR(vector_area(polygon).z(), 6e5, 1e-6) << seed;
  }
}

TEST(BoundaryLoop, RefusesWhatIsNoBoundary) {
  const std::vector<model::Stroke> two =
      named({line({0, 0, 0}, {9, 0, 0}, 3), line({0, 0, 0}, {0, 9, 0}, 3)});
  EXPECT_THROW(boundary_loop(two, {}, 0.1), std::invalid_argument);
  EXPECT_THROW(boundary_loop(two, {"*"}, 0.1), std::invalid_argument);
  EXPECT_THROW(boundary_loop(two, {"t*"}, 0.1), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::strokes
