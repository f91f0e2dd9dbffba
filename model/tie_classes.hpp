#pragma once

#include <vector>

namespace bodyline::model {

/// Union-find with signs over members 0 to count - 1: which follow which, and which cannot move at
/// all.
class TieClasses {
 public:
  explicit TieClasses(int count);

  struct Place {
    int root = -1;  ///< the lowest member of the class
    double factor = 1.0;
    bool fixed = false;
  };

  /// b follows a with the given factor, 1 or -1 (and any offset).
  void tie(int a, int b, double factor);
  void fix(int member);
  Place place(int member) const;

 private:
  std::vector<int> parent_;
  std::vector<double> factor_;  ///< to the parent
  std::vector<char> fixed_;     ///< of roots
};

}  // namespace bodyline::model
