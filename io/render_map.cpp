#include "io/render_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "io/round_up.hpp"
#include "model/factors.hpp"

namespace bodyline::io {
namespace {

constexpr std::array<std::pair<Map, const char*>, 7> names{{
    {Map::shade, "shade"},
    {Map::mean_curvature, "mean-curvature"},
    {Map::gauss, "gauss"},
    {Map::zebra, "zebra"},
    {Map::isophotes, "isophotes"},
    {Map::patches, "patches"},
    {Map::stages, "stages"},
}};

constexpr double range_share = 0.90;
constexpr int scale_steps = 1024;  // of the colours of a curvature map: finer than the eye
constexpr int range_samples = 8;   // per direction and face

// In the unit of the map: 1/m and 1/m^2 from 1/mm and 1/mm^2.
double map_value(Map map, const model::SurfaceJet& jet, bool inward) {
  const model::Curvature curvature = model::curvature(jet, inward);
  return map == Map::gauss ? model::square_mm_per_square_m * curvature.gauss
                           : model::mm_per_m * curvature.mean;
}

std::string without_mirror_suffix(const std::string& name) {
  constexpr std::string_view suffix = ".right";
  return name.ends_with(suffix) ? name.substr(0, name.size() - suffix.size()) : name;
}

double degrees(double cosine) {
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

// What kinds of faces there are, indexed by FaceKind.
std::array<bool, 3> kinds_of(const std::vector<model::Surface>& faces) {
  std::array<bool, 3> kinds{};
  for (const model::Surface& face : faces) kinds[static_cast<int>(face.kind)] = true;
  return kinds;
}

std::vector<MapColors::Entry> stage_entries(const std::vector<model::Surface>& faces) {
  const std::array<bool, 3> kinds = kinds_of(faces);
  std::vector<MapColors::Entry> entries;
  if (kinds[0]) entries.push_back({"patches", color_from_oklch(0.80, 0.055, 245.0)});
  if (kinds[1]) entries.push_back({"transitions", color_from_oklch(0.80, 0.130, 75.0)});
  if (kinds[2]) entries.push_back({"corners", color_from_oklch(0.64, 0.165, 25.0)});
  return entries;
}

// Patches by name in order of appearance, then greys for the other kinds that occur.
std::vector<MapColors::Entry> patch_entries(const std::vector<model::Surface>& faces) {
  std::vector<MapColors::Entry> entries;
  const std::array<bool, 3> kinds = kinds_of(faces);
  for (const model::Surface& face : faces) {
    const std::string name = without_mirror_suffix(face.name);
    const bool known =
        std::any_of(entries.begin(), entries.end(),
                    [&](const MapColors::Entry& entry) { return entry.name == name; });
    if (face.kind == model::FaceKind::patch && !known) entries.push_back({name, Color::Zero()});
  }
  const int count = static_cast<int>(entries.size());
  for (int k = 0; k < count; ++k) entries[k].color = categorical_color(k, count);
  if (kinds[1]) entries.push_back({"transitions", color_from_srgb(216, 218, 222)});
  if (kinds[2]) entries.push_back({"corners", color_from_srgb(160, 165, 174)});
  return entries;
}

const char* entry_name(model::FaceKind kind) {
  return kind == model::FaceKind::transition ? "transitions" : "corners";
}

// The entry that colours a face.
std::string entry_of(const model::Surface& face, Map map) {
  if (face.kind != model::FaceKind::patch) return entry_name(face.kind);
  return map == Map::stages ? "patches" : without_mirror_suffix(face.name);
}

}  // namespace

std::string map_name(Map map) {
  for (const auto& [known, name] : names) {
    if (known == map) return name;
  }
  return "";
}

Map map_from_name(const std::string& name) {
  std::string list;
  for (const auto& [map, known] : names) {
    if (known == name) return map;
    list += (list.empty() ? "" : ", ") + std::string(known);
  }
  throw std::invalid_argument("unknown map '" + name + "': give one of " + list);
}

std::vector<std::string> map_names() {
  std::vector<std::string> list;
  for (const auto& [map, name] : names) list.emplace_back(name);
  return list;
}

double curvature_range(const std::vector<model::Surface>& faces, Map map) {
  std::vector<std::pair<double, double>> samples;  // |value| and area
  double total = 0.0;
  for (const model::Surface& face : faces) {
    for (int k = 0; k < range_samples * range_samples; ++k) {
      const double u = (k / range_samples + 0.5) / range_samples;
      const double v = (k % range_samples + 0.5) / range_samples;
      const model::SurfaceJet jet = model::jet(face, u, v, 2);
      const double value = std::abs(map_value(map, jet, face.inward));
      const double area = jet.d[1].cross(jet.d[2]).norm();
      if (!std::isfinite(value)) continue;
      samples.emplace_back(value, area);
      total += area;
    }
  }
  std::sort(samples.begin(), samples.end());
  double below = 0.0;
  for (const auto& [value, area] : samples) {
    below += area;
    if (below >= range_share * total && value > 1e-9) return rounded_up(value);
  }
  return 1.0;
}

MapColors::MapColors(const std::vector<model::Surface>& faces, Map map, std::optional<double> range,
                     const SurfaceField* field)
    : map_(map), field_(field) {
  if (map == Map::field) {
    if (field == nullptr) throw std::invalid_argument("there is no field to draw");
    for (const model::Surface& face : faces) face_fields_.push_back(field->face(face.name));
    range_ = field->range;
  }
  if (map == Map::mean_curvature || map == Map::gauss) {
    range_ = range ? *range : curvature_range(faces, map);
  }
  if (map == Map::mean_curvature || map == Map::gauss || map == Map::field) {
    for (int k = 0; k <= scale_steps; ++k) {
      scale_.push_back(diverging_color(2.0 * k / scale_steps - 1.0));
    }
  }
  if (map == Map::patches) entries_ = patch_entries(faces);
  if (map == Map::stages) entries_ = stage_entries(faces);
  const Color paint = color_from_srgb(86, 110, 138);
  for (const model::Surface& face : faces) {
    inward_.push_back(face.inward);
    Color color = paint;
    for (const Entry& entry : entries_) {
      if (entry.name == entry_of(face, map)) color = entry.color;
    }
    face_colors_.push_back(color);
  }
}

int MapColors::jet_order() const {
  return map_ == Map::mean_curvature || map_ == Map::gauss ? 2 : 1;
}

Color MapColors::color(int face, const model::SurfaceJet& jet, const Eigen::Vector3d& normal,
                       const Eigen::Vector3d& to_camera) const {
  switch (map_) {
    case Map::mean_curvature:
    case Map::gauss:
      return scale_color(map_value(map_, jet, inward_[face]));
    case Map::zebra: {
      const Eigen::Vector3d mirror = 2.0 * normal.dot(to_camera) * normal - to_camera;
      const double stripe = degrees(mirror.z()) / zebra_stripe;
      return stripe - std::floor(stripe) < 0.5 ? color_from_srgb(246, 247, 249)
                                               : color_from_srgb(30, 34, 42);
    }
    case Map::isophotes:
      return isophote_color(degrees(normal.z()));
    default:
      return face_colors_[face];
  }
}

Color MapColors::field_color(int face, double u, double v) const {
  const FaceField* const field = face_fields_[face];
  const double value = field != nullptr ? field->sample(u, v) : std::nan("");
  return std::isnan(value) ? unknown_color() : scale_color(value);
}

Color MapColors::scale_color(double value) const {
  const double t = std::isfinite(value) ? std::clamp(value / range_, -1.0, 1.0) : 0.0;
  return scale_[static_cast<std::size_t>(std::lround((0.5 + 0.5 * t) * scale_steps))];
}

Color isophote_color(double angle) {
  constexpr double band = 5.0;  // degrees, a deep and a pale one in turn
  const int index = static_cast<int>(angle / band);
  const Color color = sequential_color(1.0 - (index + 0.5) * band / isophote_end);
  return index % 2 == 0 ? color : Color(0.72f * color + 0.28f);
}

}  // namespace bodyline::io
