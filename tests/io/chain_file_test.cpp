#include "io/chain_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/input_error.hpp"
#include "model/chain_faces.hpp"
#include "tests/io/model_file_support.hpp"

namespace bodyline {
namespace {

std::string example(const std::string& name) {
  return BODYLINE_SOURCE_DIR "/examples/" + name + ".toml";
}

class ChainFileOf : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Examples, ChainFileOf, ::testing::Values("hull", "pair", "headlight"),
                         [](const auto& at) { return std::string(at.param); });

TEST_P(ChainFileOf, ComesBackBitForBit) {
  const std::string text = io::write_chain_text(io::read_chain(example(GetParam())));
  EXPECT_EQ(io::write_chain_text(io::read_chain_text(text, "again")), text);
}

// The pieces of neighbouring patches share whole boundary nets, so that nothing opens between them.
TEST(ChainFile, FacesOfTheHullHaveNoGapBetweenThem) {
  const auto chain = std::get<model::PatchChain>(io::read_chain(example("hull")).chain);
  const auto faces = model::chain_faces(chain, 0.01);
  int shared = 0;
  for (const model::Surface& a : faces) {
    for (const model::Surface& b : faces) {
      double gap = 0.0;
      for (int j = 0; j <= a.degree_v; ++j)
        gap = std::max(gap, (a.point(a.degree_u, j) - b.point(0, j)).norm());
      if (gap <= 1e-8) ++shared;
    }
  }
  std::size_t along = 0;
  for (const model::Surface& face : faces) along += face.name.starts_with("bow") ? 1 : 0;
  EXPECT_GT(along, 1u);
  EXPECT_GE(shared, 3);
}

struct Mistake {
  const char* name;
  const char* file;
  const char* right;
  const char* wrong;
  const char* key;
  const char* words;
};

class BadChainFile : public ::testing::TestWithParam<Mistake> {};
INSTANTIATE_TEST_SUITE_P(
    Mistakes, BadChainFile,
    ::testing::Values(Mistake{"family", "hull", "\"h-bezier\"", "\"hbezier\"", "family",
                              "known are ge-bezier, bezier-like, h-bezier"},
                      Mistake{"no_theorem", "hull", "\"h-bezier\"", "\"ge-bezier\"", "patches.bow",
                              "shape parameters along u"},
                      Mistake{"tied_shape", "hull", "shape.u = [0.5, 2, 1]\nshape.v = [1, 2, 1]",
                              "shape.u = [0.5, 2, 1]\nshape.v = [1, 2, 3]", "patches.fore.join",
                              "must be equal, but are 1 and 3"},
                      Mistake{"negative", "hull", "shape.u = [1, 1, 0.5]", "shape.u = [1, -1, 0.5]",
                              "patches.bow", "from 0 to 1000000"},
                      Mistake{"direction", "hull", "join.direction = \"v\"",
                              "join.direction = \"w\"", "patches.fore.join.direction",
                              "known are u, uv and v"},
                      Mistake{"ratio", "hull", "join.ratio = 1", "join.ratio = 0",
                              "patches.fore.join", "must be positive"},
                      Mistake{"continuity", "pair", "join.continuity = 2", "join.continuity = 3",
                              "patches.second.join", "continuity is 1 or 2"},
                      Mistake{"half_degree", "pair", "degree = [4, 4]", "degree = [4, 4.5]",
                              "patches.first.degree", "2 whole numbers"},
                      Mistake{"unknown_key", "headlight", "join.ratio", "join.ration",
                              "curves.c1.join.ration", "did you mean \"ratio\""},
                      Mistake{"too_few_shapes", "headlight", "shape = [1, 2, 1]", "shape = [1, 2]",
                              "curves.c1", "has 2 shape parameters, but needs 3"}),
    [](const auto& at) { return at.param.name; });

TEST_P(BadChainFile, IsRefusedWithItsKeyAndWhatIsAllowed) {
  std::string text = testing::file_text(example(GetParam().file));
  const std::size_t at = text.find(GetParam().right);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(GetParam().right).size(), GetParam().wrong);
  try {
    io::read_chain_text(text, "chain.toml");
    FAIL();
  } catch (const io::InputError& error) {
    EXPECT_EQ(error.key(), GetParam().key);
    EXPECT_THAT(error.what(), ::testing::HasSubstr(GetParam().words));
    EXPECT_GT(error.line(), 0);
  }
}

}  // namespace
}  // namespace bodyline
