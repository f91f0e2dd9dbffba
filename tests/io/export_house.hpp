#pragma once

#include <vector>

#include "model/surface.hpp"

namespace bodyline::test {

/// A closed body of nine faces that has one of everything an exporter meets: a box with bulging
/// faces and a roof of four three-sided faces over one apex. Degrees 3 and 6 meet along shared
/// curves, parameters run in all directions, some normals point inwards, and the face "front" has a
/// Gregory term. About 1 m in size; "floor" comes last.
std::vector<model::Surface> make_house(unsigned seed = 1);

/// The same without its floor: four free edges.
std::vector<model::Surface> make_open_house(unsigned seed = 1);

/// Volume inside a closed body by the divergence theorem, mm^3.
double enclosed_volume(const std::vector<model::Surface>& surfaces);

}  // namespace bodyline::test
