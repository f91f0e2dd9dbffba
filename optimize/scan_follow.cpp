#include "optimize/scan_follow.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr int chunk = 1024;  // points of one task, a multiple of the kernels' 8; the sums' order

// Neighbours on one face, coordinates side by side: x y z, normal x y z, u v; then foot and normal
// of the body.
struct Block {
  int face = -1, count = 0;
  std::size_t first = 0;  // in the order of distances
  std::vector<double> numbers;

  double* column(int k) { return numbers.data() + std::size_t(k) * padded(); }
  int padded() const { return (count + 7) / 8 * 8; }
};
enum Column {
  position = 0,
  scan_normal = 3,
  parameter = 6,
  foot = 8,
  body_normal = 11,
  columns = 14
};

Vector3d vector_at(Block& block, int column, int k) {
  return {block.column(column)[k], block.column(column + 1)[k], block.column(column + 2)[k]};
}

void set_vector(Block& block, int column, int k, const Vector3d& value) {
  for (int c = 0; c < 3; ++c) block.column(column + c)[k] = value[c];
}

model::FootPointArrays arrays(Block& block) {
  model::FootPointArrays a;
  a.count = block.count;
  a.x = block.column(position), a.y = block.column(position + 1), a.z = block.column(position + 2);
  a.u = block.column(parameter), a.v = block.column(parameter + 1);
  for (int c = 0; c < 3; ++c) {
    a.foot[c] = block.column(foot + c);
    a.normal[c] = block.column(body_normal + c);
  }
  return a;
}

}  // namespace

struct ScanFollower::State {
  const std::vector<model::Face>* faces;
  const model::Scan* scan;
  std::vector<std::array<bool, 4>> rims;
  const model::Kernels* kernels;
  std::vector<Block> blocks;
  std::vector<double> distances;

  FaceMoments pull(Block& block, const double* nets, const PullReach& reach, int steps);
};

ScanFollower::ScanFollower(const model::BodyPlan& plan, model::Stage stage, const model::Scan& scan,
                           std::vector<std::array<bool, 4>> rims, model::Isa isa)
    : state_(new State{&plan.faces(stage), &scan, std::move(rims), &model::kernels(isa), {}, {}}) {}
ScanFollower::~ScanFollower() = default;

void ScanFollower::start(const std::vector<Match>& matches) {
  State& s = *state_;
  std::vector<std::vector<int>> of_face(s.faces->size());
  for (int k = 0; k < int(matches.size()); ++k) of_face[matches[k].face].push_back(k);
  s.blocks.clear();
  std::vector<const int*> members;
  std::size_t first = 0;
  for (int f = 0; f < int(of_face.size()); ++f) {
    for (int begin = 0; begin < int(of_face[f].size()); begin += chunk) {
      const int count = std::min(chunk, int(of_face[f].size()) - begin);
      s.blocks.push_back({f, count, first, {}});
      members.push_back(of_face[f].data() + begin);
      first += std::size_t(count);
    }
  }
  s.distances.resize(first);
  tbb::parallel_for(std::size_t(0), s.blocks.size(), [&](std::size_t b) {
    Block& block = s.blocks[b];
    block.numbers.assign(std::size_t(columns) * block.padded(), 0.0);
    for (int k = 0; k < block.count; ++k) {
      const int at = members[b][k];
      set_vector(block, position, k, s.scan->points[at]);
      if (!s.scan->normals.empty()) set_vector(block, scan_normal, k, s.scan->normals[at]);
      block.column(parameter)[k] = matches[at].u;
      block.column(parameter + 1)[k] = matches[at].v;
    }
  });
}

FaceMoments ScanFollower::State::pull(Block& block, const double* nets, const PullReach& reach,
                                      int steps) {
  const model::Face& face = (*faces)[block.face];
  const double* const blend = face.blend < 0 ? nullptr : nets + 3 * face.blend;
  kernels->foot_points(face.degree_u, face.degree_v, nets + 3 * face.net, blend, steps,
                       arrays(block));
  FaceMoments sums(face, block.face);
  std::vector<model::MomentPoint> points;
  points.reserve(std::size_t(block.count));
  const double sign = face.inward ? -1.0 : 1.0;
  for (int k = 0; k < block.count; ++k) {
    Match match{block.face, block.column(parameter)[k], block.column(parameter + 1)[k],
                vector_at(block, foot, k), sign * vector_at(block, body_normal, k)};
    const Vector3d point = vector_at(block, position, k);
    match.distance = (point - match.foot).norm();
    distances[block.first + k] = match.distance;
    if (blend) continue;
    const Vector3d normal = vector_at(block, scan_normal, k);
    const MatchPull pull = robust_pull(match, point, scan->normals.empty() ? nullptr : &normal,
                                       rims[block.face], reach);
    points.push_back(moment_point(match.u, match.v, pull, sums.constant));
  }
  sums.add(*kernels, face, points);
  return sums;
}

std::vector<FaceMoments> ScanFollower::follow(const double* nets, const PullReach& reach,
                                              int steps) {
  State& s = *state_;
  std::vector<FaceMoments> parts;
  for (const Block& block : s.blocks) parts.emplace_back((*s.faces)[block.face], block.face);
  tbb::parallel_for(std::size_t(0), s.blocks.size(),
                    [&](std::size_t b) { parts[b] = s.pull(s.blocks[b], nets, reach, steps); });
  std::vector<FaceMoments> sums;
  merge_moments(parts, sums);
  return sums;
}

const std::vector<double>& ScanFollower::distances() const { return state_->distances; }

}  // namespace bodyline::optimize
