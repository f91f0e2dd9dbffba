#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace bodyline::io {

/// The largest factor by which data of this kind can grow: three bytes stand for at most 264.
inline constexpr std::size_t largest_lzf_growth = 88;

/// Unpacks data packed with LZF (M. Lehmann's liblzf), as PCD files use it. Empty when the data are
/// damaged or do not unpack to `size` bytes.
std::string unpacked_lzf(std::string_view packed, std::size_t size);

}  // namespace bodyline::io
