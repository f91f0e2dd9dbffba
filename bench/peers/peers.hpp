#pragma once

#include <memory>

#include "bench/kernel_patch.hpp"

/// The same work done by other means, per call for all 64 nodes of the patch. Compiled for the
/// machine at hand, in a library of its own so that none of it gets into the program.
#define BODYLINE_PEER __attribute__((visibility("default")))

namespace bodyline::bench {

/// Point and derivatives to second order: out has 18 numbers per node.
constexpr int jet_numbers = 18;

/// Straightforward Eigen: tables of basis values, loops over control points of Vector3d, node by
/// node.
BODYLINE_PEER void eigen_jets(const Patch& patch, double* out);
BODYLINE_PEER void eigen_curvature(const Patch& patch, double* mean, double* gauss);
BODYLINE_PEER double eigen_bending(const Patch& patch);

/// ceres::Jet with a derivative for each of the 48 coordinates.
BODYLINE_PEER double ceres_bending_48(const Patch& patch, double* gradient);

/// ceres::Jet with a derivative for each of the 15 numbers of a node's jet; the linear map back to
/// the net by hand.
BODYLINE_PEER double ceres_bending_15(const Patch& patch, double* gradient);

/// ADOL-C: the whole patch on a tape, recorded once, then value and reverse sweep per call.
class BODYLINE_PEER AdolcBending {
 public:
  explicit AdolcBending(const Patch& patch);
  double gradient(const Patch& patch, double* gradient) const;
};

/// OpenCASCADE, one evaluation per node.
class BODYLINE_PEER OcctPatch {
 public:
  explicit OcctPatch(const Patch& patch);
  ~OcctPatch();
  void jets(const Patch& patch, double* out) const;  ///< Geom_BezierSurface::D2
  void jets_adaptor(const Patch& patch,
                    double* out) const;  ///< GeomAdaptor_Surface::D2, which caches
  void curvature(const Patch& patch, double* mean, double* gauss) const;  ///< GeomLProp_SLProps

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bodyline::bench
