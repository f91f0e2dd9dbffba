#include "io/model_file_warnings.hpp"

#include <algorithm>
#include <array>

#include "io/model_file_names.hpp"

namespace bodyline::io {
namespace {

double binomial(int n, int k) {
  double result = 1.0;
  for (int i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
  return result;
}

/// Range of shape value k in which the GE-Bezier basis of a degree is positive.
std::array<double, 2> positive_range(int degree, int k) {
  const int mirrored = std::min(k, degree - 2 - k);
  const double upper = binomial(degree - 1, mirrored);
  if (degree % 2 == 0 && k == degree / 2 - 1) return {0.0, upper};
  return {-binomial(degree - 1, mirrored + 1), upper};
}

}  // namespace

void append_warnings(const ModelFile& file, const model::Model& model,
                     std::vector<Warning>& warnings) {
  for (const model::Patch& patch : model.patches) {
    for (const bool along_u : {true, false}) {
      const std::vector<double>& shape = along_u ? patch.shape_u : patch.shape_v;
      const int degree = static_cast<int>(shape.size()) + 1;
      for (std::size_t k = 0; k < shape.size(); ++k) {
        const auto [lower, upper] = positive_range(degree, static_cast<int>(k));
        if (shape[k] >= lower && shape[k] <= upper) continue;
        const std::string key = "patches." + patch.name + ".shape." + (along_u ? "u" : "v") + "[" +
                                std::to_string(k) + "]";
        warnings.push_back({file.name(), file.line_of(key), key,
                            "is " + shortest(shape[k]) + "; the basis is positive only for " +
                                shortest(lower) + " to " + shortest(upper) + "."});
      }
    }
  }
}

}  // namespace bodyline::io
