#pragma once

#include <string>
#include <vector>

/// Tables that bodyline_bench prints after its run, from the medians of the repetitions.
namespace bodyline::bench {

/// Behind the name of a benchmark that is measured in real time: its processor time instead, that
/// of all threads if it asks for that.
inline constexpr const char* processor_time = " (processor time)";

/// Two benchmarks that do the same work: how many times `slow` takes as long as `fast`.
struct Ratio {
  std::string label;
  std::string slow, fast;  ///< names of benchmarks
  double target = 0.0;     ///< 0: none
  bool at_most = false;    ///< the ratio should stay below the target, not above
  double scale = 1.0;      ///< how many times more work `fast` does
};

/// A benchmark as a share of the core's FMA peak.
struct Share {
  std::string label;
  std::string name;              ///< of the benchmark
  double operations = 0.0;       ///< floating-point operations per iteration; a fused one counts 2
  std::string peak;              ///< name of the benchmark that measures the peak
  double peak_operations = 0.0;  ///< its operations per iteration
  double target = 0.0;           ///< fraction; 0: none
  double nodes = 0.0;            ///< per iteration, for the column ns/node
};

/// How often something is done in a second.
struct Rate {
  std::string label;
  std::string name;     ///< of the benchmark
  double items = 0.0;   ///< per iteration
  double target = 0.0;  ///< per second; 0: none
};

struct Report {
  std::vector<Share> shares;
  std::vector<Rate> rates;
  std::vector<Ratio> ratios;
};

/// Runs the registered benchmarks with the usual options of Google Benchmark (by default repeated
/// and interleaved at random, so that a disturbance of the machine meets all alike) and prints the
/// tables; returns the exit code. Lines whose benchmarks were filtered out are left out.
int run_and_report(int argc, char** argv, const std::vector<Report>& reports);

}  // namespace bodyline::bench
