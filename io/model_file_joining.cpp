#include "io/model_file_joining.hpp"

#include <algorithm>

#include "io/model_file_lookup.hpp"
#include "io/model_file_names.hpp"

namespace bodyline::io {
namespace {

using model::PatchSide;
using model::Side;

constexpr double largest_parameter = 1e6;

/// The side of a patch that runs along a curve; the mirrored side of a central patch does not
/// count. Refuses a patch that has none, or two, at `between`.
PatchSide side_along(const model::Model& model, int patch, int curve, const FileTable& table) {
  std::vector<Side> found;
  for (const Side side : model::all_sides) {
    const auto& candidate =
        model.patches[static_cast<std::size_t>(patch)].sides[static_cast<std::size_t>(side)];
    if (candidate.curve == curve && !candidate.mirrored) found.push_back(side);
  }
  if (found.size() != 1) {
    table.fail("between", "names " +
                              in_quotes(model.patches[static_cast<std::size_t>(patch)].name) +
                              ", but " + (found.empty() ? "no side" : "more than one side") +
                              " of this patch runs along the curve " +
                              in_quotes(model.curves[static_cast<std::size_t>(curve)].name) + ".");
  }
  return {patch, found.front()};
}

/// The two patches that meet along the curve after which a joint or seam is named.
std::array<PatchSide, 2> read_between(const std::string& name, const FileTable& table,
                                      const model::Model& model) {
  const int curve = index_of(model.curves, name, table, "", "curve");
  const std::vector<std::string> names = table.texts("between", {2, 2});
  if (names[0] == names[1]) {
    table.fail("between", "names " + in_quotes(names[0]) + " twice; two patches are needed.");
  }
  std::array<PatchSide, 2> result;
  for (std::size_t i = 0; i < 2; ++i) {
    const int patch = index_of(model.patches, names[i], table, "between", "patch");
    result[i] = side_along(model, patch, curve, table);
  }
  return result;
}

std::optional<int> read_uncut(const FileTable& table, const model::Joint& joint,
                              const model::Model& model) {
  if (!table.has("uncut")) return std::nullopt;
  const std::string name = table.text("uncut");
  const std::string& a = model.patches[static_cast<std::size_t>(joint.a.patch)].name;
  const std::string& b = model.patches[static_cast<std::size_t>(joint.b.patch)].name;
  if (name == a) return 0;
  if (name == b) return 1;
  table.fail("uncut", "is " + in_quotes(name) + ", but must be one of the joint's patches, " +
                          in_quotes(a) + " or " + in_quotes(b) + ".");
}

std::vector<int> read_patch_list(const FileTable& table, const model::Model& model) {
  std::vector<int> result;
  for (const std::string& name : table.texts("patches", {3, most_entries})) {
    const std::string key = "patches[" + std::to_string(result.size()) + "]";
    const int patch = index_of(model.patches, name, table, key, "patch");
    if (std::find(result.begin(), result.end(), patch) != result.end()) {
      table.fail(key, "is " + in_quotes(name) + ", which is in the list already.");
    }
    result.push_back(patch);
  }
  return result;
}

model::WheelArch read_arch(const FileTable& table, const std::string& key,
                           const model::Model& model) {
  model::WheelArch arch;
  if (!table.has(key)) return arch;
  for (const std::string& name : table.texts(key, {1, most_entries})) {
    const std::string element = key + "[" + std::to_string(arch.curves.size()) + "]";
    const int curve = index_of(model.curves, name, table, element, "curve");
    if (std::find(arch.curves.begin(), arch.curves.end(), curve) != arch.curves.end()) {
      table.fail(element, "is " + in_quotes(name) + ", which is in the list already.");
    }
    arch.curves.push_back(curve);
  }
  return arch;
}

}  // namespace

void read_joints(const FileTable& root, model::Model& model) {
  for (const auto& [name, table] : entries(root, "joints")) {
    table.allow_only({"between", "fullness", "lean", "continuity", "uncut", "note"}, "a joint");
    model::Joint joint;
    joint.name = name;
    const auto between = read_between(name, table, model);
    joint.a = between[0];
    joint.b = between[1];
    joint.fullness = table.pair_or("fullness", joint.fullness, largest_parameter);
    if (const auto lean = table.find_table("lean")) {
      lean->allow_only({"a", "b"}, "a lean");
      joint.lean[0] = lean->pair_or("a", joint.lean[0], largest_parameter);
      joint.lean[1] = lean->pair_or("b", joint.lean[1], largest_parameter);
    }
    if (table.has("continuity")) joint.continuity = table.integer("continuity");
    joint.uncut = read_uncut(table, joint, model);
    joint.note = table.text_or("note", "");
    model.joints.push_back(std::move(joint));
  }
}

void read_seams(const FileTable& root, model::Model& model) {
  for (const auto& [name, table] : entries(root, "seams")) {
    table.allow_only({"between"}, "a seam");
    if (find_name(model.joints, name) >= 0) {
      root.fail("seams." + name, "is a joint already; a curve is a joint or a seam, not both.");
    }
    const auto between = read_between(name, table, model);
    model.seams.push_back({name, between[0], between[1]});
  }
}

void read_corners(const FileTable& root, model::Model& model) {
  for (const auto& [name, table] : entries(root, "corners")) {
    table.allow_only({"patches", "apex"}, "a corner");
    model::Corner corner;
    corner.name = name;
    corner.patches = read_patch_list(table, model);
    if (table.has("apex")) {
      corner.apex = index_of(model.patches, table.text("apex"), table, "apex", "patch");
      if (std::find(corner.patches.begin(), corner.patches.end(), corner.apex) ==
          corner.patches.end()) {
        table.fail("apex", "is " + in_quotes(table.text("apex")) +
                               ", which is not one of the corner's patches.");
      }
    }
    model.corners.push_back(std::move(corner));
  }
}

void read_wheels(const FileTable& root, model::Model& model) {
  const auto wheels = root.find_table("wheels");
  if (!wheels) return;
  wheels->allow_only({"front", "rear"}, "the wheels");
  model.front_arch = read_arch(*wheels, "front", model);
  model.rear_arch = read_arch(*wheels, "rear", model);
}

}  // namespace bodyline::io
