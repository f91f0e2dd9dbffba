#include "io/read_drawing_svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <stdexcept>

#include "io/drawing_limits.hpp"
#include "io/drawing_text.hpp"
#include "io/input_error.hpp"
#include "io/scan_words.hpp"
#include "io/svg_hidden.hpp"
#include "io/svg_length.hpp"
#include "io/svg_shape.hpp"
#include "io/svg_transform.hpp"
#include "io/svg_viewport.hpp"

namespace bodyline::io {
namespace {

using Eigen::Affine2d;
using Eigen::Vector2d;

constexpr int deepest = 200;                    // elements within each other
constexpr std::size_t most_elements = 1 << 18;  // each use of one counts

int line_at(std::string_view text, std::ptrdiff_t offset) {
  if (offset < 0) return 0;
  const std::size_t end = std::min(std::size_t(offset), text.size());
  return 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(end), '\n'));
}

std::string label_of(const pugi::xml_node& element) {
  const std::string label = element.attribute("inkscape:label").value();
  return label.empty() ? element.attribute("id").value() : label;
}

/// What an element takes from those around it.
struct Surroundings {
  Affine2d transform = Affine2d::Identity();
  std::string layer;
  bool visible = true;
  int depth = 0;
};

/// Walks through a document and gathers what it draws.
class SvgReader {
 public:
  SvgReader(std::string_view text, const std::string& file, const pugi::xml_node& root)
      : text_(text), file_(file), root_(root), hidden_(root) {}

  model::Drawing read() {
    at_element(root_, [this] {
      const SvgViewport viewport = svg_viewport(root_);
      // Units of the viewBox, or nearly so where it is stretched in one direction only.
      const double scale = viewport.to_pixels.linear()(0, 0);
      drawing_.unit_mm = viewport.physical ? scale * svg_pixel_mm : 0.0;
      Affine2d transform = Affine2d::Identity();
      transform.linear() = viewport.to_pixels.linear() / scale;
      // The file's y points down.
      Surroundings around;
      around.transform = Eigen::Scaling(1.0, -1.0) * transform * own_transform(root_);
      read_children(root_, around);
    });
    drawing_.y_down = true;
    return std::move(drawing_);
  }

 private:
  template <typename Work>
  void at_element(const pugi::xml_node& element, const Work& work) const {
    try {
      work();
    } catch (const std::invalid_argument& error) {
      std::string subject = svg_name(element);
      const std::string label = label_of(element);
      if (!label.empty()) subject += " " + shown_word(label);
      fail(element, subject + ": " + error.what() + ".");
    }
  }

  [[noreturn]] void fail(const pugi::xml_node& element, const std::string& sentence) const {
    throw InputError(file_, line_at(text_, element.offset_debug()), "", sentence);
  }

  static Affine2d own_transform(const pugi::xml_node& element) {
    if (!svg_property(element, "transform-origin").empty())
      throw std::invalid_argument(
          "transform-origin is not read; use the attribute transform alone");
    return svg_transform(svg_property(element, "transform"));
  }

  void read_children(const pugi::xml_node& element, const Surroundings& around) {
    for (const pugi::xml_node& child : element.children())
      if (child.type() == pugi::node_element) read_element(child, around);
  }

  void read_element(const pugi::xml_node& element, const Surroundings& around) {
    if (hidden_.is_hidden(element)) return;
    if (around.depth > deepest)
      fail(element, "elements lie over " + std::to_string(deepest) + " deep within each other.");
    if (++elements_ > most_elements)
      fail(element, "there are over " + std::to_string(most_elements) + " elements.");
    at_element(element, [&] {
      Surroundings own = around;
      ++own.depth;
      const std::string visibility = svg_property(element, "visibility");
      if (!visibility.empty()) own.visible = visibility == "visible" || visibility == "inherit";
      const std::string name = svg_name(element);
      own.transform = around.transform * own_transform(element);
      if (is_svg_shape(name)) return add_shape(element, name, own);
      if (name == "use") return read_use(element, own);
      if (name == "svg") own.transform = own.transform * svg_viewport(element).to_pixels;
      constexpr std::array<std::string_view, 4> holders{"g", "a", "switch", "svg"};
      if (std::find(holders.begin(), holders.end(), name) == holders.end()) return;
      read_group(element, own);
    });
  }

