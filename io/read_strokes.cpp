#include "io/read_strokes.hpp"

#include <array>
#include <map>

#include "io/input_error.hpp"
#include "io/read_strokes_formats.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

struct StrokeFormat {
  const char* extension;
  std::vector<model::Stroke> (*read)(const std::filesystem::path&);
};

constexpr std::array<StrokeFormat, 5> formats{{{".obj", read_strokes_obj},
                                               {".csv", read_strokes_text},
                                               {".txt", read_strokes_text},
                                               {".xyz", read_strokes_text},
                                               {".json", read_strokes_json}}};

// A stroke without a name gets its number; of several with one name the later ones are numbered.
void give_names(std::vector<model::Stroke>& strokes) {
  std::map<std::string, int> seen;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    std::string& name = strokes[k].name;
    if (name.empty()) name = "stroke " + std::to_string(k + 1);
    if (const int times = ++seen[name]; times > 1) name += "." + std::to_string(times);
  }
}

}  // namespace

std::vector<std::string> stroke_extensions() {
  std::vector<std::string> extensions;
  for (const StrokeFormat& format : formats) extensions.emplace_back(format.extension);
  return extensions;
}

std::vector<model::Stroke> read_strokes(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  for (const StrokeFormat& format : formats) {
    if (extension != format.extension) continue;
    std::vector<model::Stroke> strokes = format.read(path);
    if (strokes.empty()) throw InputError(path.string(), 0, "", "holds no stroke.");
    give_names(strokes);
    return strokes;
  }
  std::string known;
  for (const StrokeFormat& format : formats)
    known.append(known.empty() ? "" : ", ").append(format.extension);
  throw InputError(path.string(), 0, "",
                   "is of no known format of strokes; those are " + known + ".");
}

}  // namespace bodyline::io
