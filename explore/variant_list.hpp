#pragma once

#include <string>
#include <vector>

#include "explore/design_space.hpp"

namespace bodyline::explore {

/// Reads variants from the text of a CSV file whose first line names columns of the space, in any
/// order; a leading "in:" is passed over, and so are all other columns that write_variant_table
/// writes. Columns that the file does not have stay at the start. Returns one row per variant.
/// Throws io::InputError, with `name` for the file, for unknown columns and for values that are no
/// numbers or outside the columns' ranges.
std::vector<double> read_variant_list(const std::string& text, const std::string& name,
                                      const DesignSpace& space);

}  // namespace bodyline::explore
