#pragma once

#include <array>
#include <complex>
#include <vector>

#include "model/face_rule.hpp"

/// The energies of a face straight from their definitions, one node at a time, in plain scalar code
/// that shares nothing with the kernels but the quadrature nodes. Derivatives by the control points
/// come from complex steps.
namespace bodyline::test {

enum class Energy { area, bending, variation, fold };
const char* energy_name(Energy energy);

/// A face as the kernels take it.
struct Face {
  const model::FaceTables* tables = nullptr;
  std::vector<double> net;
  std::array<double, 3> blend{};
};

double reference_energy(const Face& face, Energy energy);

/// Derivatives by the net's numbers, then by the three of the blend coefficient where the face has
/// one.
std::vector<double> reference_gradient(const Face& face, Energy energy);

/// All ten derivatives at all nodes, laid out like Kernels::jets, from the definition of the basis
/// functions.
std::vector<double> reference_jets(const Face& face);

/// Mean and Gauss curvature at one node of reference_jets.
std::array<double, 2> reference_curvature(const std::vector<double>& jets, int nodes, int kv,
                                          int ku);

}  // namespace bodyline::test
