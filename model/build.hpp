#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/surface.hpp"

namespace bodyline::model {

/// Which halves of the body to return.
enum class Halves { left_and_central, both };

/// The faces of a model at a stage, in the order patches, transitions, corners, each followed by
/// its mirror image where it has one. 25 faces for the template at `base` and `kept`, 77 at `body`.
/// `base` is before any seam correction. Throws ModelError when the model is not connected (see
/// connect.hpp).
std::vector<Surface> build(const Model& model, Stage stage, Halves halves = Halves::both);

}  // namespace bodyline::model
