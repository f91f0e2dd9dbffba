#pragma once

#include <ostream>
#include <string>

#include "explore/variant_filter.hpp"

namespace bodyline::explore {

/// Writes variants as a CSV file that Design Explorer and HiPlot open as it is: a column "id",
/// "in:NAME" for every variable, "out:NAME" for every metric, "status", "cause", and "img" when the
/// store has thumbnails: names of PNG files "IMAGES/ID.png", which are written too. `images` is
/// empty, or the folder for them; names in the table are relative to that of the table. Numbers
/// read back as the same doubles; a metric that is none is left empty. Returns the number of
/// variants.
std::uint64_t write_variant_table(const StoreReader& store, const VariantFilter& filter,
                                  std::ostream& out, const std::filesystem::path& images);

}  // namespace bodyline::explore
