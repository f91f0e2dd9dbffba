#include "optimize/scan_match.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimize/scan_tree.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr int chunk = 512;  // points for one task, a multiple of the kernels' 8

// Samples of all faces, to be searched.
struct FaceSamples {
  std::vector<SearchTree::Key> keys;
  std::vector<int> face;
  std::vector<std::array<double, 2>> parameters;
};

// One face tried for one point.
struct Try {
  int point, face;
  double u, v;
};

// Coordinates side by side, as the kernel takes them.
struct Columns {
  explicit Columns(int count)
      : numbers(std::size_t(11) * padded(count), 0.0), length(padded(count)) {}
  static int padded(int count) { return (count + 7) / 8 * 8; }
  double* operator[](int k) { return numbers.data() + std::size_t(k) * length; }
  std::vector<double> numbers;
  int length;
};

model::FootPointArrays arrays(Columns& columns, int count) {
  model::FootPointArrays a;
  a.count = count;
  a.x = columns[0], a.y = columns[1], a.z = columns[2];
  a.u = columns[3], a.v = columns[4];
  for (int c = 0; c < 3; ++c) a.foot[c] = columns[5 + c], a.normal[c] = columns[8 + c];
  return a;
}

}  // namespace

ScanMatcher::ScanMatcher(const model::BodyPlan& plan, model::Stage stage, const model::Scan& scan,
                         const MatchOptions& options, model::Isa isa)
    : plan_(&plan),
      stage_(stage),
      scan_(&scan),
      options_(options),
      kernels_(&model::kernels(isa)) {}

namespace {

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
    Columns columns(count);
    for (int k = 0; k < count; ++k) {
      columns[3][k] = (k / n + 0.5) / n_u;
      columns[4][k] = (k % n + 0.5) / n;
    }
    const double* const blend = face.blend < 0 ? nullptr : nets + 3 * face.blend;
    kernels.foot_points(face.degree_u, face.degree_v, net, blend, 0, arrays(columns, count));
    const double scale = with_normals ? (face.inward ? -1.0 : 1.0) * options.normal_length : 0.0;
    for (int k = 0; k < count; ++k) {
      samples.keys.push_back({columns[5][k], columns[6][k], columns[7][k], scale * columns[8][k],
                              scale * columns[9][k], scale * columns[10][k]});
      samples.face.push_back(f);
      samples.parameters.push_back({columns[3][k], columns[4][k]});
    }
  }
  return samples;
}

// The faces to try for each point, in the order of the points; `candidates` each, repeated where
// fewer are near.
std::vector<Try> choose_tries(const FaceSamples& samples, const model::Scan& scan,
                              const MatchOptions& options) {
  const SearchTree tree(samples.keys);
  const int per_point = options.candidates;
  std::vector<Try> tries(scan.points.size() * per_point);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, scan.points.size(), chunk), [&](auto range) {
    std::vector<std::size_t> index(std::min<std::size_t>(4 * per_point, samples.keys.size()));
    for (std::size_t p = range.begin(); p < range.end(); ++p) {
      const Vector3d normal = scan.normals.empty() ? Vector3d(Vector3d::Zero()) : scan.normals[p];
      const std::size_t near =
          tree.nearest(SearchTree::key(scan.points[p], normal, options.normal_length), index);
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

struct Task {
  int face, begin, end;
};

}  // namespace

std::vector<Match> ScanMatcher::match(const double* nets) const {
  const bool with_normals = !scan_->normals.empty();
  const FaceSamples samples = sample_faces(*plan_, stage_, nets, *kernels_, options_, with_normals);
  const std::vector<Try> tries = choose_tries(samples, *scan_, options_);

  // Tries by face, and tasks of neighbours of the same face.
  const std::vector<model::Face>& faces = plan_->faces(stage_);
  std::vector<std::vector<int>> of_face(faces.size());
  for (int t = 0; t < int(tries.size()); ++t) of_face[tries[t].face].push_back(t);
  std::vector<Task> tasks;
  for (int f = 0; f < int(faces.size()); ++f) {
    for (int begin = 0; begin < int(of_face[f].size()); begin += chunk)
      tasks.push_back({f, begin, std::min(begin + chunk, int(of_face[f].size()))});
  }
  std::vector<Match> results(tries.size());
  tbb::parallel_for(std::size_t(0), tasks.size(), [&](std::size_t k) {
    const auto [f, begin, end] = tasks[k];
    Columns columns(end - begin);
    for (int t = begin; t < end; ++t) {
      const Try& one = tries[of_face[f][t]];
      for (int c = 0; c < 3; ++c) columns[c][t - begin] = scan_->points[one.point][c];
      columns[3][t - begin] = one.u;
      columns[4][t - begin] = one.v;
    }
    const double* const blend = faces[f].blend < 0 ? nullptr : nets + 3 * faces[f].blend;
    kernels_->foot_points(faces[f].degree_u, faces[f].degree_v, nets + 3 * faces[f].net, blend,
                          options_.steps, arrays(columns, end - begin));
    const double sign = faces[f].inward ? -1.0 : 1.0;
    for (int t = begin; t < end; ++t) {
      const int at = t - begin;
      Match& match = results[of_face[f][t]];
      match.face = f;
      match.u = columns[3][at];
      match.v = columns[4][at];
      match.foot = {columns[5][at], columns[6][at], columns[7][at]};
      match.normal = sign * Vector3d(columns[8][at], columns[9][at], columns[10][at]);
    }
  });

  // The best of each point's tries: faces turned like the scan first, then the nearest.
  std::vector<Match> best(scan_->points.size());
  tbb::parallel_for(std::size_t(0), best.size(), [&](std::size_t p) {
    double least = std::numeric_limits<double>::infinity();
    best[p] = results[p * options_.candidates];
    for (int k = 0; k < options_.candidates; ++k) {
      const Match& one = results[p * options_.candidates + k];
      double measure = (scan_->points[p] - one.foot).norm();
      if (with_normals && one.normal.dot(scan_->normals[p]) < options_.least_cosine)
        measure += options_.normal_length;
      if (!(measure < least)) continue;
      least = measure;
      best[p] = one;
    }
    const Vector3d offset = scan_->points[p] - best[p].foot;
    const double length = offset.norm();
    best[p].distance = offset.dot(best[p].normal) < 0.0 ? -length : length;
  });
  return best;
}

}  // namespace bodyline::optimize
