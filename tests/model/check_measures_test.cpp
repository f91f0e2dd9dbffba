#include <gtest/gtest.h>

#include <cmath>

#include "check_models.hpp"
#include "model/measures_extreme.hpp"
#include "model/measures_wheelbase.hpp"

/// Energies and sizes.
namespace bodyline::testing {
namespace {

using model::Halves;
using model::Stage;

// Half a unit of the last digit that the references are printed with.
constexpr double six_digits = 5e-7;
constexpr double variation_digits = 5e-11;
constexpr double size_mm = 1e-6;  // promised
constexpr double relative_rounding = 1e-12;

model::FaceIntegrals base_patch(const char* car, const char* patch) {
  for (const model::Surface& face : model::build(load_car(car), Stage::base)) {
    if (face.name == patch) return model::face_integrals(face);
  }
  throw std::out_of_range(patch);
}

model::FaceIntegrals whole_body(const std::vector<model::Surface>& faces, Halves halves) {
  std::vector<model::FaceIntegrals> of_each;
  for (const model::Surface& face : faces) of_each.push_back(model::face_integrals(face));
  return model::body_integrals(faces, of_each, halves);
}

TEST(Measures, EnergiesAreThoseOfTheReference) {
  EXPECT_NEAR(base_patch("model1", "hood").bending, 0.573390, six_digits);
  EXPECT_NEAR(base_patch("template", "hood").bending, 0.499187, six_digits);
  EXPECT_NEAR(base_patch("model1", "roof").bending, 0.397046, six_digits);
  EXPECT_NEAR(base_patch("model1", "hood").variation_per_mm2, 5.123e-7, variation_digits);
}

TEST(Measures, BothHalvesAreTwiceTheLeftOne) {
  const model::Model car = load_car("model2");
  for (const Stage stage : {Stage::base, Stage::body}) {
    const auto both = model::build(car, stage, Halves::both);
    const auto left = model::build(car, stage, Halves::left_and_central);
    const model::FaceIntegrals a = whole_body(both, Halves::both);
    const model::FaceIntegrals b = whole_body(left, Halves::left_and_central);
    EXPECT_NEAR(a.area_mm2, b.area_mm2, relative_rounding * a.area_mm2);
    EXPECT_NEAR(a.bending, b.bending, relative_rounding * a.bending);
    EXPECT_NEAR(a.variation_per_mm2, b.variation_per_mm2, relative_rounding * a.variation_per_mm2);
    const double volume = model::enclosed_volume(both, Halves::both);
    EXPECT_NEAR(model::enclosed_volume(left, Halves::left_and_central), volume,
                relative_rounding * volume);
    const model::Box box_a = model::bounding_box(both, Halves::both);
    const model::Box box_b = model::bounding_box(left, Halves::left_and_central);
    EXPECT_LE((box_a.low - box_b.low).norm() + (box_a.high - box_b.high).norm(), size_mm);
  }
}

TEST(Measures, ThePlainBoxHasTheSizeItIsDrawnWith) {
  constexpr double length = 2000.0, width = 1600.0, height = 1000.0;
  const model::BodyTotals totals = model::check_body(plain_box(), {Stage::base}).totals;
  EXPECT_LE((totals.box.size() - Eigen::Vector3d(length, width, height)).norm(), size_mm);
  const double area = 2.0 * (length * width + width * height + height * length);
  EXPECT_NEAR(totals.area_mm2, area, relative_rounding * area);
  const double volume = length * width * height;
  EXPECT_NEAR(totals.volume_mm3.value(), volume, relative_rounding * volume);
  EXPECT_NEAR(totals.bending, 0.0, relative_rounding);
}

TEST(Measures, AnOpenBottomOnTheGroundAddsNothingToTheVolume) {
  const model::Model car = load_car("model1");
  std::vector<model::Surface> faces = model::build(car, Stage::base);
  const double open = model::enclosed_volume(faces, Halves::both);
  model::Surface floor;
  floor.degree_u = floor.degree_v = 1;
  floor.net = {{0, -900, 0}, {0, 900, 0}, {4000, -900, 0}, {4000, 900, 0}};
  faces.push_back(floor);
  EXPECT_EQ(model::enclosed_volume(faces, Halves::both), open);
}

TEST(Measures, TheBoxTouchesTheSurfaceNotItsNet) {
  // z = 4 h u (1 - u) raised by a slope: the highest point is between the samples.
  constexpr double rise = 100.0, slope = 37.0;
  model::Surface vault;
  vault.degree_u = 2;
  vault.degree_v = 1;
  vault.net = {{0, 0, 0},
               {0, 10, 0},
               {50, 0, 2 * rise + 0.5 * slope},
               {50, 10, 2 * rise + 0.5 * slope},
               {100, 0, slope},
               {100, 10, slope}};
  const double top = (4 * rise + slope) * (4 * rise + slope) / (16 * rise);
  const model::Box box = model::bounding_box({vault}, Halves::both);
  EXPECT_NEAR(box.high.z(), top, size_mm);
  EXPECT_NEAR(box.low.z(), 0.0, size_mm);
  EXPECT_NEAR(box.high.y(), 10.0, size_mm);
}

TEST(Measures, NoPointOfABodyIsOutsideItsBox) {
  constexpr int samples = 40;
  for (const char* name : car_names) {
    const auto faces = model::build(load_car(name), Stage::body, Halves::left_and_central);
    const model::Box box = model::bounding_box(faces, Halves::left_and_central);
    for (const model::Surface& face : faces) {
      for (int k = 0; k < samples * samples; ++k) {
        const double u = (k / samples) / (samples - 1.0), v = (k % samples) / (samples - 1.0);
        const Eigen::Vector3d p = model::jet(face, u, v, 0).d[0];
        EXPECT_LE((p - box.high).maxCoeff(), size_mm) << face.name;
        EXPECT_LE((box.low - p).maxCoeff(), size_mm) << face.name;
      }
    }
  }
}

TEST(Measures, LargestValueFindsAMaximumOffTheGrid) {
  const auto f = [](double u, double v) {
    return -std::pow(u - 0.3171, 2) - 5.0 * std::pow(v - u * u - 0.2013, 2);
  };
  const model::Extreme best = model::largest_value(f, 8);
  // The value is flat at a maximum: places are known to the square root of rounding.
  EXPECT_NEAR(best.u, 0.3171, 1e-7);
  EXPECT_NEAR(best.v, 0.3171 * 0.3171 + 0.2013, 1e-7);
}

// Two cubic arcs that stand for half a circle to 3e-4 of its radius.
void add_half_circle(model::Model& model, model::WheelArch& arch, double x, double z, double r) {
  constexpr double handle = 0.5522847498307936;
  for (const double side : {-1.0, 1.0}) {
    arch.curves.push_back(int(model.curves.size()));
    model::Curve quarter;
    quarter.points = {{x + side * r, 7, z},
                      {x + side * r, 7, z + handle * r},
                      {x + side * handle * r, 7, z + r},
                      {x, 7, z + r}};
    model.curves.push_back(quarter);
  }
}

TEST(Measures, ArchesAreFittedByTheirCircles) {
  constexpr double arc_error = 3e-4;
  model::Model model;
  add_half_circle(model, model.front_arch, 900.0, 120.0, 400.0);
  add_half_circle(model, model.rear_arch, 3800.0, 130.0, 350.0);
  const model::ArchCircle front = model::arch_circle(model, model.front_arch).value();
  EXPECT_NEAR(front.x, 900.0, size_mm);
  EXPECT_NEAR(front.z, 120.0, 3.0 * arc_error * 400.0);
  EXPECT_NEAR(front.radius, 400.0, 3.0 * arc_error * 400.0);
  EXPECT_NEAR(model::wheelbase(model).value(), 2900.0, size_mm);
}

TEST(Measures, ABodyWithoutArchesOrWithStraightOnesHasNoWheelbase) {
  model::Model model;
  EXPECT_FALSE(model::wheelbase(model).has_value());
  model.curves.push_back({"line", {{0, 0, 0}, {1, 0, 1}, {2, 0, 2}}, ""});
  model.front_arch.curves = model.rear_arch.curves = {0};
  EXPECT_FALSE(model::wheelbase(model).has_value());
}

}  // namespace
}  // namespace bodyline::testing
