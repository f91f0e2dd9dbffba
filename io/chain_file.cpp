#include "io/chain_file.hpp"

#include <cmath>

#include "io/model_file.hpp"
#include "io/model_file_lookup.hpp"
#include "io/model_file_table.hpp"
#include "io/model_file_text.hpp"
#include "io/toml_text.hpp"
#include "model/family.hpp"

namespace bodyline::io {
namespace {

constexpr int known_format = 1;
constexpr double largest_coordinate = 1e6;  // mm
constexpr double largest_number = 1e6;
constexpr Count any_shape{0, 100}, any_points{1, 169};

double number_or(const FileTable& table, std::string_view name, double otherwise) {
  return table.has(name) ? table.real(name, largest_number) : otherwise;
}

template <class Join>
Join read_join(const FileTable& table) {
  Join join;
  if (table.has("continuity")) join.continuity = table.integer("continuity");
  join.ratio = number_or(table, "ratio", join.ratio);
  join.slide = number_or(table, "slide", join.slide);
  return join;
}

// What throws std::invalid_argument is at fault in the table of this key.
template <class Action>
void at_key(const FileTable& root, const std::string& key, const Action& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    std::string sentence = error.what();
    root.fail(key, sentence.ends_with('.') ? sentence : sentence + ".");
  }
}

model::FamilyPatch read_patch(const std::string& name, const std::string& family,
                              const FileTable& table) {
  table.allow_only({"degree", "points", "shape", "join"}, "a patch of a chain");
  model::FamilyPatch patch;
  patch.name = name;
  patch.family = family;
  if (table.has("degree")) {
    const std::vector<double> degree = table.numbers("degree", {2, 2}, largest_number);
    for (const double d : degree) {
      if (d != std::floor(d)) table.fail("degree", "must hold 2 whole numbers.");
    }
    patch.degree_u = int(degree[0]);
    patch.degree_v = int(degree[1]);
  }
  patch.points = table.points("points", any_points, 1.0, largest_coordinate);
  const auto shape = table.find_table("shape");
  if (!shape) table.fail("shape", "is required but missing.");
  shape->allow_only({"u", "v"}, "a shape");
  patch.shape_u = shape->numbers("u", any_shape, largest_number);
  patch.shape_v = shape->numbers("v", any_shape, largest_number);
  return patch;
}

model::PatchChain read_patches(const FileTable& root, const std::string& family) {
  model::PatchChain chain;
  for (const auto& [name, table] : entries(root, "patches")) {
    const std::string key = "patches." + name;
    chain.patches.push_back(read_patch(name, family, table));
    at_key(root, key, [&] { model::check_patch(chain.patches.back()); });
    const auto join = table.find_table("join");
    if (chain.patches.size() == 1) {
      if (join) table.fail("join", "is given, but nothing stands before the first patch.");
      continue;
    }
    if (!join) table.fail("join", "is required but missing.");
    join->allow_only({"direction", "continuity", "ratio", "slide"}, "a join");
    chain.joins.push_back(read_join<model::PatchJoin>(*join));
    at_key(root, key + ".join.direction", [&] {
      chain.joins.back().direction = model::join_direction(join->text_or("direction", "u"));
    });
    at_key(root, key + ".join", [&] {
      const std::size_t k = chain.joins.size();
      model::join_patch(chain.patches[k - 1], chain.joins[k - 1], chain.patches[k]);
    });
  }
  if (chain.patches.empty()) root.fail("patches", "is empty; a chain has at least one patch.");
  return chain;
}

model::CurveChain read_curves(const FileTable& root, const std::string& family) {
  model::CurveChain chain;
  std::optional<model::CurveJoin> closing;
  for (const auto& [name, table] : entries(root, "curves")) {
    table.allow_only({"points", "shape", "join"}, "a curve of a chain");
    model::FamilyCurve curve;
    curve.name = name;
    curve.family = family;
    curve.points = table.points("points", any_points, 1.0, largest_coordinate);
    curve.shape = table.numbers("shape", any_shape, largest_number);
    at_key(root, "curves." + name, [&] { model::check_curve(curve); });
    chain.curves.push_back(std::move(curve));
    const auto join = table.find_table("join");
    if (join) {
      join->allow_only({"continuity", "ratio", "slide"}, "a join");
      const auto read = read_join<model::CurveJoin>(*join);
      // That of the first curve closes the chain.
      if (chain.curves.size() == 1) {
        closing = read;
      } else {
        chain.joins.push_back(read);
      }
    } else if (chain.curves.size() > 1) {
      table.fail("join", "is required but missing.");
    }
  }
  if (chain.curves.empty()) root.fail("curves", "is empty; a chain has at least one curve.");
  if (closing) chain.joins.push_back(*closing);
  at_key(root, "curves", [&] { model::propagate(chain); });
  return chain;
}

template <class Join>
void write_join(const Join& join, TomlLines& lines) {
  lines.line("join.continuity", std::to_string(join.continuity));
  lines.line("join.ratio", toml_number(join.ratio));
  if (join.continuity == 2) lines.line("join.slide", toml_number(join.slide));
}

void write_patches(const model::PatchChain& chain, TomlLines& lines) {
  for (std::size_t k = 0; k < chain.patches.size(); ++k) {
    const model::FamilyPatch& patch = chain.patches[k];
    lines.header("patches." + valid_name(patch.name));
    lines.line("degree",
               "[" + std::to_string(patch.degree_u) + ", " + std::to_string(patch.degree_v) + "]");
    lines.line("points", toml_points(patch.points));
    lines.line("shape.u", toml_numbers(patch.shape_u));
    lines.line("shape.v", toml_numbers(patch.shape_v));
    if (k == 0) continue;
    const model::PatchJoin& join = chain.joins[k - 1];
    lines.line("join.direction", toml_text(model::join_direction_name(join.direction)));
    write_join(join, lines);
  }
}

void write_curves(const model::CurveChain& chain, TomlLines& lines) {
  const std::size_t count = chain.curves.size();
  for (std::size_t k = 0; k < count; ++k) {
    const model::FamilyCurve& curve = chain.curves[k];
    lines.header("curves." + valid_name(curve.name));
    lines.line("points", toml_points(curve.points));
    lines.line("shape", toml_numbers(curve.shape));
    if (k > 0) {
      write_join(chain.joins[k - 1], lines);
    } else if (chain.closed()) {
      write_join(chain.joins[count - 1], lines);
    }
  }
}

}  // namespace

