#include "io/ply_header.hpp"

#include <array>
#include <utility>

#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

constexpr int most_header_lines = 10'000;

using TypeName = std::pair<std::string_view, ScalarType>;
constexpr std::array<TypeName, 18> type_names{{{"char", ScalarType::int8},
                                               {"uchar", ScalarType::uint8},
                                               {"short", ScalarType::int16},
                                               {"ushort", ScalarType::uint16},
                                               {"int", ScalarType::int32},
                                               {"uint", ScalarType::uint32},
                                               {"float", ScalarType::float32},
                                               {"double", ScalarType::float64},
                                               {"int8", ScalarType::int8},
                                               {"uint8", ScalarType::uint8},
                                               {"int16", ScalarType::int16},
                                               {"uint16", ScalarType::uint16},
                                               {"int32", ScalarType::int32},
                                               {"uint32", ScalarType::uint32},
                                               {"int64", ScalarType::int64},
                                               {"uint64", ScalarType::uint64},
                                               {"float32", ScalarType::float32},
                                               {"float64", ScalarType::float64}}};

ScalarType type_from_word(const ScanInput& input, std::string_view word) {
  for (const auto& [name, type] : type_names) {
    if (name == word) return type;
  }
  input.fail_line(shown_word(word) + " is not a type of numbers in a PLY file.");
}

void read_format(const ScanInput& input, std::string_view rest, PlyHeader& header) {
  const std::string_view format = next_word(rest);
  header.ascii = format == "ascii";
  header.order = format == "binary_big_endian" ? ByteOrder::big : ByteOrder::little;
  if (header.ascii || header.order == ByteOrder::big || format == "binary_little_endian") return;
  input.fail_line(shown_word(format) + " is not a format of PLY files; those are ascii, " +
                  "binary_little_endian and binary_big_endian.");
}

PlyElement element_from_words(const ScanInput& input, std::string_view rest) {
  PlyElement element;
  element.name = next_word(rest);
  const std::string_view count = next_word(rest);
  if (element.name.empty() || !whole_from_word(count, element.count)) {
    input.fail_line("an element needs a name and a count, but the count is " + shown_word(count) +
                    ".");
  }
  return element;
}

PlyProperty property_from_words(const ScanInput& input, std::string_view rest) {
  PlyProperty property;
  std::string_view type = next_word(rest);
  if (type == "list") {
    property.length_type = type_from_word(input, next_word(rest));
    type = next_word(rest);
  }
  property.type = type_from_word(input, type);
  property.name = next_word(rest);
  if (property.name.empty()) input.fail_line("the property has no name.");
  return property;
}

// Elements that take no space would be counted without end.
void check_elements(const ScanInput& input, const PlyHeader& header) {
  for (const PlyElement& element : header.elements) {
    if (!element.properties.empty() || element.count == 0) continue;
    input.fail("its element " + shown_word(element.name) + " has no properties.");
  }
}

}  // namespace

int PlyElement::find(const std::string& property, bool list) const {
  for (std::size_t k = 0; k < properties.size(); ++k) {
    if (properties[k].name == property && properties[k].length_type.has_value() == list) {
      return static_cast<int>(k);
    }
  }
  return -1;
}

const PlyElement* PlyHeader::find(const std::string& element) const {
  for (const PlyElement& known : elements) {
    if (known.name == element) return &known;
  }
  return nullptr;
}

PlyHeader read_ply_header(ScanInput& input) {
  PlyHeader header;
  std::string_view line;
  if (!input.line(line) || next_word(line) != "ply") {
    input.fail("is not a PLY file: its first line is not \"ply\".");
  }
  for (int lines = 0; lines < most_header_lines && input.line(line); ++lines) {
    const std::string_view keyword = next_word(line);
    if (keyword == "end_header") {
      check_elements(input, header);
      return header;
    }
    if (keyword == "format") {
      read_format(input, line, header);
    } else if (keyword == "element") {
      header.elements.push_back(element_from_words(input, line));
    } else if (keyword == "property") {
      if (header.elements.empty()) input.fail_line("a property stands before any element.");
      header.elements.back().properties.push_back(property_from_words(input, line));
    } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
      input.fail_line(shown_word(keyword) + " is not known in the head of a PLY file.");
    }
  }
  input.fail("its head does not end: there is no line \"end_header\".");
}

}  // namespace bodyline::io
