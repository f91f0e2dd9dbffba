#include <gmock/gmock.h>

#include <cmath>

#include "cli/deviation_field.hpp"
#include "io/picture.hpp"
#include "io/read_model.hpp"
#include "model/build.hpp"
#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using ::testing::HasSubstr;

// A scan of the body itself, with points moved along the outward normals.
model::Scan scan_of(const model::Model& model, double outwards, double x_from) {
  model::Scan scan;
  constexpr int points = 30;  // per direction of a face
  for (const model::Surface& face : model::build(model, model::Stage::body)) {
    for (int k = 0; k < points * points; ++k) {
      const double u = (k / points + 0.5) / points, v = (k % points + 0.5) / points;
      const Eigen::Vector3d normal = model::outward_normal(face, u, v);
      const Eigen::Vector3d point = model::jet(face, u, v, 0).d[0] + outwards * normal;
      if (point.x() < x_from) continue;
      scan.points.push_back(point);
      scan.normals.push_back(normal);
    }
  }
  return scan;
}

class Deviation : public testing::CommandLine {
 protected:
  const model::Model model_ = io::read_model(car("template"));
  io::SurfaceField field(double outwards, double x_from = -1e9) const {
    const model::Scan scan = scan_of(model_, outwards, x_from);
    optimize::Deviation deviation = optimize::measure_deviation(model_, scan, {});
    return cli::deviation_field(model_, model::Stage::body, deviation);
  }
};

TEST_F(Deviation, AFieldOfAShellAroundTheBodyIsItsThickness) {
  constexpr double thickness = 2.0;
  constexpr double tight_rounds = 0.05;  // mm: points over an edge are nearer to its other side
  const io::SurfaceField outside = field(thickness), inside = field(-thickness);
  EXPECT_DOUBLE_EQ(outside.range, 2.0);
  int faces = 0;
  for (const model::Surface& face : model::build(model_, model::Stage::body)) {
    ASSERT_NE(outside.face(face.name), nullptr) << face.name;
    ASSERT_NE(inside.face(face.name), nullptr) << face.name;
    EXPECT_NEAR(outside.face(face.name)->sample(0.4, 0.3), thickness, tight_rounds) << face.name;
    EXPECT_NEAR(inside.face(face.name)->sample(0.4, 0.3), -thickness, tight_rounds) << face.name;
    ++faces;
  }
  EXPECT_GT(faces, 60);
}

TEST_F(Deviation, AFieldOfACompleteScanHasNoHolesAndOneOfHalfAScanHas) {
  const auto unknown = [](const io::SurfaceField& field, const std::string& name) {
    const io::FaceField* const face = field.face(name);
    if (face == nullptr) return 1.0;
    double count = 0.0;
    for (const double value : face->values) count += std::isnan(value);
    return count / double(face->values.size());
  };
  const io::SurfaceField complete = field(0.0);
  for (const model::Patch& patch : model_.patches) {
    EXPECT_EQ(unknown(complete, patch.name), 0.0) << patch.name;
  }
  const io::SurfaceField rear = field(0.0, 2000.0);
  EXPECT_EQ(unknown(rear, "hood"), 1.0);
  EXPECT_EQ(unknown(rear, "trunk_lid"), 0.0);
}

TEST_F(Deviation, WritesTheMapAndThePage) {
  ASSERT_EQ(bodyline({"scan", car("model1"), "-o", "scan.ply", "--points", "5000"}).exit_code, 0);
  const auto run =
      bodyline({"deviation", car("model2"), "scan.ply", "--pose", "none", "-o", "map.png", "--size",
                "200x150", "--report", "map.html", "--section", "z=600"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(io::read_png(file("map.png")).width, 200);
  EXPECT_THAT(text("map.html"), HasSubstr("<h3>z = 600 mm</h3>"));
  EXPECT_THAT(run.out, HasSubstr("report: map.html"));
}

TEST_F(Deviation, WritesNoFileUnlessAsked) {
  ASSERT_EQ(bodyline({"scan", car("model1"), "-o", "scan.ply", "--points", "2000"}).exit_code, 0);
  const auto before = files();
  ASSERT_EQ(bodyline({"deviation", car("model1"), "scan.ply", "--pose", "none"}).exit_code, 0);
  EXPECT_EQ(files(), before);
}

TEST_F(Deviation, LooksForMistakesBeforeItStarts) {
  write("old.png", "old");
  const auto refused = [&](std::vector<std::string> options, const std::string& words) {
    std::vector<std::string> command{"deviation", car("model1"), "no_such_scan.ply"};
    command.insert(command.end(), options.begin(), options.end());
    const auto run = bodyline(command);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, HasSubstr(words));
  };
  refused({"-o", "old.png"}, "exists already");
  refused({"-o", "a.jpg"}, ".png");
  refused({"-o", "a.png", "--view", "below"}, "below");
  refused({"--report", "a.htm"}, ".html");
  refused({"--report", "a.html", "--section", "x=wide"}, "'x=wide' is not a plane");
  refused({"--range", "-1"}, "--range");
  refused({"--section", "x=1200"}, "--section chooses what the page shows");
  refused({"--section", "x=1200", "-o", "a.png"}, "--section chooses what the page shows");
  refused({"--range", "5"}, "--range is of the colours");
}

}  // namespace
}  // namespace bodyline
