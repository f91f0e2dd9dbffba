#include "io/drawing_text.hpp"

#include <cstdint>
#include <fstream>
#include <system_error>

#include "io/input_error.hpp"

namespace bodyline::io {

std::string drawing_text(const std::filesystem::path& path) {
  constexpr std::uintmax_t most_bytes = 64 << 20;
  const auto fail = [&path](const std::string& sentence) {
    throw InputError(path.string(), 0, "", sentence);
  };
  std::error_code status;
  if (!std::filesystem::exists(path, status)) fail("does not exist.");
  if (std::filesystem::is_directory(path, status)) fail("is a folder, not a drawing.");
  const std::uintmax_t size = std::filesystem::file_size(path, status);
  if (status) fail("is not a regular file.");
  if (size == 0) fail("is empty.");
  if (size > most_bytes) fail("has over 64 MiB, too much for a drawing.");
  std::ifstream stream(path, std::ios::binary);
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (!stream) fail("cannot be read.");
  return text;
}

}  // namespace bodyline::io
