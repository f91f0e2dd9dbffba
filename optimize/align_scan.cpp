#include "optimize/align_scan.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "optimize/align_box.hpp"
#include "optimize/align_cloud.hpp"
#include "optimize/align_ends.hpp"
#include "optimize/align_floor.hpp"
#include "optimize/align_ground.hpp"
#include "optimize/align_level.hpp"
#include "optimize/align_one_side.hpp"
#include "optimize/align_refusals.hpp"
#include "optimize/align_register.hpp"
#include "optimize/align_search.hpp"
#include "optimize/align_symmetry.hpp"
#include "optimize/align_unit.hpp"
#include "optimize/align_words.hpp"
#include "optimize/body_samples.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr int cloud_points = 20000;
constexpr int least_points = 500;
constexpr int settled_points = 6000;
constexpr double coarse_spacing = 110.0;  // mm, of the samples of the start model
constexpr double fine_spacing = 60.0;

constexpr double least_partners = 0.35;
constexpr double side_ratio = 0.35;  // of the covered samples on the two sides

constexpr double near_floor = 10.0;  // mm: a scan has points lower than those that are looked at

const std::vector<double> refining_scales{100, 80, 80, 60, 60, 60};
const std::vector<double> shifting_scales{500, 500, 400, 400, 300, 300, 200, 200};
const std::vector<double> given_scales{200, 150, 100, 100, 80, 80, 60, 60};

/// A scan in mm, ready to be placed.
struct Prepared {
  AlignCloud cloud;       ///< of the car and whatever is around it
  AlignCloud off_ground;  ///< without what may be the ground
  bool ground = false;
  LengthUnit unit;
};

void scale_to_mm(AlignCloud& cloud, double mm) {
  for (Vector3d& point : cloud.points) point *= mm;
  cloud.spacing *= mm;
}

void set_aside_ground(const Plane& plane, Prepared& prepared) {
  prepared.off_ground = prepared.cloud;
  if (!may_be_ground(prepared.cloud, plane)) return;
  AlignCloud rest = without_plane(prepared.cloud, plane);
  prepared.ground = rest.points.size() >= std::size_t(least_points);
  if (prepared.ground) prepared.off_ground = std::move(rest);
}

LengthUnit unit_of(const AlignOptions& options, double length) {
  if (options.pose) return {unit_name(options.pose->scale), options.pose->scale};
  return options.unit_mm == 0.0 ? guess_unit(length) : given_unit(options.unit_mm, length);
}

Prepared prepared(const model::Scan& scan, const AlignOptions& options) {
  Prepared result;
  result.cloud = thin_and_clean(scan, cloud_points, least_points, options.seed);
  const Plane plane = largest_plane(result.cloud, options.seed);
  refuse_flat(plane);
  set_aside_ground(plane, result);
  const Vector3d extents = principal_box(result.off_ground).extents();
  if (!options.pose) refuse_by_box(extents);
  result.unit = unit_of(options, extents[0]);
  scale_to_mm(result.cloud, result.unit.mm);
  scale_to_mm(result.off_ground, result.unit.mm);
  return result;
}

// The plane of the ground may be a flat side of the car: then its points lie on the shape.
bool plane_is_car(const Prepared& prepared, const BodySamples& shape, const Placement& placement) {
  const auto on_shape = [&](const AlignCloud& cloud) {
    const AlignCloud few = thinned(cloud, settled_points);
    return double(cloud.points.size()) * points_score(few, shape, placement, shape_tolerance);
  };
  const double plane_points =
      double(prepared.cloud.points.size() - prepared.off_ground.points.size());
  return on_shape(prepared.cloud) - on_shape(prepared.off_ground) > 0.5 * plane_points;
}

void keep_plane_of_car(Prepared& prepared, const BodySamples& shape, const Placement& placement) {
  if (!prepared.ground || !plane_is_car(prepared, shape, placement)) return;
  prepared.ground = false;
  prepared.off_ground = prepared.cloud;
}

// Tries the scan with and without what may be the ground; leaves the car in `off_ground`.
std::vector<Candidate> searched(Prepared& prepared, const BodySamples& shape) {
  auto best = search_placements(prepared.cloud, prepared.off_ground, shape);
  if (!prepared.ground) return best;
  auto with_plane = search_placements(prepared.cloud, prepared.cloud, shape);
  if (with_plane.front().score.total() > best.front().score.total()) best = with_plane;
  keep_plane_of_car(prepared, shape, best.front().placement);
  return best;
}

