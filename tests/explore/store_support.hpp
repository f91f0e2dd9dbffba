#pragma once

#include <filesystem>

#include "explore/store_reader.hpp"
#include "explore/store_writer.hpp"

/// Stores with rows that are made up, which the tests compare with what they read.
namespace bodyline::testing {

/// Rows whose numbers follow from their places.
explore::VariantRows made_up_rows(const explore::StoreLayout& layout, std::uint64_t first,
                                  int count);

/// A new store of a study for so many rows.
explore::StoreWriter new_store(const std::filesystem::path& path, const explore::Study& study,
                               std::uint64_t planned, const explore::StoreOptions& options = {});

/// Appends the next rows to a store, so many at once.
void append_made_up(explore::StoreWriter& store, int count, int at_once);

/// Whether a store holds exactly so many committed rows, made up and readable.
::testing::AssertionResult holds_rows(const std::filesystem::path& path, std::uint64_t rows);

/// Whether rows are equal but for the seconds.
bool same_rows(const explore::VariantRows& a, const explore::VariantRows& b);

/// All rows of a store.
explore::VariantRows all_rows(const std::filesystem::path& path);

}  // namespace bodyline::testing
