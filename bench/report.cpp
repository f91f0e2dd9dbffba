#include "bench/report.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

namespace bodyline::bench {
namespace {

using Samples = std::map<std::string, std::vector<double>>;  // seconds per iteration

/// Keeps the time of every repetition and prints the medians only. Processor time, so that other
/// work on the machine does not count, unless a benchmark asks for real time, as those with several
/// threads do.
class Collector : public benchmark::ConsoleReporter {
 public:
  using ConsoleReporter::ConsoleReporter;

  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> printed;
    for (const Run& run : runs) {
      if (run.error_occurred) continue;
      if (run.run_type == Run::RT_Iteration) collect(run);
      if (run.repetitions == 1 || run.aggregate_name == "median") printed.push_back(run);
    }
    ConsoleReporter::ReportRuns(printed);
  }

  const Samples& samples() const { return samples_; }

 private:
  void collect(const Run& run) {
    const std::string& name = run.run_name.function_name;
    const bool real = run.run_name.time_type.find("real_time") != std::string::npos;
    const double seconds = real ? run.real_accumulated_time : run.cpu_accumulated_time;
    samples_[name].push_back(seconds / static_cast<double>(run.iterations));
    if (real) {
      samples_[name + processor_time].push_back(run.cpu_accumulated_time /
                                                static_cast<double>(run.iterations));
    }
  }

  Samples samples_;
};

std::optional<double> median(const Samples& samples, const std::string& name) {
  const auto found = samples.find(name);
  if (found == samples.end()) return std::nullopt;
  std::vector<double> sorted = found->second;
  std::sort(sorted.begin(), sorted.end());
  return sorted[sorted.size() / 2];
}

const char* verdict(double value, double target, bool at_most) {
  if (target == 0.0) return "";
  return (at_most ? value <= target : value >= target) ? "met" : "missed";
}

void print(const Samples& samples, const Share& share) {
  const auto time = median(samples, share.name), peak = median(samples, share.peak);
  if (!time || !peak) return;
  const double rate = share.operations / *time, limit = share.peak_operations / *peak;
  std::printf("%-46s %8.2f ns/node %6.1f GFLOP/s %5.1f %% of %.1f", share.label.c_str(),
              *time / share.nodes * 1e9, rate * 1e-9, 100.0 * rate / limit, limit * 1e-9);
  if (share.target > 0.0) {
    std::printf("  (>= %.0f %%: %s)", 100.0 * share.target,
                verdict(rate / limit, share.target, false));
  }
  std::printf("\n");
}

void print(const Samples& samples, const Rate& rate) {
  const auto time = median(samples, rate.name);
  if (!time) return;
  const double value = rate.items / *time;
  std::printf("%-70s %8.0f/s", rate.label.c_str(), value);
  if (rate.target > 0.0)
    std::printf("  (>= %g: %s)", rate.target, verdict(value, rate.target, false));
  std::printf("\n");
}

void print(const Samples& samples, const Ratio& ratio) {
  const auto slow = median(samples, ratio.slow), fast = median(samples, ratio.fast);
  if (!slow || !fast) return;
  const double value = *slow * ratio.scale / *fast;
  std::printf("%-70s %8.2f", ratio.label.c_str(), value);
  if (ratio.target > 0.0) {
    std::printf("  (%s %g: %s)", ratio.at_most ? "<=" : ">=", ratio.target,
                verdict(value, ratio.target, ratio.at_most));
  }
  std::printf("\n");
}

}  // namespace

int run_and_report(int argc, char** argv, const std::vector<Report>& reports) {
  // The caller's own flags come last and win.
  std::string repetitions = "--benchmark_repetitions=9",
              interleaving = "--benchmark_enable_random_interleaving=true",
              least_time = "--benchmark_min_time=0.02",
              summary = "--benchmark_display_aggregates_only=true";
  std::vector<char*> arguments = {argv[0], repetitions.data(), interleaving.data(),
                                  least_time.data()};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;
  Collector collector(benchmark::ConsoleReporter::OO_Tabular);
  benchmark::RunSpecifiedBenchmarks(&collector);
  std::printf("\nShare of the peak, medians\n");
  for (const Report& report : reports) {
    for (const Share& share : report.shares) print(collector.samples(), share);
  }
  std::printf("\nRates, medians\n");
  for (const Report& report : reports) {
    for (const Rate& rate : report.rates) print(collector.samples(), rate);
  }
  std::printf("\nRatios of medians, same run\n");
  for (const Report& report : reports) {
    for (const Ratio& ratio : report.ratios) print(collector.samples(), ratio);
  }
  return 0;
}

}  // namespace bodyline::bench
