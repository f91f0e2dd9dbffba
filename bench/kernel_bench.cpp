#include "bench/kernel_bench.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "bench/fma_peak.hpp"
#include "bench/kernel_operations.hpp"
#include "bench/kernel_patch.hpp"
#include "bench/peers/peers.hpp"

namespace bodyline::bench {
namespace {

constexpr int degree = Patch::points - 1;
constexpr double patch_nodes = Patch::nodes * Patch::nodes;
constexpr int variables = 3 * Patch::points * Patch::points;

/// Everything the benchmarks share; made before the clock starts.
struct Fixture {
  model::FaceTables tables{degree, degree, Patch::nodes, model::Range::whole, false};
  Patch patch = bench_patch(tables);
  AdolcBending adolc{patch};
  OcctPatch occt{patch};
  // The kernels write rows of 64 bytes; 8 numbers more leave room to align them.
  std::vector<double> storage = std::vector<double>(30 * 64 + 8);
  double* out() {
    void* p = storage.data();
    std::size_t room = storage.size() * sizeof(double);
    return static_cast<double*>(std::align(64, 30 * 64 * sizeof(double), p, room));
  }
  const model::FaceRule& rule() const { return tables.rule(); }
  const double* net() const { return patch.net.data(); }
};

using Shared = std::shared_ptr<Fixture>;

void add(const std::string& name, std::function<double()> work) {
  benchmark::RegisterBenchmark(name.c_str(), [work](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(work());
  });
}

std::vector<model::Isa> available_sets() {
  std::vector<model::Isa> sets;
  for (const model::Isa isa : {model::Isa::baseline, model::Isa::avx2, model::Isa::avx512}) {
    if (model::isa_available(isa)) sets.push_back(isa);
  }
  return sets;
}

void add_kernels(const Shared& f, model::Isa isa) {
  const model::Kernels& k = model::kernels(isa);
  const std::string set = std::string("/") + k.name;
  add("peak" + set, [isa] { return fma_peak(isa); });
  add("jets" + set, [f, &k] {
    k.jets(f->rule(), f->net(), nullptr, 2, f->out());
    return f->out()[0];
  });
  add("curvature" + set, [f, &k] {
    k.curvature(f->rule(), f->net(), nullptr, f->out(), f->out() + 64);
    return f->out()[0];
  });
  add("bending" + set, [f, &k] { return k.bending(f->rule(), f->net(), nullptr); });
  add("variation" + set, [f, &k] { return k.variation(f->rule(), f->net(), nullptr); });
  add("bending_pullback" + set,
      [f, &k] { return k.bending_pullback(f->rule(), f->net(), nullptr, 1.0, f->out(), nullptr); });
  add("variation_pullback" + set, [f, &k] {
    return k.variation_pullback(f->rule(), f->net(), nullptr, 1.0, f->out(), nullptr);
  });
}

void add_peers(const Shared& f) {
  add("jets/eigen", [f] { return eigen_jets(f->patch, f->out()), f->out()[0]; });
  add("jets/occt_bezier", [f] { return f->occt.jets(f->patch, f->out()), f->out()[0]; });
  add("jets/occt_adaptor", [f] { return f->occt.jets_adaptor(f->patch, f->out()), f->out()[0]; });
  add("curvature/eigen",
      [f] { return eigen_curvature(f->patch, f->out(), f->out() + 64), f->out()[0]; });
  add("curvature/occt_slprops",
      [f] { return f->occt.curvature(f->patch, f->out(), f->out() + 64), f->out()[0]; });
  add("bending/eigen", [f] { return eigen_bending(f->patch); });
  add("bending_gradient/ceres_jet_48", [f] { return ceres_bending_48(f->patch, f->out()); });
  add("bending_gradient/ceres_jet_15", [f] { return ceres_bending_15(f->patch, f->out()); });
  add("bending_gradient/adolc", [f] { return f->adolc.gradient(f->patch, f->out()); });
  const model::Kernels& k = model::kernels(model::best_isa());
  add("bending_gradient/central_differences", [f, &k] {
    constexpr double step = 1e-3;
    std::vector<double>& net = f->patch.net;
    for (int i = 0; i < variables; ++i) {
      const double kept = net[i];
      net[i] = kept + step;
      const double above = k.bending(f->rule(), f->net(), nullptr);
      net[i] = kept - step;
      const double below = k.bending(f->rule(), f->net(), nullptr);
      net[i] = kept;
      f->out()[i] = (above - below) / (2.0 * step);
    }
    return f->out()[0];
  });
}

/// Refuses to compare what is not the same work: all gradients and values must agree.
void require_agreement(Fixture& f) {
  const model::Kernels& k = model::kernels(model::best_isa());
  std::vector<double> ours(variables), theirs(variables);
  const double value = k.bending_pullback(f.rule(), f.net(), nullptr, 1.0, ours.data(), nullptr);
  const auto require = [&](double other) {
    bool agrees = std::abs(other - value) <= 1e-10 * value;
    for (int i = 0; i < variables; ++i)
      agrees = agrees && std::abs(ours[i] - theirs[i]) <= 1e-10 * std::abs(ours[i]) + 1e-12 * value;
    if (!agrees) throw std::logic_error("a peer of the benchmarks computes something else");
  };
  require(ceres_bending_48(f.patch, theirs.data()));
  require(ceres_bending_15(f.patch, theirs.data()));
  require(f.adolc.gradient(f.patch, theirs.data()));
  require(eigen_bending(f.patch));
  std::vector<double> jets(64 * jet_numbers), peer_jets(jets.size());
  f.occt.jets(f.patch, peer_jets.data());
  eigen_jets(f.patch, jets.data());
  k.jets(f.rule(), f.net(), nullptr, 2, f.out());
  for (int node = 0; node < 64; ++node) {
    for (int e = 0; e < jet_numbers; ++e) {
      const double x = f.out()[e * 64 + node];
      if (std::abs(x - jets[node * jet_numbers + e]) > 1e-8 ||
          std::abs(x - peer_jets[node * jet_numbers + e]) > 1e-8) {
        throw std::logic_error("a peer of the benchmarks computes other jets");
      }
    }
  }
}

void add_shares(Report& report, model::Isa isa, bool with_targets) {
  const std::string set = std::string("/") + model::kernels(isa).name;
  const auto share = [&](const std::string& name, double operations, double target) {
    report.shares.push_back({name + set, name + set, patch_nodes * operations, "peak" + set,
                             fma_peak_operations(isa), with_targets ? target : 0.0, patch_nodes});
  };
  share("jets", jets_operations(degree, degree), 0.8);
  share("curvature", curvature_operations(degree, degree), 0.0);
  share("bending", bending_operations(degree, degree), 0.6);
  share("bending_pullback", bending_pullback_operations(degree, degree), 0.5);
  share("variation", variation_operations(degree, degree), 0.6);
  share("variation_pullback", variation_pullback_operations(degree, degree), 0.5);
}

}  // namespace

void register_kernel_benchmarks() {
  const Shared fixture = std::make_shared<Fixture>();
  require_agreement(*fixture);
  for (const model::Isa isa : available_sets()) add_kernels(fixture, isa);
  add_peers(fixture);
}

Report kernel_report() {
  Report report;
  const model::Isa best = model::best_isa();
  add_shares(report, best, true);
  for (const model::Isa isa : available_sets()) {
    if (isa != best) add_shares(report, isa, false);
  }
  const std::string set = std::string("/") + model::kernels(best).name;
  report.ratios = {
      {"bending: (value + gradient) / value", "bending_pullback" + set, "bending" + set, 2.5, true},
      {"variation: (value + gradient) / value", "variation_pullback" + set, "variation" + set, 2.8,
       true},
      {"jets: OpenCASCADE Geom_BezierSurface::D2 / ours", "jets/occt_bezier", "jets" + set, 60.0},
      {"jets: OpenCASCADE GeomAdaptor_Surface::D2 (cached) / ours", "jets/occt_adaptor",
       "jets" + set},
      {"jets: straightforward Eigen / ours", "jets/eigen", "jets" + set, 8.0},
      {"curvature: OpenCASCADE GeomLProp_SLProps / ours", "curvature/occt_slprops",
       "curvature" + set, 60.0},
      {"curvature: straightforward Eigen / ours", "curvature/eigen", "curvature" + set},
      {"bending value: straightforward Eigen / ours", "bending/eigen", "bending" + set},
      {"bending value + gradient: ceres::Jet of 15 and chain rule / ours",
       "bending_gradient/ceres_jet_15", "bending_pullback" + set, 30.0},
      {"bending value + gradient: ceres::Jet of 48 / ours", "bending_gradient/ceres_jet_48",
       "bending_pullback" + set, 30.0},
      {"bending value + gradient: ADOL-C, tape reused / ours", "bending_gradient/adolc",
       "bending_pullback" + set, 150.0},
      {"bending gradient: central differences over the patch's 48 / ours",
       "bending_gradient/central_differences", "bending_pullback" + set},
  };
  return report;
}

}  // namespace bodyline::bench
