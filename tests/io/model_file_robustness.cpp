#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "io/model_file_text.hpp"
#include "io/read_model.hpp"
#include "io/write_model.hpp"
#include "tests/io/model_file_support.hpp"

namespace bodyline {
namespace {

constexpr int flipped_files = 3000;

/// The law of the reader: every text is either a model, which can be written and read again, or an
/// InputError on a line that the text has.
void expect_model_or_input_error(const std::string& text) {
  try {
    const model::Model read = io::read_model_text(text, "text");
    const std::string written = io::write_model_text(read);
    EXPECT_EQ(io::write_model_text(io::read_model_text(written, "written")), written);
  } catch (const io::InputError& error) {
    EXPECT_LE(error.line(), 1 + std::count(text.begin(), text.end(), '\n')) << error.what();
  }
}

TEST(ModelFileRobustness, EveryTruncationIsAModelOrAnError) {
  const std::string text = testing::file_text(testing::car_path("model1"));
  for (std::size_t length = 0; length < text.size(); ++length) {
    expect_model_or_input_error(text.substr(0, length));
  }
}

TEST(ModelFileRobustness, FlippedBytesAreAModelOrAnError) {
  const std::string text = testing::file_text(testing::car_path("model2"));
  std::mt19937 random(77);
  for (int k = 0; k < flipped_files; ++k) {
    std::string flipped = text;
    for (int flips = 1 + k % 4; flips > 0; --flips) {
      flipped[random() % flipped.size()] = static_cast<char>(random() % 256);
    }
    expect_model_or_input_error(flipped);
  }
}

TEST(ModelFileRobustness, SwappedLinesAreAModelOrAnError) {
  const std::string text = testing::file_text(testing::car_path("template"));
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at) + 1;
    lines.push_back(text.substr(at, end - at));
    at = end;
  }
  std::mt19937 random(5);
  for (int k = 0; k < flipped_files; ++k) {
    std::vector<std::string> mixed = lines;
    for (int swaps = 1 + k % 3; swaps > 0; --swaps) {
      mixed[random() % mixed.size()] = lines[random() % lines.size()];
    }
    std::string joined;
    for (const std::string& line : mixed) joined += line;
    expect_model_or_input_error(joined);
  }
}

TEST(ModelFileRobustness, HostileNestingIsRefusedBeforeTheParserRecurses) {
  const std::size_t many = io::longest_file / 2;
  for (const std::string unit : {"[", "{", "a.", "\"a\".", "x={a=", "[[", "\"\"\"", "'", "\\"}) {
    std::string text;
    while (text.size() + unit.size() <= many) text += unit;
    EXPECT_THROW(io::read_model_text(text, "hostile"), io::InputError) << unit;
    EXPECT_THROW(io::read_model_text("a = " + text, "hostile"), io::InputError) << unit;
  }
}

TEST(ModelFileRobustness, FilesThatAreTooLongAreRefused) {
  const std::string text(io::longest_file + 1, '\n');
  EXPECT_THROW(io::read_model_text(text, "long"), io::InputError);
}

TEST(ModelFileRobustness, EveryFileOfTheFuzzersCorpusIsAModelOrAnError) {
  const std::filesystem::path corpus = std::string(BODYLINE_SOURCE_DIR) + "/tests/io/corpus";
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(corpus)) {
    SCOPED_TRACE(entry.path().string());
    expect_model_or_input_error(testing::file_text(entry.path().string()));
    ++count;
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace bodyline
