// Stores that are put together from several.

#include "explore/merge_stores.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "explore/store_sensitivity.hpp"
#include "store_support.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

using explore::Study;
using ::testing::HasSubstr;

constexpr int rows = 100;

const std::string model1 = "model = \"model1.toml\"";
const std::string shape = "fullness = { vary = [\"fullness.hood*\"], range = [1.0, 2.0] }\n";
const std::string link =
    "tail = { vary = [\"shape.tail.u*\"], factor = [0.5, 2], linked = true }\n";
const std::string metrics = "bending = {}\nheight = {}";
const std::string outlined =
    "bending = {}\noutline = { kind = \"outline\", views = \"side=a.svg\" }";

std::string sampler(int seed) {
  return "kind = \"random\"\ncount = 100\nseed = " + std::to_string(seed);
}

void make_store(const std::filesystem::path& path, const Study& study) {
  explore::StoreWriter store = new_store(path, study, rows);
  store.append(made_up_rows(store.layout(), 0, rows));
  store.finish();
}

// The sentence with which the stores of two studies are not put together.
std::string sentence_for(const Study& a, const Study& b) {
  const Folder folder;
  make_store(folder / "a.h5", a);
  make_store(folder / "b.h5", b);
  try {
    explore::merge_stores({folder / "a.h5", folder / "b.h5"}, folder / "c.h5", false);
  } catch (const explore::StoreError& error) {
    return error.what();
  }
  return "";
}

std::string sentence_for(const std::string& a, const std::string& b) {
  return sentence_for(study_of(a), study_of(b));
}

std::string text_with(const std::string& wanted_metrics, const std::string& rest = "") {
  return study_text(model1, shape, wanted_metrics, sampler(1), rest);
}

TEST(MergeStores, TakesStudiesThatDifferInWhatTheyTry) {
  EXPECT_EQ(sentence_for(study_text(model1, shape + link, metrics, sampler(1)),
                         study_text(model1,
                                    "fullness = { vary = [\"fullness.hood*\"], range = [1, 1.5] }\n"
                                    "tail = { vary = [\"shape.tail.u*\"], factor = [0.9, 2], "
                                    "linked = true }",
                                    metrics, sampler(2))),
            "");
}

TEST(MergeStores, RefusesWhatWouldNotMeanTheSame) {
  const std::string plain = text_with(metrics);
  EXPECT_THAT(sentence_for(plain, "nodes = 16\n" + plain), HasSubstr("\"nodes\" differ"));
  EXPECT_THAT(sentence_for(plain, text_with(metrics, "[checks]\nfolds = false")),
              HasSubstr("checks differ"));
  EXPECT_THAT(sentence_for(plain, text_with(metrics, "[constraints]\nheight = { most = 1300 }")),
              HasSubstr("constraints differ"));
  EXPECT_THAT(sentence_for(text_with(metrics, "[constraints]\nheight = { most = 1250 }"),
                           text_with(metrics, "[constraints]\nheight = { most = 1300 }")),
              HasSubstr("constraints differ"));
  EXPECT_THAT(sentence_for(text_with(outlined),
                           text_with("bending = {}\noutline = { kind = \"outline\", views = "
                                     "\"side=b.svg\" }")),
              HasSubstr("metrics differ"));
  const auto scan = [](const std::string& more) {
    return text_with("bending = {}\nscan = { file = \"a.xyz\"" + more + " }");
  };
  EXPECT_THAT(sentence_for(scan(""), scan(", points = 500")), HasSubstr("metrics differ"));
  EXPECT_THAT(sentence_for(scan(""), scan(", posed = true")), HasSubstr("metrics differ"));
  EXPECT_THAT(sentence_for(study_text(model1, shape + link, metrics, sampler(1)),
                           study_text(model1,
                                      shape + "tail = { vary = [\"shape.tail.u*\"], factor = [0.5, "
                                              "2], linked = true }\n",
                                      metrics, sampler(1))),
              "");
  EXPECT_THAT(sentence_for(study_text(model1, shape + link, metrics, sampler(1)),
                           study_text(model1,
                                      shape + "tail = { vary = [\"shape.tail.v*\"], factor = [0.5, "
                                              "2], linked = true }\n",
                                      metrics, sampler(1))),
              HasSubstr("linked variables differ"));
}

TEST(MergeStores, RefusesAnotherScanOfTheSameName) {
  Study a = study_of(text_with("bending = {}\nscan = { file = \"a.xyz\" }")), b = a;
  a.files = {{"a.xyz", 9, "995dc9bbdf1939fa"}};
  b.files = {{"a.xyz", 9, "995dc9bbdf1939fb"}};
  EXPECT_THAT(sentence_for(a, b), HasSubstr("scans or drawings differ"));
}

// Its rows are not those of the design of the study that it holds.
TEST(MergeStores, MakesWhatNoRunGoesOnWithAndNoDesignIsReadFrom) {
  const Folder folder;
  const Study study = study_of(
      study_text(model1, shape, metrics, "kind = \"morris\"\ntrajectories = 2\nlevels = 4"));
  make_store(folder / "a.h5", study);
  make_store(folder / "b.h5", study);
  EXPECT_FALSE(explore::StoreReader(folder / "a.h5").header().merged);
  explore::merge_stores({folder / "a.h5", folder / "b.h5"}, folder / "c.h5", false);
  const explore::StoreReader merged(folder / "c.h5");
  EXPECT_TRUE(merged.header().merged);
  EXPECT_EQ(merged.rows(), 2u * rows);
  try {
    explore::store_sensitivity(merged, "height");
    ADD_FAILURE() << "sensitivities of a mixture";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("put together from several"));
  }
  try {
    explore::StoreWriter::resume(folder / "c.h5", study);
    ADD_FAILURE() << "a run goes on behind foreign rows";
  } catch (const explore::StoreError& error) {
    EXPECT_THAT(error.what(), HasSubstr("put together from several stores"));
  }
}

}  // namespace
}  // namespace bodyline::testing
