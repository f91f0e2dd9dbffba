#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/build.hpp"
#include "model/surface.hpp"

/// Sizes and energies of faces and of whole bodies.
namespace bodyline::model {

/// Gauss nodes per direction where nothing else is said; with them the area and the energies of a
/// car's patches are exact to about 1e-8.
inline constexpr int measure_nodes = 24;

/// Integrals over one face (all of it; of a central face the left half is computed and doubled).
struct FaceIntegrals {
  double area_mm2 = 0.0;
  double bending = 0.0;            ///< of k1^2 + k2^2; no unit
  double variation_per_mm2 = 0.0;  ///< of |grad_S H|^2
};
FaceIntegrals face_integrals(const Surface& surface, int nodes = measure_nodes);

/// Area of one face, mm^2.
double face_area(const Surface& surface);

/// Integral of the normals S_u x S_v over one face, mm^2. Depends on the face's boundary only.
Eigen::Vector3d vector_area(const Surface& surface);

/// How often a face of a list counts in the whole body: twice when the list leaves out its image.
double times_counted(const Surface& surface, Halves halves);

/// Integrals over the whole body from those over each of its faces. `faces` are those that `build`
/// returns for `halves`.
FaceIntegrals body_integrals(const std::vector<Surface>& faces,
                             const std::vector<FaceIntegrals>& of_each, Halves halves);

/// Volume between the body and the ground z = 0, mm^3: the integral of z n_z over the faces, n the
/// outward normal. Exact for a closed body, at any height. An opening in the ground or in an
/// upright plane adds nothing to the integral, so that a car that is open below and at its wheels
/// counts as if these openings were closed flat. Not meaningful at Stage::kept.
double enclosed_volume(const std::vector<Surface>& faces, Halves halves);

/// The smallest box around a body, mm: length, width and height are the sides of `size()`.
struct Box {
  Eigen::Vector3d low, high;
  Eigen::Vector3d size() const { return high - low; }
};

/// The box around the faces themselves (not their nets), to 1e-6 mm. Throws std::invalid_argument
/// when there are none.
Box bounding_box(const std::vector<Surface>& faces, Halves halves);

}  // namespace bodyline::model
