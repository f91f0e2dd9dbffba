#include "explore/read_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "explore/variant_list.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

using ::testing::HasSubstr;

const std::string base = "model = \"model1.toml\"";
const std::string shape = "shape = { vary = [\"shape.*\"], offset = [-0.1, 0.1] }";
const std::string sobol = "kind = \"sobol\"\ncount = 8";

TEST(ReadStudy, TakesAllThatAStudySays) {
  const explore::Study study = study_of(study_text(
      base, shape, "bending = {}\nhood = { kind = \"area\", faces = [\"hood\"], stage = \"kept\" }",
      "kind = \"saltelli\"\ncount = 16\nseed = 5\nscrambled = false\nsecond_order = true",
      "[constraints]\nhood = { least = 1, most = 2 }\n[checks]\nfolds = false\n[keep]\nnets = "
      "true\n"
      "thumbnails = 128\ncompressed = false\nblock = 256"));
  EXPECT_EQ(study.name, "test");
  EXPECT_EQ(study.models.front().name, "model1");
  ASSERT_EQ(study.metrics.size(), 2u);
  EXPECT_EQ(study.metrics[1].kind, explore::MetricKind::area);
  EXPECT_EQ(study.metrics[1].stage, model::Stage::kept);
  EXPECT_EQ(study.sampler.kind, explore::SamplerKind::saltelli);
  EXPECT_EQ(study.sampler.seed, 5u);
  EXPECT_FALSE(study.sampler.scrambled);
  EXPECT_TRUE(study.sampler.second_order);
  EXPECT_EQ(study.constraints.front().least, 1.0);
  EXPECT_FALSE(study.checks.folds);
  EXPECT_TRUE(study.keep.nets);
  EXPECT_EQ(study.keep.thumbnail_width, 128);
  EXPECT_FALSE(study.keep.compressed);
  EXPECT_EQ(study.keep.block, 256);
  ASSERT_EQ(study.inputs.size(), 2u);
  EXPECT_EQ(study.inputs[1].name, "model1.toml");
}

TEST(ReadStudy, FindsFilesBesideTheStudy) {
  const Folder folder;
  std::filesystem::copy_file(std::filesystem::path(BODYLINE_SOURCE_DIR) / "cars/model1.toml",
                             folder / "model1.toml");
  std::ofstream(folder / "study.toml") << study_text(base, shape, "bending = {}", sobol);
  EXPECT_EQ(explore::read_study(folder / "study.toml").models.front().model.name, "model1");
}

// The content of a scan is not kept, but what it takes to see that it is another.
TEST(ReadStudy, KnowsTheFilesThatMetricsMeasureAgainst) {
  const Folder folder;
  std::filesystem::copy_file(std::filesystem::path(BODYLINE_SOURCE_DIR) / "cars/model1.toml",
                             folder / "model1.toml");
  std::ofstream(folder / "study.toml") << study_text(base, shape,
                                                     "a = { kind = \"scan\", file = \"a.xyz\" }\n"
                                                     "b = { kind = \"scan\", file = \"a.xyz\" }\n"
                                                     "c = { kind = \"scan\", file = \"none.xyz\" }",
                                                     sobol);
  const auto files_with = [&](const std::string& content) {
    std::ofstream(folder / "a.xyz") << content;
    return explore::read_study(folder / "study.toml").files;
  };
  const auto first = files_with("123456789");
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0], (explore::MeasuredFile{"a.xyz", 9, "995dc9bbdf1939fa"}));  // as XZ has it
  EXPECT_EQ(first[1], (explore::MeasuredFile{"none.xyz", 0, ""}));
  EXPECT_NE(files_with("123456788"), first);
  EXPECT_EQ(files_with("123456789"), first);
}

struct Refused {
  const char* name;
  std::string text;
  const char* sentence;
};

void PrintTo(const Refused& refused, std::ostream* stream) { *stream << refused.name; }

class RefusedStudy : public ::testing::TestWithParam<Refused> {};

TEST_P(RefusedStudy, SaysWhere) {
  EXPECT_THAT(refusal(GetParam().text), HasSubstr(GetParam().sentence));
}

std::string with_metrics(const std::string& metrics) {
  return study_text(base, shape, metrics, sobol);
}
std::string with_sampler(const std::string& sampler) {
  return study_text(base, shape, "bending = {}", sampler);
}
std::string with_rest(const std::string& rest) {
  return study_text(base, shape, "bending = {}", sobol, rest);
}
std::string with_variables(const std::string& variables) {
  return study_text(base, variables, "bending = {}", sobol);
}

