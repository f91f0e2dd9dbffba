#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "io/read_model.hpp"
#include "tests/io/model_file_support.hpp"

namespace bodyline {
namespace {

/// One mistake in the file of model 1: the text `right`, which the file holds after `after`,
/// becomes `wrong`.
struct Mistake {
  std::string name;
  std::string after;
  std::string right;
  std::string wrong;
  std::string key;                 ///< of the error
  std::vector<std::string> words;  ///< in the sentence: the value and what is allowed
  int lines_down = 0;              ///< from the start of `wrong` to the line of the error
  std::string at = "";             ///< or: the text on the line of the error
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

const std::string hood = "[patches.hood]\n";
const std::string hood_joint = "[joints.hood__windshield]\n";

std::vector<Mistake> toml_mistakes() {
  return {
      {"letter_outside_quotes", hood, "central", "zentr\xc3\xa4l", "", {"ASCII", "quotes"}},
      {"quotes_within_word",
       "",
       "name = \"model1\"",
       "name = 1\"\xc3\xa4\"",
       "",
       {"ASCII", "space before"}},
      {"continued_beyond_ascii",
       "",
       "note = \"\"\"\n",
       "note = \"\"\"\\\n\xc3\xa4",
       "",
       {"backslash", "ASCII"},
       1},
      {"not_toml", "", "format = 1", "format : 1", "", {"not valid TOML"}},
      {"number_cut_off",
       hood,
       "cut.u = [0.03, 0.98]",
       "cut.u = [0.03, 0.98",
       "",
       {"not valid TOML"},
       1},
      {"text_not_closed", "", "name = \"model1\"", "name = \"model1", "", {"not valid TOML"}},
      {"defined_twice", "", "[patches.hood]", "[patches.grille]", "", {"redefine", "grille"}},
      {"key_twice",
       hood,
       "central = true",
       "central = true\ncentral = true",
       "",
       {"redefine", "central"},
       1},
      {"not_utf8", "", "name = \"model1\"", "name = \"\xff\xfe\"", "", {"not valid TOML"}},
      {"deep_nesting", hood, "cut.u = [0.03, 0.98]", "cut.u = [[[[[[[[[0]]]]]]]]]", "", {"nested"}},
      {"long_dotted_key", hood, "central", "a.b.c.d.e.f.g.h.i.j.k", "", {"dots"}},
  };
}

std::vector<Mistake> key_mistakes() {
  return {
      {"no_format", "", "format = 1\n", "", "format", {"required", "missing"}},
      {"newer_format", "", "format = 1", "format = 2", "format", {"2", "format 1"}},
      {"format_not_whole", "", "format = 1", "format = 1.5", "format", {"1.5", "whole number"}},
      {"unknown_table", "", "[wheels]", "[wheel]", "wheel", {"unknown key", "wheels"}},
      {"unknown_patch_key",
       hood,
       "central",
       "centrall",
       "patches.hood.centrall",
       {"did you mean \"central\"", "; allowed are"}},
      {"unknown_joint_key",
       hood_joint,
       "fullness",
       "fulness",
       "joints.hood__windshield.fulness",
       {"did you mean \"fullness\""}},
      {"unknown_cut_key", hood, "cut.u", "cut.w", "patches.hood.cut.w", {"u, v"}},
      {"unknown_curve_key",
       "[curves.grille__hood]\n",
       "note",
       "remark",
       "curves.grille__hood.remark",
       {"points, note"}},
      {"missing_points",
       "[curves.grille__hood]\n",
       "points =",
       "note =",
       "",
       {"not valid TOML"},
       1},
      {"missing_side",
       hood,
       "u1 = \"hood__windshield\"\n",
       "",
       "patches.hood.u1",
       {"required"},
       -3},
      {"missing_shape", hood, "shape.u = [1, 1]\n", "", "patches.hood.shape.u", {"required"}, 0},
      {"missing_between",
       hood_joint,
       "between = [\"hood\", \"windshield\"]\n",
       "",
       "joints.hood__windshield.between",
       {"required"},
       -1},
      {"bad_name",
       "",
       "[curves.front_arch_top]",
       "[curves.\"front arch\"]",
       "curves.front arch",
       {"letter"}},
      {"unknown_unit", "", "units = \"mm\"", "units = \"ft\"", "units", {"\"ft\"", "\"in\""}},
      {"mirror_side_given",
       hood,
       "central = true",
       "central = true\nv1 = \"hood__front_fender_upper\"",
       "patches.hood.v1",
       {"mirror"},
       1},
      {"unknown_basis",
       hood,
       "central = true",
       "central = true\nbasis = \"ge-bezir\"",
       "patches.hood.basis",
       {"did you mean \"ge-bezier\""},
       1},
  };
}

std::vector<Mistake> type_mistakes() {
  return {
      {"text_for_number",
       hood,
       "shape.u = [1, 1]",
       "shape.u = [1, \"1\"]",
       "patches.hood.shape.u[1]",
       {"a number", "the text \"1\""}},
      {"number_for_text",
       hood,
       "u0 = \"grille__hood\"",
       "u0 = 7",
       "patches.hood.u0",
       {"a text", "the number 7"}},
      {"text_for_flag",
       hood,
       "central = true",
       "central = \"yes\"",
       "patches.hood.central",
       {"true or false", "\"yes\""}},
      {"number_for_table",
       hood,
       "cut.u = [0.03, 0.98]\ncut.v = [0.02, 0.98]",
       "cut = 0.03",
       "patches.hood.cut",
       {"a table", "0.03"}},
      {"number_for_array",
       hood,
       "cut.u = [0.03, 0.98]",
       "cut.u = 0.03",
       "patches.hood.cut.u",
       {"2 numbers", "0.03"}},
      {"date_for_number",
       hood,
       "shape.u = [1, 1]",
       "shape.u = [1, 2020-05-29]",
       "patches.hood.shape.u[1]",
       {"a number", "a date"}},
      {"three_cut_values",
       hood,
       "cut.u = [0.03, 0.98]",
       "cut.u = [0.03, 0.98, 1]",
       "patches.hood.cut.u",
       {"2 numbers", "3"}},
      {"one_fullness",
       hood_joint,
       "fullness = [1.5, 1.5]",
       "fullness = [1.5]",
       "joints.hood__windshield.fullness",
       {"2 numbers", "1"}},
      {"point_of_two",
       "[curves.grille__hood]\n",
       "[5, -172, 567]",
       "[5, -172]",
       "curves.grille__hood.points[1]",
       {"3 coordinates", "2"}},
      {"row_of_long_curve",
       "[curves.roof__side_window]\n",
       "[2382, -503, 1176]",
       "[2382, -503, true]",
       "curves.roof__side_window.points[1][2]",
       {"a number", "true"}},
      {"curve_of_two_points",
       "[curves.grille_bottom]\n",
       ", [-8, -96, 0], [-8, 96, 0]",
       "",
       "curves.grille_bottom.points",
       {"3 to 10 points", "2"}},
      {"nan",
       "[curves.grille__hood]\n",
       "[5, -172, 567]",
       "[5, nan, 567]",
       "curves.grille__hood.points[1][1]",
       {"finite", "nan"}},
      {"infinity",
       hood,
       "shape.u = [1, 1]",
       "shape.u = [-inf, 1]",
       "patches.hood.shape.u[0]",
       {"finite", "-inf"}},
      {"huge_number",
       "[curves.grille__hood]\n",
       "[5, -172, 567]",
       "[5, 1e308, 567]",
       "curves.grille__hood.points[1][1]",
       {"1e+308", "1000000"}},
      {"huge_integer",
       hood,
       "shape.u = [1, 1]",
       "shape.u = [9223372036854775807, 1]",
       "patches.hood.shape.u[0]",
       {"9223372036854775807"}},
      {"integer_overflow",
       hood,
       "shape.u = [1, 1]",
       "shape.u = [9223372036854775808, 1]",
       "",
       {"not valid TOML"}},
  };
}

std::vector<Mistake> name_mistakes() {
  return {
      {"unknown_curve",
       hood,
       "u0 = \"grille__hood\"",
       "u0 = \"grille__hod\"",
       "patches.hood.u0",
       {"grille__hod", "did you mean \"grille__hood\""}},
      {"unknown_patch",
       hood_joint,
       "\"windshield\"",
       "\"winshield\"",
       "joints.hood__windshield.between",
       {"did you mean \"windshield\""}},
      {"joint_without_curve",
       "",
       "[joints.hood__windshield]",
       "[joints.hood__roof]",
       "joints.hood__roof",
       {"no curve of this name"}},
      {"patch_away_from_curve",
       hood_joint,
       "\"windshield\"",
       "\"roof\"",
       "joints.hood__windshield.between",
       {"\"roof\"", "no side"}},
      {"joined_to_itself",
       hood_joint,
       "\"windshield\"",
       "\"hood\"",
       "joints.hood__windshield.between",
       {"\"hood\" twice"}},
      {"seam_is_a_joint",
       "",
       "[seams.front_fender_upper__door_upper]\nbetween = [\"front_fender_upper\", \"door_upper\"]",
       "[seams.side_window__door_upper]\nbetween = [\"side_window\", \"door_upper\"]",
       "seams.side_window__door_upper",
       {"joint"}},
      {"unknown_uncut",
       "",
       "uncut = \"door_upper\"",
       "uncut = \"roof\"",
       "joints.door_upper__door_lower.uncut",
       {"\"door_upper\" or \"door_lower\""}},
      {"unknown_corner_patch",
       "[corners.a_pillar_top]\n",
       "\"roof\"",
       "\"rof\"",
       "corners.a_pillar_top.patches[1]",
       {"did you mean \"roof\""}},
      {"corner_patch_twice",
       "[corners.a_pillar_top]\n",
       "\"roof\"",
       "\"windshield\"",
       "corners.a_pillar_top.patches[1]",
       {"already"}},
      {"apex_elsewhere",
       "[corners.a_pillar_top]\n",
       "apex = \"side_window\"",
       "apex = \"hood\"",
       "corners.a_pillar_top.apex",
       {"\"hood\""}},
      {"unknown_arch",
       "[wheels]\n",
       "\"front_arch_top\"",
       "\"front_arch\"",
       "wheels.front[1]",
       {"no curve of this name"}},
      {"arch_twice",
       "[wheels]\n",
       "\"front_arch_top\"",
       "\"front_arch_front\"",
       "wheels.front[1]",
       {"already"}},
  };
}

std::vector<Mistake> body_mistakes() {
  return {
      {"cut_order",
       hood,
       "cut.u = [0.03, 0.98]",
       "cut.u = [0.98, 0.03]",
       "patches.hood.cut.u",
       {"0.98, 0.03", "lower < upper"}},
      {"cut_below_zero",
       hood,
       "cut.u = [0.03, 0.98]",
       "cut.u = [-0.03, 0.98]",
       "patches.hood.cut.u",
       {"-0.03", "0 <="}},
      {"cut_missing_at_joint",
       hood,
       "cut.u = [0.03, 0.98]",
       "cut.u = [0, 0.98]",
       "patches.hood.cut.u",
       {"joint"}},
      {"cut_at_free_edge",
       "[patches.grille]\n",
       "cut.u = [0, 0.95]",
       "cut.u = [0.1, 0.95]",
       "patches.grille.cut.u",
       {"0.1"}},
      {"cut_not_symmetric",
       hood,
       "cut.v = [0.02, 0.98]",
       "cut.v = [0.02, 0.97]",
       "patches.hood.cut.v",
       {"0.97", "add up to 1"}},
      {"seam_cuts_differ",
       "[patches.front_fender_upper]\n",
       "cut.v = [0, 0.81]",
       "cut.v = [0, 0.72]",
       "patches.door_upper.cut.u",
       {"0.72", "0.81"},
       0,
       "cut.u = [0, 0.81]"},
      {"shape_not_symmetric",
       hood,
       "shape.v = [0, 0]",
       "shape.v = [0, 1]",
       "patches.hood.shape.v",
       {"symmetric"}},
      {"shape_count",
       hood,
       "shape.u = [1, 1]",
       "shape.u = [1, 1, 1]",
       "patches.hood.shape.u",
       {"3 values", "has 2"}},
      {"fullness_zero",
       hood_joint,
       "fullness = [1.5, 1.5]",
       "fullness = [0, 1.5]",
       "joints.hood__windshield.fullness",
       {"is 0", "below 3"}},
      {"fullness_three",
       hood_joint,
       "fullness = [1.5, 1.5]",
       "fullness = [1.5, 3]",
       "joints.hood__windshield.fullness",
       {"is 3", "below 3"}},
      {"lean_too_far",
       "",
       "lean.b = [0.6, 0.6]",
       "lean.b = [0.6, 6]",
       "joints.side_window__door_upper.lean.b",
       {"is 6", "5"}},
      {"lean_away_from_seam",
       "",
       "lean.b = [0.6, 0.6]",
       "lean.a = [0.6, 0.6]",
       "joints.side_window__door_upper.lean.a",
       {"0.6", "seam"}},
      {"open_patch_corner",
       "[curves.grille__front_fender_lower]\n",
       "[47, -507, 529]",
       "[47, -507, 528]",
       "patches.grille.v0",
       {"close", "528", "529"},
       0,
       "v0 = \"grille__front_fender_lower\""},
      {"curve_not_symmetric",
       "[curves.grille__hood]\n",
       "[5, 172, 567]",
       "[5, 173, 567]",
       "curves.grille__hood.points[1]",
       {"mirror", "173"}},
      {"curve_used_once",
       "[patches.windshield]\n",
       "u0 = \"hood__windshield\"",
       "u0 = \"grille__hood\"",
       "joints.hood__windshield.between",
       {"\"windshield\"", "no side", "\"hood__windshield\""},
       0,
       "between = [\"hood\", \"windshield\"]"},
      {"curve_unused",
       "",
       "[curves.front_arch_top]",
       "[curves.spare]\npoints = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]\n\n[curves.front_arch_top]",
       "curves.spare",
       {"no patch"}},
      {"degrees_differ",
       "[curves.front_arch_top]\n",
       "[881, -920, 578], ",
       "",
       "patches.front_fender_upper.v1",
       {"3", "4"},
       0,
       "v1 = \"hood__front_fender_upper\""},
      {"joint_not_named",
       "",
       "[joints.grille__hood]\nbetween = [\"grille\", \"hood\"]\nfullness = [1.5, 1.5]\n",
       "",
       "curves.grille__hood",
       {"share this curve", "no joint"},
       0,
       "[curves.grille__hood]"},
      {"corner_not_named",
       "",
       "[corners.a_pillar_top]\npatches = [\"windshield\", \"roof\", \"side_window\"]\napex = "
       "\"side_window\"\n",
       "",
       "joints.windshield__side_window",
       {"corner"},
       0,
       "[joints.windshield__side_window]"},
      {"corner_order",
       "[corners.grille_corner]\n",
       "\"hood\", \"front_fender_upper\"",
       "\"front_fender_upper\", \"hood\"",
       "corners.grille_corner.patches",
       {"follow each other"}},
      {"corner_far_apart",
       "[corners.grille_corner]\n",
       "\"hood\"",
       "\"tail\"",
       "corners.grille_corner.patches",
       {"in common"}},
  };
}

class BadModelFile : public ::testing::TestWithParam<Mistake> {};

TEST_P(BadModelFile, GetsOneSentenceWithFileLineKeyAndValue) {
  const Mistake& mistake = GetParam();
  std::string text = testing::file_text(testing::car_path("model1"));
  const auto start = text.find(mistake.after);
  ASSERT_NE(start, std::string::npos);
  const auto at = text.find(mistake.right, start + mistake.after.size());
  ASSERT_NE(at, std::string::npos);
  text.replace(at, mistake.right.size(), mistake.wrong);
  const auto place = mistake.at.empty() ? at : text.find(mistake.at);
  ASSERT_NE(place, std::string::npos);
  const auto line = 1 + mistake.lines_down +
                    std::count(text.begin(), text.begin() + static_cast<long>(place), '\n');
  try {
    io::read_model_text(text, "car.toml");
    FAIL() << "was accepted";
  } catch (const io::InputError& error) {
    EXPECT_EQ(error.key(), mistake.key) << error.what();
    EXPECT_EQ(error.line(), line) << error.what();
    EXPECT_THAT(error.what(), ::testing::StartsWith("car.toml:" + std::to_string(line) + ": "));
    EXPECT_THAT(error.sentence(), ::testing::Not(::testing::HasSubstr("\n")));
    EXPECT_THAT(error.sentence(), ::testing::EndsWith("."));
    for (const std::string& word : mistake.words) {
      EXPECT_THAT(error.sentence(), ::testing::HasSubstr(word));
    }
  }
}

const auto name_of = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Toml, BadModelFile, ::testing::ValuesIn(toml_mistakes()), name_of);
INSTANTIATE_TEST_SUITE_P(Keys, BadModelFile, ::testing::ValuesIn(key_mistakes()), name_of);
INSTANTIATE_TEST_SUITE_P(Types, BadModelFile, ::testing::ValuesIn(type_mistakes()), name_of);
INSTANTIATE_TEST_SUITE_P(Names, BadModelFile, ::testing::ValuesIn(name_mistakes()), name_of);
INSTANTIATE_TEST_SUITE_P(Body, BadModelFile, ::testing::ValuesIn(body_mistakes()), name_of);

TEST(ModelFile, MissingFileAndFolderAreNamed) {
  for (const std::string& path :
       {std::string("/nowhere/car.toml"), std::string(BODYLINE_SOURCE_DIR)}) {
    try {
      io::read_model(path);
      FAIL() << path;
    } catch (const io::InputError& error) {
      EXPECT_THAT(error.what(), ::testing::StartsWith(path + ": "));
    }
  }
}

}  // namespace
}  // namespace bodyline
