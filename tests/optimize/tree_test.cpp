// Searches for nearest points, with and without normals.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "optimize/oriented_tree.hpp"
#include "optimize/point_tree.hpp"

namespace bodyline::optimize {
namespace {

std::vector<OrientedTree::Key> random_keys(std::size_t count) {
  std::mt19937 random(4);
  std::vector<OrientedTree::Key> keys(count);
  for (OrientedTree::Key& key : keys)
    for (double& number : key) number = double(random()) / double(std::mt19937::max());
  return keys;
}

double squared(const OrientedTree::Key& a, const OrientedTree::Key& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

TEST(OrientedTree, FindsAsManyOfTheNearestAsAsked) {
  const std::vector<OrientedTree::Key> keys = random_keys(300);
  const OrientedTree tree(keys);
  const OrientedTree::Key query{0.3, 0.4, 0.5, 0.6, 0.5, 0.4};
  std::vector<std::size_t> expected(keys.size());
  std::iota(expected.begin(), expected.end(), 0);
  std::sort(expected.begin(), expected.end(), [&](std::size_t a, std::size_t b) {
    return squared(keys[a], query) < squared(keys[b], query);
  });
  for (const std::size_t count : {1, 32, 33, 100}) {
    std::vector<std::size_t> found(count);
    ASSERT_EQ(tree.nearest(query, found), count);
    EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin()));
  }
  EXPECT_EQ(tree.nearest_one(query), expected.front());
}

TEST(OrientedTree, HasNothingNearWhatIsNotFinite) {
  const OrientedTree tree(random_keys(20));
  EXPECT_EQ(tree.nearest_one({NAN, 0, 0, 0, 0, 0}), std::nullopt);
  std::size_t found[2];
  EXPECT_EQ(tree.nearest({0, 0, 0, 0, 0, NAN}, found), 0U);
  EXPECT_EQ(OrientedTree({}).nearest_one({}), std::nullopt);
}

TEST(PointTree, FindsTheNearestAndAllWhenThereAreFewer) {
  const PointTree tree({{0, 0, 0}, {5, 0, 0}, {0, 3, 0}});
  EXPECT_EQ(tree.nearest({4, 0, 0}).index, 1);
  EXPECT_EQ(tree.nearest({4, 0, 0}).squared_distance, 1.0);
  std::vector<PointTree::Neighbour> found;
  tree.nearest({0, 2, 0}, 7, found);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].index, 2);
  EXPECT_EQ(found[1].index, 0);
  EXPECT_EQ(PointTree({}).nearest({0, 0, 0}).index, -1);
}

}  // namespace
}  // namespace bodyline::optimize
