#pragma once

#include <filesystem>
#include <vector>

namespace bodyline::explore {

/// Writes the rows of several stores, one after the other, into a new one with the study of the
/// first, marked as `merged`. Throws StoreError when their variables, metrics, constraints, checks
/// or bodies differ, so that a row would not mean the same, and as StoreWriter does.
void merge_stores(const std::vector<std::filesystem::path>& from, const std::filesystem::path& to,
                  bool overwrite);

}  // namespace bodyline::explore
