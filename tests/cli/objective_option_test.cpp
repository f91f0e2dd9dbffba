#include "cli/objective_option.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace bodyline {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(ObjectiveOption, ReadsTermsWeightsAndFaces) {
  const auto terms =
      cli::objective_from_text("bending=2.5,variation@hood+roof*=1e-2,area", model::Stage::kept);
  ASSERT_EQ(terms.size(), 3U);
  EXPECT_EQ(terms[0].kind, model::TermKind::bending);
  EXPECT_EQ(terms[0].weight, 2.5);
  EXPECT_THAT(terms[0].faces, IsEmpty());
  EXPECT_EQ(terms[1].kind, model::TermKind::variation);
  EXPECT_EQ(terms[1].weight, 0.01);
  EXPECT_THAT(terms[1].faces, ElementsAre("hood", "roof*"));
  EXPECT_EQ(terms[2].weight, 1.0);
  for (const model::Term& term : terms) EXPECT_EQ(term.stage, model::Stage::kept);
}

TEST(ObjectiveOption, KeysReadBackAsTheSameTerm) {
  for (const std::string key : {"bending", "variation@hood", "fold@hood+roof*+a_b"}) {
    EXPECT_EQ(cli::term_key(cli::objective_from_text(key + "=3", model::Stage::body).front()), key);
  }
}

TEST(ObjectiveOption, RefusesWhatItDoesNotUnderstand) {
  for (const std::string text :
       {"", ",", "bending=", "bending=1,", "bending=1;area=1", "bending=1x", "bending=inf",
        "bending=nan", "bending=-1", "bend=1", "bending@=1", "bending@hood+=1", "=1",
        "bending=1,bending=2", "bending@hood=1,bending@hood=2", "closeness@hood=1", " bending=1"}) {
    EXPECT_THROW(cli::objective_from_text(text, model::Stage::body), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace bodyline
