#include "io/model_file_warnings.hpp"

#include "io/model_file_names.hpp"
#include "model/basis.hpp"

namespace bodyline::io {

void append_warnings(const ModelFile& file, const model::Model& model,
                     std::vector<Warning>& warnings) {
  for (const model::Patch& patch : model.patches) {
    for (const bool along_u : {true, false}) {
      const std::vector<double>& shape = along_u ? patch.shape_u : patch.shape_v;
      const model::GeBezierBasis basis(static_cast<int>(shape.size()) + 1);
      for (std::size_t k = 0; k < shape.size(); ++k) {
        const auto [lower, upper] = basis.shape_range(static_cast<int>(k));
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
