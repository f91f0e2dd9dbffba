#include "cli/space_rows.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace bodyline::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string status_of(const explore::StoreReader& store, const explore::VariantRows& one) {
  std::string text = explore::status_name(explore::VariantStatus(one.status[0]));
  const std::string& cause = store.header().causes[one.cause[0]];
  return cause.empty() ? text : text + " (" + cause + ")";
}

Json named(const std::vector<std::string>& names, const std::vector<double>& values) {
  Json numbers = Json::object();
  for (std::size_t k = 0; k < names.size(); ++k) numbers[names[k]] = values[k];
  return numbers;
}

Json summary(const explore::StoreReader& store, const explore::VariantRows& one) {
  return {{"id", one.first},
          {"status", explore::status_name(explore::VariantStatus(one.status[0]))},
          {"cause", store.header().causes[one.cause[0]]},
          {"metrics", named(explore::metric_names(store), one.metrics)}};
}

}  // namespace

std::string variants_text(const explore::StoreReader& store,
                          const std::vector<std::uint64_t>& ids) {
  std::string text = fmt::format("{:>9}", "id");
  const std::vector<std::string> names = explore::metric_names(store);
  for (const std::string& name : names)
    text += fmt::format("  {:>{}}", name, std::max<std::size_t>(12, name.size()));
  text += "  status\n";
  for (const std::uint64_t id : ids) {
    const explore::VariantRows one = store.read(id, 1);
    text += fmt::format("{:>9}", id);
    for (std::size_t k = 0; k < names.size(); ++k)
      text +=
          fmt::format("  {:>{}.6g}", one.metrics[k], std::max<std::size_t>(12, names[k].size()));
    text += "  " + status_of(store, one) + "\n";
  }
  return text;
}

Json variants_json(const explore::StoreReader& store, const std::vector<std::uint64_t>& ids) {
  Json list = Json::array();
  for (const std::uint64_t id : ids) list.push_back(summary(store, store.read(id, 1)));
  return list;
}

Json variant_json(const explore::StoreReader& store, std::uint64_t id) {
  const explore::VariantRows one = store.read(id, 1);
  Json variant = summary(store, one);
  variant["variables"] = named(explore::variable_names(store), one.values);
  return variant;
}

void check_id(const explore::StoreReader& store, std::uint64_t id) {
  if (id < store.rows()) return;
  throw std::invalid_argument(
      fmt::format("the store has no variant {}: it holds {}, counted from 0", id, store.rows()));
}

}  // namespace bodyline::cli
