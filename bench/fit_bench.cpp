#include "bench/fit_bench.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "bench/peers/fit_peers.hpp"
#include "io/read_model.hpp"
#include "model/evaluator.hpp"
#include "model/net_surface.hpp"
#include "optimize/pull_term.hpp"
#include "optimize/rim_pulls.hpp"
#include "optimize/scan_follow.hpp"
#include "optimize/simulate_scan.hpp"

namespace bodyline::bench {
namespace {

constexpr std::size_t scan_points = 1'000'000;
constexpr std::size_t batch = 4096;
constexpr int warm_steps = 2;
constexpr double sample_spacing = 40.0;  // mm, as the matcher's own
const optimize::PullReach reach{20.0, 100.0};

/// The template at stage base, with a scan of itself and where its points lie.
struct ScannedCar {
  ScannedCar();

  const double* nets() const { return evaluator.nets(); }
  const model::BodyPlan& plan() const { return context->plan; }

  std::shared_ptr<const model::BodyContext> context;
  model::Evaluator evaluator;
  model::Scan scan;
  std::vector<optimize::Match> matches;
  optimize::ScanFollower follower;
  optimize::PullTerm term;
};

model::Scan scan_of(const model::Model& car) {
  optimize::SimulateOptions options;
  options.points = scan_points;
  options.noise_mm = 1.0;
  model::Scan scan = optimize::simulate_scan(car, options);
  for (std::size_t k = 0; k < scan.points.size(); ++k) {
    if (scan.points[k].y() <= 0.0) continue;
    scan.points[k].y() *= -1.0;
    scan.normals[k].y() *= -1.0;
  }
  return scan;
}

ScannedCar::ScannedCar()
    : context(std::make_shared<model::BodyContext>(
          io::read_model(BODYLINE_SOURCE_DIR "/cars/template.toml"))),
      evaluator(context, {}, {}),
      scan(scan_of(io::read_model(BODYLINE_SOURCE_DIR "/cars/template.toml"))),
      follower(context->plan, model::Stage::base, scan,
               optimize::rims_of(context->plan, model::Stage::base)),
      term(context->plan, model::Stage::base) {
  evaluator.build(Eigen::VectorXd(0));
  matches = optimize::ScanMatcher(plan(), model::Stage::base, scan).match(nets());
  follower.start(matches);
}

std::vector<FitFace> fit_faces(const ScannedCar& car) {
  std::vector<FitFace> faces;
  for (const model::Face& face : car.plan().base_faces) {
    const int numbers = 3 * (face.degree_u + 1) * (face.degree_v + 1);
    const double* const net = car.nets() + 3 * face.net;
    faces.push_back({face.degree_u, face.degree_v, {net, net + numbers}, {}, {}, {}});
  }
  for (std::size_t k = 0; k < car.matches.size(); ++k) {
    FitFace& face = faces[car.matches[k].face];
    face.parameters.push_back({car.matches[k].u, car.matches[k].v});
    face.normals.push_back(car.matches[k].normal);
    face.targets.push_back(car.scan.points[k]);
  }
  return faces;
}

// The rows of each face out of those of the whole term.
std::vector<FitSquares> face_squares(ScannedCar& car) {
  Eigen::VectorXd residual(car.term.residual_count());
  model::NetTerm::Jacobian jacobian;
  car.term.residuals(car.nets(), residual, &jacobian);
  std::vector<FitSquares> squares;
  Eigen::Index row = 0;
  for (const model::Face& face : car.plan().base_faces) {
    const int numbers = 3 * (face.degree_u + 1) * (face.degree_v + 1);
    FitSquares one;
    one.root = jacobian.block(row, 3 * face.net, numbers, numbers);
    const Eigen::Map<const Eigen::VectorXd> net(car.nets() + 3 * face.net, numbers);
    one.target = one.root * net - residual.segment(row, numbers);
    squares.push_back(std::move(one));
    row += numbers + 1;
  }
  return squares;
}

template <class Work>
void add(const std::string& name, Work work) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [work](benchmark::State& state) {
                                 for (auto _ : state) benchmark::DoNotOptimize(work());
                               })
      ->Unit(benchmark::kMicrosecond)
      ->UseRealTime();
}

// Nothing is set up before the first benchmark that needs it runs.
using Slot = std::shared_ptr<std::unique_ptr<ScannedCar>>;

ScannedCar& car_in(const Slot& slot) {
  if (!*slot) *slot = std::make_unique<ScannedCar>();
  return **slot;
}

void add_iterations(const Slot& slot) {
  add("fit/iteration", [slot] {
    ScannedCar& car = car_in(slot);
    car.term.set(car.follower.follow(car.nets(), reach, warm_steps));
    std::vector<FitFace> nets;
    for (const model::Face& face : car.plan().base_faces) {
      const int numbers = 3 * (face.degree_u + 1) * (face.degree_v + 1);
      const double* const net = car.nets() + 3 * face.net;
      nets.push_back({face.degree_u, face.degree_v, {net, net + numbers}, {}, {}, {}});
    }
    return CeresFit(face_squares(car), std::move(nets)).step();
  });
  const auto by_face = std::make_shared<std::unique_ptr<CeresFit>>();
  add("fit/ceres_block_per_face", [slot, by_face] {
    if (!*by_face)
      *by_face = std::make_unique<CeresFit>(fit_faces(car_in(slot)), CeresFit::Blocks::one_a_face);
    return (*by_face)->step();
  });
  const auto by_point = std::make_shared<std::unique_ptr<CeresFit>>();
  add("fit/ceres_block_per_point", [slot, by_point] {
    if (!*by_point)
      *by_point =
          std::make_unique<CeresFit>(fit_faces(car_in(slot)), CeresFit::Blocks::one_a_point);
    return (*by_point)->step();
  });
}

