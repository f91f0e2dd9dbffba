// What the command `sketch` refuses, and how.

#include <gmock/gmock.h>

#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using ::testing::HasSubstr;

/// Files that cannot be used, and words of the sentence.
struct Refusal {
  std::string name, svg, toml;
  std::vector<std::string> options;
  std::string words;
};

void PrintTo(const Refusal& refusal, std::ostream* stream) { *stream << refusal.words; }

class RefusedSketch : public testing::CommandLine, public ::testing::WithParamInterface<Refusal> {};

TEST_P(RefusedSketch, WithOneSentenceExitCode2AndNoFile) {
  const Refusal& refusal = GetParam();
  write("views.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 900 900\">" +
                         refusal.svg + "</svg>");
  write("views.toml", refusal.toml);
  const auto before = files();
  std::vector<std::string> command{"sketch", refusal.toml.empty() ? "views.svg" : "views.toml",
                                   "-o", "car.toml"};
  command.insert(command.end(), refusal.options.begin(), refusal.options.end());
  const auto run = bodyline(command);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr(refusal.words));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_EQ(files(), before);
}

const std::string side_view = "[views.side]\nfile = \"views.svg\"\n";
const std::string some_line = "<path id=\"door_bottom\" d=\"M 0,0 L 500,90\"/>";
const std::string side_layer = "<g id=\"side\">" + some_line + "</g>";

const std::string endless_name(1'000'000, '[');

const std::vector<Refusal> refusals{
    {"AnEmptyDrawing", "", "", {}, "views.svg: draws nothing."},
    {"NoLayerOfAView", some_line, "", {}, "has no layer named side, front, rear or top"},
    {"NoScale", side_layer, "", {}, "nothing says how large the car is in the view side"},
    {"NoCurve",
     "<g id=\"side\"><path d=\"M 0,0 L 500,90\"/></g>",
     side_view + "scale = 5.0\n",
     {},
     "no path in the drawings is named after a curve of the body"},
    {"AnUnknownView", side_layer, "[views.left]\nfile = \"views.svg\"\n", {}, "'left' is no view"},
    {"NoView", side_layer, "tolerance = 1.0\n", {}, "views: is required but missing"},
    {"AMissingFile", side_layer, "[views.side]\nfile = \"a.svg\"\n", {}, "a.svg: does not exist"},
    {"AMissingLayer",
     side_layer,
     side_view + "layer = \"sid\"\n",
     {},
     "views.toml:3: views.side.layer: holds nothing, or does not exist."},
    {"AScaleOfNothing",
     side_layer,
     side_view + "scale = 0.0\n",
     {},
     "views.toml:3: views.side.scale: must be above 0."},
    {"ANoseThatDoesNotFit",
     side_layer,
     side_view + "nose = \"up\"\n",
     {},
     "views.side.nose: does not point up in this view."},
    {"AnUnknownKey", side_layer, side_view + "sclae = 5.0\n", {}, "views.side.sclae"},
    {"ADegreeTooHigh", side_layer, "degree = 12\n" + side_view, {}, "views.toml:1: degree"},
    {"AToleranceOfNothing",
     side_layer,
     "[curves.door_bottom]\ntolerance = -1.0\n" + side_view,
     {},
     "views.toml:2: curves.door_bottom.tolerance: must be above 0."},
    {"ADegreeOfAnUnknownCurve",
     side_layer,
     "",
     {"--degree", "door_botom=4"},
     "no curve is named 'door_botom'; the nearest name is 'door_bottom'"},
    {"ADrawnDegreeTooHigh",
     "<g id=\"side\"><path inkscape:label=\"door_bottom [degree 12]\" d=\"M 0,0 L 500,90\"/></g>",
     side_view + "scale = 5.0\n",
     {},
     "the name 'door_bottom [degree 12]' needs a degree from 2 to 9 in its brackets"},
    {"AnEndlessNameWithABracket",
     "<g id=\"side\"><path inkscape:label=\"" + endless_name + "[\" d=\"M 0,0 L 500,90\"/></g>",
     side_view + "scale = 5.0\n",
     {},
     "no path in the drawings is named after a curve of the body"},
    {"AnEndlessNameWithADegree",
     "<g id=\"side\"><path inkscape:label=\"" + endless_name +
         " [degree 12]\" d=\"M 0,0 L 500,90\"/></g>",
     side_view + "scale = 5.0\n",
     {},
     "[[...' needs a degree from 2 to 9 in its brackets"},
    {"TwoDrawnDegrees",
     "<g id=\"side\"><path inkscape:label=\"door_bottom [degree 4]\" d=\"M 0,0 L 500,90\"/>"
     "<g inkscape:label=\"door_bottom [degree 5]\"><path d=\"M 0,0 L 500,90\"/></g></g>",
     side_view + "scale = 5.0\n",
     {},
     "the curve 'door_bottom' is drawn with the degrees 4 and 5"},
    {"NoDegree", side_layer, "", {"--degree", "3.5"}, "is not a whole number from 2 to 9"},
    {"NoTolerance", side_layer, "", {"--tolerance", "0"}, "is not a number from 0.001"},
    {"SlantedAxes",
     "<g id=\"side\"><path id=\"axes\" d=\"M 100,30 L 0,0 L 0,-100\"/>" + some_line + "</g>",
     "",
     {},
     "the path \"axes\" of the view side does not lie as it should"},
};

INSTANTIATE_TEST_SUITE_P(Each, RefusedSketch, ::testing::ValuesIn(refusals),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace bodyline
