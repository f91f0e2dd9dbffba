#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace bodyline::io {

/// Which numbers the lines of a file hold.
struct LineNumbers {
  int least = 3;                      ///< so many or more in each line of a point
  bool numbers_may_be_names = false;  ///< a line may have a name, which may look like a number
};

/// Takes the decimal commas out of a file of numbers, line by line. In "1,5 2,3 0,4" and
/// "1,5;2,3;0,4" blanks or semicolons part the numbers and a comma stands for the decimal point; in
/// "1, 2, 3", "1,2,3" and "1,2,3 inside" commas part them. The first line that tells which holds
/// for the whole file. A comma can only be decimal between two digits, in a word that begins a
/// number and has no other comma and no decimal point.
class DecimalCommas {
 public:
  explicit DecimalCommas(const LineNumbers& numbers) : numbers_(numbers) {}

  /// The line with points for its decimal commas, valid until the next call; none where it cannot
  /// be told what its commas are, or where they are not what they were before.
  std::optional<std::string_view> with_points(std::string_view line);

 private:
  enum class Use { unknown, decimal, parting };
  /// What one line tells; `unknown` where it has no commas of numbers.
  struct Verdict {
    Use use = Use::unknown;
    bool clear = true;
  };
  Verdict verdict_on(std::string_view line) const;
  std::string_view replaced(std::string_view line);

  LineNumbers numbers_;
  Use use_ = Use::unknown;
  std::string buffer_;
};

/// What to say of a line for which there is no answer; ends without a full stop.
std::string unclear_commas(std::string_view line);

}  // namespace bodyline::io
