#pragma once

#include "explore/study.hpp"
#include "io/model_file_table.hpp"

/// The parts of a study's file. Each throws io::InputError.
namespace bodyline::explore {

void read_variables(const io::FileTable& root, Study& study);
void read_metrics(const io::FileTable& root, Study& study);
void read_constraints(const io::FileTable& root, Study& study);
/// From the table of a sampler, which stands in a study or among what an optimizer needs.
SamplerSpec read_sampler(const io::FileTable& table);
/// The sampler or the optimizer; of metrics and constraints that were read before.
void read_choice_of_variants(const io::FileTable& root, Study& study);

}  // namespace bodyline::explore
