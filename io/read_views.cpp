#include "io/read_views.hpp"

#include <algorithm>
#include <stdexcept>

#include "io/drawing_axes.hpp"
#include "io/drawing_text.hpp"
#include "io/input_error.hpp"
#include "io/model_file_table.hpp"
#include "io/model_file_text.hpp"
#include "io/read_drawing.hpp"
#include "io/scan_words.hpp"
#include "model/elevation.hpp"

namespace bodyline::io {
namespace {

using model::View;

constexpr double largest_length = 1e6;  // mm

// The paths in a layer, with what of their layers lies within it.
model::Drawing layer_of(const model::Drawing& drawing, const std::string& layer) {
  model::Drawing part = drawing;
  part.paths.clear();
  for (model::DrawnPath path : drawing.paths) {
    if (path.layer == layer) {
      path.layer.clear();
    } else if (path.layer.starts_with(layer + "/")) {
      path.layer.erase(0, layer.size() + 1);
    } else {
      continue;
    }
    part.paths.push_back(std::move(path));
  }
  return part;
}

ViewsFile views_in_layers(const std::filesystem::path& path) {
  const model::Drawing drawing = read_drawing(path);
  ViewsFile file;
  for (const View view : model::all_views()) {
    ViewDrawing found;
    found.view = view;
    found.drawing = layer_of(drawing, model::view_name(view));
    if (found.drawing.paths.empty()) continue;
    file.views.push_back(std::move(found));
  }
  if (file.views.empty())
    throw InputError(path.string(), 0, "",
                     "has no layer named side, front, rear or top in which something is drawn.");
  return file;
}

// A point as the file that draws it has it, turned into the coordinates of the drawing.
Eigen::Vector2d drawn_point(const std::array<double, 2>& point, const model::Drawing& drawing) {
  return {point[0], drawing.y_down ? -point[1] : point[1]};
}

// A number above 0.
std::optional<double> find_positive(const FileTable& table, const std::string& name,
                                    double largest) {
  const std::optional<double> number = table.find_number(name, largest);
  if (number && !(*number > 0.0)) table.fail(name, "must be above 0.");
  return number;
}

ViewDrawing read_view(const std::string& name, const FileTable& table,
                      const std::filesystem::path& folder) {
  table.allow_only({"file", "layer", "scale", "origin", "nose"}, "a view");
  constexpr double largest = 1e9;
  ViewDrawing view;
  try {
    view.view = model::view_of(name);
    if (table.has("nose")) view.nose = nose_of(table.text("nose"));
  } catch (const std::invalid_argument& error) {
    table.fail("", std::string(error.what()) + ".");
  }
  if (!nose_fits(view.view, view.nose))
    table.fail("nose", "does not point " + nose_name(view.nose) + " in this view.");
  view.drawing = read_drawing(folder / table.text("file"));
  if (table.has("layer")) {
    view.drawing = layer_of(view.drawing, table.text("layer"));
    if (view.drawing.paths.empty()) table.fail("layer", "holds nothing, or does not exist.");
  }
  view.scale = find_positive(table, "scale", largest);
  if (table.has("origin"))
    view.origin = drawn_point(table.pair_or("origin", {}, largest), view.drawing);
  return view;
}

std::optional<int> find_degree(const FileTable& table) {
  if (!table.has("degree")) return std::nullopt;
  return int(table.whole("degree", 2, model::max_patch_degree));
}

void read_curves(const FileTable& root, ViewsFile& file) {
  const auto curves = root.find_table("curves");
  if (!curves) return;
  for (const auto& [name, table] : curves->tables()) {
    table.allow_only({"degree", "tolerance"}, "a curve");
    file.curves[name] = {find_degree(table), find_positive(table, "tolerance", largest_length)};
  }
}

ViewsFile views_in_table(const std::filesystem::path& path) {
  const std::string text = drawing_text(path);
  check_text_limits(text, path.string());
  const ModelFile source(text, path.string());
  const FileTable root(source, source.root(), "");
  root.allow_only({"start", "tolerance", "degree", "size", "curves", "views"}, "a file of views");
  ViewsFile file;
  if (root.has("start")) file.start = path.parent_path() / root.text("start");
  file.tolerance = find_positive(root, "tolerance", largest_length);
  file.degree = find_degree(root);
  read_curves(root, file);
  if (const auto size = root.find_table("size")) {
    size->allow_only({"length", "width", "height"}, "a size");
    file.length = find_positive(*size, "length", largest_length);
    file.width = find_positive(*size, "width", largest_length);
    file.height = find_positive(*size, "height", largest_length);
  }
  const auto views = root.find_table("views");
  if (!views) root.fail("views", "is required but missing.");
  for (const auto& [name, table] : views->tables())
    file.views.push_back(read_view(name, table, path.parent_path()));
  if (file.views.empty()) root.fail("views", "names no view.");
  return file;
}

}  // namespace

ViewsFile read_views(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension != ".toml" && extension != ".svg")
    throw InputError(path.string(), 0, "", "is neither a .toml file of views nor an .svg drawing.");
  ViewsFile file = extension == ".svg" ? views_in_layers(path) : views_in_table(path);
  try {
    for (ViewDrawing& view : file.views) take_axes(view);
  } catch (const std::invalid_argument& error) {
    throw InputError(path.string(), 0, "", std::string(error.what()) + ".");
  }
  return file;
}

}  // namespace bodyline::io
