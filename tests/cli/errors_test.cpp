#include <gmock/gmock.h>

#include <algorithm>

#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using ::testing::HasSubstr;

/// A command line that cannot be carried out, and words its sentence must hold. CAR stands for a
/// good model, BAD for a broken one, OLD for a model file that exists in the folder.
struct Refusal {
  std::string name;
  std::vector<std::string> command;
  std::string words;
};

void PrintTo(const Refusal& refusal, std::ostream* stream) { *stream << refusal.words; }

class Refused : public testing::CommandLine, public ::testing::WithParamInterface<Refusal> {};

TEST_P(Refused, WithOneSentenceExitCode2AndNoFile) {
  write("old.toml", "old");
  write("bad.toml", "format = 1\nname = 7\n");
  const auto before = files();
  std::vector<std::string> command = GetParam().command;
  std::replace(command.begin(), command.end(), std::string("CAR"), car("template"));
  const auto run = bodyline(command);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, ::testing::StartsWith("bodyline: "));
  EXPECT_THAT(run.err, HasSubstr(GetParam().words));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_EQ(files(), before);
  EXPECT_EQ(text("old.toml"), "old");
}

const std::string headlight = BODYLINE_SOURCE_DIR "/examples/headlight.toml";
const std::string hull = BODYLINE_SOURCE_DIR "/examples/hull.toml";

