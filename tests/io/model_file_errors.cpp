#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "io/read_model.hpp"
#include "tests/io/bad_model_file.hpp"
#include "tests/io/model_file_support.hpp"

namespace bodyline {
namespace {

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

INSTANTIATE_TEST_SUITE_P(Toml, BadModelFile, ::testing::ValuesIn(toml_mistakes()), name_of);
INSTANTIATE_TEST_SUITE_P(Keys, BadModelFile, ::testing::ValuesIn(key_mistakes()), name_of);
INSTANTIATE_TEST_SUITE_P(Types, BadModelFile, ::testing::ValuesIn(type_mistakes()), name_of);
INSTANTIATE_TEST_SUITE_P(Names, BadModelFile, ::testing::ValuesIn(name_mistakes()), name_of);

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
