#include "io/write_outline.hpp"

#include <cmath>
#include <stdexcept>

#include "io/scan_words.hpp"
#include "io/write_svg_drawing.hpp"
#include "model/number_text.hpp"

namespace bodyline::io {
namespace {

using Eigen::Vector2d;
using Lines = std::vector<std::vector<Vector2d>>;

double rounded(double value) { return std::round(1000.0 * value) / 1000.0; }

Lines rounded(Lines lines) {
  for (std::vector<Vector2d>& line : lines) {
    // Adding zero turns a negative one into a plain one.
    for (Vector2d& point : line) point = {rounded(point.x()) + 0.0, rounded(point.y()) + 0.0};
  }
  return lines;
}

model::Drawing drawing_of(const Lines& lines, const std::string& layer) {
  model::Drawing drawing;
  drawing.unit_mm = 1.0;
  for (const std::vector<Vector2d>& line : lines) {
    model::DrawnPath& path = drawing.paths.emplace_back();
    path.name = "outline";
    path.layer = layer;
    path.closed = line.size() > 2 && line.front() == line.back();
    for (std::size_t k = 1; k < line.size(); ++k)
      path.segments.push_back(model::line_segment(line[k - 1], line[k]));
  }
  return drawing;
}

std::string csv_text(const Lines& lines) {
  std::string text = "x,y\n";
  for (const std::vector<Vector2d>& line : lines) {
    if (&line != &lines.front()) text += '\n';
    for (const Vector2d& point : line)
      text += model::number_text(point.x()) + ',' + model::number_text(point.y()) + '\n';
  }
  return text;
}

}  // namespace

void write_outline(const Lines& lines, const std::string& layer, const std::filesystem::path& path,
                   Overwrite overwrite) {
  const std::string extension = lower_extension(path);
  if (extension == ".svg") {
    write_svg_drawing(drawing_of(rounded(lines), layer), path, {}, overwrite);
  } else if (extension == ".csv") {
    write_file(path, csv_text(rounded(lines)), overwrite);
  } else {
    throw std::invalid_argument(path.string() + ": an outline is written as .svg or .csv");
  }
}

}  // namespace bodyline::io