// Share of the samples of the shape beyond `side` of the plane that have a point near.
double side_coverage(const PointTree& tree, const BodySamples& shape, const Placement& placement,
                     double sign) {
  double covered = 0.0, all = 0.0;
  for (std::size_t i = 0; i < shape.points().size(); ++i) {
    if (sign * shape.points()[i].y() < 0.25 * shape.high.y()) continue;
    const Vector3d stretched =
        shape.centre() + placement.stretch.cwiseProduct(shape.points()[i] - shape.centre());
    const Vector3d back = placement.rotation.transpose() * (stretched - placement.translation);
    all += 1.0;
    covered += tree.nearest(back).squared_distance < 4.0 * shape_tolerance * shape_tolerance;
  }
  return all > 0.0 ? covered / all : 0.0;
}

void find_missing_side(const AlignCloud& cloud, const BodySamples& shape,
                       const Placement& placement, AlignResult& result) {
  const PointTree tree(cloud.points);
  const double left = side_coverage(tree, shape, placement, -1.0);
  const double right = side_coverage(tree, shape, placement, 1.0);
  result.coverage = 0.5 * (left + right);
  if (left < side_ratio * right) result.missing = MissingSide::left;
  if (right < side_ratio * left) result.missing = MissingSide::right;
}

// `placement` leaves the car standing level. Where an end is missing the whole shape is stretched
// anew, without turns: a small one would lift or lower the far end by much. `known` is the end that
// is missing where that is known.
void find_missing_end(const AlignCloud& cloud, const BodySamples& shape, const Placement& placement,
                      MissingEnd known, AlignResult& result) {
  const AlignCloud few = thinned(cloud, settled_points);
  const Placement upright = registered(few, shape, placement, refining_scales, without_turns);
  result.missing_end =
      known == MissingEnd::none ? missing_end(few, shape, upright, result.coverage) : known;
  if (result.missing_end != MissingEnd::none)
    result.beyond_end = samples_beyond(cloud, shape, upright, result.missing_end);
}

// Settles the plane of symmetry from the scan itself where both sides are there.
Placement settled(const AlignCloud& cloud, const BodySamples& shape, const Placement& placement,
                  AlignResult& result) {
  const AlignCloud few = thinned(cloud, settled_points);
  find_missing_side(few, shape, placement, result);
  Placement symmetric = placement;
  const SymmetryResult symmetry = settle_symmetry(cloud, symmetric);
  if (result.missing != MissingSide::none || symmetry.partners < least_partners) {
    Placement one = registered(few, shape, placement, refining_scales, all_free);
    if (result.missing == MissingSide::none) return one;
    settle_one_side(cloud, result.missing == MissingSide::right ? -1.0 : 1.0, one);
    return registered(few, shape, one, refining_scales, in_plane);
  }
  result.symmetry_mm = symmetry.residual_mm;
  return registered(few, shape, symmetric, refining_scales, in_plane);
}

double median_misfit(const AlignCloud& cloud, const BodySamples& shape,
                     const Placement& placement) {
  std::vector<double> misfits;
  for (const Vector3d& point : cloud.points)
    misfits.push_back(
        shape.tree.nearest(placement.rotation * point + placement.translation).squared_distance);
  return std::sqrt(median(std::move(misfits)));
}

// Shifts the car along its plane of symmetry to where it is closest to the shape as it is.
Placement shifted(const AlignCloud& cloud, const BodySamples& shape, Placement placement) {
  const AlignCloud few = thinned(cloud, settled_points);
  placement.stretch.setOnes();
  placement = registered(few, shape, placement, shifting_scales, shifts_in_plane);
  const double scale = std::max(shape_tolerance, 3.0 * median_misfit(few, shape, placement));
  return registered(few, shape, placement, {scale, scale, scale}, shifts_in_plane);
}

// Scores a placement on its stretched shape; a side that is missing does not count.
void judge(const AlignCloud& cloud, const BodySamples& shape, const Placement& placement,
           AlignResult& result) {
  const AlignCloud few = thinned(cloud, settled_points);
  const PlacementScore score =
      placement_score(few, PointTree(few.points), shape, placement, shape_tolerance);
  result.fit = score.points;
  result.cover = score.samples * (result.missing == MissingSide::none ? 1.0 : 2.0);
}

/// A search and what speaks for it.
struct Found {
  Placement placement;
  AlignResult result;
  FitEvidence evidence;
};

// Whether anything lay below the car: then it is set aside.
bool set_aside_below(const BodySamples& shape, const Placement& placement, AlignCloud& cloud) {
  const double floor = floor_under(cloud, shape, placement);
  AlignCloud above;
  above.spacing = cloud.spacing;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (placement.rotation.row(2).dot(cloud.points[i]) + placement.translation.z() < floor)
      continue;
    above.points.push_back(cloud.points[i]);
    above.normals.push_back(cloud.normals[i]);
  }
  if (above.points.size() == cloud.points.size() || above.points.size() < least_points)
    return false;
  cloud = std::move(above);
  return true;
}

