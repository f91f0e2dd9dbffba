#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "io/palette.hpp"
#include "io/surface_field.hpp"
#include "io/tessellate.hpp"
#include "model/surface.hpp"

namespace bodyline::io {

/// What the colours of a picture say.
enum class Map {
  shade,           ///< paint in a studio
  mean_curvature,  ///< 1/m, positive where the body bulges outwards
  gauss,           ///< Gauss curvature, 1/m^2
  zebra,           ///< stripes every 15 degrees of elevation of the mirrored ray
  isophotes,       ///< bands every 5 degrees of the angle between the normal and straight up
  patches,         ///< one colour per patch; transitions and corners grey
  stages,          ///< patches, transitions and corners in three colours
  field,           ///< a SurfaceField; has no name, for it needs data that a model does not have
};

/// "shade", "mean-curvature", "gauss", "zebra", "isophotes", "patches" or "stages".
std::string map_name(Map map);

/// Throws std::invalid_argument listing the names.
Map map_from_name(const std::string& name);

std::vector<std::string> map_names();

/// Curvature (in the map's unit, 1/m or 1/m^2) at which the colours of a curvature map end: the
/// value that nine tenths of the body's area stay below, rounded up to 1, 2 or 5 times a power of
/// ten.
double curvature_range(const std::vector<model::Surface>& faces, Map map);

/// Colours of a map. Plain data; queries may run in several threads.
class MapColors {
 public:
  /// `range` as for curvature_range; found from the faces when absent. `field` is what Map::field
  /// shows and must outlive the colours. Throws std::invalid_argument when it is missing.
  MapColors(const std::vector<model::Surface>& faces, Map map, std::optional<double> range,
            const SurfaceField* field = nullptr);

  Map map() const { return map_; }
  double range() const { return range_; }
  /// Derivatives a point's colour needs.
  int jet_order() const;
  /// Whether thin lines along the edges of the faces belong to the map.
  bool edge_lines() const { return map_ == Map::patches || map_ == Map::stages; }

  /// The colour at a point of a face, before light. `normal` and `to_camera` are unit vectors.
  Color color(int face, const model::SurfaceJet& jet, const Eigen::Vector3d& normal,
              const Eigen::Vector3d& to_camera) const;

  /// The same for Map::field at (u, v).
  Color field_color(int face, double u, double v) const;

  /// What Map::field shows; null for other maps.
  const SurfaceField* field() const { return field_; }

  /// Names and colours of what the map distinguishes: patches without their mirror images, or
  /// stages.
  struct Entry {
    std::string name;
    Color color;
  };
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  Color scale_color(double value) const;

  Map map_;
  const SurfaceField* field_ = nullptr;
  std::vector<const FaceField*> face_fields_;  // by face, of Map::field
  double range_ = 1.0;
  std::vector<bool> inward_;
  std::vector<Color> face_colors_;
  std::vector<Color> scale_;  // of a curvature or a field, from -range to range
  std::vector<Entry> entries_;
};

/// Width of a stripe of the zebra, a dark and a light half together, degrees of elevation.
inline constexpr double zebra_stripe = 15.0;

/// Angle, degrees, at which the colours of the isophotes end.
inline constexpr double isophote_end = 120.0;

/// Colour of the isophotes at an angle between the normal and straight up, degrees.
Color isophote_color(double angle);

}  // namespace bodyline::io
