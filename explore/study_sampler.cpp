#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "explore/kind_keys.hpp"
#include "explore/sampler_kind.hpp"
#include "explore/study_tables.hpp"

namespace bodyline::explore {
namespace {

using io::FileTable;

constexpr std::int64_t most_variants = 1'000'000'000'000;
constexpr std::int64_t most_levels = 1'000'000;

SamplerKind kind_of(const FileTable& table) {
  try {
    return sampler_kind(table.text("kind"));
  } catch (const std::invalid_argument& error) {
    table.fail("kind", std::string(error.what()) + ".");
  }
}

KindKeys keys_of(SamplerKind kind) {
  switch (kind) {
    case SamplerKind::factorial:
    case SamplerKind::one_at_a_time:
      return {{"levels"}, {}};
    case SamplerKind::sobol:
    case SamplerKind::halton:
      return {{"count"}, {"seed", "scrambled"}};
    case SamplerKind::latin:
    case SamplerKind::latin_maximin:
    case SamplerKind::random:
      return {{"count"}, {"seed"}};
    case SamplerKind::star:
      return {};
    case SamplerKind::list:
      return {{"file"}, {}};
    case SamplerKind::morris:
      return {{"trajectories", "levels"}, {"seed"}};
    case SamplerKind::saltelli:
      return {{"count"}, {"seed", "scrambled", "second_order"}};
  }
  return {};
}

constexpr std::array keys_of_samplers{"count",     "seed",         "levels", "trajectories",
                                      "scrambled", "second_order", "file"};

}  // namespace

SamplerSpec read_sampler(const FileTable& table) {
  table.allow_only(
      {"kind", "count", "seed", "levels", "trajectories", "scrambled", "second_order", "file"},
      "a sampler");
  SamplerSpec sampler;
  sampler.kind = kind_of(table);
  check_kind_keys(table, keys_of(sampler.kind), keys_of_samplers,
                  "sampler " + sampler_name(sampler.kind));
  const auto whole = [&](const char* key, std::int64_t least, std::int64_t most,
                         std::int64_t otherwise) {
    return table.has(key) ? table.whole(key, least, most) : otherwise;
  };
  sampler.count = std::uint64_t(whole("count", 1, most_variants, 0));
  sampler.seed = std::uint64_t(whole("seed", 0, std::numeric_limits<std::int64_t>::max(), 1));
  sampler.levels = int(whole("levels", 2, most_levels, 0));
  sampler.trajectories = int(whole("trajectories", 1, most_levels, 0));
  sampler.scrambled = table.flag_or("scrambled", true);
  sampler.second_order = table.flag_or("second_order", false);
  sampler.file = table.text_or("file", "");
  if (sampler.kind == SamplerKind::morris && sampler.levels % 2 != 0)
    table.fail("levels", "must be even for Morris's steps of half the range.");
  return sampler;
}

}  // namespace bodyline::explore
