#include "bench/strokes_bench.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/random.hpp"
#include "strokes/build_surface.hpp"

namespace bodyline::bench {
namespace {

using Eigen::Vector3d;

constexpr int count = 1000;
constexpr double asked_per_second = 100.0;  // 1000 in 10 s
constexpr double short_length = 0.05, long_length = 0.1;
constexpr double width_mm = 2000.0, depth_mm = 1400.0;

Vector3d on_surface(double u, double v) {
  return {width_mm * u, depth_mm * v, 150.0 * std::sin(3.0 * u) * std::sin(2.5 * v + 0.4)};
}

/// A boundary of four sides and 1000 strokes of a length, part of the width, all over the inside in
/// all directions; 20 points each.
std::vector<model::Stroke> drawing(double length) {
  constexpr int points = 20;
  std::vector<model::Stroke> strokes;
  const auto add = [&](const std::string& name, double u0, double v0, double u1, double v1) {
    model::Stroke stroke{name, {}};
    for (int k = 0; k < points; ++k) {
      const double t = static_cast<double>(k) / (points - 1);
      stroke.points.push_back(on_surface(u0 + t * (u1 - u0), v0 + t * (v1 - v0)));
    }
    strokes.push_back(std::move(stroke));
  };
  add("boundary 1", 0, 0, 1, 0);
  add("boundary 2", 1, 0, 1, 1);
  add("boundary 3", 1, 1, 0, 1);
  add("boundary 4", 0, 1, 0, 0);
  model::Random random(1);
  const double room = 1.0 - length;
  for (int k = 0; k < count; ++k) {
    const double angle = std::numbers::pi * random.uniform();
    const double u = 0.5 * length + room * random.uniform(),
                 v = 0.5 * length + room * random.uniform();
    const double du = 0.49 * length * std::cos(angle), dv = 0.49 * length * std::sin(angle);
    add("stroke", u - du, v - dv, u + du, v + dv);
  }
  return strokes;
}

// What came of it, so that a fast run that rejects everything shows.
void count_outcomes(const strokes::SurfaceBuild& build, benchmark::State& state) {
  int inserted = 0;
  double largest = 0.0;
  for (const strokes::StrokeOutcome& outcome : build.outcomes) {
    if (outcome.rejection != strokes::Rejection::none) continue;
    ++inserted;
    if (outcome.gave_way_mm == 0.0) largest = std::max(largest, outcome.deviation_mm);
  }
  state.counters["inserted"] = inserted;
  state.counters["faces"] = static_cast<double>(build.surface.net.patches.size());
  state.counters["deviation_mm"] = largest;
  if (build.smooth) state.counters["tolerance_mm"] = build.smooth->tolerance_mm;
}

void add(const std::string& name, double length, strokes::Method method) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) {
                                 const std::vector<model::Stroke> strokes = drawing(length);
                                 strokes::BuildOptions options;
                                 options.method = method;
                                 for (auto _ : state)
                                   count_outcomes(strokes::build_surface(strokes, options), state);
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

}  // namespace

void register_strokes_benchmarks() {
  add("strokes/smooth/short", short_length, strokes::Method::smooth);
  add("strokes/smooth/long", long_length, strokes::Method::smooth);
  add("strokes/paper/short", short_length, strokes::Method::paper);
  add("strokes/paper/long", long_length, strokes::Method::paper);
}

Report strokes_report() {
  Report report;
  report.rates = {
      {"strokes inserted and made smooth, a twentieth of the width long", "strokes/smooth/short",
       count, asked_per_second},
      {"the same, a tenth of the width long", "strokes/smooth/long", count, asked_per_second},
      {"strokes inserted by the paper's rules, a twentieth", "strokes/paper/short", count, 0.0},
      {"the same, a tenth", "strokes/paper/long", count, 0.0}};
  return report;
}

}  // namespace bodyline::bench
