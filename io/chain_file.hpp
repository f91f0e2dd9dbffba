#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "io/write_file.hpp"
#include "model/curve_chain.hpp"
#include "model/patch_chain.hpp"

namespace bodyline::io {

/// A chain file (docs/families.md, section 7): patches or curves, each joined to the one before it.
struct ChainFile {
  std::variant<model::PatchChain, model::CurveChain> chain;
  std::string note;
};

/// Reads a chain; the rows that its joins determine are propagated. Throws InputError, with file,
/// line and key; `name` stands for the file in messages.
ChainFile read_chain_text(std::string_view text, const std::string& name);
ChainFile read_chain(const std::filesystem::path& path);

/// The text of a chain file. Reading it gives the same bits.
std::string write_chain_text(const ChainFile& file);
void write_chain(const ChainFile& file, const std::filesystem::path& path,
                 Overwrite overwrite = Overwrite::never);

}  // namespace bodyline::io