  void read_group(const pugi::xml_node& element, Surroundings& own) {
    const std::string label = label_of(element);
    if (!label.empty()) own.layer += (own.layer.empty() ? "" : "/") + label;
    read_children(element, own);
  }

  void read_use(const pugi::xml_node& element, Surroundings& own) {
    std::string_view target = element.attribute("href").value();
    if (target.empty()) target = element.attribute("xlink:href").value();
    if (!target.starts_with('#')) throw std::invalid_argument("it refers to nothing in this file");
    const pugi::xml_node found = element_of(std::string(target.substr(1)));
    if (found.empty())
      throw std::invalid_argument("there is no element " + shown_word(target.substr(1)));
    const auto offset = [&element](const char* name) {
      const std::string_view text = element.attribute(name).value();
      return text.empty() ? 0.0 : svg_length(text).pixels;
    };
    own.transform = own.transform * Eigen::Translation2d(offset("x"), offset("y"));
    if (svg_name(found) != "symbol") return read_element(found, own);
    if (!found.attribute("viewBox").empty())
      throw std::invalid_argument("it refers to a symbol with a viewBox, which is not read");
    read_group(found, own);
  }

  pugi::xml_node element_of(const std::string& id) {
    if (!ids_) {
      ids_.emplace();
      for (pugi::xml_node node = root_; node; node = next_in_document(node))
        if (const pugi::xml_attribute found = node.attribute("id"))
          ids_->emplace(found.value(), node);
    }
    const auto found = ids_->find(id);
    return found == ids_->end() ? pugi::xml_node() : found->second;
  }

  // The node behind this one as the file is read, without recursion.
  pugi::xml_node next_in_document(pugi::xml_node node) const {
    if (node.first_child()) return node.first_child();
    while (node && node != root_ && !node.next_sibling()) node = node.parent();
    return node == root_ ? pugi::xml_node() : node.next_sibling();
  }

  void add_shape(const pugi::xml_node& element, const std::string& name, const Surroundings& own) {
    if (!own.visible) return;
    for (model::DrawnPath& path : svg_shape(element, name)) {
      path.name = label_of(element);
      path.layer = own.layer;
      segments_ += path.segments.size();
      if (segments_ > most_drawn_segments) throw std::invalid_argument("the file draws too much");
      for (model::CubicSegment& segment : path.segments)
        for (Vector2d& point : segment.points) point = placed(own.transform * point);
      drawing_.paths.push_back(std::move(path));
    }
  }

  static Vector2d placed(const Vector2d& point) {
    if (!(point.cwiseAbs().maxCoeff() <= largest_drawn_coordinate) || !point.allFinite())
      throw std::invalid_argument("it is drawn beyond all bounds, at coordinates over 1e9");
    return point;
  }

  std::string_view text_;
  std::string file_;
  pugi::xml_node root_;
  SvgHidden hidden_;
  model::Drawing drawing_;
  std::optional<std::map<std::string, pugi::xml_node>> ids_;
  std::size_t elements_ = 0, segments_ = 0;
};

}  // namespace

model::Drawing read_drawing_svg_text(std::string_view text, const std::string& name) {
  if (text.starts_with("\x1f\x8b"))
    throw InputError(name, 0, "", "is compressed; save it as plain SVG.");
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result) {
    std::string why = result.description();
    if (why.ends_with('.')) why.pop_back();
    throw InputError(name, line_at(text, result.offset), "",
                     "is not well-formed XML: " + why + ".");
  }
  const pugi::xml_node root = document.document_element();
  if (svg_name(root) != "svg")
    throw InputError(name, 0, "", "is no SVG file: its outermost element is not svg.");
  return SvgReader(text, name, root).read();
}

model::Drawing read_drawing_svg(const std::filesystem::path& path) {
  return read_drawing_svg_text(drawing_text(path), path.string());
}

}  // namespace bodyline::io
