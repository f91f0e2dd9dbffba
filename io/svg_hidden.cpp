#include "io/svg_hidden.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>

namespace bodyline::io {
namespace {

std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\f";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == text.npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(blanks) - begin + 1));
}

std::vector<std::string> parted(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(trimmed(part));
  return parts;
}

// The value of a property in a list such as "fill: none; display:inline"; the last one counts.
std::string declared(const std::string& declarations, const std::string& property) {
  std::string value;
  for (const std::string& declaration : parted(declarations, ';')) {
    const std::size_t colon = declaration.find(':');
    if (colon == declaration.npos || trimmed(declaration.substr(0, colon)) != property) continue;
    value = trimmed(declaration.substr(colon + 1));
    const std::size_t important = value.find('!');
    if (important != value.npos) value = trimmed(value.substr(0, important));
  }
  return value;
}

void add_hiding(const std::string& sheet, std::vector<std::string>& selectors) {
  std::size_t begin = 0;
  while (true) {
    const std::size_t open = sheet.find('{', begin), close = sheet.find('}', open);
    if (close == sheet.npos) return;
    if (declared(sheet.substr(open + 1, close - open - 1), "display") == "none") {
      for (std::string& selector : parted(sheet.substr(begin, open - begin), ','))
        selectors.push_back(std::move(selector));
    }
    begin = close + 1;
  }
}

}  // namespace

SvgHidden::SvgHidden(const pugi::xml_node& root) {
  for (const pugi::xml_node& child : root.children()) {
    const std::string name = svg_name(child);
    if (name == "style") add_hiding(child.child_value(), selectors_);
    if (name != "defs") continue;
    for (const pugi::xml_node& inner : child.children())
      if (svg_name(inner) == "style") add_hiding(inner.child_value(), selectors_);
  }
}

bool SvgHidden::is_hidden(const pugi::xml_node& element) const {
  const std::string own = svg_property(element, "display");
  if (!own.empty()) return own == "none";
  if (selectors_.empty()) return false;
  std::vector<std::string> names{svg_name(element),
                                 "#" + std::string(element.attribute("id").value())};
  for (const std::string& name : parted(element.attribute("class").value(), ' '))
    names.push_back("." + name);
  return std::any_of(names.begin(), names.end(), [this](const std::string& name) {
    return std::find(selectors_.begin(), selectors_.end(), name) != selectors_.end();
  });
}

std::string svg_property(const pugi::xml_node& element, const std::string& property) {
  const std::string styled = declared(element.attribute("style").value(), property);
  return styled.empty() ? element.attribute(property.c_str()).value() : styled;
}

std::string svg_name(const pugi::xml_node& element) {
  const std::string name = element.name();
  const std::size_t colon = name.find(':');
  if (colon == name.npos) return name;
  return name.substr(0, colon) == "svg" ? name.substr(colon + 1) : name;
}

}  // namespace bodyline::io
