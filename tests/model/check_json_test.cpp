#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "check_models.hpp"
#include "io/check_json.hpp"

/// The JSON of a check has the documented keys, in their order, and the numbers of the check.
namespace bodyline::testing {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> list;
  for (const auto& item : object.items()) list.push_back(item.key());
  return list;
}

TEST(CheckJson, HasTheDocumentedKeys) {
  const Json json = io::check_json(model::check_body(load_car("model1")), {"a finding"}, {"first"});
  EXPECT_EQ(keys(json), (std::vector<std::string>{"model", "stage", "edges", "patches", "totals",
                                                  "findings", "warnings"}));
  EXPECT_EQ(keys(json["edges"][0]),
            (std::vector<std::string>{"name", "kind", "stage", "gap_mm", "normal_deviation_deg",
                                      "curvature_jump_per_mm", "continuity", "polynomial"}));
  EXPECT_EQ(keys(json["patches"][0]),
            (std::vector<std::string>{"name", "kind", "stage", "mirrored", "folded",
                                      "max_normal_turn_deg", "worst_uv", "worst_point", "area_m2",
                                      "bending", "variation_per_mm2"}));
  EXPECT_EQ(keys(json["totals"]),
            (std::vector<std::string>{"area_m2", "volume_m3", "length_mm", "width_mm", "height_mm",
                                      "wheelbase_mm", "bending", "variation_times_area", "faces"}));
  EXPECT_EQ(json["warnings"][0], "first");
}

TEST(CheckJson, AddsUpToTheTotalsOfTheStage) {
  constexpr double rounding = 1e-12;
  const Json json = io::check_json(model::check_body(load_car("template")), {});
  double bending = 0.0, area = 0.0, variation = 0.0;
  int faces = 0;
  for (const Json& face : json["patches"]) {
    if (face["stage"] != "body") continue;
    const int sides = face["mirrored"].get<bool>() ? 2 : 1;
    bending += sides * face["bending"].get<double>();
    area += sides * face["area_m2"].get<double>();
    variation += sides * face["variation_per_mm2"].get<double>() * 1e6;
    faces += sides;
  }
  const Json& totals = json["totals"];
  EXPECT_EQ(totals["faces"], faces);
  EXPECT_NEAR(totals["bending"].get<double>() / bending, 1.0, rounding);
  EXPECT_NEAR(totals["area_m2"].get<double>() / area, 1.0, rounding);
  EXPECT_NEAR(totals["variation_times_area"].get<double>() / (variation * area), 1.0, rounding);
}

TEST(CheckJson, WritesNullForWhatDoesNotExist) {
  const model::BodyCheck check = model::check_body(plain_box(), {model::Stage::kept});
  const Json json = io::check_json(check, {});
  EXPECT_TRUE(json["totals"]["wheelbase_mm"].is_null());
  EXPECT_TRUE(json["totals"]["volume_m3"].is_null());
}

}  // namespace
}  // namespace bodyline::testing
