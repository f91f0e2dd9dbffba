// Dimensions and hard points on the command line of fit.

#include <gmock/gmock.h>

#include <fstream>

#include "cli/bounds_options.hpp"
#include "cli/fit_text.hpp"
#include "io/read_model.hpp"
#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using ::testing::HasSubstr;

class BoundsOptions : public testing::CommandLine {
 protected:
  std::string scan() {
    const auto run =
        bodyline({"scan", car("model2"), "-o", "scan.ply", "--points", "5000", "--overwrite"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return "scan.ply";
  }
  std::string refusal(const std::vector<std::string>& options) {
    std::vector<std::string> words{"fit", scan(), "-o", "out.toml", "--overwrite"};
    words.insert(words.end(), options.begin(), options.end());
    const auto run = bodyline(words);
    EXPECT_EQ(run.exit_code, 2);
    return run.err;
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(file(name)) << text;
  }
};

TEST(DimensionBound, OneNumberFixesTwoBound) {
  const auto fixed = cli::dimension_bound_from_text("length=4500");
  EXPECT_EQ(fixed.name, "length");
  EXPECT_EQ(fixed.lower, 4500.0);
  EXPECT_EQ(fixed.upper, 4500.0);
  const auto bounded = cli::dimension_bound_from_text("rake.windshield=58:62.5");
  EXPECT_EQ(bounded.name, "rake.windshield");
  EXPECT_EQ(bounded.lower, 58.0);
  EXPECT_EQ(bounded.upper, 62.5);
}

TEST(DimensionBound, WhatIsNoBoundIsRefused) {
  for (const char* text : {"length", "length=", "length=a", "length=1:", "length=1:2:3"})
    EXPECT_THROW(cli::dimension_bound_from_text(text), std::invalid_argument) << text;
}

TEST_F(BoundsOptions, AreKeptAndReported) {
  write("points.csv", "# package\n2000, -300, 900, inside, 20\n");
  const auto report = json({"fit", scan(), "-o", "out.toml", "--pose", "none", "--dimension",
                            "length=4760", "--hard-points", "points.csv", "--json"});
  const auto& length = report.at("dimensions").at("length");
  EXPECT_NEAR(length.at("value").get<double>(), 4760.0, 1.0);
  EXPECT_EQ(length.at("lower"), 4760.0);
  EXPECT_EQ(length.at("kept"), true);
  EXPECT_LT(report.at("hard_points").at(0).at("distance_mm").get<double>(), -19.0);
  EXPECT_EQ(report.at("hard_points").at(0).at("kept"), true);
}

TEST_F(BoundsOptions, WhatIsNotKeptIsAFindingWithItsExitCode) {
  // All three at once cannot be; in the middle between them nothing folds.
  const auto run = bodyline({"fit", scan(), "-o", "out.toml", "--pose", "none", "--dimension",
                             "length=4760", "--dimension", "front_overhang=900", "--dimension",
                             "wheelbase=2785", "--dimension", "rear_overhang=1083", "--json"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const auto report = nlohmann::json::parse(run.out);
  EXPECT_EQ(report.at("folded"), nlohmann::json::array());
  EXPECT_EQ(report.at("dimensions").at("length").at("kept"), false);
}

TEST(ArchWarnings, AreOfRimsOverTenMillimetresOff) {
  const auto words = cli::arch_warnings(
      {{true, "top", 9.9}, {true, "front", 12.4}, {false, "rear", -20.2}, {false, "top", -9.9}});
  ASSERT_EQ(words.size(), 2u);
  EXPECT_EQ(words[0], "wheel arch front, front: rim 12 mm short of the scan");
  EXPECT_EQ(words[1], "wheel arch rear, rear: rim 20 mm beyond the scan");
}

TEST(ArchWarnings, NameThePartsThatTheScanDoesNotTell) {
  model::Model model;
  EXPECT_EQ(cli::hidden_arches(model, {}), "");  // it has no arches
  model.front_arch.curves = model.rear_arch.curves = {0};
  const std::vector<optimize::ArchGap> most{
      {true, "rear", 1.0}, {true, "top", 2.0}, {false, "rear", 3.0}, {false, "front", 4.0}};
  const std::string words = cli::hidden_arches(model, most);
  EXPECT_EQ(words.substr(words.find(": ")), ": front, front; rear, top");
  std::vector<optimize::ArchGap> all = most;
  all.push_back({true, "front", 0.0});
  all.push_back({false, "top", 0.0});
  EXPECT_EQ(cli::hidden_arches(model, all), "");
}

TEST(FitFindings, AFitThatFailedOrABoundThatIsNotKept) {
  cli::FittedCar car;
  car.result.status = optimize::Status::small_improvement;
  EXPECT_FALSE(cli::has_findings(car));
  cli::FittedCar failed = car;
  failed.result.status = optimize::Status::failed;
  EXPECT_TRUE(cli::has_findings(failed));
  cli::FittedCar folded = car;
  folded.result.folded_faces = {"roof"};
  EXPECT_TRUE(cli::has_findings(folded));
  car.bounds_kept.points = {{0.0, true}, {1.0, false}};
  EXPECT_TRUE(cli::has_findings(car));
  car.bounds_kept.points.clear();
  car.bounds_kept.dimensions = {{4000.0, false}};
  EXPECT_TRUE(cli::has_findings(car));
}

TEST_F(BoundsOptions, BeyondAKilometreAreRefused) {
  write("far.csv", "1 2 3 inside\n1e300 0 900 outside\n");
  EXPECT_THAT(refusal({"--hard-points", "far.csv"}), HasSubstr("far.csv:2: \"1e300\" is beyond"));
}

TEST_F(BoundsOptions, ADimensionThatNoCarHasIsRefusedWithWhatCanBe) {
  for (const char* value : {"-5", "0", "nan", "1e9", "4.7"}) {
    EXPECT_THAT(refusal({"--dimension", std::string("length=") + value}),
                HasSubstr("length is from 100 to 20000 mm, not "));
  }
  EXPECT_THAT(refusal({"--dimension", "rake.windshield=200"}),
              HasSubstr("rake.windshield is from 0 to 90 degrees, not 200"));
}

TEST_F(BoundsOptions, ADimensionThatIsAskedForTwiceMustBePossible) {
  EXPECT_THAT(refusal({"--dimension", "length=4700", "--dimension", "length=4800:4900"}),
              HasSubstr("length is asked for more than once, and 4700 and 4800 to 4900 exclude"));
  const model::Model model = io::read_model(car("template"));
  const auto bounds = cli::read_bounds({{"length=4700", "length=4700"}, ""}, model);
  EXPECT_EQ(bounds.dimensions.size(), 1u);
}

TEST_F(BoundsOptions, WhatIsNoCarIsRefusedWithItsFile) {
  std::string points;
  for (int k = 0; k < 2000; ++k)
    points += std::to_string(k % 50 * 90) + " " + std::to_string(k / 50 * 40) + " 0\n";
  write("flat.xyz", points);
  const auto run = bodyline({"fit", "flat.xyz", "-o", "out.toml"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("flat.xyz: the scan is a flat plane, not a car"));
  EXPECT_THAT(run.err, HasSubstr("--pose"));
}

TEST_F(BoundsOptions, ALineThatIsTooFarOrTooLongIsRefusedWithItsFile) {
  write("far.csv", "0 0 0\n0 0 2000000\n");
  EXPECT_THAT(refusal({"--pose", "none", "--feature", "windshield__roof=far.csv"}),
              HasSubstr("far.csv: the line of the feature 'windshield__roof' goes beyond 1 km"));
  std::string to_and_fro;
  for (int k = 0; k < 2000; ++k) to_and_fro += k % 2 == 0 ? "0 0 0\n" : "0 0 900000\n";
  write("long.csv", to_and_fro);
  EXPECT_THAT(refusal({"--pose", "none", "--feature", "windshield__roof=long.csv"}),
              HasSubstr("long.csv: the line of the feature 'windshield__roof' is too long"));
}

TEST_F(BoundsOptions, AnUnknownDimensionIsRefusedWithTheNearest) {
  EXPECT_THAT(refusal({"--dimension", "lenth=4000"}), HasSubstr("the nearest is 'length'"));
}

TEST_F(BoundsOptions, BadHardPointsAreRefusedWithFileAndLine) {
  write("a.csv", "1 2 3 inside\n1 2 x inside\n");
  EXPECT_THAT(refusal({"--hard-points", "a.csv"}),
              HasSubstr("a.csv:2: \"x\" is not a finite number"));
  write("b.csv", "1 2 3 beside\n");
  EXPECT_THAT(refusal({"--hard-points", "b.csv"}), HasSubstr("\"beside\" is no rule"));
  write("c.csv", "1 2 3 inside -4\n");
  EXPECT_THAT(refusal({"--hard-points", "c.csv"}), HasSubstr("must not be negative"));
  write("d.csv", "1 2 3 inside 4 5\n");
  EXPECT_THAT(refusal({"--hard-points", "d.csv"}), HasSubstr("there is more"));
  write("e.csv", "# nothing\n");
  EXPECT_THAT(refusal({"--hard-points", "e.csv"}), HasSubstr("has no hard points"));
}

}  // namespace
}  // namespace bodyline
