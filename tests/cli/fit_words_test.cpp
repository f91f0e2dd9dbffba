// What fit says about a scan and drawings.

#include <gmock/gmock.h>

#include "io/read_scan.hpp"
#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class FitWords : public testing::CommandLine {
 protected:
  // A scan of model 1 as text, in its own coordinates, without the points behind `x_to`.
  void write_scan(const std::string& name, double x_to) {
    ASSERT_EQ(bodyline({"scan", car("model1"), "-o", "all.ply", "--points", "12000", "--overwrite"})
                  .exit_code,
              0);
    const model::Scan scan = io::read_scan(file("all.ply")).scan;
    std::string rows;
    for (const Eigen::Vector3d& point : scan.points) {
      if (point.x() < x_to)
        rows += std::to_string(point.x()) + " " + std::to_string(point.y()) + " " +
                std::to_string(point.z()) + "\n";
    }
    write(name, rows);
  }
};

TEST_F(FitWords, ThePoseComesWithHowItWasFoundAndAnOptionThatRepeatsIt) {
  write_scan("scan.xyz", 1e9);
  const auto found = json({"deviation", car("model1"), "scan.xyz", "--json"});
  const auto& alignment = found.at("alignment");
  EXPECT_EQ(alignment.at("given"), false);
  EXPECT_EQ(alignment.at("unit"), "mm");
  EXPECT_EQ(alignment.at("unit_given"), false);
  EXPECT_GT(alignment.at("fit"), 0.9);
  EXPECT_GT(alignment.at("coverage"), 0.9);
  EXPECT_EQ(alignment.at("missing_side"), nullptr);
  EXPECT_EQ(alignment.at("missing_end"), nullptr);
  EXPECT_THAT(found.at("scan").get<std::string>(), HasSubstr("lay nearly in the model's"));
  const auto again = json({"deviation", car("model1"), "scan.xyz", "--json", "--pose",
                           alignment.at("option").get<std::string>()});
  EXPECT_EQ(again.at("alignment").at("given"), true);
  const double tight = 1e-9;  // rounding of the option's digits
  EXPECT_NEAR(again.at("pose").at("translation_mm").at(0),
              found.at("pose").at("translation_mm").at(0), tight);
  EXPECT_NEAR(again.at("distance_mm").at("median"), found.at("distance_mm").at("median"), 1e-6);
}

TEST_F(FitWords, ACarCutInHalfKeepsItsProportionsAndIsToldToBeHalf) {
  write_scan("front.xyz", 2430.0);  // half of 4878 mm
  const auto run = bodyline({"fit", "front.xyz", "-o", "car.toml", "--json"});
  ASSERT_LE(run.exit_code, 1) << run.err;
  const auto fit = nlohmann::json::parse(run.out);
  EXPECT_EQ(fit.at("alignment").at("missing_end"), "rear");
  EXPECT_THAT(fit.at("scan").get<std::string>(),
              HasSubstr("THE REAR OF THE CAR IS NOT IN THE SCAN"));
  EXPECT_FALSE(fit.at("wheel_arches").empty());
  // The template is 4698 mm long; the stretch along the hidden half is a guess.
  const auto check = bodyline({"check", "car.toml", "--json"});
  EXPECT_NEAR(nlohmann::json::parse(check.out).at("totals").at("length_mm"), 4698.0, 500.0);
  EXPECT_LT(fit.at("distance_mm").at("median"), 2.0);
}

TEST_F(FitWords, OutlinesWithoutAScaleSayHowToGiveOne) {
  ASSERT_EQ(bodyline({"outline", car("model1"), "-o", "side.csv", "--view", "side"}).exit_code, 0);
  const auto run = bodyline({"fit", "--views", "side=side.csv", "-o", "car.toml"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("side=FILE@1 where a unit of the drawing is 1 mm"));
  EXPECT_THAT(run.err, HasSubstr("--dimension length=MM"));
}

TEST_F(FitWords, AViewThatIsDrawnTheOtherWayRoundIsNamed) {
  ASSERT_EQ(bodyline({"outline", car("template"), "-o", "{view}.csv"}).exit_code, 0);
  const auto drawings = [&](const std::string& top) {
    return json({"fit", "--views", "side=side.csv@1,top=top.csv@1" + top, "-o", "car.toml",
                 "--overwrite", "--json"})
        .at("drawings")
        .get<std::string>();
  };
  EXPECT_THAT(drawings(""), Not(HasSubstr("THE VIEW")));
  EXPECT_THAT(drawings(":nose-right"),
              HasSubstr("THE VIEW top LOOKS AS IF ITS NOSE POINTED THE OTHER WAY, unlike the view "
                        "side"));
}

TEST_F(FitWords, DrawingsThatDifferInASizeAreNamedWithIt) {
  write("side.csv", "0,0\n4500,0\n4500,1400\n0,1400\n0,0\n");
  write("top.csv", "0,0\n4500,0\n4500,1800\n0,1800\n0,0\n");
  write("front.csv", "0,0\n2000,0\n2000,1400\n0,1400\n0,0\n");
  const auto run = bodyline(
      {"fit", "--views", "side=side.csv@1,top=top.csv@1,front=front.csv", "-o", "car.toml"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("the drawings differ in their width by"));
  EXPECT_THAT(run.err, HasSubstr(" mm in top, "));
  EXPECT_THAT(run.err, HasSubstr("; the drawings differ in their height by"));
  EXPECT_THAT(run.err, HasSubstr(" mm in front"));
}

TEST_F(FitWords, WhatChoosesThePageNeedsOne) {
  const auto run = bodyline({"fit", "none.ply", "-o", "car.toml", "--section", "x=1200"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("--section chooses what the page shows; give --report"));
}

}  // namespace
}  // namespace bodyline
