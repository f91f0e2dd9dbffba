#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "explore/hdf5_handle.hpp"

/// Small things read from an HDF5 file. `at` is a file, group or dataset; all throw
/// std::runtime_error when it is not there or of another kind.
namespace bodyline::explore {

std::string read_text_attribute(hid_t at, const std::string& name);
std::uint64_t read_number_attribute(hid_t at, const std::string& name);

std::string read_text(hid_t at, const std::string& name);
std::vector<std::string> read_texts(hid_t at, const std::string& name);
std::uint64_t read_number(hid_t at, const std::string& name);

Hdf5Handle open_dataset(hid_t at, const std::string& name);
/// The present shape of a dataset.
std::vector<std::uint64_t> shape_of(hid_t dataset);

}  // namespace bodyline::explore
