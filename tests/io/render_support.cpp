#include "render_support.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "io/read_model.hpp"
#include "model/bernstein.hpp"
#include "model/build.hpp"

namespace bodyline::test {
namespace {

constexpr int golden_factor = 4, golden_square = 8;
constexpr int sphere_degree = 10;

bool updating() {
  const char* value = std::getenv("BODYLINE_UPDATE_PICTURES");
  return value != nullptr && std::string(value) == "1";
}

// A point of the face of a cube, blown up to the unit sphere; a and b from -1 to 1, even in angle.
Eigen::Vector3d sphere_point(const std::array<int, 3>& axes, double sign, double a, double b) {
  Eigen::Vector3d direction;
  direction[axes[0]] = sign;
  direction[axes[1]] = std::tan(0.25 * std::numbers::pi * a);
  direction[axes[2]] = std::tan(0.25 * std::numbers::pi * b);
  return direction.normalized();
}

// Interpolates at the parameters of the control points.
model::Surface sphere_face(const std::array<int, 3>& axes, double sign, double radius) {
  constexpr int n = sphere_degree;
  Eigen::MatrixXd basis(n + 1, n + 1);
  std::array<double, n + 1> nodes{};
  for (int k = 0; k <= n; ++k) {
    nodes[k] = 0.5 - 0.5 * std::cos(std::numbers::pi * k / n);
    const model::BernsteinJet jet = model::bernstein(n, nodes[k]);
    for (int i = 0; i <= n; ++i) basis(k, i) = jet.d[0][i];
  }
  const Eigen::MatrixXd inverse = basis.inverse();
  model::Surface face;
  face.name = "face" + std::to_string(axes[0]) + (sign > 0.0 ? "+" : "-");
  face.degree_u = face.degree_v = n;
  face.net.resize((n + 1) * (n + 1));
  face.inward = sign < 0.0;
  for (int c = 0; c < 3; ++c) {
    Eigen::MatrixXd samples(n + 1, n + 1);
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        samples(i, j) =
            radius * (sphere_point(axes, sign, 2.0 * nodes[i] - 1.0, 2.0 * nodes[j] - 1.0)[c] +
                      (c == 2 ? 1.0 : 0.0));
      }
    }
    const Eigen::MatrixXd net = inverse * samples * inverse.transpose();
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) face.point(i, j)[c] = net(i, j);
    }
  }
  return face;
}

}  // namespace

std::filesystem::path golden_folder() {
  return std::filesystem::path(BODYLINE_SOURCE_DIR) / "tests/io/golden";
}

double worst_square_difference(const io::Picture& a, const io::Picture& b, int square) {
  double worst = 0.0;
  for (int top = 0; top < a.height; top += square) {
    for (int left = 0; left < a.width; left += square) {
      double sum = 0.0;
      int count = 0;
      for (int y = top; y < std::min(top + square, a.height); ++y) {
        for (int x = left; x < std::min(left + square, a.width); ++x) {
          const auto p = a.pixel(x, y), q = b.pixel(x, y);
          for (int c = 0; c < 3; ++c) sum += (p[c] - q[c]) * (p[c] - q[c]);
          count += 3;
        }
      }
      worst = std::max(worst, std::sqrt(sum / count));
    }
  }
  return worst;
}

void expect_picture_matches(const io::Picture& picture, const std::filesystem::path& golden_path,
                            double tolerance) {
  const io::Picture small = io::scaled_down(picture, golden_factor);
  if (updating()) {
    std::filesystem::create_directories(golden_path.parent_path());
    io::write_png(small, golden_path, io::Overwrite::allowed);
    return;
  }
  ASSERT_TRUE(std::filesystem::exists(golden_path))
      << golden_path << " is missing; run with BODYLINE_UPDATE_PICTURES=1 to make it";
  const io::Picture golden = io::read_png(golden_path);
  ASSERT_EQ(golden.width, small.width) << golden_path;
  ASSERT_EQ(golden.height, small.height) << golden_path;
  const double difference = worst_square_difference(small, golden, golden_square);
  if (difference <= tolerance) return;
  const std::filesystem::path kept =
      std::filesystem::temp_directory_path() / golden_path.filename();
  io::write_png(small, kept, io::Overwrite::allowed);
  ADD_FAILURE() << "the picture differs from " << golden_path << " by " << difference << " where "
                << tolerance << " is allowed; it was kept as " << kept;
}

io::Picture mirrored(const io::Picture& picture) {
  io::Picture result{picture.width, picture.height, {}};
  for (int y = 0; y < picture.height; ++y) {
    for (int x = picture.width - 1; x >= 0; --x) {
      for (const std::uint8_t channel : picture.pixel(x, y)) result.rgb.push_back(channel);
    }
  }
  return result;
}

std::vector<model::Surface> sphere(double radius) {
  std::vector<model::Surface> faces;
  for (const std::array<int, 3>& axes :
       {std::array{0, 1, 2}, std::array{1, 2, 0}, std::array{2, 0, 1}}) {
    for (const double sign : {1.0, -1.0}) faces.push_back(sphere_face(axes, sign, radius));
  }
  return faces;
}

model::Surface square(double length) {
  model::Surface face;
  face.name = "square";
  face.degree_u = face.degree_v = 1;
  for (const double y : {-0.5 * length, 0.5 * length}) {
    for (const double z : {0.0, length}) face.net.emplace_back(0.0, y, z);
  }
  face.inward = true;  // S_u x S_v = y x z = x, to the rear
  return face;
}

std::vector<model::Surface> car(const std::string& name) {
  const std::filesystem::path file =
      std::filesystem::path(BODYLINE_SOURCE_DIR) / "cars" / (name + ".toml");
  return model::build(io::read_model(file), model::Stage::body);
}

}  // namespace bodyline::test
