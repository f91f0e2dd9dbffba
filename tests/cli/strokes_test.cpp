// The command `strokes`.

#include <gmock/gmock.h>

#include <cmath>

#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string boundary =
    "0 0 0\n500 0 40\n1000 0 0\n\n1000 0 0\n1000 350 60\n1000 700 0\n\n1000 700 0\n500 700 40\n"
    "0 700 0\n\n0 700 0\n0 350 60\n0 0 0\n\n";
const std::string across = "500 0 40\n510 350 160\n500 700 40\n\n";
const std::string crossing = "100 330 75\n500 360 150\n900 340 70\n\n";

constexpr double allowed_deg = 1e-6, allowed_gap_mm = 1e-6;

class StrokesCommand : public testing::CommandLine {
 protected:
  void SetUp() override { write("strokes.csv", boundary + across + crossing); }
};

TEST_F(StrokesCommand, JoinsPatchesSmoothlyByDefault) {
  const auto report = json({"strokes", "strokes.csv", "-o", "a.step", "--json"});
  EXPECT_EQ(report["method"], "smooth");
  EXPECT_GT(report["faces"], 3);
  EXPECT_LE(report["check"]["normal_deviation_deg"], allowed_deg);
  EXPECT_LE(report["check"]["gap_mm"], allowed_gap_mm);
  EXPECT_TRUE(report["check"]["findings"].empty());
  EXPECT_LE(report["newest_deviation_mm"], report["smooth"]["tolerance_mm"]);
  EXPECT_THAT(text("a.step"), StartsWith("ISO-10303-21"));
}

TEST_F(StrokesCommand, MakesCreasesByThePapersMethod) {
  const auto report =
      json({"strokes", "strokes.csv", "-o", "a.step", "--json", "--method", "paper"});
  EXPECT_EQ(report["method"], "paper");
  EXPECT_TRUE(report["smooth"].is_null());
  EXPECT_GT(report["check"]["normal_deviation_deg"], 1.0);
  EXPECT_LE(report["newest_deviation_mm"], 1e-9) << "the newest stroke is a curve of the surface";
}

TEST_F(StrokesCommand, KeepsToTheToleranceThatItIsGiven) {
  for (const char* const within : {"0.2", "5"}) {
    const auto report = json(
        {"strokes", "strokes.csv", "-o", "a.json", "--overwrite", "--json", "--within", within});
    EXPECT_EQ(report["smooth"]["tolerance_mm"], std::stod(within));
    EXPECT_LE(report["newest_deviation_mm"], std::stod(within));
  }
}

TEST_F(StrokesCommand, FairsWithinTheTolerance) {
  const auto plain = json({"strokes", "strokes.csv", "-o", "a.json", "--json", "--within", "5"});
  const auto fair =
      json({"strokes", "strokes.csv", "-o", "b.json", "--json", "--within", "5", "--fair"});
  EXPECT_LT(fair["check"]["bending"], plain["check"]["bending"]);
  EXPECT_LE(fair["newest_deviation_mm"], 5.0);
}

TEST_F(StrokesCommand, WhatItWritesAsJsonItReadsAgain) {
  const auto first = json({"strokes", "strokes.csv", "-o", "a.json", "--json"});
  const auto second = json({"strokes", "a.json", "-o", "b.json", "--json"});
  EXPECT_EQ(first, second);
  const auto document = nlohmann::json::parse(text("b.json"));
  EXPECT_EQ(document["surface"]["faces"].size(), first["faces"]);
}

TEST_F(StrokesCommand, WritesEveryFormatThatExportKnows) {
  for (const char* const name : {"a.stp", "a.iges", "a.stl", "a.obj", "a.ply", "a.glb", "a.gltf"}) {
    EXPECT_EQ(bodyline({"strokes", "strokes.csv", "-o", name}).exit_code, 0) << name;
    EXPECT_FALSE(text(name).empty());
  }
}

