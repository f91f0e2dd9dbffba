#include "io/write_svg_drawing.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "model/number_text.hpp"

namespace bodyline::io {
namespace {

using Eigen::Vector2d;
using model::number_text;

std::string point_text(const Vector2d& point) {
  return number_text(point.x()) + ',' + number_text(0.0 - point.y());
}

bool is_line(const model::CubicSegment& segment) {
  return model::line_segment(segment.points[0], segment.points[3]).points == segment.points;
}

std::string path_data(const model::DrawnPath& path) {
  std::string data;
  for (const model::CubicSegment& segment : path.segments) {
    const auto& p = segment.points;
    if (data.empty()) data = "M " + point_text(p[0]);
    if (is_line(segment)) {
      data += " L " + point_text(p[3]);
    } else {
      data += " C " + point_text(p[1]) + ' ' + point_text(p[2]) + ' ' + point_text(p[3]);
    }
  }
  return path.closed ? data + " Z" : data;
}

/// Makes elements of a document whose identifiers are unique.
class SvgWriter {
 public:
  SvgWriter(const model::Drawing& drawing, const SvgDrawingOptions& options)
      : drawing_(drawing), options_(options) {}

  std::string text() {
    begin();
    for (const model::DrawnPath& path : drawing_.paths) add_path(path);
    for (const SvgText& text : options_.texts) add_text(text);
    std::ostringstream stream;
    document_.save(stream, "  ");
    return stream.str();
  }

 private:
  void begin() {
    const double unit = drawing_.unit_mm > 0.0 ? drawing_.unit_mm : 1.0;
    Eigen::AlignedBox2d box = model::drawn_box(drawing_.paths);
    if (box.isEmpty()) box.extend(Vector2d(0.0, 0.0));
    const Vector2d size = box.sizes() + Vector2d::Constant(2.0 * options_.margin);
    root_ = document_.append_child("svg");
    set(root_, "xmlns", "http://www.w3.org/2000/svg");
    set(root_, "xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
    set(root_, "xmlns:sodipodi", "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd");
    set(root_, "version", "1.1");
    set(root_, "width", number_text(unit * size.x()) + "mm");
    set(root_, "height", number_text(unit * size.y()) + "mm");
    set(root_, "viewBox",
        number_text(box.min().x() - options_.margin) + ' ' +
            number_text(-box.max().y() - options_.margin) + ' ' + number_text(size.x()) + ' ' +
            number_text(size.y()));
    pugi::xml_node view = root_.append_child("sodipodi:namedview");
    set(view, "id", identifier("view"));
    set(view, "inkscape:document-units", "mm");
  }

  static void set(pugi::xml_node element, const char* name, const std::string& value) {
    element.append_attribute(name).set_value(value.c_str());
  }

  // The name with only letters, digits, '_', '-' and '.', and a number where it is taken.
  std::string identifier(const std::string& name) {
    std::string plain = name;
    for (char& c : plain)
      if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-' && c != '.') c = '_';
    if (plain.empty() || !std::isalpha(static_cast<unsigned char>(plain.front())))
      plain = "x" + plain;
    std::string id = plain;
    for (int k = 2; !identifiers_.insert(id).second; ++k) id = plain + "-" + std::to_string(k);
    return id;
  }

  // The group of a layer such as "side/left", made when there is none yet.
  pugi::xml_node layer_group(const std::string& layer) {
    pugi::xml_node group = root_;
    for (std::size_t begin = 0; begin < layer.size();) {
      const std::size_t end = std::min(layer.find('/', begin), layer.size());
      const std::string name = layer.substr(begin, end - begin);
      const auto found = group.find_child([&name](const pugi::xml_node& child) {
        return child.attribute("inkscape:groupmode") &&
               name == child.attribute("inkscape:label").value();
      });
      group = found ? found : new_layer(group, name, layer.substr(0, end));
      begin = end + 1;
    }
    return group;
  }

  pugi::xml_node new_layer(pugi::xml_node parent, const std::string& name,
                           const std::string& layer) {
    pugi::xml_node group = parent.append_child("g");
    set(group, "inkscape:groupmode", "layer");
    set(group, "inkscape:label", name);
    set(group, "id", identifier("layer-" + name));
    const auto& locked = options_.locked;
    if (std::find(locked.begin(), locked.end(), layer) != locked.end())
      set(group, "sodipodi:insensitive", "true");
    return group;
  }

  void add_path(const model::DrawnPath& path) {
    pugi::xml_node element = layer_group(path.layer).append_child("path");
    const SvgStyle style = options_.style ? options_.style(path) : SvgStyle{};
    if (!path.name.empty()) {
      set(element, "id", identifier(path.name));
      set(element, "inkscape:label", path.name);
    }
    set(element, "style",
        "fill:none;stroke:" + style.color + ";stroke-width:" + number_text(style.width) +
            ";stroke-linejoin:round");
    set(element, "d", path_data(path));
  }

  void add_text(const SvgText& text) {
    pugi::xml_node element = layer_group(text.layer).append_child("text");
    set(element, "x", number_text(text.at.x()));
    set(element, "y", number_text(-text.at.y()));
    set(element, "style",
        "font-family:sans-serif;fill:#606060;font-size:" + number_text(text.size) + "px");
    element.text().set(text.text.c_str());
  }

  const model::Drawing& drawing_;
  const SvgDrawingOptions& options_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  std::set<std::string> identifiers_;
};

}  // namespace

std::string svg_drawing(const model::Drawing& drawing, const SvgDrawingOptions& options) {
  return SvgWriter(drawing, options).text();
}

void write_svg_drawing(const model::Drawing& drawing, const std::filesystem::path& path,
                       const SvgDrawingOptions& options, Overwrite overwrite) {
  write_file(path, svg_drawing(drawing, options), overwrite);
}

}  // namespace bodyline::io
