#include "io/read_polylines.hpp"

#include <optional>
#include <string>
#include <string_view>

#include "io/decimal_commas.hpp"
#include "io/drawing_limits.hpp"
#include "io/drawing_text.hpp"
#include "io/input_error.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

using Eigen::Vector3d;

/// Gathers the points of a file into lines.
class PolylineReader {
 public:
  explicit PolylineReader(std::string file) : file_(std::move(file)) {}

  void take(std::string_view text) {
    ++line_;
    const std::size_t comment = text.find('#');
    std::string_view rest = text.substr(0, comment);
    if (std::string_view blank = rest; next_word(blank).empty()) {
      if (comment == text.npos) finish();
      return;
    }
    Vector3d point;
    const std::optional<std::string_view> clear = commas_.with_points(rest);
    if (!clear) fail(unclear_commas(rest) + ".");
    std::string_view words = *clear;
    for (int axis = 0; axis < 3; ++axis) {
      if (!number_from_word(next_word(words), point[axis])) return pass_heading(rest);
    }
    if (!next_word(words).empty()) fail("a point is x y z; there is more.");
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > largest_drawn_coordinate)
      fail("coordinates are finite numbers up to 1e9.");
    if (++count_ > most_drawn_segments)
      fail("there are over " + std::to_string(most_drawn_segments) + " points.");
    polyline_.push_back(point);
  }

  std::vector<std::vector<Vector3d>> result() {
    finish();
    if (polylines_.empty()) throw InputError(file_, 0, "", "has no points.");
    return std::move(polylines_);
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) const {
    throw InputError(file_, line_, "", sentence);
  }

  void pass_heading(std::string_view text) {
    if (heading_ || count_ > 0) fail(shown_word(text) + " is no point x y z.");
    heading_ = true;
  }

  void finish() {
    if (polyline_.size() == 1) fail("ends a line of a single point; a line takes two or more.");
    if (!polyline_.empty()) polylines_.push_back(std::move(polyline_));
    polyline_ = {};
  }

  std::string file_;
  std::vector<std::vector<Vector3d>> polylines_;
  std::vector<Vector3d> polyline_;
  std::size_t count_ = 0;
  DecimalCommas commas_{{3, false}};
  int line_ = 0;
  bool heading_ = false;
};

}  // namespace

std::vector<std::vector<Vector3d>> read_polylines(const std::filesystem::path& path) {
  const std::string text = drawing_text(path);
  std::string_view rest = text;
  if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);  // some editors mark UTF-8 so
  PolylineReader reader(path.string());
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    reader.take(rest.substr(0, end));
    rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
  }
  return reader.result();
}

}  // namespace bodyline::io