TEST_F(StrokesCommand, DrawsAPicture) {
  EXPECT_EQ(bodyline({"strokes", "strokes.csv", "-o", "a.stl", "--picture", "a.png", "--size",
                      "160x90", "--map", "zebra"})
                .exit_code,
            0);
  EXPECT_THAT(text("a.png"), StartsWith("\x89PNG"));
}

TEST_F(StrokesCommand, ARejectedStrokeIsReportedWithItsReasonAndExitCode1) {
  write("more.csv",
        "stroke,x,y,z\nrim 1,0,0,0\nrim 1,1000,0,0\nrim 2,1000,0,0\nrim 2,1000,700,0\n"
        "rim 3,1000,700,0\nrim 3,0,700,0\nrim 4,0,700,0\nrim 4,0,0,0\n"
        "good,500,0,0\ngood,500,350,60\ngood,500,700,0\nbad,100,100,20\nbad,100,-300,20\n");
  const auto run = bodyline({"strokes", "more.csv", "-o", "a.stl", "--json", "--boundary", "rim*"});
  EXPECT_EQ(run.exit_code, 1);
  const auto inside = nlohmann::json::parse(run.out)["inside"];
  EXPECT_EQ(inside[0]["rejection"], nullptr);
  EXPECT_EQ(inside[1]["rejection"], "end-outside");
  EXPECT_FALSE(text("a.stl").empty()) << "the others make a surface";
}

TEST_F(StrokesCommand, AMissedStrokeIsAFindingAndExitCode1) {
  std::string zigzag;
  for (int k = 0; k <= 80; ++k)
    zigzag += std::to_string(400 + 2 * k) + " 350 " + (k % 2 == 0 ? "50" : "80") + "\n";
  write("jagged.csv", boundary + zigzag);
  const auto run = bodyline({"strokes", "jagged.csv", "-o", "a.stl", "--json"});
  EXPECT_EQ(run.exit_code, 1);
  const auto report = nlohmann::json::parse(run.out);
  EXPECT_GT(report["inside"][0]["newest_deviation_mm"], report["smooth"]["tolerance_mm"]);
  EXPECT_THAT(report["check"]["findings"].dump(), HasSubstr("the surface misses stroke 5"));
}

