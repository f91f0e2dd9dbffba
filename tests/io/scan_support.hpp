#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/input_error.hpp"
#include "io/read_scan.hpp"
#include "io/scalar_type.hpp"

/// What the tests of scans share.
namespace bodyline::testing {

/// A test with a folder of its own, into which it writes the files that it reads.
class ScanFiles : public ::testing::Test {
 protected:
  ScanFiles() {
    std::string name = (std::filesystem::temp_directory_path() / "bodyline_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder");
    folder_ = name;
  }
  ~ScanFiles() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path file(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }

  io::ScanFile read(const std::string& name, const std::string& content,
                    const io::ReadScanOptions& options = {}) const {
    return io::read_scan(file(name, content), options);
  }

  /// What reading says against a file, without the file's name; empty when it reads.
  std::string refusal(const std::string& name, const std::string& content) const {
    const auto path = file(name, content);
    try {
      io::read_scan(path);
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

/// Points that floats hold exactly, no two alike.
inline std::vector<Eigen::Vector3d> some_points(int count) {
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k < count; ++k) points.emplace_back(k, 0.5 * (k % 7), -0.25 * (k % 11));
  return points;
}

/// One number as a binary file holds it.
template <typename Number>
std::string bytes_of(Number number, io::ByteOrder order = io::ByteOrder::little) {
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(Number));
  if (order == io::ByteOrder::big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

template <typename Number>
std::string bytes_of(const Eigen::Vector3d& vector, io::ByteOrder order = io::ByteOrder::little) {
  std::string bytes;
  for (int c = 0; c < 3; ++c) bytes += bytes_of(static_cast<Number>(vector[c]), order);
  return bytes;
}

/// "x y z" with another separator if wanted.
inline std::string words_of(const Eigen::Vector3d& vector, const std::string& separator = " ") {
  std::array<char, 100> text{};
  std::snprintf(text.data(), text.size(), "%.17g%s%.17g%s%.17g", vector.x(), separator.c_str(),
                vector.y(), separator.c_str(), vector.z());
  return text.data();
}

/// Lines "x y z" of `some_points`.
inline std::string lines(int count) {
  std::string text;
  for (const auto& point : some_points(count)) text += words_of(point) + "\n";
  return text;
}

/// Head of a PLY file of vertices x y z in floats; `rest` are further lines.
inline std::string ply(const std::string& vertices, const std::string& rest = "",
                       const std::string& format = "ascii") {
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\n" + rest + "end_header\n";
}

/// Head of one face.
inline const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";

/// Head of a PCD file of points x y z in floats.
inline std::string pcd(const std::string& points, const std::string& data = "ascii") {
  return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\n"
         "POINTS " +
         points + "\nDATA " + data + "\n";
}

/// A box of 4 x 2 x 1 from the origin: its vertices, and its sides as quadrangles that are
/// counter-clockwise seen from outside.
inline const std::vector<Eigen::Vector3d>& box_points() {
  static const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0},
                                                   {0, 0, 1}, {4, 0, 1}, {4, 2, 1}, {0, 2, 1}};
  return points;
}
inline constexpr std::array<std::array<int, 4>, 6> box_sides{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 4, 7, 3}, {1, 2, 6, 5}}};

/// The same as twelve triangles.
inline std::vector<std::array<int, 3>> box_triangles() {
  std::vector<std::array<int, 3>> triangles;
  for (const auto& [a, b, c, d] : box_sides) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  return triangles;
}

/// Every point lies on a side of the box scaled by `size`, with that side's outward normal, and
/// every side has its share of the points.
inline void expect_points_on_box(const io::ScanFile& file, std::size_t count, double size = 1.0) {
  EXPECT_TRUE(file.mesh);
  EXPECT_TRUE(file.with_normals);
  ASSERT_EQ(file.scan.points.size(), count);
  ASSERT_EQ(file.scan.normals.size(), count);
  const Eigen::Vector3d sizes = size * Eigen::Vector3d(4, 2, 1);
  const double rounding = 1e-6 * size;  // of single precision
  std::array<double, 6> points_on{};
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector3d &point = file.scan.points[k], &normal = file.scan.normals[k];
    Eigen::Index axis = 0;
    ASSERT_NEAR(normal.cwiseAbs().maxCoeff(&axis), 1.0, 1e-6);
    const bool upper = normal[axis] > 0.0;
    ASSERT_NEAR(point[axis], upper ? sizes[axis] : 0.0, rounding) << point.transpose();
    ASSERT_TRUE((point.array() >= -rounding).all()) << point.transpose();
    ASSERT_TRUE((point.array() <= sizes.array() + rounding).all()) << point.transpose();
    ++points_on[2 * axis + upper];
  }
  const std::array<double, 3> share{2.0 / 28, 4.0 / 28, 8.0 / 28};
  for (int side = 0; side < 6; ++side) {
    // Each point stands for a part of the area of its own; only parts at an edge can go astray.
    EXPECT_NEAR(points_on[side], share[side / 2] * double(count), 4.0) << side;
  }
}

}  // namespace bodyline::testing
