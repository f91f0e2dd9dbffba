#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "io/read_model.hpp"
#include "io/write_model.hpp"
#include "tests/io/model_file_support.hpp"

namespace bodyline {
namespace {

using testing::car_names;
using testing::car_path;
using testing::file_text;
using testing::number_bits;
using testing::words;

constexpr int random_models = 40;

void expect_same(const model::Model& a, const model::Model& b) {
  EXPECT_EQ(number_bits(a), number_bits(b));
  EXPECT_EQ(words(a), words(b));
}

/// A text with everything that needs care in a TOML string.
std::string random_note(std::mt19937& random) {
  const std::vector<std::string> pieces{"plain", "\"", "\"\"\"", "\\",   "\\u0041", "\n",
                                        "\r\n",  "\t", "\x01",   "\x7f", "# [x]",   "'''",
                                        "äöü€",  "𝛼",  " ",      "= 1"};
  std::string note;
  for (int count = static_cast<int>(random() % 8); count > 0; --count) {
    note += pieces[random() % pieces.size()];
  }
  return note;
}

/// A car with the same topology in which every number has a full random mantissa and still obeys
/// the rules.
model::Model random_model(const model::Model& car, std::mt19937& random) {
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  model::Model model = car;
  const Eigen::Vector3d stretch(between(1e-3, 3), between(0.5, 2), between(0.5, 2));
  for (auto& curve : model.curves) {
    curve.note = random_note(random);
    for (auto& point : curve.points) point = point.cwiseProduct(stretch);
  }
  for (auto& patch : model.patches) {
    patch.note = random_note(random);
    for (double& value : patch.shape_u) value = between(-1, 1) * std::pow(10.0, between(-12, 3));
    if (!patch.central) {
      for (double& value : patch.shape_v) value = between(-4, 4);
    }
  }
  for (auto& joint : model.joints) {
    joint.note = random_note(random);
    for (double& value : joint.fullness) value = between(0.01, 2.99);
    for (auto& side : joint.lean) {
      for (double& value : side) value *= value == 0.0 ? -1.0 : between(-2, 2);
    }
  }
  model.note = random_note(random);
  return model;
}

TEST(ModelFile, CarsAreWrittenAsTheyStandInTheirFiles) {
  for (const std::string& name : car_names) {
    const std::string text = file_text(car_path(name));
    EXPECT_EQ(io::write_model_text(io::read_model_text(text, name)), text) << name;
  }
}

TEST(ModelFile, RandomModelsComeBackBitForBit) {
  std::mt19937 random(20240117);
  for (const std::string& name : car_names) {
    const model::Model car = io::read_model(car_path(name));
    for (int k = 0; k < random_models; ++k) {
      const model::Model written = random_model(car, random);
      const std::string text = io::write_model_text(written);
      const model::Model read = io::read_model_text(text, name);
      expect_same(written, read);
      EXPECT_EQ(io::write_model_text(read), text);
      if (HasFailure()) FAIL() << text;
    }
  }
}

TEST(ModelFile, PatchesOfEveryFamilyComeBackBitForBit) {
  const std::string path = BODYLINE_SOURCE_DIR "/examples/families.toml";
  const model::Model read = io::read_model(path);
  EXPECT_EQ(io::write_model_text(read), file_text(path));
  std::vector<std::string> families;
  for (const auto& patch : read.patches) families.push_back(patch.basis);
  EXPECT_THAT(families, ::testing::IsSupersetOf({"ge-bezier", "bezier-like", "h-bezier"}));
}

TEST(ModelFile, EdgesOfTheDoublesComeBackBitForBit) {
  model::Model written = io::read_model(car_path("model1"));
  const std::vector<double> values{-0.0,
                                   std::numeric_limits<double>::denorm_min(),
                                   std::numeric_limits<double>::min(),
                                   -std::numeric_limits<double>::epsilon(),
                                   0.1,
                                   1.0 / 3.0,
                                   std::nextafter(1.0, 2.0),
                                   1e-7,
                                   1e5,
                                   1e-300,
                                   999999.99999999988,
                                   1e6};
  for (const double value : values) {
    written.patches[1].shape_u[0] = value;
    expect_same(written, io::read_model_text(io::write_model_text(written), "edge"));
  }
}

TEST(ModelFile, TablesKeepTheOrderOfTheFile) {
  const model::Model read = io::read_model(car_path("model1"));
  EXPECT_EQ(read.curves.front().name, "grille_bottom");
  EXPECT_EQ(read.patches.front().name, "grille");
  EXPECT_EQ(read.patches[1].name, "hood");
  EXPECT_EQ(read.patches.back().name, "rear_fender_lower");
  EXPECT_EQ(read.joints.front().name, "grille__hood");
}

TEST(ModelFile, UnitsScaleThePointsAndNothingElse) {
  // Small enough to be a car in metres as well; a power of two leaves the digits alone.
  model::Model small = io::read_model(car_path("model1"));
  for (auto& curve : small.curves) {
    for (auto& point : curve.points) point /= 1024.0;
  }
  for (const auto& [unit, length] : {std::pair("mm", 1.0), std::pair("cm", 10.0),
                                     std::pair("m", 1000.0), std::pair("in", 25.4)}) {
    std::string text = io::write_model_text(small);
    const std::string line = "units = \"mm\"";
    text.replace(text.find(line), line.size(), std::string("units = \"") + unit + "\"");
    const model::Model read = io::read_model_text(text, unit);
    model::Model expected = small;
    for (auto& curve : expected.curves) {
      for (auto& point : curve.points) point *= length;
    }
    expect_same(read, expected);
    expect_same(read, io::read_model_text(io::write_model_text(read), unit));
  }
}

TEST(ModelFile, ACarOfAKilometreIsAMistakeInTheUnits) {
  std::string text = file_text(car_path("model1"));
  const std::string line = "units = \"mm\"";
  text.replace(text.find(line), line.size(), "units = \"m\"");
  EXPECT_THROW(io::read_model_text(text, "metres"), io::InputError);
}

TEST(ModelFile, OmittedValuesAreTheDefaults) {
  std::string text = file_text(car_path("model1"));
  for (const std::string line : {"fullness = [1.5, 1.5]\n", "units = \"mm\"\n"}) {
    for (auto at = text.find(line); at != std::string::npos; at = text.find(line)) {
      text.erase(at, line.size());
    }
  }
  expect_same(io::read_model_text(text, "short"), io::read_model(car_path("model1")));
}

TEST(ModelFile, TheThreeCarsAreReadWithoutWarnings) {
  for (const std::string& name : car_names) {
    std::vector<io::Warning> warnings;
    io::read_model(car_path(name), &warnings);
    EXPECT_THAT(warnings, ::testing::IsEmpty()) << name;
  }
}

TEST(ModelFile, ShapeOutsideThePositiveRangeIsReadWithAWarning) {
  std::string text = file_text(car_path("model1"));
  const std::string hood =
      "v0 = \"hood__front_fender_upper\"\ncut.u = [0.03, 0.98]\ncut.v = [0.02, 0.98]\n";
  const std::string shape = "shape.u = [1, 1]";
  const auto at = text.find(shape, text.find(hood));
  ASSERT_NE(at, std::string::npos);
  text.replace(at, shape.size(), "shape.u = [1, -3]");
  std::vector<io::Warning> warnings;
  const model::Model read = io::read_model_text(text, "odd.toml", &warnings);
  EXPECT_EQ(read.patches[1].shape_u[1], -3.0);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].line,
            1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
  EXPECT_EQ(warnings[0].key, "patches.hood.shape.u[1]");
  EXPECT_THAT(warnings[0].sentence, ::testing::HasSubstr("-2 to 1"));
}

TEST(ModelFile, TheExampleOfTheDocumentationIsWrittenAsItStands) {
  const std::string page = file_text(std::string(BODYLINE_SOURCE_DIR) + "/docs/model-format.md");
  const std::string fence = "```toml\n";
  const auto start = page.find(fence) + fence.size();
  const std::string example = page.substr(start, page.find("```\n", start) - start);
  EXPECT_EQ(io::write_model_text(io::read_model_text(example, "example")), example);
}

TEST(ModelFile, WhatNoFileCanHoldIsNotWritten) {
  const model::Model car = io::read_model(car_path("model1"));
  const auto refuses = [&car](auto&& change) {
    model::Model model = car;
    change(model);
    EXPECT_THROW(io::write_model_text(model), std::invalid_argument);
  };
  refuses([](model::Model& m) { m.curves[0].points[1].y() = std::nan(""); });
  refuses(
      [](model::Model& m) { m.joints[0].fullness[1] = std::numeric_limits<double>::infinity(); });
  refuses([](model::Model& m) { m.patches[0].name = "the hood"; });
  refuses([](model::Model& m) { m.curves[0].name = ""; });
  refuses([](model::Model& m) { m.patches[0].sides[0].curve = 1000; });
  refuses([](model::Model& m) { m.joints[0].a.patch = -1; });
  refuses([](model::Model& m) { m.patches[0].sides[0].mirrored = true; });
}

}  // namespace
}  // namespace bodyline
