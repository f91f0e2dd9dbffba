// The command `outline`, and `fit` to what it writes.

#include <gmock/gmock.h>

#include "io/read_drawing.hpp"
#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using ::testing::HasSubstr;

class OutlineCommand : public testing::CommandLine {};

TEST_F(OutlineCommand, WritesEveryView) {
  const auto report = json({"outline", car("model2"), "-o", "{view}.svg", "--json"});
  for (const std::string view : {"side", "front", "rear", "top"}) {
    EXPECT_EQ(report.at(view).at("file"), view + ".svg");
    EXPECT_EQ(report.at(view).at("lines"), 1);
    const auto drawing = io::read_drawing(file(view + ".svg"));
    const Eigen::Vector2d size = model::drawn_box(drawing.paths).sizes();
    EXPECT_NEAR(size.x(), report.at(view).at("size_mm").at(0), 0.01);
    EXPECT_NEAR(size.y(), report.at(view).at("size_mm").at(1), 0.01);
  }
  // The same car from all sides.
  EXPECT_NEAR(report.at("side").at("size_mm").at(0), report.at("top").at("size_mm").at(0), 0.1);
  EXPECT_NEAR(report.at("side").at("size_mm").at(1), report.at("front").at("size_mm").at(1), 0.1);
}

TEST_F(OutlineCommand, WritesTheSameBytesAgain) {
  for (const std::string name : {"a.csv", "b.csv"})
    EXPECT_EQ(bodyline({"outline", car("model1"), "-o", name, "--view", "top"}).exit_code, 0);
  EXPECT_EQ(text("a.csv"), text("b.csv"));
}

TEST_F(OutlineCommand, WritesWhatFitTakes) {
  ASSERT_EQ(bodyline({"outline", car("model2"), "-o", "{view}.svg"}).exit_code, 0);
  write(
      "edge.csv",
      "x,y,z\n2122.0,-548.0,1185.0\n2092.7,-469.2,1194.8\n2068.1,-388.8,1203.0\n2048.2,-307.0,1209."
      "6\n2033.2,-224.1,1214.6\n2022.9,-140.4,1218.0\n2017.3,-56.2,1219.9\n2016.2,0.0,1220.2\n");
  const auto report =
      json({"fit", "--views", "side=side.svg,top=top.svg,front=front.svg", "--feature",
            "windshield__roof=edge.csv", "-o", "car.toml", "--report", "car.html", "--json"});
  for (const std::string view : {"side", "top", "front"})
    EXPECT_LE(report.at("outline_mm").at(view).at("median"), 1.0) << view;
  EXPECT_FALSE(report.at("outline_mm").contains("rear"));
  EXPECT_LE(report.at("feature_mm").at("windshield__roof").at("median"), 1.0);
  EXPECT_TRUE(report.at("folded").empty());
  EXPECT_FALSE(report.contains("pose"));
  EXPECT_THAT(text("car.html"), HasSubstr("Outline from side"));
  EXPECT_EQ(bodyline({"check", "car.toml"}).exit_code, 1);  // seams, as in the template
}

TEST_F(OutlineCommand, OutlinesFindTheirPlaceOnAScan) {
  ASSERT_EQ(bodyline({"outline", car("model2"), "-o", "side.svg", "--view", "side"}).exit_code, 0);
  ASSERT_EQ(bodyline({"scan", car("model2"), "-o", "scan.ply", "--points", "5000", "--noise", "1",
                      "--pose", "random"})
                .exit_code,
            0);
  const auto report = json({"fit", "scan.ply", "--views", "side=side.svg", "--points", "5000", "-o",
                            "car.toml", "--json"});
  EXPECT_LE(report.at("outline_mm").at("side").at("median"), 2.0);
  EXPECT_LE(report.at("distance_mm").at("median"), 3.0);
  EXPECT_TRUE(report.contains("pose"));
}

}  // namespace
}  // namespace bodyline
