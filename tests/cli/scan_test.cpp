#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "cli/pose_option.hpp"
#include "io/read_scan.hpp"
#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using ::testing::HasSubstr;

class ScanCommand : public testing::CommandLine {};

TEST_F(ScanCommand, WritesAsManyPointsAsAskedWithNormals) {
  const auto run = bodyline({"scan", car("template"), "-o", "scan.ply", "--points", "700"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "scan.ply: 700 points, pose 0,0,0,0,0,0,1\n");
  const io::ScanFile scan = io::read_scan(file("scan.ply"));
  EXPECT_EQ(scan.scan.points.size(), 700U);
  EXPECT_TRUE(scan.with_normals);
}

TEST_F(ScanCommand, TheSameCommandWritesTheSameBytes) {
  const std::vector<std::string> command{"scan",   car("template"), "--points",   "500",
                                         "--pose", "random",        "--outliers", "0.2"};
  for (const std::string name : {"a.ply", "b.ply"}) {
    auto words = command;
    words.insert(words.end(), {"-o", name});
    EXPECT_EQ(bodyline(words).exit_code, 0);
  }
  EXPECT_EQ(text("a.ply"), text("b.ply"));
  auto words = command;
  words.insert(words.end(), {"-o", "c.ply", "--seed", "2"});
  EXPECT_EQ(bodyline(words).exit_code, 0);
  EXPECT_NE(text("a.ply"), text("c.ply"));
}

TEST_F(ScanCommand, TheReportedPoseTakesTheScanToTheModel) {
  const std::vector<std::string> command{"scan", car("template"), "--points", "300", "--noise",
                                         "0",    "--json"};
  auto plain = command, posed = command;
  plain.insert(plain.end(), {"-o", "plain.ply"});
  posed.insert(posed.end(), {"-o", "posed.ply", "--pose", "random"});
  json(plain);
  const auto report = json(posed);
  EXPECT_EQ(report.at("points"), 300);
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  for (int i = 0; i < 3; ++i) {
    translation[i] = report.at("pose").at("translation_mm").at(i);
    for (int j = 0; j < 3; ++j) rotation(i, j) = report.at("pose").at("rotation").at(i).at(j);
  }
  const double scale = report.at("pose").at("scale");
  const auto from = io::read_scan(file("posed.ply")), to = io::read_scan(file("plain.ply"));
  for (std::size_t k = 0; k < 300; ++k) {
    const Eigen::Vector3d back = scale * (rotation * from.scan.points[k]) + translation;
    EXPECT_LT((back - to.scan.points[k]).norm(), 1e-8);
  }
  const model::Pose again = cli::pose_from_text(report.at("pose_option"));
  EXPECT_TRUE(again.rotation.isApprox(rotation, 1e-12));
}

TEST_F(ScanCommand, HalfOfTheCarCanBeMissing) {
  for (const std::string part : {"left", "holes"}) {
    const auto report = json({"scan", car("template"), "-o", part + ".ply", "--points", "2000",
                              "--missing", part, "--json"});
    EXPECT_NEAR(report.at("points").get<double>(), 1000.0, 200.0);
  }
}

TEST(PoseOption, IsReadBackFromItsText) {
  for (const std::string text :
       {"0,0,0,0,0,0,1", "10,20,30,-4,5.5,6e3,25.4", "-170,-80,5,1,2,3,1000",
        "170,110,-160,1,2,3,1", "30,90,20,0,0,0,1", "30,-90,20,0,0,0,1"}) {
    const model::Pose pose = cli::pose_from_text(text);
    const model::Pose again = cli::pose_from_text(cli::pose_text(pose));
    EXPECT_TRUE(again.rotation.isApprox(pose.rotation, 1e-12)) << text;
    EXPECT_TRUE(again.translation.isApprox(pose.translation, 1e-12) || pose.translation.isZero());
    EXPECT_EQ(again.scale, pose.scale);
  }
}

TEST(PoseOption, OfASmallTurnIsSmall) {
  EXPECT_EQ(cli::pose_text(cli::pose_from_text("0,0,-0.5,1,2,3,1")), "0,0,-0.5,1,2,3,1");
}

TEST(PoseOption, IsRefusedBeyondWhatAPoseCanBe) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      cli::pose_from_text(text);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("1e300,0,0,0,0,0,1"),
            "an angle, in degrees, of a pose is from -360 to 360, not 1e+300");
  EXPECT_EQ(refusal("0,0,0,0,-1e300,0,1"),
            "a move, in mm, of a pose is from -1e+12 to 1e+12, not -1e+300");
  for (const std::string scale : {"0", "-1", "1e300", "1e-300"})
    EXPECT_NE(refusal("0,0,0,0,0,0," + scale).find("from 1e-06 to 1e+06"), std::string::npos);
  EXPECT_EQ(refusal("360,-360,0,5e9,0,0,1000"), "");
}

TEST(MovedFrameWords, TellAShiftOfAScanThatLayNearlyRight) {
  const std::string near = cli::moved_frame_words(cli::pose_from_text("0,0,0,-131.25,0,8.5,1"));
  EXPECT_NE(near.find("moved by -131.2, 0.0, 8.5 mm"), std::string::npos) << near;
  EXPECT_NE(near.find("--pose 0,0,0,-131.25,0,8.5,1 does so again, --pose none"), near.npos);
  for (const char* far : {"0,0,0,5,0,0,1000", "0,0,90,5,0,0,1", "0,0,0,5000,0,0,1"}) {
    const std::string words = cli::moved_frame_words(cli::pose_from_text(far));
    EXPECT_NE(words.find(std::string("--pose ") + far + " takes"), words.npos) << words;
    EXPECT_EQ(words.find("nearly"), words.npos);
  }
}

// The first turn is about x, the last about z, all about the axes of the model.
TEST(PoseOption, TurnsAboutXThenYThenZ) {
  const model::Pose pose = cli::pose_from_text("90,0,90,0,0,0,1");
  EXPECT_TRUE((pose.rotation * Eigen::Vector3d::UnitY()).isApprox(Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE((pose.rotation * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY()));
}

}  // namespace
}  // namespace bodyline
