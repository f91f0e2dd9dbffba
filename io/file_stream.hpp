#pragma once

#include <ostream>
#include <streambuf>
#include <vector>

#include "io/temporary_file.hpp"

namespace bodyline::io {

/// A file that gets its name when it is complete, as write_file does, written through a stream; for
/// contents that may be larger than the memory.
class FileStream {
 public:
  /// Throws InputError as write_file.
  FileStream(std::filesystem::path path, Overwrite overwrite);

  /// What goes wrong while it is written throws InputError out of the insertion.
  std::ostream& stream() { return stream_; }
  /// Writes what is left and gives the file its name.
  void finish();

 private:
  class Buffer : public std::streambuf {
   public:
    Buffer(std::filesystem::path path, Overwrite overwrite);
    void write_out();
    void finish();

   private:
    int_type overflow(int_type character) override;

    TemporaryFile file_;
    std::vector<char> bytes_;
  };

  Buffer buffer_;
  std::ostream stream_;
};

}  // namespace bodyline::io
