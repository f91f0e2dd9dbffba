#include "tests/optimize/scan_samples.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

#include "optimize/body_samples.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;
using model::Scan;

constexpr int shape_points = 20000;
constexpr double two_pi = 2.0 * std::numbers::pi;

struct Box {
  Vector3d low, high;
};

Box box_of(const Scan& scan) {
  Box box{scan.points.front(), scan.points.front()};
  for (const Vector3d& point : scan.points)
    box = {box.low.cwiseMin(point), box.high.cwiseMax(point)};
  return box;
}

std::string scan_path(const std::string& name) {
  return std::string(BODYLINE_SOURCE_DIR) + "/../shared/scans/" + name + "_points.ply";
}

}  // namespace

double SampleDraw::uniform() { return std::ldexp(double(generator_() >> 11), -53); }

double SampleDraw::normal() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return radius * std::cos(two_pi * uniform());
}

Vector3d SampleDraw::normal_vector() {
  const double x = normal(), y = normal(), z = normal();
  return {x, y, z};
}

Vector3d SampleDraw::in_box() {
  const double x = uniform(), y = uniform(), z = uniform();
  return {2.0 * x - 1.0, 2.0 * y - 1.0, 2.0 * z - 1.0};
}

Eigen::Matrix3d SampleDraw::rotation() {
  const Vector3d vector = normal_vector();
  return Eigen::Quaterniond(normal(), vector.x(), vector.y(), vector.z())
      .normalized()
      .toRotationMatrix();
}

Scan sampled(const model::Model& car, int count, double noise_mm, SampleDraw& draw) {
  const BodySamples shape = body_samples(car, 20.0);
  Scan scan;
  for (int i = 0; i < count; ++i)
    scan.points.push_back(shape.points()[draw.below(shape.points().size())] +
                          noise_mm * draw.normal_vector());
  return scan;
}

Scan scanned_from(const Scan& in_model_axes, const model::Pose& pose) {
  Scan scan = in_model_axes;
  for (Vector3d& point : scan.points)
    point = pose.rotation.transpose() * (point - pose.translation) / pose.scale;
  for (Vector3d& normal : scan.normals) normal = pose.rotation.transpose() * normal;
  return scan;
}

void add_outliers(Scan& scan, double share, SampleDraw& draw) {
  const Box box = box_of(scan);
  const int count = int(double(scan.points.size()) * share / (1.0 - share));
  for (int i = 0; i < count; ++i)
    scan.points.push_back(0.5 * (box.low + box.high) +
                          0.6 * draw.in_box().cwiseProduct(box.high - box.low));
}

void add_wheels_and_mirrors(Scan& scan, SampleDraw& draw) {
  const Box box = box_of(scan);
  const std::size_t body = scan.points.size();
  const auto at = [&](double share) { return box.low.x() + share * (box.high.x() - box.low.x()); };
  for (double side : {-1.0, 1.0}) {
    for (double share : {0.19, 0.78}) {
      for (std::size_t i = 0; i < body / 40; ++i) {
        const bool tread = draw.uniform() < 0.5;
        const double radius = tread ? 320.0 : 320.0 * std::sqrt(draw.uniform());
        const double angle = two_pi * draw.uniform();
        const double inwards = tread ? 200.0 * draw.uniform() : 0.0;
        scan.points.emplace_back(at(share) + radius * std::cos(angle),
                                 side * (box.high.y() - 30.0 - inwards),
                                 box.low.z() + 120.0 + radius * std::sin(angle));
      }
    }
    for (std::size_t i = 0; i < body / 200; ++i)
      scan.points.push_back(Vector3d(at(0.33), side * (box.high.y() + 60.0), box.high.z() - 500.0) +
                            draw.normal_vector().normalized().cwiseProduct(Vector3d(60, 110, 80)));
  }
}

void add_ground(Scan& scan, SampleDraw& draw) {
  const Box box = box_of(scan);
  const std::size_t count = scan.points.size() / 2;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d place = draw.in_box();
    scan.points.emplace_back(
        0.5 * (box.low.x() + box.high.x()) + place.x() * 0.65 * (box.high.x() - box.low.x()),
        1800.0 * place.y(), box.low.z() - 200.0 + 3.0 * draw.normal());
  }
}

void cut_holes(Scan& scan, int count, double radius, SampleDraw& draw) {
  std::vector<Vector3d> centres;
  for (int i = 0; i < count; ++i) centres.push_back(scan.points[draw.below(scan.points.size())]);
  scan = kept(scan, [&](const Vector3d& point) {
    return std::none_of(centres.begin(), centres.end(),
                        [&](const Vector3d& centre) { return (point - centre).norm() < radius; });
  });
}

Scan flat_plane(SampleDraw& draw) {
  Scan scan;
  for (int i = 0; i < shape_points; ++i) {
    const Vector3d place = draw.in_box();
    scan.points.emplace_back(2250.0 * place.x(), 900.0 * place.y(), 2.0 * draw.normal());
  }
  return scan;
}

Scan ellipsoid(const Vector3d& radii, SampleDraw& draw) {
  Scan scan;
  for (int i = 0; i < shape_points; ++i)
    scan.points.push_back(draw.normal_vector().normalized().cwiseProduct(radii));
  return scan;
}

Scan box_surface(const Vector3d& half, SampleDraw& draw) {
  const Vector3d areas(half.y() * half.z(), half.x() * half.z(), half.x() * half.y());
  Scan scan;
  for (int i = 0; i < shape_points; ++i) {
    const double chosen = draw.uniform() * areas.sum();
    const int axis = chosen < areas[0] ? 0 : chosen < areas[0] + areas[1] ? 1 : 2;
    Vector3d place = draw.in_box();
    place[axis] = place[axis] < 0.0 ? -1.0 : 1.0;
    scan.points.push_back(place.cwiseProduct(half));
  }
  return scan;
}

Scan bunny_like(const Vector3d& stretch, SampleDraw& draw) {
  struct Part {
    Vector3d centre, radii;
  };
  const std::array<Part, 4> parts{{{{0, 0, 1200}, {1500, 1150, 1200}},
                                   {{-1300, 0, 2300}, {700, 600, 600}},
                                   {{-1000, -300, 3200}, {200, 130, 800}},
                                   {{-1000, 300, 3200}, {200, 130, 800}}}};
  const std::array<int, 4> shares{12, 5, 2, 1};
  Scan scan;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (int i = 0; i < shares[p] * shape_points / 20; ++i)
      scan.points.push_back(stretch.cwiseProduct(
          parts[p].centre + draw.normal_vector().normalized().cwiseProduct(parts[p].radii)));
  return scan;
}

bool have_scan(const std::string& name) { return std::ifstream(scan_path(name)).good(); }

Scan read_test_scan(const std::string& name) {
  std::ifstream file(scan_path(name), std::ios::binary);
  std::string line;
  std::size_t count = 0;
  while (std::getline(file, line) && line != "end_header")
    if (line.rfind("element vertex ", 0) == 0) count = std::stoul(line.substr(15));
  Scan scan;
  std::array<float, 6> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    file.read(reinterpret_cast<char*>(numbers.data()), sizeof numbers);
    scan.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    scan.normals.emplace_back(numbers[3], numbers[4], numbers[5]);
  }
  return scan;
}

}  // namespace bodyline::optimize
