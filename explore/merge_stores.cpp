#include "explore/merge_stores.hpp"

#include <algorithm>
#include <iterator>
#include <memory>

#include "explore/same_structure.hpp"
#include "explore/store_reader.hpp"
#include "explore/store_writer.hpp"

namespace bodyline::explore {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t at_once = 4096;

std::vector<VariableGroup> links_of(const Study& study) {
  std::vector<VariableGroup> links;
  std::copy_if(study.variables.begin(), study.variables.end(), std::back_inserter(links),
               [](const VariableGroup& group) { return group.linked; });
  return links;
}

// Whether values of links mean the same, whatever their ranges.
bool alike(const std::vector<VariableGroup>& a, const std::vector<VariableGroup>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const VariableGroup& x, const VariableGroup& y) {
                      VariableGroup same_range = y;
                      same_range.range = x.range;
                      return x == same_range;
                    });
}

// What a row means must be the same in both.
void check_alike(const StoreReader& a, const StoreReader& b) {
  const auto refuse = [&](const std::string& what) {
    throw StoreError(b.path(),
                     "cannot be merged with " + a.path().string() + ": their " + what + " differ.");
  };
  const auto same_column = [](const Column& x, const Column& y) {
    return x.name == y.name && x.kind == y.kind;
  };
  const auto &u = a.space().columns(), &v = b.space().columns();
  if (!std::equal(u.begin(), u.end(), v.begin(), v.end(), same_column)) refuse("variables");
  const Study &one = a.study(), &other = b.study();
  if (one.base != other.base) refuse("models");
  if (!alike(links_of(one), links_of(other))) refuse("linked variables");
  if (one.metrics != other.metrics) refuse("metrics");
  if (one.files != other.files) refuse("scans or drawings");
  if (one.nodes != other.nodes) refuse("\"nodes\"");
  if (one.constraints != other.constraints) refuse("constraints");
  if (one.checks != other.checks) refuse("checks");
  if (a.study().models.size() != b.study().models.size()) refuse("models");
  for (std::size_t k = 0; k < a.study().models.size(); ++k) {
    if (a.header().inputs[k + 1].text != b.header().inputs[k + 1].text) refuse("models");
  }
  const auto same_table = [](const TableLayout& x, const TableLayout& y) {
    return x.name == y.name && x.row == y.row;
  };
  const auto &s = a.layout().tables, &t = b.layout().tables;
  if (!std::equal(s.begin(), s.end(), t.begin(), t.end(), same_table)) refuse("tables");
}

}  // namespace

void merge_stores(const std::vector<fs::path>& from, const fs::path& to, bool overwrite) {
  std::vector<std::unique_ptr<StoreReader>> stores;
  std::uint64_t planned = 0;
  for (const fs::path& path : from) {
    std::error_code status;
    if (fs::equivalent(path, to, status)) throw StoreError(to, "is one of the stores to merge.");
    stores.push_back(std::make_unique<StoreReader>(path));
    check_alike(*stores.front(), *stores.back());
    planned += stores.back()->rows();
  }
  const StoreReader& first = *stores.front();
  StoreWriter merged =
      StoreWriter::create(to, first.study(), first.space(), planned, overwrite, {.merged = true});
  for (const auto& store : stores) {
    for (std::uint64_t row = 0; row < store->rows(); row += at_once) {
      VariantRows rows =
          store->read(row, int(std::min<std::uint64_t>(at_once, store->rows() - row)), true);
      merged.append(rows);
    }
  }
  merged.finish();
}

}  // namespace bodyline::explore
