#include "io/render_legend.hpp"

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>

namespace bodyline::io {
namespace {

// All sizes follow from the height of the text, and that from the picture.
double text_height(int width, int height) {
  return std::clamp(0.021 * std::min<double>(height, 0.62 * width), 7.0, 80.0);
}

constexpr double margin = 2.2;   // around the text, in text heights
constexpr double row = 1.65;     // of a list, in text heights
constexpr double column = 11.3;  // of a list
constexpr double bar_width = 26.0, bar_height = 0.95;
constexpr double histogram_height = 3.4, histogram_gap = 0.25;
constexpr int histogram_bins = 41;  // odd: one stands for zero

// A Cairo canvas over a picture.
class Canvas {
 public:
  explicit Canvas(Picture& picture)
      : picture_(picture),
        surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width, picture.height)),
        cairo_(cairo_create(surface_)) {
    if (cairo_status(cairo_) != CAIRO_STATUS_SUCCESS) {
      release();
      throw std::runtime_error("there is no memory to draw the legend");
    }
    each_pixel([](std::uint32_t& argb, std::uint8_t* rgb) {
      argb = (static_cast<std::uint32_t>(rgb[0]) << 16) |
             (static_cast<std::uint32_t>(rgb[1]) << 8) | rgb[2];
    });
    cairo_surface_mark_dirty(surface_);
    cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_font_options_t* font = cairo_font_options_create();
    cairo_font_options_set_antialias(font, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(font, CAIRO_HINT_STYLE_NONE);
    cairo_set_font_options(cairo_, font);
    cairo_font_options_destroy(font);
  }
  ~Canvas() { release(); }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Copies the drawing back into the picture.
  void finish() {
    cairo_surface_flush(surface_);
    each_pixel([](std::uint32_t& argb, std::uint8_t* rgb) {
      for (int c = 0; c < 3; ++c) rgb[c] = static_cast<std::uint8_t>(argb >> (16 - 8 * c));
    });
  }

  void color(const Color& color) {
    cairo_set_source_rgb(cairo_, srgb_from_linear(color[0]), srgb_from_linear(color[1]),
                         srgb_from_linear(color[2]));
  }
  void fill(double x, double y, double w, double h) {
    cairo_rectangle(cairo_, x, y, w, h);
    cairo_fill(cairo_);
  }
  void fill_polygon(std::initializer_list<std::array<double, 2>> points) {
    for (const auto& [x, y] : points) cairo_line_to(cairo_, x, y);
    cairo_close_path(cairo_);
    cairo_fill(cairo_);
  }
  /// Text with its baseline at y; `align` 0 starts at x, 0.5 is centred, 1 ends there.
  void text(double x, double y, double size, double align, const std::string& words) {
    cairo_set_font_size(cairo_, size);
    cairo_text_extents_t extents{};
    cairo_text_extents(cairo_, words.c_str(), &extents);
    cairo_move_to(cairo_, x - align * extents.x_advance, y);
    cairo_show_text(cairo_, words.c_str());
  }

 private:
  void each_pixel(const std::function<void(std::uint32_t&, std::uint8_t*)>& action) {
    unsigned char* data = cairo_image_surface_get_data(surface_);
    const int stride = cairo_image_surface_get_stride(surface_);
    for (int y = 0; y < picture_.height; ++y) {
      auto* line = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
      for (int x = 0; x < picture_.width; ++x) {
        action(line[x], &picture_.rgb[3 * (static_cast<std::size_t>(y) * picture_.width + x)]);
      }
    }
  }
  void release() {
    cairo_destroy(cairo_);
    cairo_surface_destroy(surface_);
  }

  Picture& picture_;
  cairo_surface_t* surface_;
  cairo_t* cairo_;
};

Color ink() { return color_from_srgb(58, 64, 74); }

std::string number_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value == 0.0 ? 0.0 : value);
  std::string words = text.data();
  if (words.front() == '-') words.replace(0, 1, "\u2212");
  return words;
}

std::string caption(const MapColors& colors) {
  switch (colors.map()) {
    case Map::mean_curvature:
      return "mean curvature, 1/m";
    case Map::gauss:
      return "Gauss curvature, 1/m\u00b2";
    case Map::isophotes:
      return "angle between normal and vertical, degrees";
    case Map::zebra:
      return "reflected stripes, one pair per 15\u00b0 of elevation";
    case Map::field:
      return colors.field()->caption;
    default:
      return "";
  }
}

bool has_bar(Map map) {
  return map == Map::mean_curvature || map == Map::gauss || map == Map::isophotes ||
         map == Map::field;
}

// How the list of entries is laid out.
struct ListLayout {
  int columns = 1, rows = 0;
};
ListLayout list_layout(int width, int height, std::size_t entries) {
  const double unit = text_height(width, height);
  const int fit = std::max(1, static_cast<int>((width - 2.0 * margin * unit) / (column * unit)));
  const int count = static_cast<int>(entries);
  if (count == 0) return {};
  const int rows = (count + fit - 1) / fit;
  return {(count + rows - 1) / rows, rows};
}

