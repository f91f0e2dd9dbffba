#include "io/read_drawing_csv.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "io/decimal_commas.hpp"
#include "io/drawing_limits.hpp"
#include "io/drawing_text.hpp"
#include "io/input_error.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

using Eigen::Vector2d;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\f\v,;\"";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// Gathers the points of a file into paths.
class PolylineReader {
 public:
  explicit PolylineReader(const std::string& file) : file_(file) {}

  void take(std::string_view line) {
    ++line_;
    const std::size_t comment = line.find('#');
    line = line.substr(0, comment);
    if (trimmed(line).empty()) {
      if (comment == line.npos) finish();
      return;
    }
    Vector2d point;
    const std::optional<std::string_view> clear = commas_.with_points(line);
    if (!clear) fail(unclear_commas(trimmed(line)));
    std::string_view rest = *clear;
    if (!number_from_word(next_word(rest), point.x()) ||
        !number_from_word(next_word(rest), point.y()))
      return pass_heading(line);
    if (!(point.cwiseAbs().maxCoeff() <= largest_drawn_coordinate))
      fail("coordinates are finite numbers up to 1e9");
    add(point, std::string(trimmed(rest)));
  }

  model::Drawing result() {
    finish();
    return std::move(drawing_);
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) const {
    throw InputError(file_, line_, "", sentence + ".");
  }

  void pass_heading(std::string_view line) {
    if (heading_ || count_ > 0)
      fail(shown_word(trimmed(line)) +
           " is no point: it takes two numbers x y and may have a name");
    heading_ = true;
  }

  void add(const Vector2d& point, const std::string& name) {
    if (count_ > 0 && name != path_.name) finish();
    if (++total_ > most_drawn_segments)
      fail("there are over " + std::to_string(most_drawn_segments) + " points");
    if (count_ == 0) path_.name = name;
    if (count_ > 0 && point != at_) path_.segments.push_back(model::line_segment(at_, point));
    if (count_ == 0) first_line_ = line_;
    ++count_;
    at_ = point;
  }

  void finish() {
    if (count_ == 0) return;
    if (path_.segments.empty())
      throw InputError(file_, first_line_, "",
                       "begins a line of a single point; a line takes two or more.");
    path_.closed = path_.segments.size() > 2 && at_ == path_.segments.front().points.front();
    drawing_.paths.push_back(std::move(path_));
    path_ = {};
    count_ = 0;
  }

  std::string file_;
  model::Drawing drawing_;
  model::DrawnPath path_;
  Vector2d at_{0.0, 0.0};
  std::size_t count_ = 0, total_ = 0;  // points of this path, of the file
  DecimalCommas commas_{{2, true}};
  int line_ = 0, first_line_ = 0;
  bool heading_ = false;
};

}  // namespace

model::Drawing read_drawing_csv_text(std::string_view text, const std::string& name) {
  PolylineReader reader(name);
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // some editors mark UTF-8 so
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    reader.take(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  return reader.result();
}

model::Drawing read_drawing_csv(const std::filesystem::path& path) {
  return read_drawing_csv_text(drawing_text(path), path.string());
}

}  // namespace bodyline::io
