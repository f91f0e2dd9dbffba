#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/print_json.hpp"
#include "cli/space_rows.hpp"
#include "cli/space_views.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  VariantChoice choice;
  std::string sort;
  std::size_t most = 20;
  bool falling = false, json = false;
};

// A variant and the number by which it is put into order.
struct Ranked {
  std::uint64_t id = 0;
  double key = 0.0;
};

// The first ones in the order asked for; NaN comes last.
std::vector<std::uint64_t> first_ids(const explore::StoreReader& store, const Request& request,
                                     std::uint64_t& matching) {
  const explore::VariantFilter filter(store, request.choice.where, request.choice.status);
  const auto before = [&](const Ranked& a, const Ranked& b) {
    if (std::isnan(a.key) != std::isnan(b.key)) return std::isnan(b.key);
    if (a.key != b.key) return request.falling ? a.key > b.key : a.key < b.key;
    return a.id < b.id;
  };
  std::vector<Ranked> best;  // a heap with the last one in front
  const bool sorted = !request.sort.empty();
  const explore::StoreColumn column =
      sorted ? explore::store_column(store, request.sort) : explore::StoreColumn{};
  matching = 0;
  explore::for_each_variant(store, filter, [&](const explore::VariantRows& rows, int row) {
    ++matching;
    const Ranked one{rows.first + std::uint64_t(row), sorted ? column.of(rows, row) : 0.0};
    if (best.size() == request.most && !(request.most > 0 && before(one, best.front()))) return;
    best.push_back(one);
    std::push_heap(best.begin(), best.end(), before);
    if (best.size() <= request.most) return;
    std::pop_heap(best.begin(), best.end(), before);
    best.pop_back();
  });
  std::sort(best.begin(), best.end(), before);
  std::vector<std::uint64_t> ids;
  for (const Ranked& one : best) ids.push_back(one.id);
  return ids;
}

void run(Context& context, const Request& request, const std::string& path) {
  const explore::StoreReader store(path);
  std::uint64_t matching = 0;
  const std::vector<std::uint64_t> ids = first_ids(store, request, matching);
  if (request.json) {
    print_json(context, {{"store", path},
                         {"study", store.study().name},
                         {"planned", store.header().planned},
                         {"rows", store.rows()},
                         {"matching", matching},
                         {"variants", variants_json(store, ids)}});
    return;
  }
  *context.out << fmt::format("{}: {} of {} variants, {} variables, {} metrics\n",
                              store.study().name, store.rows(), store.header().planned,
                              store.space().column_count(), store.study().metrics.size())
               << variants_text(store, ids)
               << fmt::format("{} of {} that match\n", ids.size(), matching);
}

}  // namespace

void add_space_list(CLI::App& space, Context& context, const StorePath& store) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command = add_view(space, "list", "List variants with their metrics",
                                     "bodyline space sweep.h5 list --sort bending --first 5");
  add_variant_choice(*command, request->choice);
  command->add_option("--sort", request->sort, "Metric or variable to sort by")->type_name("NAME");
  command->add_flag("--falling", request->falling, "Largest first");
  command->add_option("--first", request->most, "So many variants")
      ->type_name("N")
      ->check(CLI::Range(std::size_t(0), std::size_t(1'000'000)))
      ->capture_default_str();
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, store, &context] { run(context, *request, *store); });
}

}  // namespace bodyline::cli
