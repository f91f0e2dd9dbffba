#include "io/svg_path.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "io/drawing_limits.hpp"
#include "io/scan_words.hpp"
#include "io/svg_arc.hpp"
#include "io/svg_scanner.hpp"

namespace bodyline::io {
namespace {

using Eigen::Vector2d;
using model::CubicSegment;

/// Follows the commands of a path.
class Pen {
 public:
  explicit Pen(std::string_view data) : scanner_(data) {}

  std::vector<model::DrawnPath> draw() {
    while (!scanner_.at_end()) {
      const char command = scanner_.character();
      if (begun_ || command == 'M' || command == 'm') {
        run(command);
      } else {
        throw std::invalid_argument("the path does not begin with M");
      }
    }
    finish(false);
    return std::move(paths_);
  }

 private:
  // One letter with all its groups of numbers.
  void run(char letter) {
    const char command = char(letter & ~0x20);
    relative_ = (letter & 0x20) != 0;
    if (command == 'Z') return close();
    step(command, letter);
    scanner_.skip_separator();
    while (scanner_.at_number()) {
      step(command == 'M' ? 'L' : command, letter);
      scanner_.skip_separator();
    }
  }

  void step(char command, char letter) {
    switch (command) {
      case 'M':
        return move();
      case 'L':
        return line(point());
      case 'H':
        return line({coordinate(at_.x()), at_.y()});
      case 'V':
        return line({at_.x(), coordinate(at_.y())});
      case 'C': {
        const Vector2d first = point(), second = point(), end = point();
        return cubic(first, second, end);
      }
      case 'S': {
        const Vector2d second = point(), end = point();
        return cubic(last_ == 'C' ? Vector2d(2.0 * at_ - handle_) : at_, second, end);
      }
      case 'Q': {
        const Vector2d middle = point(), end = point();
        return quadratic(middle, end);
      }
      case 'T': {
        const Vector2d end = point();
        return quadratic(last_ == 'Q' ? Vector2d(2.0 * at_ - handle_) : at_, end);
      }
      case 'A':
        return arc();
      default:
        throw std::invalid_argument(shown_word({&letter, 1}) + " is no command of a path");
    }
  }

  double coordinate(double origin) {
    scanner_.skip_separator();
    return scanner_.number() + (relative_ ? origin : 0.0);
  }

  Vector2d point() {
    const double x = coordinate(at_.x());
    return {x, coordinate(at_.y())};
  }

  void move() {
    const Vector2d to = point();
    finish(false);
    begun_ = true;
    at_ = start_ = to;
    last_ = 'M';
  }

  void line(const Vector2d& to) {
    add(model::line_segment(at_, to));
    last_ = 'L';
  }

  void cubic(const Vector2d& first, const Vector2d& second, const Vector2d& end) {
    add({{at_, first, second, end}});
    handle_ = second;
    last_ = 'C';
  }

  void quadratic(const Vector2d& middle, const Vector2d& end) {
    add({{at_, (at_ + 2.0 * middle) / 3.0, (end + 2.0 * middle) / 3.0, end}});
    handle_ = middle;
    last_ = 'Q';
  }

  void arc() {
    SvgArc shape;
    shape.radii.x() = argument();
    shape.radii.y() = argument();
    shape.rotation = argument();
    scanner_.skip_separator();
    shape.large = scanner_.flag();
    scanner_.skip_separator();
    shape.positive = scanner_.flag();
    const Vector2d to = point();
    for (const CubicSegment& segment : svg_arc(at_, shape, to)) add(segment);
    last_ = 'A';
  }

  double argument() {
    scanner_.skip_separator();
    return scanner_.number();
  }

  void close() {
    if (at_ != start_) line(start_);
    finish(true);
    last_ = 'Z';
  }

  void add(const CubicSegment& segment) {
    at_ = segment.points.back();
    const auto& p = segment.points;
    if (p[0] == p[1] && p[0] == p[2] && p[0] == p[3]) return;
    if (++count_ > most_drawn_segments)
      throw std::invalid_argument("the path has over " + std::to_string(most_drawn_segments) +
                                  " segments");
    path_.segments.push_back(segment);
  }

  void finish(bool closed) {
    path_.closed = closed;
    if (!path_.segments.empty()) paths_.push_back(std::move(path_));
    path_ = {};
  }

  SvgScanner scanner_;
  std::vector<model::DrawnPath> paths_;
  model::DrawnPath path_;
  Vector2d at_{0.0, 0.0}, start_{0.0, 0.0}, handle_{0.0, 0.0};
  char last_ = ' ';  // which command came last: S and T mirror a handle only after their own kind
  bool relative_ = false, begun_ = false;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<model::DrawnPath> svg_path(std::string_view data) { return Pen(data).draw(); }

}  // namespace bodyline::io
