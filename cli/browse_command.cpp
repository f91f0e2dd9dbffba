#include "cli/browse_command.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/output.hpp"
#include "cli/space_pareto.hpp"
#include "explore/browse_page.hpp"
#include "io/write_file.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string store;
  Objectives objectives;
  explore::BrowseOptions page;
  Output output;
};

std::string summary_text(const explore::BrowseSummary& summary, const std::string& path) {
  const std::string sampled = std::uint64_t(summary.shown) < summary.stored
                                  ? fmt::format(" of {}, sampled evenly", summary.stored)
                                  : "";
  const std::string pareto =
      summary.pareto > 0 ? fmt::format(", the {} of the Pareto set among them", summary.pareto)
                         : "";
  return fmt::format("variants: {}{}{}; {} can be seen in 3-D\npage: {}\n", summary.shown, sampled,
                     pareto, summary.bodies, path);
}

// Those given, else the goals of the optimizer that made the store, unless it has but one.
Objectives objectives_of(const explore::StoreReader& store, const Objectives& given) {
  Objectives objectives = given;
  take_goals(store, objectives);
  const bool alone = objectives.minimize.size() + objectives.maximize.size() < 2;
  return alone ? given : objectives;
}

void run(Context& context, Request& request) {
  check_output(request.output, request.store, {".html"});
  const explore::StoreReader store(request.store);
  const Objectives objectives = objectives_of(store, request.objectives);
  request.page.minimize = objectives.minimize;
  request.page.maximize = objectives.maximize;
  explore::BrowseSummary summary;
  io::write_file(request.output.path, explore::browse_page(store, request.page, summary),
                 request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
  *context.out << summary_text(summary, request.output.path);
}

void add_count(CLI::App& command, const char* flag, int& count, int least, int most,
               const char* text) {
  command.add_option(flag, count, text)
      ->type_name("N")
      ->check(CLI::Range(least, most))
      ->capture_default_str();
}

}  // namespace

void add_browse_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "browse", "Write a page to browse the variants of a store",
                  "bodyline browse sweep.h5 -o sweep.html --minimize bending --maximize height");
  command->add_option("STORE", request->store, "Store of variants (.h5)")
      ->required()
      ->type_name("");
  add_output(*command, request->output, "Page, .html");
  add_objectives(*command, request->objectives);
  constexpr int most_variants = 500000, most_bodies = 5000;
  add_count(*command, "--limit", request->page.limit, 1, most_variants,
            "Most variants; of a larger store a sample is shown, with the whole Pareto set");
  add_count(*command, "--bodies", request->page.bodies, 0, most_bodies,
            "Most variants to be seen in 3-D: the Pareto set, then a spread of others");
  add_count(*command, "--pictures", request->page.pictures, 0, most_bodies,
            "Most thumbnails of a store that keeps them");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
