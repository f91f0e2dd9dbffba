#include "optimize/scan_match.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimize/foot_columns.hpp"
#include "optimize/oriented_tree.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr int chunk = 512;  // points for one task, a multiple of the kernels' 8

// Samples of all faces, to be searched.
struct FaceSamples {
  std::vector<OrientedTree::Key> keys;
  std::vector<int> face;
  std::vector<std::array<double, 2>> parameters;
};

// One face tried for one point.
struct Try {
  int point, face;
  double u, v;
};

// Samples of a face along u or v, by the longest polygon of its net.
int sample_count(const model::Face& face, const double* net, bool along_u, double spacing) {
  constexpr int least = 3, most = 40;
  const int m = face.degree_u, n = face.degree_v;
  const auto point = [&](int i, int j) {
    return Eigen::Map<const Vector3d>(net + 3 * (i * (n + 1) + j));
  };
  double longest = 0.0;
  for (int row = 0; row <= (along_u ? n : m); ++row) {
    double length = 0.0;
    for (int k = 0; k < (along_u ? m : n); ++k) {
      length += along_u ? (point(k + 1, row) - point(k, row)).norm()
                        : (point(row, k + 1) - point(row, k)).norm();
    }
    longest = std::max(longest, length);
  }
  return std::clamp(int(std::ceil(longest / spacing)), least, most);
}

FaceSamples sample_faces(const model::BodyPlan& plan, model::Stage stage, const double* nets,
                         const model::Kernels& kernels, const MatchOptions& options,
                         bool with_normals) {
  FaceSamples samples;
  const std::vector<model::Face>& faces = plan.faces(stage);
  for (int f = 0; f < int(faces.size()); ++f) {
    const model::Face& face = faces[f];
    const double* const net = nets + 3 * face.net;
    const int n_u = sample_count(face, net, true, options.spacing);
    const int n = sample_count(face, net, false, options.spacing), count = n_u * n;
    FootColumns columns(count);
    for (int k = 0; k < count; ++k) {
      columns.u(k) = (k / n + 0.5) / n_u;
      columns.v(k) = (k % n + 0.5) / n;
    }
    const double* const blend = face.blend < 0 ? nullptr : nets + 3 * face.blend;
    kernels.foot_points(face.degree_u, face.degree_v, net, blend, 0, columns.arrays());
    const double sign = !with_normals ? 0.0 : face.inward ? -1.0 : 1.0;
    for (int k = 0; k < count; ++k) {
      samples.keys.push_back(
          OrientedTree::key(columns.foot(k), sign * columns.normal(k), options.normal_length));
      samples.face.push_back(f);
      samples.parameters.push_back({columns.u(k), columns.v(k)});
    }
  }
  return samples;
}

// The faces to try for each point, in the order of the points; `candidates` each, repeated where
// fewer are near.
std::vector<Try> choose_tries(const FaceSamples& samples, const model::Scan& scan,
                              const MatchOptions& options) {
  const OrientedTree tree(samples.keys);
  const int per_point = options.candidates;
  std::vector<Try> tries(scan.points.size() * per_point);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, scan.points.size(), chunk), [&](auto range) {
    std::vector<std::size_t> index(std::min<std::size_t>(4 * per_point, samples.keys.size()));
    for (std::size_t p = range.begin(); p < range.end(); ++p) {
      const Vector3d normal = scan.normals.empty() ? Vector3d(Vector3d::Zero()) : scan.normals[p];
      const std::size_t near =
          tree.nearest(OrientedTree::key(scan.points[p], normal, options.normal_length), index);
      Try* const own = tries.data() + p * per_point;
      int taken = 0;
      for (std::size_t k = 0; k < near && taken < per_point; ++k) {
        const int face = samples.face[index[k]];
        if (std::any_of(own, own + taken, [&](const Try& t) { return t.face == face; })) continue;
        own[taken++] = {int(p), face, samples.parameters[index[k]][0],
                        samples.parameters[index[k]][1]};
      }
      if (taken == 0) own[taken++] = {int(p), 0, 0.5, 0.5};  // a point that is not finite
      while (taken < per_point) own[taken] = own[0], ++taken;
    }
  });
  return tries;
}

