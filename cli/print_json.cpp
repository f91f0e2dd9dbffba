#include "cli/print_json.hpp"

#include <nlohmann/json.hpp>

namespace bodyline::cli {

void print_json(Context& context, const nlohmann::ordered_json& document) {
  *context.out << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
}

}  // namespace bodyline::cli
