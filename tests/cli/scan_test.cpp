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
       {"0,0,0,0,0,0,1", "10,20,30,-4,5.5,6e3,25.4", "-170,-80,5,1,2,3,1000"}) {
    const model::Pose pose = cli::pose_from_text(text);
    const model::Pose again = cli::pose_from_text(cli::pose_text(pose));
    EXPECT_TRUE(again.rotation.isApprox(pose.rotation, 1e-12)) << text;
    EXPECT_TRUE(again.translation.isApprox(pose.translation, 1e-12) || pose.translation.isZero());
    EXPECT_EQ(again.scale, pose.scale);
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
