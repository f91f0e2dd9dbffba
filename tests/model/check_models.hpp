#pragma once

#include <array>
#include <random>
#include <string>

#include "model/check_body.hpp"
#include "model/model.hpp"

/// Models that the tests of the check build and look at.
namespace bodyline::testing {

inline constexpr std::array<const char*, 3> car_names{"template", "model1", "model2"};

model::Model load_car(const std::string& name);

/// A car with every independent variable moved at random: curve points by up to 8 mm, all others
/// within ranges that keep the body buildable.
model::Model perturbed_car(const std::string& name, std::mt19937& random);

/// Gives a patch another family, with shape parameters at random in its range for bodies, symmetric
/// on a central patch.
void set_family(model::Model& car, const std::string& patch, const std::string& family,
                std::mt19937& random);

/// A car with patches of every family: next to each other, at the uncut joint, at the seams (whose
/// other patches are raised), and across the middle.
model::Model car_of_families(const std::string& name, std::mt19937& random);

/// A closed box: four central patches in a ring (front, top, rear, bottom), one left side and its
/// image; eight corners of three joints. Degrees 2 to 5, curves, shape, cuts, fullness, directions
/// of curves, order of joints and apexes at random.
model::Model random_box(std::mt19937& random);

/// The same box with straight edges, plain patches and cuts of 0.1: 2000 x 1600 x 1000 mm.
model::Model plain_box();

/// The edge of that name and kind at that stage. Throws std::out_of_range when there is none.
const model::EdgeCheck& edge_of(const model::BodyCheck& check, const std::string& name,
                                model::EdgeKind kind, model::Stage stage);

/// The face of that name at that stage. Throws std::out_of_range when there is none.
const model::FaceCheck& face_of(const model::BodyCheck& check, const std::string& name,
                                model::Stage stage);

}  // namespace bodyline::testing
