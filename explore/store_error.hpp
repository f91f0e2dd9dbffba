#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace bodyline::explore {

/// A store that cannot be used or written. `what()` is "FILE: sentence".
class StoreError : public std::runtime_error {
 public:
  StoreError(const std::filesystem::path& path, const std::string& sentence)
      : std::runtime_error(path.string() + ": " + sentence) {}
};

}  // namespace bodyline::explore
