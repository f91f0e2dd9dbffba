#include "explore/variant_source.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "explore/sampler_grid.hpp"
#include "explore/sampler_halton.hpp"
#include "explore/sampler_latin.hpp"
#include "explore/sampler_random.hpp"
#include "explore/sampler_sensitivity.hpp"
#include "explore/sampler_sobol.hpp"
#include "explore/study_error.hpp"
#include "explore/variant_list.hpp"

namespace bodyline::explore {
namespace {

class SampledSource : public VariantSource {
 public:
  SampledSource(std::unique_ptr<Sampler> sampler, const DesignSpace& space)
      : sampler_(std::move(sampler)), space_(&space) {}

  std::uint64_t size() const override { return sampler_->size(); }

  void values(std::uint64_t first, int count, std::span<double> rows) const override {
    const std::size_t d = std::size_t(space_->dimension()), n = std::size_t(space_->column_count());
    std::vector<double> points(std::size_t(count) * d);
    sampler_->points(first, count, points);
    for (std::size_t row = 0; row < std::size_t(count); ++row)
      space_->values({points.data() + row * d, d}, rows.subspan(row * n, n));
  }

 private:
  std::unique_ptr<Sampler> sampler_;
  const DesignSpace* space_;
};

class ListSource : public VariantSource {
 public:
  ListSource(std::vector<double> rows, int columns)
      : rows_(std::move(rows)), columns_(std::size_t(columns)) {}

  std::uint64_t size() const override { return rows_.size() / columns_; }

  void values(std::uint64_t first, int count, std::span<double> rows) const override {
    std::copy_n(rows_.begin() + std::ptrdiff_t(first * columns_), std::size_t(count) * columns_,
                rows.begin());
  }

 private:
  std::vector<double> rows_;
  std::size_t columns_;
};

// Evenly from end to end; of a choice every model.
Levels levels_of(const DesignSpace& space, int count) {
  Levels levels;
  for (int k = 0; k < space.dimension(); ++k) {
    std::vector<double> coordinates;
    const Column& column = space.columns()[k];
    if (column.kind == ColumnKind::choice) {
      const int models = int(column.upper) + 1;
      for (int m = 0; m < models; ++m) coordinates.push_back((m + 0.5) / models);
    } else {
      for (int level = 0; level < count; ++level)
        coordinates.push_back(double(level) / (count - 1));
    }
    levels.push_back(std::move(coordinates));
  }
  return levels;
}

std::unique_ptr<Sampler> make_sampler(const SamplerSpec& spec, const DesignSpace& space) {
  const int d = space.dimension();
  switch (spec.kind) {
    case SamplerKind::factorial:
      return factorial_sampler(levels_of(space, spec.levels));
    case SamplerKind::sobol:
      return sobol_sampler(d, spec.count, spec.scrambled, spec.seed);
    case SamplerKind::halton:
      return halton_sampler(d, spec.count, spec.scrambled, spec.seed);
    case SamplerKind::latin:
      return latin_sampler(d, spec.count, spec.seed);
    case SamplerKind::latin_maximin:
      return latin_maximin_sampler(d, spec.count, spec.seed);
    case SamplerKind::random:
      return random_sampler(d, spec.count, spec.seed);
    case SamplerKind::one_at_a_time:
      return one_at_a_time_sampler(space.start_point(), levels_of(space, spec.levels));
    case SamplerKind::star:
      return one_at_a_time_sampler(std::vector<double>(std::size_t(d), 0.5), levels_of(space, 2));
    case SamplerKind::morris:
      return morris_sampler(d, spec.trajectories, spec.levels, spec.seed);
    case SamplerKind::saltelli:
      return saltelli_sampler(d, spec.count, spec.second_order, spec.scrambled, spec.seed);
    case SamplerKind::list:
      break;
  }
  throw std::logic_error("a list is no sampler");
}

// What a sampler refuses, as a mistake of the table that gives it.
template <class Make>
auto in_words_of(const Study& study, const Make& make) -> decltype(make()) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    throw StudyError(study.optimizer ? "optimizer" : "sampler", error.what());
  }
}

}  // namespace

std::unique_ptr<VariantSource> make_source(const Study& study, const DesignSpace& space) {
  if (study.sampler.kind == SamplerKind::list) {
    for (const StudyInput& input : study.inputs) {
      if (input.name != study.sampler.file) continue;
      return std::make_unique<ListSource>(read_variant_list(input.text, input.name, space),
                                          space.column_count());
    }
    throw StudyError("sampler.file", "was not read");
  }
  return in_words_of(study, [&]() -> std::unique_ptr<VariantSource> {
    return std::make_unique<SampledSource>(make_sampler(study.sampler, space), space);
  });
}

std::uint64_t source_size(const Study& study, const DesignSpace& space) {
  if (study.sampler.kind != SamplerKind::latin_maximin) return make_source(study, space)->size();
  return in_words_of(study, [&] {
    check_latin_maximin(study.sampler.count);
    return study.sampler.count;
  });
}

}  // namespace bodyline::explore
