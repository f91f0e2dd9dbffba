#include "explore/sampler_kind.hpp"

#include <array>
#include <stdexcept>
#include <utility>

namespace bodyline::explore {
namespace {

constexpr std::array<std::pair<SamplerKind, const char*>, 11> names{
    {{SamplerKind::factorial, "factorial"},
     {SamplerKind::sobol, "sobol"},
     {SamplerKind::halton, "halton"},
     {SamplerKind::latin, "latin"},
     {SamplerKind::latin_maximin, "latin_maximin"},
     {SamplerKind::random, "random"},
     {SamplerKind::one_at_a_time, "one_at_a_time"},
     {SamplerKind::star, "star"},
     {SamplerKind::list, "list"},
     {SamplerKind::morris, "morris"},
     {SamplerKind::saltelli, "saltelli"}}};

}  // namespace

std::string sampler_name(SamplerKind kind) { return names[std::size_t(kind)].second; }

SamplerKind sampler_kind(const std::string& name) {
  std::string list;
  for (const auto& [kind, known] : names) {
    if (name == known) return kind;
    list += (list.empty() ? "" : ", ") + std::string(known);
  }
  throw std::invalid_argument("\"" + name + "\" is not a sampler; the samplers are " + list);
}

}  // namespace bodyline::explore
