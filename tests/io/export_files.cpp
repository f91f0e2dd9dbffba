#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/convert.hpp"
#include "io/export.hpp"
#include "io/input_error.hpp"
#include "io/nets_json.hpp"
#include "io/read_model.hpp"
#include "io/write_model.hpp"
#include "model/build.hpp"

namespace bodyline {
namespace {

using Json = nlohmann::json;
using model::Stage;
using Path = std::filesystem::path;

const Path car_path = BODYLINE_SOURCE_DIR "/cars/model1.toml";

std::string read_text(const Path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A folder of its own for every test.
class ExportedFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "bodyline_export_XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  Path in_folder(const std::string& name) const { return folder_ / name; }

  const model::Model car_ = io::read_model(car_path);

 private:
  Path folder_;
};

void expect_face(const Json& section, const model::Surface& face) {
  ASSERT_TRUE(section.contains(face.name)) << face.name;
  const Json& entry = section[face.name];
  EXPECT_EQ(entry["degree"], Json::array({face.degree_u, face.degree_v}));
  ASSERT_EQ(entry["net"].size(), static_cast<std::size_t>(face.degree_u + 1));
  for (int i = 0; i <= face.degree_u; ++i) {
    ASSERT_EQ(entry["net"][i].size(), static_cast<std::size_t>(face.degree_v + 1));
    for (int j = 0; j <= face.degree_v; ++j)
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(entry["net"][i][j][c].get<double>(), face.point(i, j)[c]) << face.name;
  }
  ASSERT_EQ(entry.contains("blend"), face.blend.has_value());
  EXPECT_EQ(entry.contains("blend_note"), face.blend.has_value());
  for (int c = 0; face.blend && c < 3; ++c)
    EXPECT_EQ(entry["blend"][c].get<double>(), (*face.blend)[c]);
}

TEST_F(ExportedFile, JsonHoldsEveryNetBitForBit) {
  const Json json = Json::parse(io::nets_json(car_, ""));
  EXPECT_EQ(json["base"].size(), 25u);
  EXPECT_EQ(json["kept"].size(), 25u);
  EXPECT_EQ(json["transition"].size(), 36u);
  EXPECT_EQ(json["corner"].size(), 16u);
  for (const auto& face : model::build(car_, Stage::base)) expect_face(json["base"], face);
  for (const auto& face : model::build(car_, Stage::body)) {
    const char* section = face.kind == model::FaceKind::patch        ? "kept"
                          : face.kind == model::FaceKind::transition ? "transition"
                                                                     : "corner";
    expect_face(json[section], face);
  }
}

TEST_F(ExportedFile, ConvertGivesTheModelFileBackBitForBit) {
  const std::string text = read_text(car_path);
  io::ExportOptions options;
  options.model_text = text;
  io::export_body(car_, in_folder("car.json"), options);
  io::convert(in_folder("car.json"), in_folder("car.toml"));
  EXPECT_EQ(read_text(in_folder("car.toml")), text);
}

TEST_F(ExportedFile, JsonCarriesTheModelWhenItsTextIsNotGiven) {
  io::export_body(car_, in_folder("car.json"));
  io::convert(in_folder("car.json"), in_folder("car.toml"));
  EXPECT_EQ(read_text(in_folder("car.toml")), io::write_model_text(car_));
}

TEST_F(ExportedFile, ConvertNormalizesAModelFileOnce) {
  io::convert(car_path, in_folder("once.toml"));
  io::convert(in_folder("once.toml"), in_folder("twice.toml"));
  EXPECT_EQ(read_text(in_folder("once.toml")), read_text(in_folder("twice.toml")));
}

TEST_F(ExportedFile, ConvertRefusesWhatCarriesNoModel) {
  for (const char* text :
       {"{}", "[1]", "{\"model\": 3}", "{\"model\": \"nonsense\"}", "no json", ""}) {
    std::ofstream(in_folder("bad.json"), std::ios::trunc) << text;
    EXPECT_THROW(io::convert(in_folder("bad.json"), in_folder("car.toml")), io::InputError) << text;
    EXPECT_FALSE(std::filesystem::exists(in_folder("car.toml")));
  }
  EXPECT_THROW(io::convert(in_folder("car.step"), in_folder("car.toml")), io::InputError);
  EXPECT_THROW(io::convert(car_path, in_folder("car.step")), io::InputError);
}

TEST_F(ExportedFile, EveryExtensionGivesAFile) {
  for (const std::string& extension : io::export_extensions()) {
    io::ExportOptions options;
    options.tolerance_mm = 2.0;
    const io::ExportReport report = io::export_body(car_, in_folder("car" + extension), options);
    EXPECT_EQ(report.faces, 77);
    EXPECT_GT(std::filesystem::file_size(in_folder("car" + extension)), 1000u) << extension;
  }
}

TEST_F(ExportedFile, ReportSaysWhatDeviates) {
  io::ExportOptions options;
  options.tolerance_mm = 2.0;
  const io::ExportReport mesh = io::export_body(car_, in_folder("car.stl"), options);
  EXPECT_GT(mesh.triangles, 0);
  EXPECT_GT(mesh.max_deviation_mm, 0.0);
  EXPECT_LE(mesh.max_deviation_mm, 2.0);
  const io::ExportReport cad = io::export_body(car_, in_folder("car.step"));
  EXPECT_EQ(cad.triangles, 0);
  EXPECT_EQ(cad.not_polynomial.size(), 4u);
  EXPECT_LE(cad.max_deviation_mm, 1e-3);
}

TEST_F(ExportedFile, StageChoosesTheFaces) {
  io::ExportOptions options;
  options.stage = Stage::base;
  EXPECT_EQ(io::export_body(car_, in_folder("car.step"), options).faces, 25);
}

TEST_F(ExportedFile, ExistingFilesAreKeptUnlessAsked) {
  std::ofstream(in_folder("car.step")) << "mine";
  EXPECT_THROW(io::export_body(car_, in_folder("car.step")), io::InputError);
  EXPECT_EQ(read_text(in_folder("car.step")), "mine");
  io::ExportOptions options;
  options.overwrite = io::Overwrite::allowed;
  io::export_body(car_, in_folder("car.step"), options);
  EXPECT_NE(read_text(in_folder("car.step")), "mine");
}

TEST_F(ExportedFile, UnknownExtensionsAreRefusedWithTheKnownOnes) {
  try {
    io::export_body(car_, in_folder("car.dwg"));
    FAIL();
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find(".step"), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(in_folder("car.dwg")));
}

TEST_F(ExportedFile, RefusalsLeaveNothingBehind) {
  io::ExportOptions options;
  options.tolerance_mm = 0.0;
  EXPECT_THROW(io::export_body(car_, in_folder("car.stl"), options), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(in_folder("")));
}

}  // namespace
}  // namespace bodyline