/// Points of the hood with parameters a little off those of their nearest points.
struct HoodPoints {
  explicit HoodPoints(ScannedCar& car);
  void update();

  const model::Kernels& kernels = model::kernels(model::best_isa());
  FitFace face;
  std::vector<double> columns;
};

HoodPoints::HoodPoints(ScannedCar& car) : face(fit_faces(car)[1]), columns(11 * batch) {
  for (std::size_t k = 0; k < batch; ++k) {
    for (int c = 0; c < 3; ++c) columns[c * batch + k] = face.targets[k][c];
    for (int c = 0; c < 2; ++c) {
      face.parameters[k][c] =
          std::clamp(face.parameters[k][c] + 0.004 * (k % 2 ? 1 : -1), 0.0, 1.0);
    }
  }
}

void HoodPoints::update() {
  const auto column = [&](int c) { return columns.data() + c * batch; };
  for (std::size_t k = 0; k < batch; ++k)
    for (int c = 0; c < 2; ++c) column(3 + c)[k] = face.parameters[k][c];
  model::FootPointArrays a;
  a.count = int(batch);
  a.x = column(0), a.y = column(1), a.z = column(2), a.u = column(3), a.v = column(4);
  for (int c = 0; c < 3; ++c) a.foot[c] = column(5 + c), a.normal[c] = column(8 + c);
  kernels.foot_points(face.degree_u, face.degree_v, face.net.data(), nullptr, warm_steps, a);
}

/// Samples of all faces of the car, and the triangles between them.
struct Tessellation {
  explicit Tessellation(const ScannedCar& car);
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
};

Tessellation::Tessellation(const ScannedCar& car) {
  for (const model::Surface& face :
       model::net_surfaces(car.plan(), model::Stage::base, car.nets())) {
    const double length = (face.net.back() - face.net.front()).norm();
    const int cells = std::clamp(int(length / sample_spacing), 4, 60), row = cells + 1;
    const int first = int(vertices.size());
    for (int i = 0; i <= cells; ++i)
      for (int j = 0; j <= cells; ++j)
        vertices.push_back(model::jet(face, double(i) / cells, double(j) / cells, 0).d[0]);
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const int a = first + i * row + j;
        triangles.push_back({a, a + row, a + 1});
        triangles.push_back({a + row, a + row + 1, a + 1});
      }
    }
  }
}

void add_foot_points(const Slot& slot) {
  const auto hood = std::make_shared<std::unique_ptr<HoodPoints>>();
  const auto hood_of = [slot, hood]() -> HoodPoints& {
    if (!*hood) *hood = std::make_unique<HoodPoints>(car_in(slot));
    return **hood;
  };
  add("foot_points/ours", [hood_of] {
    hood_of().update();
    return hood_of().columns[0];
  });
  const auto occt = std::make_shared<std::unique_ptr<OcctNearest>>();
  add("foot_points/occt", [hood_of, occt] {
    if (!*occt) *occt = std::make_unique<OcctNearest>(hood_of().face);
    return (*occt)->nearest(0, batch);
  });
  const auto tree = std::make_shared<std::unique_ptr<NanoflannNearest>>();
  add("foot_points/nanoflann", [slot, hood_of, tree] {
    if (!*tree) *tree = std::make_unique<NanoflannNearest>(Tessellation(car_in(slot)).vertices);
    return (*tree)->nearest(hood_of().face.targets, 0, batch);
  });
  const auto mesh = std::make_shared<std::unique_ptr<EmbreeNearest>>();
  add("foot_points/embree", [slot, hood_of, mesh] {
    if (!*mesh) {
      const Tessellation tessellation(car_in(slot));
      *mesh = std::make_unique<EmbreeNearest>(tessellation.vertices, tessellation.triangles);
    }
    return (*mesh)->nearest(hood_of().face.targets, 0, batch);
  });
}

}  // namespace

void register_fit_benchmarks() {
  const Slot slot = std::make_shared<std::unique_ptr<ScannedCar>>();
  add_foot_points(slot);
  add_iterations(slot);
}

Report fit_report() {
  Report report;
  report.ratios = {
      {"foot points, warm: OpenCASCADE / ours", "foot_points/occt", "foot_points/ours", 50.0},
      {"foot points, warm: nanoflann's query / ours", "foot_points/nanoflann", "foot_points/ours",
       6.0},
      {"foot points, warm: Embree's query / ours", "foot_points/embree", "foot_points/ours", 6.0},
      {"fit iteration, 1e6 points: Ceres, a block per face / ours", "fit/ceres_block_per_face",
       "fit/iteration", 25.0},
      {"fit iteration, 1e6 points: Ceres, a block per point / ours", "fit/ceres_block_per_point",
       "fit/iteration", 60.0},
  };
  return report;
}

}  // namespace bodyline::bench
