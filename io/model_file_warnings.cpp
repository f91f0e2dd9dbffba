#include "io/model_file_warnings.hpp"

#include "model/connect.hpp"
#include "model/family.hpp"
#include "model/number_text.hpp"

namespace bodyline::io {

void append_warnings(const ModelFile& file, const model::Model& model,
                     std::vector<Warning>& warnings) {
  for (const model::Patch& patch : model.patches) {
    for (const bool along_u : {true, false}) {
      const std::vector<double>& shape = along_u ? patch.shape_u : patch.shape_v;
      const model::Side side = along_u ? model::Side::v0 : model::Side::u0;
      const auto basis = model::family(patch.basis, model::side_degree(model, patch, side));
      for (std::size_t k = 0; k < shape.size(); ++k) {
        const auto [lower, upper] = basis->shape_range(static_cast<int>(k) % basis->shape_count());
        if (shape[k] >= lower && shape[k] <= upper) continue;
        const std::string key = "patches." + patch.name + ".shape." + (along_u ? "u" : "v") + "[" +
                                std::to_string(k) + "]";
        warnings.push_back({file.name(), file.line_of(key), key,
                            "is " + model::number_text(shape[k]) +
                                "; the basis is positive only for " + model::number_text(lower) +
                                " to " + model::number_text(upper) + "."});
      }
    }
  }
}

}  // namespace bodyline::io
