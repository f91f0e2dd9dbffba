#include "io/body_section.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "io/svg_section.hpp"
#include "render_support.hpp"

namespace bodyline {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double radius = 400.0;
// Chords of a sphere between grid points, and its polynomial faces.
constexpr double section_error = 2.0;  // mm

TEST(BodySection, OfASphereIsACircle) {
  const std::vector<io::Segment> segments = io::body_section(test::sphere(radius), {0, 100.0});
  ASSERT_FALSE(segments.empty());
  const double expected = std::sqrt(radius * radius - 100.0 * 100.0);
  double length = 0.0;
  for (const io::Segment& segment : segments) {
    for (const Eigen::Vector3d& point : segment) {
      EXPECT_NEAR(point.x(), 100.0, 1e-9);
      EXPECT_NEAR(std::hypot(point.y(), point.z() - radius), expected, section_error);
    }
    length += (segment[1] - segment[0]).norm();
  }
  EXPECT_NEAR(length, 2.0 * std::numbers::pi * expected, 10.0 * section_error);
}

TEST(BodySection, OfAPlaneThatMissesIsEmpty) {
  EXPECT_TRUE(io::body_section(test::sphere(radius), {0, 2.0 * radius}).empty());
  EXPECT_EQ(io::svg_section(test::sphere(radius), {0, 2.0 * radius}, {}, 1.0), "");
}

TEST(BodySection, UsualPlanesCutTheBody) {
  const std::vector<model::Surface> faces = test::sphere(radius);
  const std::vector<io::SectionPlane> planes = io::usual_section_planes(faces);
  ASSERT_EQ(planes.size(), 4U);
  EXPECT_EQ(planes[0].axis, 1);
  for (const io::SectionPlane& plane : planes) {
    EXPECT_FALSE(io::body_section(faces, plane).empty()) << plane.name();
  }
}

TEST(SectionPlane, IsReadFromText) {
  const io::SectionPlane plane = io::section_plane_from_text("z=-12.5");
  EXPECT_EQ(plane.axis, 2);
  EXPECT_DOUBLE_EQ(plane.at, -12.5);
  EXPECT_EQ(io::section_plane_from_text("x=1200").name(), "x = 1200 mm");
}

TEST(SectionPlane, RefusesOtherText) {
  for (const char* text : {"", "x", "x=", "w=1", "x=1mm", "x:1", "x=nan", "1200", "x= 1"}) {
    EXPECT_THROW(io::section_plane_from_text(text), std::invalid_argument) << text;
  }
}

TEST(SvgSection, AcrossTheCarShowsTheLeftHalfAndAlongItEverything) {
  const auto view_box = [](const io::SectionPlane& plane) {
    const std::string svg = io::svg_section(test::sphere(radius), plane, {}, 1.0);
    const std::size_t at = svg.find("viewBox=\"") + 9;
    std::istringstream stream(svg.substr(at, svg.find('"', at) - at));
    std::array<double, 4> box{};
    for (double& number : box) stream >> number;
    return box;
  };
  constexpr double margin = 130.0;  // mm around the drawing, both sides and a little more
  EXPECT_NEAR(view_box({0, 0.0})[2], radius, margin);
  EXPECT_LT(view_box({0, 0.0})[0], -radius + section_error);
  EXPECT_NEAR(view_box({1, 0.0})[2], 2.0 * radius, margin);
}

TEST(SvgSection, DrawsPointsNearThePlaneInTheColourOfTheirSide) {
  const auto faces = test::sphere(radius);
  const Eigen::Vector3d near(1.0, -radius - 3.0, radius), far(50.0, -radius, radius);
  const io::SectionPlane plane{0, 0.0};
  const auto dots = [&](const Eigen::Vector3d& point, double distance) {
    return io::svg_section(faces, plane, {{point, distance}}, 4.0);
  };
  EXPECT_THAT(dots(near, 3.0), HasSubstr("class=\"dots\""));
  EXPECT_THAT(dots(far, 3.0), Not(HasSubstr("class=\"dots\"")));
  EXPECT_NE(dots(near, 3.0), dots(near, -3.0));
  EXPECT_NE(dots(near, 3.0), dots(near, 0.0));
}

}  // namespace
}  // namespace bodyline