TEST_F(StrokesCommand, AMissedBoundaryIsAFindingAndExitCode1) {
  // Zigzags narrower than the shortest piece of a curve of ten metres.
  std::string zigzag;
  for (int k = 1; k <= 40; ++k)
    zigzag += std::to_string(5000 - 0.5 * k) + " 7000 " + (k % 2 == 0 ? "0" : "6") + "\n";
  write("jagged.csv", "0 0 0\n10000 0 0\n\n10000 0 0\n10000 7000 0\n\n10000 7000 0\n" + zigzag +
                          "0 7000 0\n\n0 7000 0\n0 0 0\n");
  const auto run = bodyline(
      {"strokes", "jagged.csv", "-o", "a.step", "--json", "--threshold", "1", "--within", "1"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const auto report = nlohmann::json::parse(run.out);
  EXPECT_GT(report["smooth"]["boundary_deviation_mm"], 1.0);
  EXPECT_THAT(report["check"]["findings"].dump(), HasSubstr("misses its boundary's strokes"));
}

TEST_F(StrokesCommand, SaysWhatItDid) {
  const auto run = bodyline({"strokes", "strokes.csv", "-o", "a.stl"});
  EXPECT_THAT(run.out, HasSubstr("method smooth; newest strokes within"));
  EXPECT_THAT(run.out, HasSubstr("2 of 2 strokes inserted"));
}

/// A stroke on the hood of model 1, lifted by up to 10 mm.
std::string hood_stroke() {
  std::string stroke;
  for (int k = 0; k <= 20; ++k) {
    const double t = k / 20.0;
    // The hood's middle line rises from 553 to 808 mm; its surface there is near this.
    stroke +=
        std::to_string(350 + 600 * t) + " 100 " + std::to_string(700 + 150 * t - 60 * t * t) + "\n";
  }
  return stroke;
}

TEST_F(StrokesCommand, RefinesAPatchOfABody) {
  write("hood.csv", hood_stroke());
  const auto run = bodyline({"strokes", "hood.csv", "--refine", car("model1"), "--patch", "hood",
                             "-o", "a.step", "--json"});
  ASSERT_LE(run.exit_code, 1) << run.err;
  const auto report = nlohmann::json::parse(run.out);
  EXPECT_EQ(report["refined"]["patch"], "hood");
  EXPECT_LE(report["refined"]["border_before_deg"], allowed_deg);
  EXPECT_LE(report["refined"]["border_deg"], allowed_deg);
  EXPECT_EQ(report["inside"][0]["rejection"], nullptr);
  ASSERT_EQ(report["inside"].size(), 2) << "the hood lies on the middle: an image joins the stroke";
  EXPECT_EQ(report["inside"][1]["rejection"], nullptr);
  EXPECT_EQ(report["faces"], 77 + 2) << "the hood is three patches now";
  EXPECT_THAT(text("a.step"), HasSubstr("'hood 2'"));
  EXPECT_THAT(text("a.step"), HasSubstr("'roof'"));
}

struct Refusal {
  std::string name;
  std::vector<std::string> arguments;
  std::string words;
};
void PrintTo(const Refusal& refusal, std::ostream* stream) { *stream << refusal.words; }

class StrokesRefused : public StrokesCommand, public ::testing::WithParamInterface<Refusal> {};

TEST_P(StrokesRefused, WithOneSentenceExitCode2AndNoFile) {
  write("open.csv", "0 0 0\n1 0 0\n\n5 5 5\n6 6 6\n");
  write("hood.csv", hood_stroke());
  write("bad.csv", "0 0 zero\n");
  const auto before = files();
  std::vector<std::string> command{"strokes"};
  for (const std::string& argument : GetParam().arguments)
    command.push_back(argument == "CAR" ? car("model1") : argument);
  const auto run = bodyline(command);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, StartsWith("bodyline: "));
  EXPECT_THAT(run.err, HasSubstr(GetParam().words));
  EXPECT_EQ(files(), before);
}

const std::vector<Refusal> refusals{
    {"Method", {"strokes.csv", "-o", "a.stl", "--method", "best"}, "--method"},
    {"Within", {"strokes.csv", "-o", "a.stl", "--within", "0"}, "--within"},
    {"FairPaper", {"strokes.csv", "-o", "a.stl", "--method", "paper", "--fair"}, "smooth method"},
    {"Extension", {"strokes.csv", "-o", "a.docx"}, ".step"},
    {"Boundary", {"strokes.csv", "-o", "a.stl", "--boundary", "rim"}, "no stroke is called 'rim'"},
    {"NoBoundary", {"open.csv", "-o", "a.stl"}, "boundary"},
    {"Word", {"bad.csv", "-o", "a.stl"}, "no coordinate"},
    {"PatchAlone", {"strokes.csv", "-o", "a.stl", "--patch", "hood"}, "go together"},
    {"RefineAlone", {"strokes.csv", "-o", "a.stl", "--refine", "CAR"}, "go together"},
    {"UnknownPatch",
     {"hood.csv", "-o", "a.stl", "--refine", "CAR", "--patch", "bonnet"},
     "no patch 'bonnet'; it has"},
    {"RightPatch",
     {"hood.csv", "-o", "a.stl", "--refine", "CAR", "--patch", "front_fender_upper.right"},
     "is a mirror image: refine 'front_fender_upper'"},
    {"PaperRefines",
     {"hood.csv", "-o", "a.stl", "--refine", "CAR", "--patch", "hood", "--method", "paper"},
     "cannot refine"},
    {"BoundaryRefines",
     {"hood.csv", "-o", "a.stl", "--refine", "CAR", "--patch", "hood", "--boundary", "x"},
     "its own boundary"},
};
INSTANTIATE_TEST_SUITE_P(Command, StrokesRefused, ::testing::ValuesIn(refusals),
                         [](const auto& refusal) { return refusal.param.name; });

}  // namespace
}  // namespace bodyline
