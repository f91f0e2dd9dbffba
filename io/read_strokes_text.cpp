#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "io/decimal_commas.hpp"
#include "io/read_strokes_formats.hpp"
#include "io/scan_input.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\"");
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\"") - begin + 1);
}

// The columns of a line: parted by commas, semicolons or tabs where it has any, by blanks else.
std::vector<std::string_view> columns_of(std::string_view line) {
  std::vector<std::string_view> columns;
  const char* const separators = line.find_first_of(",;\t") == line.npos ? " \t\r" : ",;\t";
  const bool blanks = separators[0] == ' ';
  while (true) {
    const std::size_t end = line.find_first_of(separators);
    const std::string_view column = trimmed(line.substr(0, end));
    if (!blanks || !column.empty()) columns.push_back(column);
    if (end == line.npos) return columns;
    line.remove_prefix(end + 1);
  }
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Which columns hold what.
struct Layout {
  std::array<std::size_t, 3> coordinate{0, 1, 2};
  std::optional<std::size_t> name;
};

bool is_number(std::string_view word) {
  double ignored = 0.0;
  return number_from_word(word, ignored);
}

// A heading names columns; without one three columns are x y z, and four a name before them.
std::optional<Layout> layout_of_heading(const std::vector<std::string_view>& columns) {
  Layout layout;
  std::array<bool, 3> found{};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::string word = lower(columns[k]);
    for (std::size_t c = 0; c < 3; ++c) {
      if (word != std::string(1, static_cast<char>('x' + c))) continue;
      layout.coordinate[c] = k;
      found[c] = true;
    }
    if (word == "stroke" || word == "name" || word == "curve" || word == "id") layout.name = k;
  }
  if (found[0] && found[1] && found[2]) return layout;
  return std::nullopt;
}

Layout layout_of_points(const std::vector<std::string_view>& columns) {
  if (columns.size() < 4) return {};
  return {{1, 2, 3}, 0};
}

}  // namespace

std::vector<model::Stroke> read_strokes_text(const std::filesystem::path& path) {
  ScanInput input(path);
  std::vector<model::Stroke> strokes;
  std::optional<Layout> layout;
  bool apart = true;  // the next point begins a stroke
  std::string_view line;
  DecimalCommas commas({3, true});
  while (input.line(line)) {
    const std::string_view text = trimmed(line);
    if (text.empty()) apart = true;
    if (text.empty() || text.starts_with('#')) continue;
    const std::optional<std::string_view> clear = commas.with_points(line);
    if (!clear) input.fail_line(unclear_commas(text) + ".");
    const std::vector<std::string_view> columns = columns_of(*clear);
    if (!layout) {
      layout = layout_of_heading(columns);
      if (layout) continue;
      layout = layout_of_points(columns);
    }
    Eigen::Vector3d point;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = layout->coordinate[c];
      const std::string_view word = at < columns.size() ? columns[at] : std::string_view();
      if (!is_number(word) || !number_from_word(word, point[static_cast<int>(c)]))
        input.fail_line(fmt::format("{} is no coordinate: a point takes x, y and z{}.",
                                    shown_word(word), layout->name ? " and its stroke" : ""));
    }
    const std::string name =
        layout->name && *layout->name < columns.size() ? std::string(columns[*layout->name]) : "";
    if (apart || strokes.back().name != name) strokes.push_back({name, {}});
    strokes.back().points.push_back(point);
    apart = false;
  }
  return strokes;
}

}  // namespace bodyline::io