double doubt_of(const std::vector<Candidate>& candidates) {
  return candidates.size() > 1 ? candidates[1].score.total() / candidates[0].score.total() : 0.0;
}

// `whole` is the start model, of which `coarse` and `fine` are what is left without the end `cut`.
Found found_on(Prepared car, const BodySamples& coarse, const BodySamples& fine,
               const BodySamples& whole, MissingEnd cut) {
  Found found;
  const double all = double(car.cloud.points.size());
  auto candidates = searched(car, coarse);
  const double doubt = doubt_of(candidates);
  Placement placement = settled(car.off_ground, fine, candidates.front().placement, found.result);
  if (set_aside_below(fine, placement, car.off_ground)) {
    // The shape may have been stretched to the ground: everything once more.
    car.cloud = car.off_ground;
    car.ground = false;
    found.result = {};
    candidates = searched(car, coarse);
    placement = settled(car.off_ground, fine, candidates.front().placement, found.result);
    car.ground = true;
  }
  found.result.doubt = std::max(doubt, doubt_of(candidates));
  judge(car.off_ground, fine, placement, found.result);
  if (car.ground) found.result.ground = 1.0 - double(car.off_ground.points.size()) / all;
  found.evidence = {found.result.fit, found.result.cover, found.result.doubt, placement.stretch[0]};
  settle_level(car.off_ground, placement);
  find_missing_end(car.off_ground, whole, placement, cut, found.result);
  found.placement = shifted(car.off_ground, fine, placement);
  if (car.ground) found.result.floor_mm = lowest(car.off_ground, found.placement) - near_floor;
  return found;
}

// Tries halves of the start model where the scan may be no whole car.
Found found_placement(const Prepared& car, const BodySamples& coarse, const BodySamples& fine) {
  const Found whole = found_on(car, coarse, fine, fine, MissingEnd::none);
  if (is_clearly_a_car(whole.evidence)) return whole;
  Found best = whole;
  bool is_half = false;
  for (const double end : {-1.0, 1.0}) {
    const Found half = found_on(car, half_of(coarse, end), half_of(fine, end), fine,
                                end < 0.0 ? MissingEnd::rear : MissingEnd::front);
    if (!is_rather_half_a_car(half.evidence, best.evidence)) continue;
    best = half;
    is_half = true;
  }
  if (!is_half) refuse_by_fit(whole.evidence);
  return best;
}

// The given pose, judged.
Placement given_placement(Prepared car, const BodySamples& fine, const AlignOptions& options,
                          AlignResult& result) {
  Placement given;
  given.rotation = options.pose->rotation;
  given.translation = options.pose->translation;
  const auto stretched_to = [&](const AlignCloud& cloud) {
    return registered(thinned(cloud, settled_points), fine, given, given_scales, stretches);
  };
  if (car.ground) keep_plane_of_car(car, fine, stretched_to(car.off_ground));
  settled(car.off_ground, fine, given, result);  // tells which side is missing
  const Placement stretched = stretched_to(car.off_ground);
  if (set_aside_below(fine, stretched, car.off_ground)) car.ground = true;
  judge(car.off_ground, fine, stretched, result);
  find_missing_end(car.off_ground, fine, stretched, MissingEnd::none, result);
  if (car.ground) {
    result.ground = 1.0 - double(car.off_ground.points.size()) / double(car.cloud.points.size());
    result.floor_mm = lowest(car.off_ground, given) - near_floor;
  }
  result.pose_is_doubtful = !is_a_car({result.fit, result.cover, 0.0, stretched.stretch[0]});
  return given;
}

}  // namespace

AlignResult align_scan(const model::Scan& scan, const model::Model& start,
                       const AlignOptions& options) {
  if (options.pose) model::check_pose(*options.pose);
  Prepared car = prepared(scan, options);
  const BodySamples fine = body_samples(start, fine_spacing);
  AlignResult result;
  Placement placement;
  if (options.pose) {
    placement = given_placement(car, fine, options, result);
  } else {
    const Found found = found_placement(car, body_samples(start, coarse_spacing), fine);
    result = found.result;
    placement = found.placement;
  }
  result.unit = car.unit.name;
  result.pose.scale = car.unit.mm;
  result.pose.rotation = placement.rotation;
  result.pose.translation = placement.translation;
  for (Vector3d& point : result.beyond_end.points) point /= car.unit.mm;
  result.warning = align_warning(result, options.reference);
  result.words = align_words(result, options.reference);
  return result;
}

}  // namespace bodyline::optimize