void draw_list(Canvas& canvas, const Picture& picture,
               const std::vector<MapColors::Entry>& entries) {
  const double unit = text_height(picture.width, picture.height);
  const ListLayout layout = list_layout(picture.width, picture.height, entries.size());
  const double left = 0.5 * (picture.width - layout.columns * column * unit);
  const double top = picture.height - (margin * 0.6 + layout.rows * row) * unit;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const int at = static_cast<int>(k);
    const double x = left + (at % layout.columns) * column * unit;
    const double y = top + (at / layout.columns) * row * unit;
    canvas.color(entries[k].color);
    canvas.fill(x, y, unit, unit);
    canvas.color(ink());
    canvas.text(x + 1.4 * unit, y + 0.82 * unit, 0.86 * unit, 0.0, entries[k].name);
  }
}

// Upright bars over the scale, each in its colour.
void draw_histogram(Canvas& canvas, const SurfaceField& field, double left, double bottom, double w,
                    double unit) {
  const std::vector<std::size_t> counts = histogram(field.values, field.range, histogram_bins);
  const double most =
      double(std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end())));
  const double step = w / histogram_bins;
  for (int k = 0; k < histogram_bins; ++k) {
    const double h = histogram_height * unit * double(counts[k]) / most;
    canvas.color(0.82f * diverging_color(2.0 * (k + 0.5) / histogram_bins - 1.0));
    canvas.fill(left + k * step, bottom - h, 0.86 * step, h);
  }
}

void draw_bar(Canvas& canvas, const Picture& picture, const MapColors& colors) {
  const double unit = text_height(picture.width, picture.height);
  const double w = std::min(bar_width * unit, 0.8 * picture.width), h = bar_height * unit;
  const double left = 0.5 * (picture.width - w), top = picture.height - 3.6 * unit;
  const bool isophotes = colors.map() == Map::isophotes;
  const auto color_at = [&](double t) {
    return isophotes ? isophote_color(t * isophote_end) : diverging_color(2.0 * t - 1.0);
  };
  const int steps = std::max(2, static_cast<int>(w));
  for (int k = 0; k < steps; ++k) {
    canvas.color(color_at((k + 0.5) / steps));
    canvas.fill(left + k * w / steps, top, w / steps + 0.5, h);
  }
  if (!isophotes) {  // arrows: the end colours go on beyond the range
    const double right = left + w, middle = top + 0.5 * h;
    canvas.color(color_at(0.0));
    canvas.fill_polygon({{left + 0.5, top}, {left - 0.8 * h, middle}, {left + 0.5, top + h}});
    canvas.color(color_at(1.0));
    canvas.fill_polygon({{right - 0.5, top}, {right + 0.8 * h, middle}, {right - 0.5, top + h}});
  }
  canvas.color(ink());
  const double low = isophotes ? 0.0 : -colors.range(),
               high = isophotes ? isophote_end : colors.range();
  const int ticks = isophotes ? 8 : 4;
  for (int k = 0; k <= ticks; ++k) {
    const double x = left + k * w / ticks;
    canvas.fill(x - 0.04 * unit, top + h, 0.08 * unit, 0.35 * unit);
    canvas.text(x, top + h + 1.45 * unit, 0.9 * unit, 0.5,
                number_text(low + (high - low) * k / ticks));
  }
  double above = 0.55 * unit;
  if (colors.field() != nullptr) {
    draw_histogram(canvas, *colors.field(), left, top - histogram_gap * unit, w, unit);
    above += (histogram_gap + histogram_height) * unit;
    canvas.color(ink());
  }
  canvas.text(0.5 * picture.width, top - above, unit, 0.5, caption(colors));
}

}  // namespace

Frame body_frame(int width, int height, const MapColors& colors, bool with_title) {
  const double unit = text_height(width, height);
  const double list = list_layout(width, height, colors.entries().size()).rows;
  double bottom = 0.0;
  if (has_bar(colors.map())) bottom = 5.2 * unit;
  if (colors.map() == Map::field) bottom += (histogram_height + histogram_gap) * unit;
  if (colors.map() == Map::zebra) bottom = 2.4 * unit;
  if (list > 0) bottom = (0.6 * margin + row * list) * unit;
  const double side = 0.045 * width, edge = std::max(0.045 * height, margin * unit);
  const double top = edge + (with_title ? 2.0 * unit : 0.0);
  const double low = height - std::max(edge + bottom, 0.085 * height);
  return {side, top, width - side, std::max(low, top + 0.2 * height)};
}

void draw_legend(Picture& picture, const MapColors& colors, const std::string& title) {
  const std::string words = caption(colors);
  if (title.empty() && words.empty() && colors.entries().empty()) return;
  Canvas canvas(picture);
  const double unit = text_height(picture.width, picture.height);
  if (has_bar(colors.map())) {
    draw_bar(canvas, picture, colors);
  } else if (!colors.entries().empty()) {
    draw_list(canvas, picture, colors.entries());
  } else if (!words.empty()) {
    canvas.color(ink());
    canvas.text(0.5 * picture.width, picture.height - 1.6 * unit, unit, 0.5, words);
  }
  if (!title.empty()) {
    canvas.color(ink());
    canvas.text(margin * unit, (margin + 0.9) * unit, 1.35 * unit, 0.0, title);
  }
  canvas.finish();
}

}  // namespace bodyline::io
