#include "io/write_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "io/model_file_names.hpp"
#include "io/toml_text.hpp"

namespace bodyline::io {
namespace {

using model::Model;
using model::Side;

/// The item at an index; a model in memory may hold any index.
template <typename Item>
const Item& item(const std::vector<Item>& items, int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= items.size()) {
    throw std::invalid_argument("The model names a curve or patch that it does not have.");
  }
  return items[static_cast<std::size_t>(index)];
}

template <typename Items>
std::string names_at(const Items& items, const std::vector<int>& indices) {
  std::vector<std::string> names;
  for (const int index : indices) names.push_back(item(items, index).name);
  return toml_names(names);
}

void write_header(const Model& model, TomlLines& lines) {
  lines.line("format", "1");
  lines.line("name", toml_text(model.name));
  lines.line("units", "\"mm\"");
  lines.note(model.note);
}

void write_curve(const model::Curve& curve, TomlLines& lines) {
  lines.header("curves." + valid_name(curve.name));
  lines.line("points", toml_points(curve.points));
  lines.note(curve.note);
}

bool same_bits(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return a == b && std::signbit(a[0]) == std::signbit(b[0]) &&
         std::signbit(a[1]) == std::signbit(b[1]);
}

void write_sides(const Model& model, const model::Patch& patch, TomlLines& lines) {
  for (const Side side : model::all_sides) {
    const auto& written = patch.sides[static_cast<std::size_t>(side)];
    const auto& v0 = patch.sides[static_cast<std::size_t>(Side::v0)];
    const bool is_mirror = patch.central && side == Side::v1;
    if (written.mirrored != is_mirror ||
        (is_mirror && (written.curve != v0.curve || written.reversed != v0.reversed))) {
      throw std::invalid_argument(
          "Patch " + in_quotes(patch.name) +
          " cannot be written: v1, and only v1, of a central patch mirrors v0.");
    }
    if (is_mirror) continue;
    std::string curve = written.reversed ? "\"-" : "\"";
    curve.append(item(model.curves, written.curve).name).append("\"");
    lines.line(model::side_name(side), curve);
  }
}

void write_patch(const Model& model, const model::Patch& patch, TomlLines& lines) {
  const model::Patch defaults;
  lines.header("patches." + valid_name(patch.name));
  if (patch.central) lines.line("central", "true");
  if (patch.basis != defaults.basis) lines.line("basis", toml_text(patch.basis));
  write_sides(model, patch, lines);
  if (!same_bits(patch.cut_u, defaults.cut_u)) lines.line("cut.u", toml_numbers(patch.cut_u));
  if (!same_bits(patch.cut_v, defaults.cut_v)) lines.line("cut.v", toml_numbers(patch.cut_v));
  lines.line("shape.u", toml_numbers(patch.shape_u));
  lines.line("shape.v", toml_numbers(patch.shape_v));
  lines.note(patch.note);
}

std::string between_text(const Model& model, const model::PatchSide& a, const model::PatchSide& b) {
  return names_at(model.patches, {a.patch, b.patch});
}

void write_joint(const Model& model, const model::Joint& joint, TomlLines& lines) {
  constexpr std::array<double, 2> upright{0.0, 0.0};
  lines.header("joints." + valid_name(joint.name));
  lines.line("between", between_text(model, joint.a, joint.b));
  lines.line("fullness", toml_numbers(joint.fullness));
  if (!same_bits(joint.lean[0], upright)) lines.line("lean.a", toml_numbers(joint.lean[0]));
  if (!same_bits(joint.lean[1], upright)) lines.line("lean.b", toml_numbers(joint.lean[1]));
  if (joint.continuity != model::Joint{}.continuity)
    lines.line("continuity", std::to_string(joint.continuity));
  if (joint.uncut) {
    const int patch = *joint.uncut == 0 ? joint.a.patch : joint.b.patch;
    lines.line("uncut", "\"" + item(model.patches, patch).name + "\"");
  }
  lines.note(joint.note);
}

void write_corner(const Model& model, const model::Corner& corner, TomlLines& lines) {
  lines.header("corners." + valid_name(corner.name));
  lines.line("patches", names_at(model.patches, corner.patches));
  if (corner.apex >= 0) lines.line("apex", "\"" + item(model.patches, corner.apex).name + "\"");
}

void write_wheels(const Model& model, TomlLines& lines) {
  if (model.front_arch.curves.empty() && model.rear_arch.curves.empty()) return;
  lines.header("wheels");
  for (const auto& [key, arch] :
       {std::pair("front", &model.front_arch), std::pair("rear", &model.rear_arch)}) {
    if (!arch->curves.empty()) lines.line(key, names_at(model.curves, arch->curves));
  }
}

}  // namespace

std::string write_model_text(const Model& model) {
  TomlLines lines;
  write_header(model, lines);
  for (const auto& curve : model.curves) write_curve(curve, lines);
  for (const auto& patch : model.patches) write_patch(model, patch, lines);
  for (const auto& joint : model.joints) write_joint(model, joint, lines);
  for (const auto& seam : model.seams) {
    lines.header("seams." + valid_name(seam.name));
    lines.line("between", between_text(model, seam.a, seam.b));
  }
  for (const auto& corner : model.corners) write_corner(model, corner, lines);
  write_wheels(model, lines);
  return lines.text();
}

void write_model(const Model& model, const std::filesystem::path& path, Overwrite overwrite) {
  write_file(path, write_model_text(model), overwrite);
}

}  // namespace bodyline::io
