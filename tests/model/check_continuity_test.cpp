#include <gtest/gtest.h>

#include "check_models.hpp"
#include "model/check_findings.hpp"

/// After construction a body is smooth wherever faces meet.
namespace bodyline::testing {
namespace {

// What the project promises. Rounding of coordinates of some 5000 mm leaves about 1e-12 mm and,
// on strips a few mm wide, 1e-10 degrees.
constexpr double gap_mm = 1e-9;
constexpr double normal_deg = 1e-9;
// Also promised, for the corners where a seam ends; their Gregory term makes them as exact as the
// others.
constexpr double pillar_deg = 0.01;
constexpr int perturbed_cars = 8;

double allowed_deg(const model::EdgeCheck& edge) { return edge.pillar ? pillar_deg : normal_deg; }

void expect_smooth(const model::BodyCheck& check) {
  for (const model::EdgeCheck& edge : check.edges) {
    EXPECT_LE(edge.deviation.gap_mm, gap_mm) << edge.name;
    if (edge.stage == model::Stage::base) continue;
    EXPECT_LE(edge.deviation.normal_deviation_deg, allowed_deg(edge)) << edge.name;
  }
}

class Cars : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(CheckContinuity, Cars, ::testing::ValuesIn(car_names),
                         [](const auto& car) { return std::string(car.param); });

TEST_P(Cars, FacesMeetWithoutGapAndWithOneNormal) {
  const model::BodyCheck check = model::check_body(load_car(GetParam()));
  expect_smooth(check);
  EXPECT_EQ(check.edges.size(), 2 + 22 + 2 + 8);
}

TEST_P(Cars, FacesMeetAfterRandomMovesOfTheVariables) {
  std::mt19937 random(20260101);
  for (int k = 0; k < perturbed_cars; ++k) {
    SCOPED_TRACE(k);
    model::BodyCheckOptions options;
    options.fold_cells = 1;  // folds are not the subject
    expect_smooth(model::check_body(perturbed_car(GetParam(), random), options));
  }
}

TEST_P(Cars, HaveTwentyFivePatchesAndSeventySevenFaces) {
  const model::Model car = load_car(GetParam());
  EXPECT_EQ(model::build(car, model::Stage::base).size(), 25);
  EXPECT_EQ(model::build(car, model::Stage::kept).size(), 25);
  EXPECT_EQ(model::build(car, model::Stage::body).size(), 77);
  EXPECT_EQ(model::check_body(car).totals.faces, 77);
}

TEST_P(Cars, AreMirrorSymmetric) {
  constexpr double symmetric_mm = 1e-9;
  for (const model::Surface& face :
       model::build(load_car(GetParam()), model::Stage::body, model::Halves::left_and_central)) {
    if (!face.central) continue;
    const bool along_u = face.kind == model::FaceKind::transition;
    for (int i = 0; i <= face.degree_u; ++i) {
      for (int j = 0; j <= face.degree_v; ++j) {
        const Eigen::Vector3d& image =
            along_u ? face.point(face.degree_u - i, j) : face.point(i, face.degree_v - j);
        const Eigen::Vector3d mirrored(image.x(), -image.y(), image.z());
        EXPECT_LE((face.point(i, j) - mirrored).norm(), symmetric_mm) << face.name;
      }
    }
  }
}

// Seams as printed are not smooth; these are the figures that are known of them.
struct PrintedSeam {
  const char* car;
  double degrees;
};
class Seams : public ::testing::TestWithParam<PrintedSeam> {};

INSTANTIATE_TEST_SUITE_P(CheckContinuity, Seams,
                         ::testing::Values(PrintedSeam{"template", 4.7}, PrintedSeam{"model1", 7.9},
                                           PrintedSeam{"model2", 4.2}),
                         [](const auto& seam) { return std::string(seam.param.car); });

TEST_P(Seams, AreFoundAsPrintedAndCorrected) {
  constexpr double printed_digits = 0.1;
  const model::BodyCheck check = model::check_body(load_car(GetParam().car));
  const auto at = [&](model::Stage stage) {
    return edge_of(check, "front_fender_upper__door_upper", model::EdgeKind::seam, stage)
        .deviation.normal_deviation_deg;
  };
  EXPECT_NEAR(at(model::Stage::base), GetParam().degrees, printed_digits);
  EXPECT_LE(at(model::Stage::body), normal_deg);
}

TEST(CheckFindings, NameThePrintedSeamAndWhatItIsCorrectedTo) {
  const model::BodyCheck check = model::check_body(load_car("model2"));
  const std::vector<std::string> findings = model::check_findings(check);
  ASSERT_EQ(findings.size(), 2);
  EXPECT_NE(findings[0].find("front_fender_upper__door_upper"), std::string::npos);
  EXPECT_NE(findings[0].find("corrects"), std::string::npos);
}

TEST(CheckFindings, FindAnEdgeThatIsTornOpen) {
  const model::Model car = load_car("template");
  const model::BodyPlan plan = model::plan_body(car);
  std::vector<model::Surface> faces =
      model::build(car, model::Stage::body, model::Halves::left_and_central);
  const std::vector<model::BodyEdge> edges = model::list_edges(car, plan, model::Stage::body);
  constexpr double torn_mm = 1e-3;
  for (const model::BodyEdge& edge : edges) {
    SCOPED_TRACE(edge.name);
    const int face = edge.sides.front().a.face;
    const std::vector<Eigen::Vector3d> before = faces[face].net;
    for (Eigen::Vector3d& point : faces[face].net) point.z() += torn_mm;
    EXPECT_NEAR(model::edge_deviation(faces, edge, 9).gap_mm, torn_mm, gap_mm);
    faces[face].net = before;
  }
}

// A face turned about the line x = z = 0 by a known angle meets its neighbour at that angle.
TEST(CheckEdge, MeasuresTheAngleBetweenTwoPlanes) {
  constexpr double rounding_deg = 1e-13;
  for (const double degrees : {1e-10, 1e-6, 1.0, 60.0, 179.0}) {
    const double angle = degrees * 3.14159265358979323846 / 180.0;
    model::Surface flat, turned;
    flat.degree_u = flat.degree_v = turned.degree_u = turned.degree_v = 1;
    const Eigen::Vector3d end(0, 100, 0), left(-100, 0, 0);
    const Eigen::Vector3d right(100 * std::cos(angle), 0, 100 * std::sin(angle));
    flat.net = {left, left + end, {0, 0, 0}, end};
    turned.net = {{0, 0, 0}, end, right, right + end};
    const model::BodyEdge edge{"fold",
                               model::EdgeKind::joint,
                               {{{0, model::Side::u1, false}, {1, model::Side::u0, false}}}};
    const model::EdgeDeviation deviation = model::edge_deviation({flat, turned}, edge, 5);
    EXPECT_NEAR(deviation.normal_deviation_deg, degrees, rounding_deg + 1e-15 * degrees);
    EXPECT_EQ(deviation.gap_mm, 0.0);
    EXPECT_EQ(deviation.curvature_jump_per_mm, 0.0);
  }
}

// A parabola z = -c x^2 has curvature 2c at its top, and joins the plane z = 0 there.
TEST(CheckEdge, MeasuresTheCurvatureSquareToTheEdgeOnly) {
  constexpr double curvature = 1e-3, rounding = 1e-15;
  model::Surface flat, bent;
  flat.degree_u = flat.degree_v = 1;
  bent.degree_u = 2;
  bent.degree_v = 1;
  // The parameter lines of `bent` run askew to the edge.
  const Eigen::Vector3d end(0, 100, 0), askew(50, 30, 0);
  flat.net = {{-100, 0, 0}, {-100, 100, 0}, {0, 0, 0}, end};
  const Eigen::Vector3d last = 2.0 * askew - Eigen::Vector3d(0, 0, 0.5 * curvature * 100 * 100);
  bent.net = {{0, 0, 0}, end, askew, askew + end, last, last + end};
  const model::BodyEdge edge{
      "top", model::EdgeKind::joint, {{{0, model::Side::u1, false}, {1, model::Side::u0, false}}}};
  const model::EdgeDeviation deviation = model::edge_deviation({flat, bent}, edge, 5);
  EXPECT_NEAR(deviation.curvature_jump_per_mm, curvature, rounding);
}

}  // namespace
}  // namespace bodyline::testing
