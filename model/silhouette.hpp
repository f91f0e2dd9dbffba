#pragma once

#include <vector>

#include "model/model.hpp"
#include "model/silhouette_curves.hpp"

namespace bodyline::model {

struct SilhouetteOptions {
  double spacing = 10.0;  ///< of the points in the picture, about, mm
  double cell = 60.0;     ///< of the grids on which contours are looked for, about, mm
  int mask_cells = 600;   ///< along the picture's longer side, to tell what is outside
};

/// The body of a plan and nets, or of a model, to be looked at. Throws ModelError when the model
/// cannot be built.
SilhouetteBody silhouette_body(const BodyPlan& plan, Stage stage, const double* nets);
SilhouetteBody silhouette_body(const Model& model, Stage stage);

/// The silhouette of a whole body in a view, its left half (y <= 0): the outer boundary of its
/// parallel picture, that is what borders the open around it. Contours, rims and (at stage base)
/// creases, cut where others hide them; holes all around which there is body are not part of it,
/// wheel arches are, being open below. A point's normal points into the open.
std::vector<SilhouetteCurve> silhouette(const SilhouetteBody& body, View view,
                                        const SilhouetteOptions& options = {});

}  // namespace bodyline::model
