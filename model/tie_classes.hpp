#pragma once

#include <vector>

namespace bodyline::model {

/// Union-find over parameters with signs: which follow which, and which cannot move at all.
class TieClasses {
 public:
  explicit TieClasses(int count);

  struct Place {
    int root = -1;  ///< the lowest parameter of the class
    double factor = 1.0;
    bool fixed = false;
  };

  /// b follows a with the given factor, 1 or -1 (and any offset).
  void tie(int a, int b, double factor);
  void fix(int parameter);
  Place place(int parameter) const;

 private:
  std::vector<int> parent_;
  std::vector<double> factor_;  ///< to the parent
  std::vector<char> fixed_;     ///< of roots
};

}  // namespace bodyline::model
