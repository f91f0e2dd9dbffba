// Silhouettes: traced on every face, cut where others hide them, joined to outlines.

#include "model/silhouette.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "check_models.hpp"
#include "model/build.hpp"
#include "model/contour.hpp"
#include "model/measures.hpp"
#include "model/silhouette_outline.hpp"

namespace bodyline::model {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Line = std::vector<Vector2d>;

constexpr double graze_tolerance = 1e-9;  // cosine, as promised
// Between points 5 mm apart a silhouette bends away from its chords by 5^2 / (8 R), and R is 50 mm
// or more but where a corner patch is tight.
constexpr double chord_tolerance = 0.2;  // mm

struct Looked {
  std::string car;
  Stage stage;
  View view;
};

void PrintTo(const Looked& looked, std::ostream* stream) {
  *stream << looked.car << ", " << stage_name(looked.stage) << ", " << view_name(looked.view);
}

std::vector<Looked> all_looks() {
  std::vector<Looked> looks;
  for (const char* car : testing::car_names) {
    for (const Stage stage : {Stage::base, Stage::body}) {
      for (const View view : {View::side, View::front, View::top})
        looks.push_back({car, stage, view});
    }
  }
  return looks;
}

SilhouetteOptions fine() {
  SilhouetteOptions options;
  options.spacing = 5.0;
  return options;
}

/// Above 0 inside of a polygon.
int winding(const Line& polygon, const Vector2d& point) {
  int turns = 0;
  for (std::size_t k = 1; k < polygon.size(); ++k) {
    const Vector2d a = polygon[k - 1] - point, b = polygon[k] - point;
    const double side = a.x() * b.y() - a.y() * b.x();
    if (a.y() <= 0.0 && b.y() > 0.0 && side > 0.0) ++turns;
    if (a.y() > 0.0 && b.y() <= 0.0 && side < 0.0) --turns;
  }
  return std::abs(turns);
}

double area(const Line& polygon) {
  double sum = 0.0;
  for (std::size_t k = 1; k < polygon.size(); ++k)
    sum += polygon[k - 1].x() * polygon[k].y() - polygon[k - 1].y() * polygon[k].x();
  return 0.5 * std::abs(sum);
}

double distance(const Line& line, const Vector2d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Vector2d along = line[k] - line[k - 1];
    const double squared = along.squaredNorm();
    const double t =
        squared > 0.0 ? std::clamp((point - line[k - 1]).dot(along) / squared, 0.0, 1.0) : 0.0;
    least = std::min(least, (line[k - 1] + t * along - point).norm());
  }
  return least;
}

class Silhouettes : public ::testing::TestWithParam<Looked> {
 protected:
  Silhouettes()
      : body_(silhouette_body(testing::load_car(GetParam().car), GetParam().stage)),
        pieces_(silhouette(body_, GetParam().view, fine())),
        outlines_(silhouette_outline(pieces_, GetParam().view)) {}

  SilhouetteBody body_;
  std::vector<SilhouetteCurve> pieces_;
  std::vector<Line> outlines_;
};
INSTANTIATE_TEST_SUITE_P(Cars, Silhouettes, ::testing::ValuesIn(all_looks()), [](const auto& i) {
  return i.param.car + "_" + stage_name(i.param.stage) + "_" + view_name(i.param.view);
});

TEST_P(Silhouettes, ContoursGrazeTheView) {
  const Vector3d toward = view_axes(GetParam().view).toward;
  int points = 0;
  for (const SilhouetteCurve& piece : pieces_) {
    if (piece.kind != SilhouetteKind::contour) continue;
    for (const SilhouettePoint& point : piece.points) {
      ++points;
      const Vector3d normal = outward_normal(body_.faces[point.face], point.u, point.v);
      EXPECT_LE(std::abs(normal.dot(toward)), graze_tolerance);
    }
  }
  EXPECT_GT(points, 100);
}

TEST_P(Silhouettes, PointsLieOnTheirFaces) {
  for (const SilhouetteCurve& piece : pieces_) {
    for (const SilhouettePoint& point : piece.points) {
      const Vector3d on_face = jet(body_.faces[point.face], point.u, point.v, 0).d[0];
      EXPECT_LE((on_face - point.position).norm(), 1e-9);
      EXPECT_LE((project(GetParam().view, on_face) - point.picture).norm(), 1e-9);
      EXPECT_LE(point.position.y(), 1e-6);
    }
  }
}

