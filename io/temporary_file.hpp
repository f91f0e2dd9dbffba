#pragma once

#include <filesystem>
#include <string_view>

#include "io/write_file.hpp"

namespace bodyline::io {

/// A new file next to its target, whose name it takes in the end; removed again if that never
/// comes. A symbolic link is followed. Throws InputError when the target exists and may not be
/// replaced, or when the system refuses.
class TemporaryFile {
 public:
  TemporaryFile(std::filesystem::path path, Overwrite overwrite);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  /// Writes behind what was written before.
  void write(std::string_view content);
  /// Returns when all is on the disk and the file has its target's name and permissions.
  void finish();

 private:
  std::filesystem::path path_, target_, temporary_;
  Overwrite overwrite_;
  int descriptor_ = -1;
};

}  // namespace bodyline::io
