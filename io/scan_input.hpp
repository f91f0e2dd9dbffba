#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace bodyline::io {

/// A file read from front to end, text or bytes, in blocks of bounded size.
class ScanInput {
 public:
  /// Throws InputError when there is no such file, when it cannot be read, and when it is empty.
  explicit ScanInput(const std::filesystem::path& path);

  /// The next line without its end; false at the end of the file. The view is valid until the next
  /// call. Throws InputError for a line of over 1 MiB.
  bool line(std::string_view& text);

  /// The next line that is not blank.
  bool filled_line(std::string_view& text);

  /// The next `count` bytes, valid until the next call; nullptr when fewer are left.
  const char* bytes(std::size_t count);

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }      ///< of the whole file, bytes
  std::uint64_t offset() const { return offset_; }  ///< bytes taken so far

  /// Throws InputError with the number of the line taken last.
  [[noreturn]] void fail_line(const std::string& sentence) const;

  /// Throws InputError that belongs to no line.
  [[noreturn]] void fail(const std::string& sentence) const;

 private:
  bool fill(std::size_t count);
  std::string_view take(std::size_t count);

  std::filesystem::path path_;
  std::ifstream stream_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // what of the buffer is not taken yet
  std::uint64_t size_ = 0, offset_ = 0;
  int line_ = 0;
};

}  // namespace bodyline::io
