#include "explore/browse_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/build.hpp"
#include "model/net_surface.hpp"

namespace bodyline::explore {
namespace {

bool has_body(const BrowseRows& rows, int row, int variables) {
  if (rows.status[row] > std::uint8_t(VariantStatus::folded)) return false;
  return std::all_of(rows.columns.begin() + variables, rows.columns.end(),
                     [row](const auto& column) { return std::isfinite(column[row]); });
}

// Metrics of all rows, each over its range among `rows`, one row after the other.
std::vector<double> scaled_metrics(const BrowseRows& shown, const std::vector<int>& rows,
                                   int variables) {
  const std::size_t metrics = shown.columns.size() - std::size_t(variables);
  std::vector<double> scaled(rows.size() * metrics, 0.0);
  for (std::size_t m = 0; m < metrics; ++m) {
    const std::vector<double>& column = shown.columns[std::size_t(variables) + m];
    const auto smaller = [&](int a, int b) { return column[a] < column[b]; };
    const auto [least, most] = std::minmax_element(rows.begin(), rows.end(), smaller);
    const double range = column[*most] - column[*least];
    if (!(range > 0.0)) continue;
    for (std::size_t k = 0; k < rows.size(); ++k)
      scaled[k * metrics + m] = (column[rows[k]] - column[*least]) / range;
  }
  return scaled;
}

// Squared distances to the nearest row chosen so far.
class Distances {
 public:
  Distances(std::vector<double> points, std::size_t count)
      : points_(std::move(points)),
        width_(count == 0 ? 0 : points_.size() / count),
        nearest_(count, std::numeric_limits<double>::infinity()) {}

  void choose(std::size_t chosen) {
    for (std::size_t k = 0; k < nearest_.size(); ++k) {
      double sum = 0.0;
      for (std::size_t m = 0; m < width_; ++m) {
        const double step = points_[k * width_ + m] - points_[chosen * width_ + m];
        sum += step * step;
      }
      nearest_[k] = std::min(nearest_[k], sum);
    }
    nearest_[chosen] = -1.0;
  }
  std::size_t farthest() const {
    return std::size_t(std::max_element(nearest_.begin(), nearest_.end()) - nearest_.begin());
  }

 private:
  std::vector<double> points_;
  std::size_t width_;
  std::vector<double> nearest_;
};

std::vector<model::Surface> faces_of(const StoreReader& store, std::uint64_t id,
                                     const std::vector<double>& values) {
  if (!store.study().keep.nets) {
    return model::build(store.space().variant(values, "variant"), model::Stage::body,
                        model::Halves::left_and_central);
  }
  const VariantRows one = store.read(id, 1, true);
  const std::vector<double> nets(one.nets.begin(), one.nets.end());
  return model::net_surfaces(store.space().context()->plan, model::Stage::body, nets.data());
}

void append(std::vector<float>& points, const Eigen::Vector3d& point) {
  for (int k = 0; k < 3; ++k) points.push_back(float(point[k]));
}

}  // namespace

std::vector<int> spread_rows(const BrowseRows& rows, int variables, int count) {
  std::vector<int> candidates;
  for (int row = 0; row < rows.count(); ++row) {
    if (has_body(rows, row, variables)) candidates.push_back(row);
  }
  const std::size_t wanted = std::min(std::size_t(count), candidates.size());
  if (wanted == 0) return {};
  Distances distances(scaled_metrics(rows, candidates, variables), candidates.size());
  std::vector<int> chosen;
  const auto choose = [&](std::size_t candidate) {
    chosen.push_back(candidates[candidate]);
    distances.choose(candidate);
  };
  const std::size_t front = std::min(wanted, rows.pareto.size());
  for (std::size_t k = 0; k < front; ++k) {
    const int row = rows.pareto[k * rows.pareto.size() / front];
    choose(std::size_t(std::lower_bound(candidates.begin(), candidates.end(), row) -
                       candidates.begin()));
  }
  while (chosen.size() < wanted) choose(distances.farthest());
  return chosen;
}

BrowseBodies browse_bodies(const StoreReader& store, const BrowseRows& shown,
                           std::vector<int> rows) {
  std::sort(rows.begin(), rows.end());
  BrowseBodies bodies;
  bodies.rows = std::move(rows);
  std::vector<double> values(std::size_t(store.space().column_count()));
  for (const int row : bodies.rows) {
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = shown.columns[k][row];
    const std::size_t before = bodies.points_mm.size();
    for (const model::Surface& face : faces_of(store, shown.ids[row], values)) {
      for (const Eigen::Vector3d& point : face.net) append(bodies.points_mm, point);
      if (face.blend) append(bodies.points_mm, *face.blend);
    }
    bodies.points = int((bodies.points_mm.size() - before) / 3);
  }
  return bodies;
}

}  // namespace bodyline::explore
