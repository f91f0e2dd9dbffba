#include "store_support.hpp"

#include <algorithm>
#include <cstring>

#include "explore/design_space.hpp"

namespace bodyline::testing {
namespace {

// NaN is equal to itself here.
template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

}  // namespace

explore::VariantRows made_up_rows(const explore::StoreLayout& layout, std::uint64_t first,
                                  int count) {
  explore::VariantRows rows = explore::make_rows(layout, first, count);
  for (int row = 0; row < count; ++row) {
    const double index = double(first) + row;
    const auto fill = [&](auto& values, double factor) {
      const std::size_t size = values.size() / std::size_t(count);
      for (std::size_t k = 0; k < size; ++k) {
        using Value = std::decay_t<decltype(values[0])>;
        values[std::size_t(row) * size + k] = Value(factor * (index + 0.125 * double(k)));
      }
    };
    fill(rows.values, 1.0 / 3.0);
    fill(rows.metrics, -7.0);
    fill(rows.nets, 0.1);
    rows.status[row] = std::uint8_t((first + std::uint64_t(row)) % 7);
    rows.cause[row] = std::uint16_t((first + std::uint64_t(row)) % 50);
    rows.seconds[row] = float(index);
  }
  return rows;
}

explore::StoreWriter new_store(const std::filesystem::path& path, const explore::Study& study,
                               std::uint64_t planned, const explore::StoreOptions& options) {
  const explore::DesignSpace space(study);
  return explore::StoreWriter::create(path, study, space, planned, false, options);
}

bool same_rows(const explore::VariantRows& a, const explore::VariantRows& b) {
  return a.first == b.first && a.count == b.count && same_bits(a.values, b.values) &&
         same_bits(a.metrics, b.metrics) && same_bits(a.status, b.status) &&
         same_bits(a.cause, b.cause) && same_bits(a.nets, b.nets) &&
         same_bits(a.thumbnails, b.thumbnails);
}

explore::VariantRows all_rows(const std::filesystem::path& path) {
  const explore::StoreReader reader(path);
  return reader.read(0, int(reader.rows()), true);
}

void append_made_up(explore::StoreWriter& store, int count, int at_once) {
  for (int done = 0; done < count; done += at_once)
    store.append(made_up_rows(store.layout(), store.rows(), std::min(at_once, count - done)));
}

::testing::AssertionResult holds_rows(const std::filesystem::path& path, std::uint64_t rows) {
  try {
    const explore::StoreReader reader(path);
    if (reader.rows() != rows)
      return ::testing::AssertionFailure() << reader.rows() << " rows instead of " << rows;
    const explore::VariantRows found = reader.read(0, int(rows), true);
    const explore::VariantRows wanted = made_up_rows(reader.layout(), 0, int(rows));
    if (!same_rows(found, wanted) || !same_bits(found.seconds, wanted.seconds))
      return ::testing::AssertionFailure() << "other rows";
  } catch (const std::exception& error) {
    return ::testing::AssertionFailure() << error.what();
  }
  return ::testing::AssertionSuccess();
}

}  // namespace bodyline::testing
