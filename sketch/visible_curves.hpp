#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/view.hpp"

namespace bodyline::sketch {

/// For each curve of a model the views in which it should be drawn: those that see a patch beside
/// it, and, where no two of them tell its shape in space, the pair of views that does so best.
std::vector<std::vector<model::View>> visible_curves(const model::Model& model);

}  // namespace bodyline::sketch
