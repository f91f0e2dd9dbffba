#include "model/silhouette.hpp"

#include "model/build.hpp"
#include "model/net_surface.hpp"
#include "model/outer_test.hpp"
#include "model/silhouette_outline.hpp"

namespace bodyline::model {
namespace {

using Eigen::Vector2d;

constexpr double on_plane = 1e-6;  // mm to the plane of symmetry that are rounding
constexpr int halvings = 12;       // of a step, to where a piece ends
constexpr double shortest = 1e-3;  // piece, mm

// Covers the triangles of a face, and their mirror images.
void cover_face(PictureMask& mask, View view, const FacingGrid& grid,
                const std::vector<Vector2d>& pictures, bool twice) {
  for (int i = 0; i < grid.cells_u; ++i) {
    for (int j = 0; j < grid.cells_v; ++j) {
      const Vector2d* const a = &pictures[i * (grid.cells_v + 1) + j];
      const Vector2d* const b = a + grid.cells_v + 1;
      for (const auto& [p, q, r] : {std::tuple{a, a + 1, b}, std::tuple{b, a + 1, b + 1}}) {
        mask.cover_triangle(*p, *q, *r);
        if (twice) {
          mask.cover_triangle(mirrored_picture(view, *p), mirrored_picture(view, *q),
                              mirrored_picture(view, *r));
        }
      }
    }
  }
}

PictureMask mask_of(const SilhouetteBody& body, View view, const std::vector<FacingGrid>& seen,
                    const std::vector<SilhouetteCurve>& curves, int cells) {
  std::vector<std::vector<Vector2d>> pictures;
  Eigen::AlignedBox2d box;
  for (const FacingGrid& face : seen) {
    std::vector<Vector2d>& nodes = pictures.emplace_back();
    for (const Eigen::Vector3d& position : face.positions) {
      nodes.push_back(project(view, position));
      box.extend(nodes.back());
      box.extend(mirrored_picture(view, nodes.back()));
    }
  }
  PictureMask mask(box, cells);
  for (std::size_t f = 0; f < seen.size(); ++f) {
    const bool twice = view != View::side && !body.faces[f].central;
    cover_face(mask, view, seen[f], pictures[f], twice);
  }
  for (const SilhouetteCurve& curve : curves) {
    for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
      const Vector2d &a = curve.points[k].picture, &b = curve.points[k + 1].picture;
      mask.cover_line(a, b);
      if (view != View::side) mask.cover_line(mirrored_picture(view, a), mirrored_picture(view, b));
    }
  }
  mask.flood();
  return mask;
}

// Cuts the curves of a body at where they go into hiding.
class Cutter {
 public:
  Cutter(const SilhouetteBody& body, View view, const OuterTest& test,
         const std::vector<SilhouetteCurve>& curves)
      : body_(body), view_(view), test_(test), curves_(curves) {}

  std::vector<SilhouetteCurve> pieces() {
    for (int line = 0; line < int(curves_.size()); ++line) cut(line);
    return std::move(pieces_);
  }

 private:
  void cut(int line);
  bool turn_outwards(SilhouettePoint& point, const OuterTest::Place& place) const;
  std::optional<SilhouettePoint> end_between(int line, int inside, int outside) const;
  void begin(const SilhouetteCurve& curve) {
    pieces_.push_back({curve.kind, curve.face, curve.side, {}, false});
  }
  void finish();

  const SilhouetteBody& body_;
  View view_;
  const OuterTest& test_;
  const std::vector<SilhouetteCurve>& curves_;
  std::vector<SilhouetteCurve> pieces_;
};

// Where contours cross an edge it is a crease at a single point.
void Cutter::finish() {
  const std::vector<SilhouettePoint>& points = pieces_.back().points;
  double length = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k)
    length += (points[k].picture - points[k - 1].picture).norm();
  if (!(length > shortest)) pieces_.pop_back();
}

bool Cutter::turn_outwards(SilhouettePoint& point, const OuterTest::Place& place) const {
  if (point.position.y() > on_plane) return false;
  const auto out = test_.outwards(point.picture, point.normal, place);
  if (out) point.normal = *out;
  return out.has_value();
}

// The last point of the silhouette on the way from one point of a curve, which belongs to it, to
// the next, which does not.
std::optional<SilhouettePoint> Cutter::end_between(int line, int inside, int outside) const {
  const SilhouetteCurve& curve = curves_[line];
  // From the last point of a closed curve to its first the place is that of the last.
  const int later = std::max(inside, outside), earlier = std::min(inside, outside);
  const OuterTest::Place place{line, later == earlier + 1 ? earlier : later, later};
  std::optional<SilhouettePoint> last;
  double low = 0.0, high = 1.0;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (low + high);
    auto point = silhouette_point_between(body_, view_, curve, curve.points[inside],
                                          curve.points[outside], middle);
    if (point && turn_outwards(*point, place)) {
      low = middle;
      last = point;
    } else {
      high = middle;
    }
  }
  return last;
}

void Cutter::cut(int line) {
  const SilhouetteCurve& curve = curves_[line];
  const int count = int(curve.points.size());
  std::vector<SilhouettePoint> points = curve.points;
  std::vector<char> outer(count);
  bool all = true;
  for (int k = 0; k < count; ++k) {
    outer[k] = turn_outwards(points[k], {line, k, k});
    all = all && outer[k];
  }
  if (all) {
    pieces_.push_back(curve);
    pieces_.back().points = std::move(points);
    finish();
    return;
  }
  // A closed curve is walked from a hidden point on.
  int first = 0;
  while (curve.closed && outer[first]) ++first;
  const int steps = curve.closed ? count : count - 1;
  if (outer[first]) {
    begin(curve);
    pieces_.back().points.push_back(points[first]);
  }
  for (int step = 0; step < steps; ++step) {
    const int k = (first + step) % count, next = (k + 1) % count;
    if (!outer[k] && outer[next]) {
      begin(curve);
      if (const auto end = end_between(line, next, k)) pieces_.back().points.push_back(*end);
    }
    if (outer[k] && !outer[next]) {
      if (const auto end = end_between(line, k, next)) pieces_.back().points.push_back(*end);
      finish();
    }
    if (outer[next]) pieces_.back().points.push_back(points[next]);
  }
  if (!curve.closed && outer[count - 1]) finish();
}

}  // namespace

SilhouetteBody silhouette_body(const BodyPlan& plan, Stage stage, const double* nets) {
  return {net_surfaces(plan, stage, nets), stage_edges(plan, stage)};
}

SilhouetteBody silhouette_body(const Model& model, Stage stage) {
  return {build(model, stage, Halves::left_and_central), stage_edges(plan_body(model), stage)};
}

std::vector<SilhouetteCurve> silhouette(const SilhouetteBody& body, View view,
                                        const SilhouetteOptions& options) {
  std::vector<FacingGrid> seen;
  for (const Surface& face : body.faces) seen.push_back(see_face(face, view, options.cell));
  const std::vector<SilhouetteCurve> curves = silhouette_curves(body, view, seen, options.spacing);
  std::vector<std::vector<Vector2d>> lines;
  for (const SilhouetteCurve& curve : curves) {
    std::vector<Vector2d>& line = lines.emplace_back();
    for (const SilhouettePoint& point : curve.points) line.push_back(point.picture);
    if (curve.closed) line.push_back(line.front());
  }
  const OuterTest test(mask_of(body, view, seen, curves, options.mask_cells), std::move(lines));
  return Cutter(body, view, test, curves).pieces();
}

}  // namespace bodyline::model
