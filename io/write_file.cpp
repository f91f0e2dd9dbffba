#include "io/write_file.hpp"

#include "io/temporary_file.hpp"

namespace bodyline::io {

void write_file(const std::filesystem::path& path, std::string_view content, Overwrite overwrite) {
  TemporaryFile file(path, overwrite);
  file.write(content);
  file.finish();
}

}  // namespace bodyline::io
