#include <gmock/gmock.h>

#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

class ExportConvert : public testing::CommandLine {};

TEST_F(ExportConvert, TheModelComesBackByteForByte) {
  for (const std::string name : {"template", "model1", "model2"}) {
    ASSERT_EQ(bodyline({"export", car(name), "-o", name + ".json"}).exit_code, 0);
    ASSERT_EQ(bodyline({"convert", name + ".json", "-o", name + ".toml"}).exit_code, 0);
    EXPECT_EQ(text(name + ".toml"), testing::text_of(car(name)));
  }
}

TEST_F(ExportConvert, AModelWrittenAnewIsAFixedPoint) {
  ASSERT_EQ(bodyline({"convert", car("model1"), "-o", "once.toml"}).exit_code, 0);
  ASSERT_EQ(bodyline({"convert", "once.toml", "-o", "twice.toml"}).exit_code, 0);
  EXPECT_EQ(text("once.toml"), text("twice.toml"));
}

TEST_F(ExportConvert, NetsAreGroupedByStage) {
  ASSERT_EQ(bodyline({"export", car("model1"), "-o", "nets.json"}).exit_code, 0);
  const Json nets = Json::parse(text("nets.json"));
  for (const char* group : {"base", "kept", "transition", "corner"}) {
    ASSERT_FALSE(nets.at(group).empty()) << group;
    const Json& face = nets.at(group).begin().value();
    EXPECT_EQ(face.at("net").size(), face.at("degree")[0].get<std::size_t>() + 1) << group;
    EXPECT_EQ(face.at("net")[0].size(), face.at("degree")[1].get<std::size_t>() + 1) << group;
  }
}

TEST_F(ExportConvert, EveryFormatIsWrittenAndReported) {
  for (const std::string extension : {"step", "stl", "obj", "ply", "glb", "gltf"}) {
    const std::string name = "car." + extension;
    const auto run = bodyline(
        {"export", car("template"), "-o", name, "--stage", "base", "--tolerance", "2", "--quiet"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr(name + ": 25 faces"));
    EXPECT_GT(text(name).size(), 1000U) << name;
  }
}

TEST_F(ExportConvert, AFinerToleranceTakesMoreTriangles) {
  const auto bytes = [this](const std::string& tolerance) {
    EXPECT_EQ(bodyline({"export", car("template"), "-o", "car.stl", "--stage", "kept",
                        "--tolerance", tolerance, "--overwrite"})
                  .exit_code,
              0);
    return text("car.stl").size();
  };
  EXPECT_LT(bytes("5"), bytes("0.05"));
}

}  // namespace
}  // namespace bodyline
