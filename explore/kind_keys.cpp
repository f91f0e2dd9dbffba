#include "explore/kind_keys.hpp"

namespace bodyline::explore {

void check_kind_keys(const io::FileTable& table, const KindKeys& keys,
                     std::span<const char* const> all, const std::string& kind) {
  for (const char* key : all) {
    const bool needed = keys.needed.count(key) > 0;
    if (needed && !table.has(key)) table.fail(key, "is missing; the " + kind + " needs it.");
    if (!needed && keys.allowed.count(key) == 0 && table.has(key))
      table.fail(key, "is nothing that the " + kind + " has.");
  }
}

}  // namespace bodyline::explore
