#include "optimize/scan_moments.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace bodyline::optimize {
namespace {

constexpr int chunk = 4096;  // points whose moments are added in one go; the sums' order

struct Task {
  int face, begin, end;
};

}  // namespace

FaceMoments::FaceMoments(const model::Face& of, int index)
    : face(index),
      second(std::size_t(2 * of.degree_u + 1) * model::moment_stride(of.degree_v), 0.0),
      first(std::size_t(3) * (of.degree_u + 1) * (of.degree_v + 1), 0.0) {}

void FaceMoments::add(const model::Kernels& kernels, const model::Face& of,
                      const std::vector<model::MomentPoint>& points) {
  kernels.add_moments(of.degree_u, of.degree_v, points.data(), int(points.size()),
                      model::moment_stride(of.degree_v), second.data(), first.data());
  for (const model::MomentPoint& p : points) weight += p.weight[0] + p.weight[3] + p.weight[5];
}

void FaceMoments::add(const FaceMoments& other) {
  for (std::size_t k = 0; k < second.size(); ++k) second[k] += other.second[k];
  for (std::size_t k = 0; k < first.size(); ++k) first[k] += other.first[k];
  constant += other.constant;
  weight += other.weight;
}

model::MomentPoint moment_point(double u, double v, const MatchPull& pull, double& constant) {
  const Eigen::Matrix3d& w = pull.weight;
  const Eigen::Vector3d pulled = w * pull.target;
  constant += pull.target.dot(pulled);
  return {u,
          v,
          {w(0, 0), w(0, 1), w(0, 2), w(1, 1), w(1, 2), w(2, 2)},
          {pulled[0], pulled[1], pulled[2]}};
}

std::vector<FaceMoments> collect_moments(const std::vector<model::Face>& faces,
                                         const model::Kernels& kernels,
                                         const std::vector<Match>& matches,
                                         const std::vector<MatchPull>& pulls) {
  std::vector<std::vector<int>> of_face(faces.size());
  for (int k = 0; k < int(matches.size()); ++k) {
    if (pulls[k].weight.trace() > 0.0 && faces[matches[k].face].blend < 0)
      of_face[matches[k].face].push_back(k);
  }
  std::vector<Task> tasks;
  for (int f = 0; f < int(faces.size()); ++f) {
    for (int begin = 0; begin < int(of_face[f].size()); begin += chunk)
      tasks.push_back({f, begin, std::min(begin + chunk, int(of_face[f].size()))});
  }
  std::vector<FaceMoments> parts;
  for (const Task& task : tasks) parts.emplace_back(faces[task.face], task.face);
  tbb::parallel_for(std::size_t(0), tasks.size(), [&](std::size_t t) {
    std::vector<model::MomentPoint> points;
    points.reserve(tasks[t].end - tasks[t].begin);
    for (int k = tasks[t].begin; k < tasks[t].end; ++k) {
      const int at = of_face[tasks[t].face][k];
      points.push_back(moment_point(matches[at].u, matches[at].v, pulls[at], parts[t].constant));
    }
    parts[t].add(kernels, faces[tasks[t].face], points);
  });
  std::vector<FaceMoments> sums;
  merge_moments(parts, sums);
  return sums;
}

void merge_moments(const std::vector<FaceMoments>& other, std::vector<FaceMoments>& sums) {
  for (const FaceMoments& part : other) {
    const auto at =
        std::lower_bound(sums.begin(), sums.end(), part.face,
                         [](const FaceMoments& moments, int face) { return moments.face < face; });
    if (at != sums.end() && at->face == part.face) {
      at->add(part);
    } else {
      sums.insert(at, part);
    }
  }
}

}  // namespace bodyline::optimize
