#include "optimize/scan_follow.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "optimize/foot_columns.hpp"

namespace bodyline::optimize {
namespace {

constexpr int chunk = 1024;  // points of one task, a multiple of the kernels' 8; the sums' order

// Between the normals of the body and of the scan, for a rim to be drawn out.
constexpr double least_rim_cosine = 0.7;

// Neighbours on one face.
struct Block {
  enum Column { position = 0, scan_normal = 3, u = 6, v = 7, width = 8 };

  int face = -1, count = 0;
  std::size_t first = 0;  // in the order of distances
  Columns columns;
};

// What is found at the points of a block and forgotten after it.
struct Scratch {
  enum Column { foot = 0, normal = 3, weight = 6, weighted_target = 12, distance = 15, width = 16 };

  Columns columns{width, chunk};
};

model::FootPointArrays foot_arrays(Block& block, Scratch& scratch) {
  model::FootPointArrays a;
  a.count = block.count;
  a.x = block.columns[Block::position];
  a.y = block.columns[Block::position + 1];
  a.z = block.columns[Block::position + 2];
  a.u = block.columns[Block::u], a.v = block.columns[Block::v];
  for (int c = 0; c < 3; ++c) {
    a.foot[c] = scratch.columns[Scratch::foot + c];
    a.normal[c] = scratch.columns[Scratch::normal + c];
  }
  return a;
}

model::PullArrays pull_arrays(Block& block, Scratch& scratch) {
  model::PullArrays a;
  a.count = block.count;
  a.u = block.columns[Block::u], a.v = block.columns[Block::v];
  for (int e = 0; e < 6; ++e) a.weight[e] = scratch.columns[Scratch::weight + e];
  for (int c = 0; c < 3; ++c) a.weighted_target[c] = scratch.columns[Scratch::weighted_target + c];
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

  tbb::enumerable_thread_specific<Scratch> scratch;

  model::PullRule rule(Block& block, const PullReach& reach) const;
  FaceMoments pull(Block& block, const double* nets, const PullReach& reach, int steps);
};

ScanFollower::ScanFollower(const model::BodyPlan& plan, model::Stage stage, const model::Scan& scan,
                           std::vector<std::array<bool, 4>> rims, model::Isa isa)
    : state_(new State{
          &plan.faces(stage), &scan, std::move(rims), &model::kernels(isa), {}, {}, {}}) {}
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
      s.blocks.push_back({f, count, first, Columns(0, 0)});
      members.push_back(of_face[f].data() + begin);
      first += std::size_t(count);
    }
  }
  s.distances.resize(first);
  tbb::parallel_for(std::size_t(0), s.blocks.size(), [&](std::size_t b) {
    Block& block = s.blocks[b];
    block.columns = Columns(Block::width, block.count);
    for (int k = 0; k < block.count; ++k) {
      const int at = members[b][k];
      block.columns.set_vector(Block::position, k, s.scan->points[at]);
      if (!s.scan->normals.empty())
        block.columns.set_vector(Block::scan_normal, k, s.scan->normals[at]);
      block.columns[Block::u][k] = matches[at].u;
      block.columns[Block::v][k] = matches[at].v;
    }
  });
}

model::PullRule ScanFollower::State::rule(Block& block, const PullReach& reach) const {
  model::PullRule rule;
  if (!scan->normals.empty())
    for (int c = 0; c < 3; ++c) rule.scan_normal[c] = block.columns[Block::scan_normal + c];
  rule.inward = (*faces)[block.face].inward;
  std::copy(rims[block.face].begin(), rims[block.face].end(), rule.rims);
  rule.normal_reach = reach.normal;
  rule.rim_reach = reach.rim;
  rule.least_rim_cosine = least_rim_cosine;
  return rule;
}

FaceMoments ScanFollower::State::pull(Block& block, const double* nets, const PullReach& reach,
                                      int steps) {
  const model::Face& face = (*faces)[block.face];
  const double* const blend = face.blend < 0 ? nullptr : nets + 3 * face.blend;
  Scratch& own = scratch.local();
  const model::FootPointArrays feet = foot_arrays(block, own);
  kernels->foot_points(face.degree_u, face.degree_v, nets + 3 * face.net, blend, steps, feet);
  const model::PullArrays pulls = pull_arrays(block, own);
  double* const found = own.columns[Scratch::distance];
  const model::PullSums sums = kernels->pulls(feet, rule(block, reach), pulls, found);
  std::copy_n(found, block.count, distances.data() + block.first);
  FaceMoments moments(face, block.face);
  if (!blend) moments.add(*kernels, face, pulls, sums);
  return moments;
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
