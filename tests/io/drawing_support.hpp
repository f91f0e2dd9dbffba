#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/input_error.hpp"
#include "io/read_drawing.hpp"

/// What the tests of drawings share.
namespace bodyline::testing {

/// A test with a folder of its own, into which it writes the files that it reads.
class DrawingFiles : public ::testing::Test {
 protected:
  DrawingFiles() {
    std::string name = (std::filesystem::temp_directory_path() / "bodyline_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder");
    folder_ = name;
  }
  ~DrawingFiles() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path file(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }

  model::Drawing read(const std::string& name, const std::string& content) const {
    return io::read_drawing(file(name, content));
  }

  /// What reading says against a file, without the file's name; empty when it reads.
  std::string refusal(const std::string& name, const std::string& content) const {
    const auto path = file(name, content);
    try {
      io::read_drawing(path);
    } catch (const io::InputError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.find(path.string()), 0U) << text;
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
      return text.substr(std::min(text.size(), path.string().size() + 1));
    }
    return "";
  }

  std::filesystem::path folder_;
};

inline std::string svg(const std::string& inner, const std::string& attributes = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
         "xmlns:xlink=\"http://www.w3.org/1999/xlink\" " +
         attributes + ">\n" + inner + "\n</svg>\n";
}

}  // namespace bodyline::testing
