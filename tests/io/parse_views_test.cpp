#include "io/parse_views.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace bodyline {
namespace {

using io::Nose;
using io::parse_views;
using model::View;

TEST(ViewsOption, NamesAFileForEachView) {
  const auto files = parse_views("side=side.svg,top=drawings/top.png@2.5,front=f.csv,rear=r.svg");
  ASSERT_EQ(files.size(), 4U);
  EXPECT_EQ(files[0].view, View::side);
  EXPECT_EQ(files[0].path, "side.svg");
  EXPECT_FALSE(files[0].scale.has_value());
  EXPECT_EQ(files[0].nose, Nose::left);
  EXPECT_EQ(files[1].view, View::top);
  EXPECT_EQ(files[1].path, "drawings/top.png");
  EXPECT_EQ(files[1].scale, 2.5);
}

TEST(ViewsOption, TellsWhereTheNosePoints) {
  EXPECT_EQ(parse_views("side=a.svg:nose-right")[0].nose, Nose::right);
  const auto file = parse_views("top=a.svg@10:nose-up")[0];
  EXPECT_EQ(file.nose, Nose::up);
  EXPECT_EQ(file.scale, 10.0);
  EXPECT_EQ(file.path, "a.svg");
}

TEST(ViewsOption, KeepsNamesThatHoldItsMarks) {
  EXPECT_EQ(parse_views("side=me@home.svg")[0].path, "me@home.svg");
  EXPECT_EQ(parse_views("side=me@home.svg@2")[0].path, "me@home.svg");
  EXPECT_EQ(parse_views("side=a=b:c.svg")[0].path, "a=b:c.svg");
}

std::string refusal(const std::string& text) {
  try {
    parse_views(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ViewsOption, IsRefusedWithASentence) {
  EXPECT_EQ(refusal(""), "no view is given");
  EXPECT_EQ(refusal("side.svg"),
            "\"side.svg\" lacks a view: write side=FILE, front=FILE, rear=FILE or top=FILE");
  EXPECT_EQ(refusal("left=a.svg"), "'left' is no view; there are side, front, rear and top");
  EXPECT_EQ(refusal("side="), "the view side has no file");
  EXPECT_EQ(refusal("side=@2"), "the view side has no file");
  EXPECT_EQ(refusal("side=a.svg,side=b.svg"), "the view side is given twice");
  EXPECT_EQ(refusal("side=a.svg@-2"),
            "a scale is a number above 0, in mm per unit of the drawing, not \"-2\"");
  EXPECT_EQ(refusal("side=a.svg@nan"),
            "a scale is a number above 0, in mm per unit of the drawing, not \"nan\"");
  EXPECT_EQ(refusal("front=a.svg:nose-right"), "the nose does not point right in a view front");
  EXPECT_EQ(refusal("side=a.svg:nose-up"), "the nose does not point up in a view side");
  EXPECT_EQ(refusal("side=a.svg:nose-east"),
            "\"east\" is no way a nose points; those are left, right, up and down");
}

}  // namespace
}  // namespace bodyline
