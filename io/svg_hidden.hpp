#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

namespace bodyline::io {

/// Which elements of an SVG file are not shown: those with display: none, by attribute, by style or
/// by a style sheet with selectors of one name, .class or #id.
class SvgHidden {
 public:
  /// Gathers the style sheets of a document.
  explicit SvgHidden(const pugi::xml_node& root);

  bool is_hidden(const pugi::xml_node& element) const;

 private:
  std::vector<std::string> selectors_;  // those that hide
};

/// The value of a property in the attribute style, or the attribute of that name; may be empty.
std::string svg_property(const pugi::xml_node& element, const std::string& property);

/// The name of an element without the prefix of its namespace.
std::string svg_name(const pugi::xml_node& element);

}  // namespace bodyline::io