TEST_P(Silhouettes, NormalsAreSquareToThem) {
  for (const SilhouetteCurve& piece : pieces_) {
    for (std::size_t k = 1; k + 1 < piece.points.size(); ++k) {
      const Vector2d along = piece.points[k + 1].picture - piece.points[k - 1].picture;
      const Vector2d& normal = piece.points[k].normal;
      EXPECT_NEAR(normal.norm(), 1.0, 1e-9);
      // Beside an end the two steps differ in length, and their chord leans.
      EXPECT_LE(std::abs(normal.dot(along)), 0.35 * along.norm() + 0.05);
    }
  }
}

TEST_P(Silhouettes, MakeOneClosedOutline) {
  ASSERT_EQ(outlines_.size(), 1u);
  EXPECT_EQ(outlines_.front().front(), outlines_.front().back());
}

TEST_P(Silhouettes, HaveTheWholeBodyInside) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int near = 0;
  for (const Surface& face : body_.faces) {
    for (int k = 0; k < 200; ++k) {
      const Vector3d point = jet(face, uniform(random), uniform(random), 0).d[0];
      const Vector2d picture = project(GetParam().view, point);
      if (winding(outlines_.front(), picture) > 0) continue;
      ++near;
      EXPECT_LE(distance(outlines_.front(), picture), chord_tolerance) << face.name;
    }
  }
  EXPECT_LT(near, 1000);  // of 5000 and more: the outline is one around something
}

TEST_P(Silhouettes, HaveNormalsThatPointIntoTheOpen) {
  constexpr double step = 1.0;  // mm
  int wrong = 0, all = 0;
  for (const SilhouetteCurve& piece : pieces_) {
    for (std::size_t k = 1; k + 1 < piece.points.size(); ++k) {
      const SilhouettePoint& point = piece.points[k];
      ++all;
      wrong += winding(outlines_.front(), point.picture + step * point.normal) > 0 ||
               winding(outlines_.front(), point.picture - step * point.normal) == 0;
    }
  }
  // Near concave corners a step along the normal leads into the other side.
  EXPECT_LE(wrong, all / 50);
}

TEST(Silhouette, IsMirroredFromTheRear) {
  const SilhouetteBody body = silhouette_body(testing::load_car("model2"), Stage::body);
  const auto front = silhouette_outline(silhouette(body, View::front), View::front);
  const auto rear = silhouette_outline(silhouette(body, View::rear), View::rear);
  for (const Vector2d& point : front.front())
    EXPECT_LE(distance(rear.front(), {-point.x(), point.y()}), 1e-6);
}

TEST(Silhouette, FromTheSideHasTheWheelArches) {
  const Model car = testing::load_car("model2");
  const SilhouetteBody body = silhouette_body(car, Stage::body);
  const auto pieces = silhouette(body, View::side);
  const auto outline = silhouette_outline(pieces, View::side);
  for (const WheelArch& arch : {car.front_arch, car.rear_arch}) {
    // Half way up to the arch's top, in the open.
    Vector3d top(0.0, 0.0, -1e9);
    for (const int curve : arch.curves) {
      for (const Vector3d& point : car.curves[curve].points) {
        if (point.z() > top.z()) top = point;
      }
    }
    EXPECT_EQ(winding(outline.front(), {top.x(), 0.5 * top.z()}), 0);
    EXPECT_GT(winding(outline.front(), {top.x(), top.z() + 50.0}), 0);
  }
}

TEST(Silhouette, OfABoxIsARectangle) {
  // Flat walls are edge-on in every view: the outline consists of creases.
  const SilhouetteBody body = silhouette_body(testing::plain_box(), Stage::base);
  const double sizes[][2] = {{2000, 1000}, {1600, 1000}, {1600, 1000}, {2000, 1600}};
  int k = 0;
  for (const View view : all_views()) {
    const auto outline = silhouette_outline(silhouette(body, view), view);
    ASSERT_EQ(outline.size(), 1u);
    EXPECT_NEAR(area(outline.front()), sizes[k][0] * sizes[k][1], 1.0);
    ++k;
  }
}

