#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "explore/hdf5_handle.hpp"

/// Small things put into an HDF5 file. `at` is a file, group or dataset; all throw
/// std::runtime_error.
namespace bodyline::explore {

void write_attribute(hid_t at, const std::string& name, const std::string& text);
void write_attribute(hid_t at, const std::string& name, std::uint64_t number);

/// One text, in UTF-8.
Hdf5Handle write_text(hid_t at, const std::string& name, const std::string& text);
/// Arrays of one dimension, texts padded to the longest.
Hdf5Handle write_texts(hid_t at, const std::string& name, const std::vector<std::string>& texts);
Hdf5Handle write_numbers(hid_t at, const std::string& name, const std::vector<double>& numbers);
Hdf5Handle write_numbers(hid_t at, const std::string& name, const std::vector<int>& numbers);

Hdf5Handle make_group(hid_t at, const std::string& name);

/// Properties of a dataset that remembers no time: the same content gives the same bytes.
Hdf5Handle timeless_dataset();

}  // namespace bodyline::explore
