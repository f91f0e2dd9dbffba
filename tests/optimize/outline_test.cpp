// Drawn outlines: their points, their matches with silhouettes, and the derivative of the distance.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "model/evaluator.hpp"
#include "optimize/outline_deviation.hpp"
#include "optimize/outline_match.hpp"
#include "optimize/outline_samples.hpp"
#include "optimize/outline_shift.hpp"
#include "outline_support.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using model::View;

constexpr double corner = 0.1;    // mm aslant that are none of a chord of 2 mm
constexpr double endless = 1e12;  // mm: every point counts in full

std::vector<Vector2d> circle(const Vector2d& middle, double radius, int count = 200) {
  std::vector<Vector2d> points;
  for (int k = 0; k <= count; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k % count) / count;
    points.push_back(middle + radius * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

model::PlacedDrawing drawing(View view, const std::vector<std::vector<Vector2d>>& lines) {
  model::PlacedDrawing result;
  result.view = view;
  for (const auto& line : lines) result.paths.push_back(straight_path(line));
  return result;
}

TEST(OutlineSamples, AreEvenAndOnTheOutline) {
  const Vector2d middle(1000.0, 500.0);
  const OutlineSamples samples =
      outline_samples(drawing(View::side, {circle(middle, 400.0)}), 10.0);
  EXPECT_NEAR(double(samples.points.size()), 2.0 * std::numbers::pi * 40.0, 2.0);
  for (std::size_t k = 0; k < samples.points.size(); ++k) {
    const Vector2d out = samples.points[k] - middle;
    EXPECT_NEAR(out.norm(), 400.0, 0.1);
    EXPECT_GT(samples.normals[k].dot(out.normalized()), 0.999);  // out of what is drawn
    EXPECT_FALSE(samples.two_sided[k]);
    const auto [before, after] = samples.neighbours[k];
    ASSERT_GE(std::min(before, after), 0);
    EXPECT_NEAR((samples.points[after] - samples.points[k]).norm(), 10.0, 0.5);
  }
}

TEST(OutlineSamples, LeaveOutWhatIsDrawnWithin) {
  const Vector2d middle(0.0, 0.0);
  const auto only = outline_samples(drawing(View::side, {circle(middle, 400.0)}), 10.0);
  const auto with_window =
      outline_samples(drawing(View::side, {circle(middle, 100.0), circle(middle, 400.0)}), 10.0);
  EXPECT_EQ(only.points.size(), with_window.points.size());
}

TEST(OutlineSamples, LeaveOutSlotsThatABodyDoesNotFollow) {
  // A square with a slot of 30 mm into its side, and one with a notch of 300 mm.
  const auto notched = [](double width) {
    return std::vector<Vector2d>{{0, 0},       {1000, 0},          {1000, 500},
                                 {600, 500},   {600, 500 + width}, {1000, 500 + width},
                                 {1000, 1000}, {0, 1000},          {0, 0}};
  };
  const auto inside = [](const OutlineSamples& samples) {
    int count = 0;
    for (const Vector2d& point : samples.points)
      count += point.x() > 650.0 && point.x() < 950.0 && point.y() > 1.0 && point.y() < 999.0;
    return count;
  };
  EXPECT_EQ(inside(outline_samples(drawing(View::side, {notched(30.0)}), 10.0)), 0);
  EXPECT_GT(inside(outline_samples(drawing(View::side, {notched(300.0)}), 10.0)), 50);
}

TEST(OutlineSamples, OfAnOpenLineHaveTwoSidesAndEnds) {
  const auto samples =
      outline_samples(drawing(View::side, {{{0.0, 0.0}, {500.0, 100.0}, {1000.0, 0.0}}}), 10.0);
  int ends = 0;
  for (std::size_t k = 0; k < samples.points.size(); ++k) {
    EXPECT_TRUE(samples.two_sided[k]);
    ends += samples.neighbours[k][0] < 0 || samples.neighbours[k][1] < 0;
  }
  EXPECT_EQ(ends, 2);
}

TEST(OutlineSamples, AreMirroredToTheLeft) {
  for (const View view : {View::top, View::front, View::rear}) {
    const auto samples = outline_samples(drawing(view, {circle({0.0, 0.0}, 400.0)}), 10.0);
    EXPECT_EQ(samples.view, view == View::top ? View::top : View::front);
    EXPECT_EQ(samples.drawn_view, view);
    for (const Vector2d& point : samples.points)
      EXPECT_LE(view == View::top ? point.y() : -point.x(), 1e-9);
  }
}

TEST(OutlineSamples, NeedSomethingDrawn) {
  EXPECT_THROW(outline_samples(drawing(View::side, {}), 10.0), std::invalid_argument);
}

TEST(OutlineDeviation, IsNothingForABodysOwnOutline) {
  const model::Model car = outline_test_car("model2");
  const std::vector<View> views = model::all_views();
  const auto deviations = measure_outlines(car, traced_outlines(car, views));
  ASSERT_EQ(deviations.size(), views.size());
  for (const OutlineDeviation& deviation : deviations) {
    EXPECT_GT(deviation.points.size(), 300u);
    EXPECT_LE(deviation.median, 0.05);  // chords of 4 mm
    EXPECT_LE(deviation.p90, 0.2);
    EXPECT_EQ(deviation.silhouette.size(), 1u);
  }
}

TEST(OutlineDeviation, IsPositiveOutside) {
  const model::Model car = outline_test_car("model2");
  auto drawings = traced_outlines(car, {View::side});
  // Grown by a tenth about the middle of the car's lower edge.
  for (auto& path : drawings.front().paths) {
    for (auto& segment : path.segments) {
      for (Vector2d& point : segment.points)
        point = Vector2d(2350.0, 600.0) + 1.1 * (point - Vector2d(2350.0, 600.0));
    }
  }
  const auto deviation = measure_outlines(car, drawings).front();
  int outside = 0;
  for (const double distance : deviation.distances) outside += distance > 0.0;
  EXPECT_GT(outside, int(0.7 * double(deviation.distances.size())));
  EXPECT_GT(deviation.median, 20.0);
}

TEST(OutlineShift, FindsHowADrawingWasMoved) {
  const model::Model car = outline_test_car("model1");
  const auto drawings = traced_outlines(car, {View::side, View::front});
  const Vector3d moved(37.0, 0.0, -52.0);
  const Vector3d shift = outline_shift(car, shifted(drawings, moved));
  EXPECT_LE((shift + moved).norm(), 0.2);
}

TEST(OutlineShift, LeavesWhatTheOutlinesDoNotShow) {
  const model::Model car = outline_test_car("model1");
  const auto drawings = traced_outlines(car, {View::top});
  const Vector3d shift = outline_shift(car, shifted(drawings, {-20.0, 0.0, 400.0}));
  EXPECT_NEAR(shift.x(), 20.0, 0.2);
  EXPECT_NEAR(shift.z(), 0.0, 1e-6);
}

// ---- the derivative ----

/// A body with all its variables, and its silhouettes from scratch.
class Retraced {
 public:
  Retraced(const std::string& car, model::Stage stage)
      : stage_(stage),
        context_(std::make_shared<const model::BodyContext>(outline_test_car(car))),
        evaluator_(context_, context_->map.select(std::vector<std::string>{"*"}), options(stage)) {}

  const model::BodyPlan& plan() const { return context_->plan; }
  model::Evaluator& evaluator() { return evaluator_; }

  OutlinePulls match(const VectorXd& x, const OutlineSamples& samples) {
    evaluator_.build(x);
    const auto body = model::silhouette_body(plan(), stage_, evaluator_.nets());
    model::SilhouetteOptions fine;
    fine.spacing = 2.0;
    return match_outline(body, model::silhouette(body, samples.view, fine), samples,
                         {{endless, endless}, false});
  }

  int variable(const std::string& name) const {
    return context_->map.select(std::vector<std::string>{name}).front();
  }

 private:
  static model::EvaluatorOptions options(model::Stage stage) {
    model::EvaluatorOptions result;
    result.stage = stage;
    return result;
  }

  model::Stage stage_;
  std::shared_ptr<const model::BodyContext> context_;
  model::Evaluator evaluator_;
};

struct Derived {
  model::Stage stage;
  View view;
};

class OutlineDerivative : public testing::TestWithParam<Derived> {};
INSTANTIATE_TEST_SUITE_P(Views, OutlineDerivative,
                         testing::Values(Derived{model::Stage::base, View::side},
                                         Derived{model::Stage::base, View::front},
                                         Derived{model::Stage::base, View::top},
                                         Derived{model::Stage::body, View::side},
                                         Derived{model::Stage::body, View::front},
                                         Derived{model::Stage::body, View::top}),
                         [](const auto& i) {
                           return std::string(model::stage_name(i.param.stage)) + "_" +
                                  model::view_name(i.param.view);
                         });

// The distance of one of the drawing's points along the normal of the silhouette.
double off(const OutlinePulls& found, std::size_t k) {
  return (found.pulls[k].target - found.matches[k].foot).dot(found.matches[k].normal);
}

// How far the foot of a point is from being one: what the picture shows of the offset is to be
// along the normal, not aslant from a corner.
double aslant(const OutlinePulls& found, std::size_t k, View view) {
  const Vector2d offset = model::project(view, found.pulls[k].target - found.matches[k].foot);
  const Vector2d normal = model::project(view, found.matches[k].normal);
  return (offset - offset.dot(normal) * normal).norm();
}

TEST_P(OutlineDerivative, IsThatOfTheRetracedSilhouette) {
  const auto [stage, view] = GetParam();
  Retraced car("template", stage);
  const OutlineSamples samples =
      outline_samples(traced_outlines(outline_test_car("model2"), {view}).front(), 25.0);
  const VectorXd start = car.evaluator().start();
  const auto& faces = car.plan().faces(stage);
  int checked = 0;
  for (const std::string name :
       {"curve.windshield__roof[1].z", "curve.windshield__roof[1].x", "curve.door_bottom[2].z",
        "curve.roof__side_window[2].y", "curve.grille__hood[1].x", "curve.trunk_lid__tail[1].z",
        "curve.front_arch_top[1].z", "curve.door_upper__door_lower[3].y", "shape.hood.u[1]",
        "shape.door_lower.v[1]", "cut.hood.u_hi", "fullness.hood__windshield.b"}) {
    const int variable = car.variable(name);
    const double step = name.starts_with("curve") ? 1e-2 : 1e-4;
    VectorXd x = start;
    x[variable] = start[variable] + step;
    const OutlinePulls above = car.match(x, samples);
    x[variable] = start[variable] - step;
    const OutlinePulls below = car.match(x, samples);
    OutlinePulls held = car.match(start, samples);
    // A point that jumps to another part of the silhouette says nothing of a derivative, nor does
    // one at a corner, where two parts meet; the term leaves out faces with Gregory terms.
    double slope = 0.0, bulk = 0.0, total = 0.0;
    std::size_t steady = 0;
    for (std::size_t k = 0; k < held.matches.size(); ++k) {
      const Match &now = held.matches[k], &up = above.matches[k], &down = below.matches[k];
      const auto near = [&](const Match& other) {
        return other.face == now.face &&
               std::abs(other.u - now.u) + std::abs(other.v - now.v) < 0.02;
      };
      const bool counts =
          near(up) && near(down) && aslant(held, k, view) < corner && faces[now.face].blend < 0;
      if (!counts) held.pulls[k].weight.setZero();
      if (!counts) continue;
      ++steady;
      const double weight = held.pulls[k].weight.trace();
      total += weight;
      const double change =
          weight * (off(above, k) * off(above, k) - off(below, k) * off(below, k)) / (2.0 * step);
      slope += change;
      bulk += std::abs(change);
    }
    PullTerm term(car.plan(), stage);
    term.set(held.matches, held.pulls);
    std::vector<double> bar(3 * std::size_t(car.plan().point_count), 0.0);
    term.value(car.evaluator().nets(), 1.0, bar.data());
    VectorXd gradient(start.size());
    car.evaluator().build_pullback(bar, gradient);
    if (bulk / total < 1e-3) continue;  // this view or stage does not show it
    ++checked;
    // The template's arches lie elsewhere than model 2's: a tenth of the points is nearest to
    // corners.
    EXPECT_GT(double(steady), 0.8 * double(held.matches.size())) << name;
    EXPECT_NEAR(slope / total, gradient[variable], 2e-3 * bulk / total) << name;
  }
  EXPECT_GE(checked, 3);
}

}  // namespace
}  // namespace bodyline::optimize
