#include "cli/explore_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/explore_text.hpp"
#include "cli/interrupt.hpp"
#include "cli/number_check.hpp"
#include "cli/output.hpp"
#include "cli/print_json.hpp"
#include "cli/progress.hpp"
#include "explore/read_study.hpp"
#include "explore/run_optimizer.hpp"
#include "explore/run_ranks.hpp"
#include "explore/run_study.hpp"
#include "explore/tuned_source.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string study;
  Output output;
  explore::StoreOptions store;
  int threads = 0;  // 0: all
  bool check = false, resume = false, json = false;
};

void check_request(const Request& request) {
  if (request.check) return;
  if (request.output.path.empty())
    throw std::invalid_argument("give the store to write: -o SPACE.h5, or --check");
  if (request.resume && request.output.overwrite)
    throw std::invalid_argument("--resume and --overwrite exclude each other");
  if (!request.resume) check_output(request.output, request.study, {".h5", ".hdf5"});
}

using Plan = std::shared_ptr<const explore::VariantPlan>;

explore::StoreWriter open_store(const Request& request, const Plan& plan) {
  if (request.resume)
    return explore::StoreWriter::resume(request.output.path, plan->study, request.store);
  return explore::StoreWriter::create(request.output.path, plan->study, plan->space,
                                      explore::planned_rows(plan), request.output.overwrite,
                                      request.store);
}

// `owner` is null in a run of one process. What chooses variants by the results of others runs on
// one rank.
explore::RunProgress make_rows(const Request& request, const Plan& plan,
                               explore::StoreWriter& store, const explore::RunOptions& options,
                               explore::RankOwner* owner) {
  if (explore::chooses_by_results(plan->study)) {
    if (owner) owner->release();
    const explore::StoreReader begun(request.output.path);
    return explore::run_optimizer(plan, store, begun, options);
  }
  const std::unique_ptr<explore::VariantSource> source = explore::plan_source(plan);
  return owner ? owner->run(plan, *source, store, options)
               : explore::run_study(plan, *source, store, options);
}

explore::RunProgress run_plan(Context& context, const Request& request, const Plan& plan,
                              explore::RankOwner* owner) {
  const Interrupt interrupt;
  Progress progress(context, "exploring");
  explore::StoreWriter store = open_store(request, plan);
  explore::RunOptions options;
  options.threads = request.threads;
  options.should_stop = [&] { return interrupt.requested(); };
  options.on_progress = [&](const explore::RunProgress& run) {
    progress.update(double(run.done) / double(std::max<std::uint64_t>(1, run.planned)),
                    progress_text(plan->study, run));
  };
  const explore::RunProgress result = make_rows(request, plan, store, options, owner);
  store.finish();
  return result;
}

void run_alone(Context& context, const Request& request, explore::RankOwner* owner) {
  check_request(request);
  const auto plan = std::make_shared<explore::VariantPlan>(explore::read_study(request.study));
  if (request.check) {
    const explore::StudyEstimate estimate = explore::estimate_study(plan);
    if (request.json) {
      print_json(context, estimate_json(*plan, estimate, request.threads));
    } else {
      *context.out << estimate_text(*plan, estimate, request.threads);
    }
    return;
  }
  const explore::RunProgress result = run_plan(context, request, plan, owner);
  if (request.json) {
    print_json(context, result_json(plan->study, result, request.output.path));
  } else {
    *context.out << result_text(plan->study, result, request.output.path);
  }
  if (result.done < result.planned) context.exit_code = exit_findings;
}

// Under mpirun rank 0 speaks and writes; the others measure for it.
void run(Context& context, const Request& request) {
  const std::unique_ptr<explore::Ranks> ranks = explore::launched_ranks();
  if (!ranks || ranks->size() == 1) return run_alone(context, request, nullptr);
  if (ranks->rank() > 0) {
    const Interrupt interrupt;
    return explore::serve_ranks(*ranks, request.threads, [&] { return interrupt.requested(); });
  }
  explore::RankOwner owner(*ranks);
  run_alone(context, request, &owner);
  context.out->flush();  // mpirun may end the program while the others leave
}

}  // namespace

void add_explore_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "explore", "Measure a family of variants into a store",
                  "bodyline explore examples/sweep.toml -o sweep.h5");
  command->add_option("STUDY", request->study, "Study file (.toml)")->required()->type_name("");
  add_output(*command, request->output, "Store of all variants, .h5")->required(false);
  command->add_flag("--check", request->check,
                    "Only check the study, try three variants, and say what all will take");
  command->add_flag("--resume", request->resume, "Go on with a store that is not complete");
  command->add_option("--threads", request->threads, "Threads; all processors when left out")
      ->type_name("N")
      ->check(number_between(1, 1024));
  command
      ->add_option("--commit", request->store.commit_seconds,
                   "Longest time that finished variants wait to be safe on the disk, s")
      ->type_name("S")
      ->check(non_negative_number())
      ->capture_default_str();
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
