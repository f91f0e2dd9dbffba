#include "optimize/arch_gaps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "io/read_model.hpp"
#include "model/measures_wheelbase.hpp"
#include "optimize/folded_scan.hpp"
#include "optimize/simulate_scan.hpp"

namespace bodyline::optimize {
namespace {

// About the distance of the last points before the rim, and how far noise and chance leave an edge.
constexpr double told_mm = 8.0;

model::Model car(const std::string& name) {
  return io::read_model(BODYLINE_SOURCE_DIR "/cars/" + name + ".toml");
}

Deviation scan_of(const model::Model& body, int points, unsigned seed) {
  SimulateOptions scanner;
  scanner.points = std::size_t(points);
  scanner.seed = seed;
  Deviation deviation;
  deviation.scan = folded_scan(simulate_scan(body, scanner), {}, std::size_t(points)).scan;
  return deviation;
}

// Widens an arch by moving its curves away from the wheel.
model::Model widened(model::Model body, const model::WheelArch& arch, double mm) {
  const auto circle = model::arch_circle(body, arch);
  for (const int number : arch.curves) {
    for (Eigen::Vector3d& point : body.curves[std::size_t(number)].points) {
      const Eigen::Vector3d out(point.x() - circle->x, 0.0, point.z() - circle->z);
      point += mm * out.normalized();
    }
  }
  return body;
}

TEST(ArchGaps, AreNoneOnAScanOfTheBodyItself) {
  for (const char* name : {"template", "model1", "model2"}) {
    const model::Model body = car(name);
    for (const int points : {20000, 200000}) {
      for (unsigned seed = 1; seed < 4; ++seed) {
        const auto gaps = arch_gaps(body, scan_of(body, points, seed));
        EXPECT_TRUE(points < 200000 || gaps.size() == 6) << gaps.size();
        for (const ArchGap& gap : gaps) {
          EXPECT_LT(std::abs(gap.gap), told_mm)
              << name << " " << points << (gap.front ? " front " : " rear ") << gap.part << gap.gap;
        }
      }
    }
  }
}

TEST(ArchGaps, TellARimThatIsShortOfTheScanOrBeyondIt) {
  const model::Model body = car("model2");
  const Deviation deviation = scan_of(body, 200000, 1);
  for (const double mm : {-25.0, 25.0, 50.0}) {
    const auto gaps = arch_gaps(widened(body, body.front_arch, mm), deviation);
    ASSERT_EQ(gaps.size(), 6u);
    for (const ArchGap& gap : gaps) EXPECT_NEAR(gap.gap, gap.front ? mm : 0.0, told_mm) << gap.part;
  }
}

TEST(ArchGaps, AreNotGuessedFromFewPoints) {
  const model::Model body = car("model2");
  EXPECT_TRUE(arch_gaps(body, scan_of(body, 1500, 1)).empty());
}

}  // namespace
}  // namespace bodyline::optimize
