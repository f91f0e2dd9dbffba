#include "io/svg_viewport.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "io/svg_length.hpp"
#include "io/svg_scanner.hpp"

namespace bodyline::io {
namespace {

// None when missing or relative to what is around it.
std::optional<SvgLength> size_of(const pugi::xml_node& element, const char* attribute) {
  const std::string_view text = element.attribute(attribute).value();
  if (text.empty() || text == "auto" || text.ends_with('%')) return std::nullopt;
  const SvgLength length = svg_length(text);
  if (!(length.pixels > 0.0)) throw std::invalid_argument("the drawing has no width or no height");
  return length;
}

double offset_of(const pugi::xml_node& element, const char* attribute) {
  const std::string_view text = element.attribute(attribute).value();
  return text.empty() ? 0.0 : svg_length(text).pixels;
}

Eigen::Vector4d view_box(std::string_view text) {
  SvgScanner scanner(text);
  Eigen::Vector4d box;
  for (double& number : box) {
    number = scanner.number();
    scanner.skip_separator();
  }
  if (!scanner.at_end() || !(box[2] > 0.0) || !(box[3] > 0.0))
    throw std::invalid_argument("the viewBox takes x, y, width and height, the last two above 0");
  return box;
}

// Where a part lies in the room left beside it: at its beginning, in the middle or at its end.
double share(std::string_view alignment, std::string_view axis) {
  const std::size_t at = alignment.find(axis);
  if (at == alignment.npos) return 0.5;
  const std::string_view where = alignment.substr(at + axis.size(), 3);
  return where == "Min" ? 0.0 : where == "Max" ? 1.0 : 0.5;
}

}  // namespace

SvgViewport svg_viewport(const pugi::xml_node& element) {
  const auto width = size_of(element, "width"), height = size_of(element, "height");
  SvgViewport viewport;
  viewport.physical = (width && width->physical) || (height && height->physical);
  viewport.to_pixels.translation() << offset_of(element, "x"), offset_of(element, "y");
  const std::string_view box_text = element.attribute("viewBox").value();
  if (box_text.empty() || (!width && !height)) return viewport;
  const Eigen::Vector4d box = view_box(box_text);
  Eigen::Vector2d scale(width ? width->pixels / box[2] : height->pixels / box[3],
                        height ? height->pixels / box[3] : width->pixels / box[2]);
  const std::string_view fit = element.attribute("preserveAspectRatio").value();
  Eigen::Vector2d room(0.0, 0.0);
  if (!fit.starts_with("none")) {
    const bool slice = fit.find("slice") != fit.npos;
    const double both = slice ? scale.maxCoeff() : scale.minCoeff();
    room = (scale - Eigen::Vector2d::Constant(both)).cwiseProduct(box.tail<2>());
    room = room.cwiseProduct(Eigen::Vector2d(share(fit, "x"), share(fit, "Y")));
    scale.setConstant(both);
  }
  viewport.to_pixels = viewport.to_pixels * Eigen::Translation2d(room) * Eigen::Scaling(scale) *
                       Eigen::Translation2d(-box.head<2>());
  return viewport;
}

}  // namespace bodyline::io
