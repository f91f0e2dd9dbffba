#include "io/read_drawing.hpp"

#include <array>

#include "io/input_error.hpp"
#include "io/read_drawing_csv.hpp"
#include "io/read_drawing_png.hpp"
#include "io/read_drawing_svg.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

struct DrawingFormat {
  const char* extension;
  model::Drawing (*read)(const std::filesystem::path&);
};

constexpr std::array<DrawingFormat, 4> formats{{{".svg", read_drawing_svg},
                                                {".png", read_drawing_png},
                                                {".csv", read_drawing_csv},
                                                {".txt", read_drawing_csv}}};

}  // namespace

std::vector<std::string> drawing_extensions() {
  std::vector<std::string> extensions;
  for (const DrawingFormat& format : formats) extensions.emplace_back(format.extension);
  return extensions;
}

model::Drawing read_drawing(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  for (const DrawingFormat& format : formats) {
    if (extension != format.extension) continue;
    model::Drawing drawing = format.read(path);
    if (drawing.paths.empty()) throw InputError(path.string(), 0, "", "draws nothing.");
    return drawing;
  }
  throw InputError(path.string(), 0, "",
                   "is of no known format of drawings; those are .svg, .png, .csv and .txt.");
}

}  // namespace bodyline::io
