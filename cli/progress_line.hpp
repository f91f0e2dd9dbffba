#pragma once

#include <string>

namespace bodyline::cli {

/// What is known of a piece of work.
struct ProgressState {
  std::string work;        ///< "rendering car.png"
  double fraction = -1.0;  ///< done, 0 to 1; negative when not known
  std::string detail;      ///< "bending 12.3", may be empty
};

/// The text of a progress line, without a line end, at most `columns` characters of ASCII.
std::string progress_line(const ProgressState& state, double seconds, int columns);

}  // namespace bodyline::cli
