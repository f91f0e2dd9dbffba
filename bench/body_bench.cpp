#include "bench/body_bench.hpp"

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "io/read_model.hpp"
#include "model/evaluator.hpp"
#include "optimize/fairness.hpp"

namespace bodyline::bench {
namespace {

const char* const model_file = BODYLINE_SOURCE_DIR "/cars/model1.toml";
// Evaluations in one go where two threads share them, so that starting threads does not count.
constexpr int sweep = 512;
// What of the times is the processor's alone, and what passes while two threads work.
enum class Clock { processor, wall };

using Context = std::shared_ptr<const model::BodyContext>;

/// An evaluator of all variables with one term, and what it needs to be called.
struct Body {
  Body(const Context& context, model::TermKind kind, int threads = 1)
      : evaluator(context, context->map.select(std::vector<std::string>{"*"}),
                  options(kind, threads)),
        x(evaluator.start()),
        gradient(x.size()),
        nets_bar(3 * std::size_t(context->plan.point_count), 1e-3) {}

  static model::EvaluatorOptions options(model::TermKind kind, int threads) {
    model::EvaluatorOptions options;
    options.terms = {{kind, 1.0, model::Stage::body, {}}};
    options.threads = threads;
    return options;
  }

  model::Evaluator evaluator;
  Eigen::VectorXd x, gradient;
  std::vector<double> nets_bar;
};

void add(const std::string& name, Clock clock, const std::function<double()>& work) {
  auto* registered = benchmark::RegisterBenchmark(name.c_str(), [work](benchmark::State& state) {
                       for (auto _ : state) benchmark::DoNotOptimize(work());
                     })->Unit(benchmark::kMicrosecond);
  if (clock == Clock::wall) registered->UseRealTime();
}

void add_term(const Context& context, model::TermKind kind) {
  const std::string name = "body/" + model::term_name(kind);
  const auto one = std::make_shared<Body>(context, kind);
  add(name, Clock::processor, [one] { return one->evaluator.evaluate(one->x, nullptr); });
  add(name + "_pullback", Clock::processor,
      [one] { return one->evaluator.evaluate(one->x, &one->gradient); });
}

void add_construction(const Context& context) {
  const auto one = std::make_shared<Body>(context, model::TermKind::bending);
  add("body/construction", Clock::processor, [one] {
    one->evaluator.build(one->x);
    return one->evaluator.nets()[0];
  });
  add("body/construction_pullback", Clock::processor, [one] {
    one->evaluator.build(one->x);
    one->evaluator.build_pullback(one->nets_bar, one->gradient);
    return one->gradient[0];
  });
}

void add_differences(const Context& context) {
  const auto one = std::make_shared<Body>(context, model::TermKind::bending);
  add("body/central_differences", Clock::processor, [one] {
    constexpr double step = 1e-6;
    for (Eigen::Index k = 0; k < one->x.size(); ++k) {
      const double kept = one->x[k];
      one->x[k] = kept + step;
      const double above = one->evaluator.evaluate(one->x, nullptr);
      one->x[k] = kept - step;
      const double below = one->evaluator.evaluate(one->x, nullptr);
      one->x[k] = kept;
      one->gradient[k] = (above - below) / (2.0 * step);
    }
    return one->gradient[0];
  });
}

void evaluate_often(Body& body, int count) {
  for (int k = 0; k < count; ++k) body.evaluator.evaluate(body.x, &body.gradient);
}

void add_threads(const Context& context) {
  for (const int threads : {1, 2}) {
    const std::string name = std::to_string(threads) + (threads == 1 ? "_thread" : "_threads");
    const auto within = std::make_shared<Body>(context, model::TermKind::bending, threads);
    add("body/within/" + name, Clock::wall,
        [within] { return within->evaluator.evaluate(within->x, &within->gradient); });
    const auto a = std::make_shared<Body>(context, model::TermKind::bending);
    const auto b = std::make_shared<Body>(context, model::TermKind::bending);
    add("body/over/" + name, Clock::wall, [a, b, threads] {
      if (threads == 1) {
        evaluate_often(*a, sweep);
      } else {
        std::thread other([&] { evaluate_often(*b, sweep / 2); });
        evaluate_often(*a, sweep / 2);
        other.join();
      }
      return a->gradient[0];
    });
  }
}

void add_tuning() {
  add("tuning/model1", Clock::wall,
      [] { return optimize::fair(io::read_model(model_file), optimize::FairOptions{}).end.value; });
}

}  // namespace

void register_body_benchmarks() {
  const auto context = std::make_shared<model::BodyContext>(io::read_model(model_file));
  add_term(context, model::TermKind::bending);
  add_term(context, model::TermKind::variation);
  add_construction(context);
  add_differences(context);
  add_threads(context);
  add_tuning();
}

Report body_report() {
  Report report;
  report.ratios = {
      {"body, bending: (value + gradient) / value", "body/bending_pullback", "body/bending", 2.5,
       true},
      {"body, variation: (value + gradient) / value", "body/variation_pullback", "body/variation",
       2.8, true},
      {"body: construction and its pullback / (value + gradient)", "body/construction_pullback",
       "body/bending_pullback", 0.15, true},
      {"body: central differences over all variables / ours", "body/central_differences",
       "body/bending_pullback", 300.0},
      {"body: one thread / two threads, within one evaluation", "body/within/1_thread",
       "body/within/2_threads", 1.6},
      {"body: one thread / two threads, over evaluations", "body/over/1_thread",
       "body/over/2_threads", 1.9},
  };
  return report;
}

}  // namespace bodyline::bench
