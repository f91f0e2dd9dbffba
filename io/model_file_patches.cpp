#include "io/model_file_patches.hpp"

#include <algorithm>

#include "io/model_file_lookup.hpp"
#include "io/model_file_names.hpp"
#include "model/family.hpp"
#include "model/largest_coordinate.hpp"

namespace bodyline::io {
namespace {

using model::Side;

/// Points of a curve of degree 2 to 9.
constexpr Count points_of_curve{3, 10};
/// At most one for each of ten rows.
constexpr Count shape_values{0, 10};
constexpr double largest_parameter = 1e6;

/// A side as the file names it: a curve, with "-" in front when it runs backwards.
model::SideCurve read_side(const FileTable& table, const std::string& key,
                           const model::Model& model) {
  std::string curve = table.text(key);
  model::SideCurve side;
  side.reversed = curve.starts_with('-');
  if (side.reversed) curve.erase(0, 1);
  side.curve = index_of(model.curves, curve, table, key, "curve");
  return side;
}

void read_sides(const FileTable& table, const model::Model& model, model::Patch& patch) {
  for (const Side side : model::all_sides) {
    auto& read = patch.sides[static_cast<std::size_t>(side)];
    if (patch.central && side == Side::v1) {
      if (table.has("v1")) {
        table.fail(
            "v1",
            "is " + in_quotes(table.text("v1")) +
                ", but on a central patch it is the mirror image of v0 and must not be given.");
      }
      read = patch.sides[static_cast<std::size_t>(Side::v0)];
      read.mirrored = true;
    } else {
      read = read_side(table, model::side_name(side), model);
    }
  }
}

std::string read_basis(const FileTable& table) {
  const std::string basis = table.text_or("basis", model::Patch{}.basis);
  const std::vector<std::string> known = model::family_names();
  if (std::find(known.begin(), known.end(), basis) == known.end()) {
    table.fail("basis", "is " + in_quotes(basis) + ", but there is no basis of this name" +
                            suggestion(basis, known) + "; known are " + listed(known) + ".");
  }
  return basis;
}

model::Patch read_patch(const std::string& name, const FileTable& table,
                        const model::Model& model) {
  table.allow_only({"central", "basis", "u0", "u1", "v0", "v1", "cut", "shape", "note"}, "a patch");
  model::Patch patch;
  patch.name = name;
  patch.central = table.flag_or("central", false);
  patch.basis = read_basis(table);
  patch.note = table.text_or("note", "");
  read_sides(table, model, patch);
  if (const auto cut = table.find_table("cut")) {
    cut->allow_only({"u", "v"}, "a cut");
    patch.cut_u = cut->pair_or("u", patch.cut_u, largest_parameter);
    patch.cut_v = cut->pair_or("v", patch.cut_v, largest_parameter);
  }
  const auto shape = table.find_table("shape");
  if (!shape) table.fail("shape", "is required but missing.");
  shape->allow_only({"u", "v"}, "a shape");
  patch.shape_u = shape->numbers("u", shape_values, largest_parameter);
  patch.shape_v = shape->numbers("v", shape_values, largest_parameter);
  return patch;
}

}  // namespace

void read_curves(const FileTable& root, double scale, model::Model& model) {
  if (!root.has("curves")) root.fail("curves", "is required but missing.");
  for (const auto& [name, table] : entries(root, "curves")) {
    table.allow_only({"points", "note"}, "a curve");
    model::Curve curve;
    curve.name = name;
    curve.points = table.points("points", points_of_curve, scale, model::largest_coordinate);
    curve.note = table.text_or("note", "");
    model.curves.push_back(std::move(curve));
  }
}

void read_patches(const FileTable& root, model::Model& model) {
  if (!root.has("patches")) root.fail("patches", "is required but missing.");
  for (const auto& [name, table] : entries(root, "patches")) {
    model.patches.push_back(read_patch(name, table, model));
  }
}

}  // namespace bodyline::io