TEST(Silhouette, OfARoundedBoxHasItsSize) {
  const SilhouetteBody body = silhouette_body(testing::plain_box(), Stage::body);
  const Vector3d size = bounding_box(body.faces, Halves::left_and_central).size();
  for (const View view : all_views()) {
    const auto outline = silhouette_outline(silhouette(body, view), view);
    ASSERT_EQ(outline.size(), 1u);
    Eigen::AlignedBox2d box;
    for (const Vector2d& point : outline.front()) box.extend(point);
    EXPECT_LE((box.sizes() - project(view, size).cwiseAbs()).norm(), 0.1);
    EXPECT_LT(area(outline.front()), box.sizes().prod() - 1000.0);
  }
}

TEST(Contour, OfASaddleCrossesItsMiddle) {
  // z = (u - 1/2)(v - 1/2) + a little: along x the slope is v - 1/2.
  Surface saddle;
  saddle.degree_u = saddle.degree_v = 1;
  for (const double u : {0.0, 1.0}) {
    for (const double v : {0.0, 1.0}) saddle.net.push_back({u, v, (u - 0.5) * (v - 0.5)});
  }
  const Vector3d toward = Vector3d::UnitX();
  const FacingGrid grid = facing_grid(saddle, toward, 9, 9);
  const auto contours = trace_contours(saddle, toward, grid);
  ASSERT_EQ(contours.size(), 1u);
  EXPECT_FALSE(contours.front().closed);
  for (const Vector2d& point : contours.front().points) EXPECT_NEAR(point.y(), 0.5, 1e-9);
}

TEST(Contour, AroundADomeIsClosed) {
  // A paraboloid seen from aslant: a closed curve where the slope is that of the view.
  Surface dome;
  dome.degree_u = dome.degree_v = 2;
  const auto coefficient = [](int i) { return i == 1 ? 0.5 : 0.0; };  // of t (1 - t) in Bezier form
  for (int i = 0; i <= 2; ++i) {
    for (int j = 0; j <= 2; ++j) {
      const double lift = coefficient(i) * coefficient(j) * 16.0;
      dome.net.push_back({0.5 * i, 0.5 * j, lift});
    }
  }
  const Vector3d toward = Vector3d::UnitZ();
  EXPECT_TRUE(trace_contours(dome, toward, facing_grid(dome, toward, 15, 15)).empty());
  // Slopes in all directions are the same along a closed curve around the top.
  const Vector3d aslant = Vector3d(1.0, 0.0, 0.3).normalized();
  const auto contours = trace_contours(dome, aslant, facing_grid(dome, aslant, 15, 15));
  ASSERT_FALSE(contours.empty());
  for (const Contour& contour : contours) {
    for (const Vector2d& at : contour.points)
      EXPECT_NEAR(outward_normal(dome, at.x(), at.y()).dot(aslant), 0.0, graze_tolerance);
  }
}

TEST(Contour, IsFoundFromNearBy) {
  const SilhouetteBody body = silhouette_body(testing::load_car("template"), Stage::base);
  const Vector3d toward = view_axes(View::side).toward;
  const Surface& roof = body.faces[3];
  Vector2d at(0.3, 0.42);
  ASSERT_TRUE(refine_contour(roof, toward, at));
  EXPECT_NEAR(outward_normal(roof, at.x(), at.y()).dot(toward), 0.0, graze_tolerance);
  EXPECT_NEAR(at.y(), 0.5, 1e-9);
}

TEST(StageEdges, AreTheSameCurveOfBothFaces) {
  for (const char* name : testing::car_names) {
    const Model car = testing::load_car(name);
    for (const Stage stage : {Stage::base, Stage::kept, Stage::body}) {
      const auto faces = build(car, stage, Halves::left_and_central);
      int shared = 0;
      for (const StageEdge& edge : stage_edges(plan_body(car), stage)) {
        if (!edge.b) continue;
        ++shared;
        EXPECT_LE(edge_deviation(faces, {"", EdgeKind::joint, {{edge.a, *edge.b}}}, 9).gap_mm,
                  1e-6);
      }
      EXPECT_GT(shared, 0);
    }
  }
}

}  // namespace
}  // namespace bodyline::model