INSTANTIATE_TEST_SUITE_P(
    Each, RefusedStudy,
    ::testing::Values(
        Refused{"NotToml", "format = ", "study.toml:1: not valid TOML"},
        Refused{"Format", "format = 2", "study.toml:1: format: is 2"},
        Refused{"NoBase", study_text("", shape, "bending = {}", sobol), "exactly one of"},
        Refused{"TwoBases",
                study_text(base + "\nblend = [\"a\", \"b\"]", shape, "bending = {}", sobol),
                "exactly one of"},
        Refused{"NoModel", study_text("model = \"no.toml\"", shape, "bending = {}", sobol),
                "no.toml: does not exist."},
        Refused{"SameNames",
                study_text("blend = [\"model1.toml\", \"model1.toml\"]", "", "bending = {}", sobol),
                "two models have files of the same name"},
        Refused{"UnknownKey", with_rest("[keep]\nnet = true"),
                "study.toml:12: keep.net: unknown key"},
        Refused{"TwoRanges",
                with_variables("x = { vary = [\"cut.*\"], range = [0, 1], width = [0.1, 0.2] }"),
                "variables.x.width: is a second range"},
        Refused{"FallingRange", with_variables("x = { vary = [\"cut.*\"], range = [1, 0] }"),
                "must rise"},
        Refused{"WideWidth", with_variables("x = { vary = [\"cut.*\"], width = [0, 0.1] }"),
                "between 0 and 1"},
        Refused{"LinkedValues",
                with_variables("x = { vary = [\"cut.*\"], range = [0, 1], linked = true }"),
                "needs the range \"offset\" or \"factor\""},
        Refused{"Weights",
                with_variables("x = { vary = [\"cut.*\"], width = [0.1, 0.2], weights = [1] }"),
                "belongs to a linked group"},
        Refused{"OddNodes", study_text(base + "\nnodes = 12", shape, "bending = {}", sobol),
                "nodes: must be a multiple of 8"},
        Refused{"NoMetrics", with_metrics(""), "a study measures something"},
        Refused{"UnknownMetric", with_metrics("weight = {}"),
                "study.toml:7: metrics.weight: \"weight\" is not a metric"},
        Refused{"UnknownFace", with_metrics("bending = { faces = [\"hod\"] }"),
                "metrics.bending.faces"},
        Refused{"FacesOfALength", with_metrics("length = { faces = [\"hood\"] }"),
                "belongs to bending"},
        Refused{"RakeWithoutFace", with_metrics("rake = {}"), "metrics.rake.face: is missing"},
        Refused{"RakeOfASide", with_metrics("rake = { face = \"side_window\" }"),
                "no patch across the middle"},
        Refused{"ScanWithoutFile", with_metrics("scan = {}"), "metrics.scan.file: is missing"},
        Refused{"OutlineWithoutViews", with_metrics("outline = {}"),
                "metrics.outline.views: is missing"},
        Refused{"OutlineOfNoView", with_metrics("outline = { views = \"left=a.svg\" }"),
                "metrics.outline.views"},
        Refused{"ViewsOfAScan", with_metrics("scan = { file = \"a.ply\", views = \"side=a.svg\" }"),
                "metrics.scan.views: belongs to an outline only"},
        Refused{"NoSampler",
                "format = 1\nname = \"x\"\n" + base + "\n[variables]\n" + shape +
                    "\n[metrics]\nbending = {}",
                "sampler: is missing"},
        Refused{"UnknownSampler", with_sampler("kind = \"sobel\""), "\"sobel\" is not a sampler"},
        Refused{"NoCount", with_sampler("kind = \"sobol\""),
                "sampler.count: is missing; the sampler sobol needs it"},
        Refused{"ForeignKey", with_sampler("kind = \"star\"\ncount = 3"),
                "is nothing that the sampler star has"},
        Refused{"TooManyCombinations", with_sampler("kind = \"factorial\"\nlevels = 3"),
                "more than 10^12"},
        Refused{"TooManySobolPoints", with_sampler("kind = \"sobol\"\ncount = 5000000000"),
                "at most 2^32"},
        Refused{"OddLevels", with_sampler("kind = \"morris\"\nlevels = 5\ntrajectories = 2"),
                "must be even"},
        Refused{"UnknownConstraint", with_rest("[constraints]\nlength = { most = 3 }"),
                "constraints.length"},
        Refused{"EmptyConstraint", with_rest("[constraints]\nbending = {}"),
                "needs \"least\", \"most\" or both"},
        Refused{"CrossedConstraint", with_rest("[constraints]\nbending = { least = 2, most = 1 }"),
                "is below \"least\""},
        Refused{"OddBlock", with_rest("[keep]\nblock = 100"), "must be a power of two"}),
    [](const auto& test) { return std::string(test.param.name); });

std::vector<double> list_of(const std::string& text) {
  const explore::Study study =
      study_of(study_text(base, "x = { vary = [\"fullness.hood__windshield.*\"], range = [1, 2] }",
                          "bending = {}", sobol));
  return explore::read_variant_list(text, "list.csv", explore::DesignSpace(study));
}

std::string list_refusal(const std::string& text) {
  try {
    list_of(text);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(VariantList, TakesColumnsInAnyOrderAndLeavesOthersAtTheStart) {
  EXPECT_THAT(list_of("id,in:fullness.hood__windshield.b,out:bending\r\n0,1.25,3\r\n\r\n1,2,4\r\n"),
              ::testing::ElementsAre(1.5, 1.25, 1.5, 2.0));
}

TEST(VariantList, SaysWhatIsWrongAndWhere) {
  const std::string header = "fullness.hood__windshield.a\n";
  EXPECT_THAT(list_refusal(""), HasSubstr("list.csv: is empty"));
  EXPECT_THAT(list_refusal(header), HasSubstr("holds no variant"));
  EXPECT_THAT(list_refusal("fulness.hood__windshield.a\n1\n"), HasSubstr("did you mean"));
  EXPECT_THAT(list_refusal(header + "1.5\n1.x\n"), HasSubstr("list.csv:3: the value \"1.x\""));
  EXPECT_THAT(list_refusal(header + "nan\n"), HasSubstr("is not a finite number"));
  EXPECT_THAT(list_refusal(header + "2.5\n"), HasSubstr("from 1 to 2"));
  EXPECT_THAT(list_refusal(header + "1,2\n"), HasSubstr("has 2 values"));
}

}  // namespace
}  // namespace bodyline::testing