const std::vector<Refusal> refusals{
    {"VariationOfPatches",
     {"chain", hull, "--fair", "--measure", "variation"},
     "--measure of patches is bending"},
    {"UnknownMeasureOfCurves",
     {"chain", headlight, "--fair", "--measure", "tension"},
     "there is no measure \"tension\" of curves"},
    {"NoVariableOfACurveChain",
     {"chain", headlight, "--fair", "--vary", "slide.*"},
     "no variable matches \"slide.*\""},
    {"NoCommand", {}, "give a command"},
    {"OnlyOptions", {"--quiet"}, "give a command"},
    {"UnknownOptionAlone", {"--jason"}, "--jason"},
    {"FitToNothing", {"fit", "-o", "new.toml"}, "there is nothing to fit to"},
    {"FitWithAPoseWithoutAScan",
     {"fit", "--views", "side=a.svg", "--pose", "none", "-o", "new.toml"},
     "place a scan"},
    {"FitToAnUnknownView", {"fit", "--views", "left=a.svg", "-o", "new.toml"}, "is no view"},
    {"FitToAMissingDrawing", {"fit", "--views", "side=a.svg", "-o", "new.toml"}, "a.svg"},
    {"FitWithAnUnknownCurve",
     {"fit", "--feature", "roof_windshield=a.csv", "-o", "new.toml"},
     "the nearest name is"},
    {"FitWithAFeatureWithoutAFile",
     {"fit", "--feature", "windshield__roof", "-o", "new.toml"},
     "is no feature line"},
    {"OutlinesWithoutAPlaceForTheView", {"outline", "CAR", "-o", "a.svg"}, "{view}"},
    {"OutlineOfAnUnknownView", {"outline", "CAR", "-o", "a.svg", "--view", "left"}, "is no view"},
    {"OutlineInAnUnknownFormat", {"outline", "CAR", "-o", "a.dxf", "--view", "side"}, ".svg, .csv"},
    {"EmptyModelName", {"variables", ""}, "empty"},
    {"EmptyOutputName", {"convert", "CAR", "-o", ""}, "empty"},
    {"UnknownCommand", {"evalute", "CAR"}, "'evalute' is not a command; the nearest is 'evaluate'"},
    {"UnknownOption", {"variables", "CAR", "--jason"}, "--jason"},
    {"NoModel", {"variables"}, "MODEL"},
    {"NotANumber",
     {"fair", "CAR", "-o", "a.toml", "--within", "nan"},
     "nan is not a number above 0"},
    {"Infinite",
     {"fair", "CAR", "-o", "a.toml", "--max-cut", "inf"},
     "a number from 0.001 to 0.499"},
    {"NegativeTime", {"fair", "CAR", "-o", "a.toml", "--seconds", "-1"}, "a number of 0 or more"},
    {"NoFairness", {"fit", "CAR", "-o", "a.toml", "--fairness", "nan"}, "nan is not a number of 0"},
    {"MissingFile", {"variables", "no.toml"}, "no.toml: does not exist"},
    {"BrokenFile", {"variables", "bad.toml"}, "bad.toml:2"},
    {"FolderAsModel", {"variables", "."}, "is a folder"},
    {"UnknownVariable", {"variables", "CAR", "shape.hod.u*"}, "the nearest name is 'shape.hood.u"},
    {"SetUnknown", {"set", "CAR", "cut.hood.ulo=0.1", "-o", "a.toml"}, "'cut.hood.u_lo'"},
    {"SetNothing", {"set", "CAR", "-o", "a.toml"}, "NAME=VALUE"},
    {"SetNoValue", {"set", "CAR", "cut.hood.u_lo", "-o", "a.toml"}, "NAME=VALUE"},
    {"SetNoNumber", {"set", "CAR", "cut.hood.u_lo=wide", "-o", "a.toml"}, "'wide'"},
    {"SetNotFinite", {"set", "CAR", "cut.hood.u_lo=nan", "-o", "a.toml"}, "not a finite number"},
    {"SetFixed", {"set", "CAR", "cut.grille.u_lo=0.1", "-o", "a.toml"}, "is fixed"},
    {"SetContradiction",
     {"set", "CAR", "curve.hood__windshield[1-2].y=9", "-o", "a.toml"},
     "contradicts"},
    {"SetAmbiguous", {"set", "CAR", "cut.hood.u_lo*=2", "-o", "a.toml"}, "two ways"},
    {"SetInvalidModel", {"set", "CAR", "cut.hood.u_lo=0.95", "-o", "a.toml"}, "not be a valid"},
    {"SetFullnessTooLarge",
     {"set", "CAR", "fullness.hood__windshield.a=3", "-o", "a.toml"},
     "not be a valid"},
    {"SetNoOutput", {"set", "CAR", "cut.hood.u_lo=0.1"}, "--output"},
    {"SetWrongExtension", {"set", "CAR", "cut.hood.u_lo=0.1", "-o", "a.step"}, ".toml"},
    {"SetExisting", {"set", "CAR", "cut.hood.u_lo=0.1", "-o", "old.toml"}, "exists already"},
    {"SetFolder", {"set", "CAR", "cut.hood.u_lo=0.1", "-o", "no/a.toml"}, "folder does not exist"},
    {"EvaluateTerm", {"evaluate", "CAR", "--objective", "bendig=1"}, "bendig"},
    {"EvaluateWeight", {"evaluate", "CAR", "--objective", "bending=-1"}, "'-1'"},
    {"EvaluateFace", {"evaluate", "CAR", "--objective", "bending@hod=1"}, "\"hood\""},
    {"EvaluateStage", {"evaluate", "CAR", "--stage", "built"}, "base, kept and body"},
    {"EvaluateNodes", {"evaluate", "CAR", "--nodes", "7"}, "multiples of 8"},
    {"EvaluateNodesWord", {"evaluate", "CAR", "--nodes", "many"}, "--nodes"},
    {"EvaluateVary", {"evaluate", "CAR", "--vary", "shapes.*"}, "shapes.*"},
    {"ExportExtension", {"export", "CAR", "-o", "car.dwg"}, ".step"},
    {"ExportExisting", {"export", "CAR", "-o", "old.toml"}, ".step"},
    {"ExportTolerance", {"export", "CAR", "-o", "a.stl", "--tolerance", "0"}, "olerance"},
    {"ConvertStep", {"convert", "bad.step", "-o", "a.toml"}, "bad.step"},
    {"ConvertBroken", {"convert", "bad.toml", "-o", "a.toml"}, "bad.toml:2"},
    {"ConvertExisting", {"convert", "CAR", "-o", "old.toml"}, "exists already"},
    {"ScanExtension", {"scan", "CAR", "-o", "a.xyz"}, ".ply"},
    {"ScanExisting", {"scan", "CAR", "-o", "old.toml"}, ".ply"},
    {"ScanFewPoints", {"scan", "CAR", "-o", "a.ply", "--points", "5"}, "not with 5"},
    {"ScanManyPoints", {"scan", "CAR", "-o", "a.ply", "--points", "1e99"}, "--points"},
    {"ScanNoise", {"scan", "CAR", "-o", "a.ply", "--noise", "-1"}, "noise"},
    {"ScanOutliers", {"scan", "CAR", "-o", "a.ply", "--outliers", "2"}, "outliers"},
    {"ScanMissing", {"scan", "CAR", "-o", "a.ply", "--missing", "right"}, "'right'"},
    {"ScanPoseShort", {"scan", "CAR", "-o", "a.ply", "--pose", "1,2,3"}, "takes seven"},
    {"ScanPoseLong", {"scan", "CAR", "-o", "a.ply", "--pose", "1,2,3,4,5,6,7,8"}, "has 8"},
    {"ScanPoseWord", {"scan", "CAR", "-o", "a.ply", "--pose", "1,2,3,4,5,up,7"}, "'up'"},
    {"ScanPoseScale", {"scan", "CAR", "-o", "a.ply", "--pose", "1,2,3,4,5,6,-7"}, "scale"},
    {"RenderExtension", {"render", "CAR", "-o", "a.jpg"}, ".png"},
    {"RenderView", {"render", "CAR", "-o", "a.png", "--view", "under"}, "under"},
    {"RenderMap", {"render", "CAR", "-o", "a.png", "--map", "shiny"}, "shiny"},
    {"RenderSize", {"render", "CAR", "-o", "a.png", "--size", "big"}, "'big'"},
    {"RenderTooLarge", {"render", "CAR", "-o", "a.png", "--size", "1x99999"}, "99999"},
};

INSTANTIATE_TEST_SUITE_P(Each, Refused, ::testing::ValuesIn(refusals),
                         [](const auto& test) { return test.param.name; });

class Streams : public testing::CommandLine {};

TEST_F(Streams, AFullDiskIsAnError) {
  const auto run = testing::run_in(
      file("."), {"sh", "-c", "bodyline variables " + car("template") + " > /dev/full"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("cannot be written"));
}

}  // namespace
}  // namespace bodyline
