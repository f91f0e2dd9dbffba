#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace bodyline::explore {

/// Where in a file stand the two numbers of a chunked dataset that grow with it, 8 bytes each.
struct DatasetPlaces {
  std::uint64_t rows = 0;  ///< its present number of rows
  std::uint64_t root = 0;  ///< the address of its index of chunks
};

/// Finds them in an object header of version 1 (section IV.A.1.a of the "HDF5 File Format
/// Specification, Version 2.0"), which has no checksums: the numbers can be replaced one by one.
/// `read` gives bytes of the file at an address. Throws std::runtime_error for any other header.
DatasetPlaces dataset_places(
    std::uint64_t header,
    const std::function<std::vector<std::byte>(std::uint64_t address, std::size_t count)>& read);

}  // namespace bodyline::explore