ChainFile read_chain_text(std::string_view text, const std::string& name) {
  const ModelFile file(text, name);
  const FileTable root(file, file.root(), "");
  root.allow_only({"format", "name", "note", "family", "patches", "curves"}, "a chain file");
  if (root.integer("format") != known_format)
    root.fail("format", "is not 1, the format that this program reads.");
  const std::string family = root.text("family");
  at_key(root, "family", [&] { model::find_family(family); });
  if (root.has("patches") == root.has("curves"))
    root.fail("", "a chain file has either patches or curves.");
  ChainFile result;
  result.note = root.text_or("note", "");
  if (root.has("patches")) {
    model::PatchChain chain = read_patches(root, family);
    chain.name = root.text("name");
    result.chain = std::move(chain);
  } else {
    model::CurveChain chain = read_curves(root, family);
    chain.name = root.text("name");
    result.chain = std::move(chain);
  }
  return result;
}

ChainFile read_chain(const std::filesystem::path& path) {
  return read_chain_text(read_file_text(path), path.string());
}

std::string write_chain_text(const ChainFile& file) {
  TomlLines lines;
  const auto* patches = std::get_if<model::PatchChain>(&file.chain);
  const auto* curves = std::get_if<model::CurveChain>(&file.chain);
  lines.line("format", "1");
  lines.line("name", toml_text(patches ? patches->name : curves->name));
  lines.note(file.note);
  lines.line("family",
             toml_text(patches ? patches->patches.at(0).family : curves->curves.at(0).family));
  if (patches) write_patches(*patches, lines);
  if (curves) write_curves(*curves, lines);
  return lines.text();
}

void write_chain(const ChainFile& file, const std::filesystem::path& path, Overwrite overwrite) {
  write_file(path, write_chain_text(file), overwrite);
}

}  // namespace bodyline::io
