#include "io/svg_length.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "io/scan_words.hpp"
#include "io/svg_scanner.hpp"

namespace bodyline::io {
namespace {

struct Unit {
  std::string_view name;
  double mm;
};

constexpr std::array<Unit, 6> units{{{"mm", 1.0},
                                     {"cm", 10.0},
                                     {"in", 25.4},
                                     {"pt", 25.4 / 72.0},
                                     {"pc", 25.4 / 6.0},
                                     {"Q", 0.25}}};

}  // namespace

SvgLength svg_length(std::string_view text) {
  SvgScanner scanner(text);
  const double value = scanner.number();
  const std::string_view name = scanner.word();
  if (scanner.at_end()) {
    if (name.empty() || name == "px") return {value, false};
    for (const Unit& unit : units)
      if (name == unit.name) return {value * unit.mm / svg_pixel_mm, true};
  }
  throw std::invalid_argument(shown_word(text) +
                              " is no length that can be read: a number with mm, cm, in, pt, pc, "
                              "px or no unit");
}

}  // namespace bodyline::io