// Tries that go through a kernel together: neighbours on one face.
struct Task {
  int face = -1;
  std::vector<int> tries;
};

std::vector<Task> tasks_of(const std::vector<Try>& tries, std::size_t face_count) {
  std::vector<std::vector<int>> of_face(face_count);
  for (int t = 0; t < int(tries.size()); ++t) of_face[tries[t].face].push_back(t);
  std::vector<Task> tasks;
  for (int f = 0; f < int(face_count); ++f) {
    for (std::size_t begin = 0; begin < of_face[f].size(); begin += chunk) {
      const auto first = of_face[f].begin() + std::ptrdiff_t(begin);
      const std::size_t count = std::min<std::size_t>(chunk, of_face[f].size() - begin);
      tasks.push_back({f, {first, first + std::ptrdiff_t(count)}});
    }
  }
  return tasks;
}

// Newton's method for the tries of a task; results are by try, without distances.
void find_feet(const Task& task, const std::vector<Try>& tries, const model::Scan& scan,
               const model::Face& face, const double* nets, const model::Kernels& kernels,
               int steps, std::vector<Match>& results) {
  const int count = int(task.tries.size());
  FootColumns columns(count);
  for (int k = 0; k < count; ++k) {
    const Try& one = tries[task.tries[k]];
    columns.set_point(k, scan.points[one.point]);
    columns.u(k) = one.u;
    columns.v(k) = one.v;
  }
  const double* const blend = face.blend < 0 ? nullptr : nets + 3 * face.blend;
  kernels.foot_points(face.degree_u, face.degree_v, nets + 3 * face.net, blend, steps,
                      columns.arrays());
  const double sign = face.inward ? -1.0 : 1.0;
  for (int k = 0; k < count; ++k) {
    Match& match = results[task.tries[k]];
    match.face = task.face;
    match.u = columns.u(k);
    match.v = columns.v(k);
    match.foot = columns.foot(k);
    match.normal = sign * columns.normal(k);
  }
}

// The best of a point's tries: faces turned like the scan first, then the nearest.
Match best_of(const Match* tries, const Vector3d& point, const Vector3d* normal,
              const MatchOptions& options) {
  Match best = tries[0];
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < options.candidates; ++k) {
    double measure = (point - tries[k].foot).norm();
    if (normal && tries[k].normal.dot(*normal) < options.least_cosine)
      measure += options.normal_length;
    if (!(measure < least)) continue;
    least = measure;
    best = tries[k];
  }
  const Vector3d offset = point - best.foot;
  const double length = offset.norm();
  best.distance = offset.dot(best.normal) < 0.0 ? -length : length;
  return best;
}

}  // namespace

ScanMatcher::ScanMatcher(const model::BodyPlan& plan, model::Stage stage, const model::Scan& scan,
                         const MatchOptions& options, model::Isa isa)
    : plan_(&plan),
      stage_(stage),
      scan_(&scan),
      options_(options),
      kernels_(&model::kernels(isa)) {}

std::vector<Match> ScanMatcher::match(const double* nets) const {
  const bool with_normals = !scan_->normals.empty();
  const std::vector<model::Face>& faces = plan_->faces(stage_);
  const FaceSamples samples = sample_faces(*plan_, stage_, nets, *kernels_, options_, with_normals);
  const std::vector<Try> tries = choose_tries(samples, *scan_, options_);
  const std::vector<Task> tasks = tasks_of(tries, faces.size());
  std::vector<Match> results(tries.size());
  tbb::parallel_for(std::size_t(0), tasks.size(), [&](std::size_t k) {
    find_feet(tasks[k], tries, *scan_, faces[tasks[k].face], nets, *kernels_, options_.steps,
              results);
  });
  std::vector<Match> best(scan_->points.size());
  tbb::parallel_for(std::size_t(0), best.size(), [&](std::size_t p) {
    best[p] = best_of(&results[p * options_.candidates], scan_->points[p],
                      with_normals ? &scan_->normals[p] : nullptr, options_);
  });
  return best;
}

}  // namespace bodyline::optimize
