#include "io/scatter_plot.hpp"

#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "io/palette.hpp"
#include "io/svg_chart_axis.hpp"

namespace bodyline::io {
namespace {

constexpr double left = 86.0, right = 24.0, top = 24.0, bottom = 58.0;  // margins, pixels
constexpr double text_size = 13.0, tick_length = 5.0, line_height = 18.0;
constexpr int colors = 7;

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Cairo = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append(void* text, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

// All numbers of one axis.
std::vector<double> all_values(const ScatterPlot& plot, std::vector<double> ScatterSeries::*axis) {
  std::vector<double> values;
  for (const ScatterSeries& series : plot.series)
    values.insert(values.end(), (series.*axis).begin(), (series.*axis).end());
  return values;
}

ChartAxis::Scale scale(bool logarithmic) {
  return logarithmic ? ChartAxis::Scale::logarithmic : ChartAxis::Scale::linear;
}

// Draws one plot; the members are what its parts need.
class Painter {
 public:
  Painter(const ScatterPlot& plot, cairo_t* cairo)
      : plot_(plot),
        cairo_(cairo),
        x_(all_values(plot, &ScatterSeries::x), scale(plot.log_x)),
        y_(all_values(plot, &ScatterSeries::y), scale(plot.log_y)) {}

  void draw() {
    grey(1.0);
    cairo_paint(cairo_);
    cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, text_size);
    draw_axes();
    for (const ScatterSeries& series : plot_.series) draw_series(series);
    draw_legend();
  }

 private:
  void grey(double light) { cairo_set_source_rgb(cairo_, light, light, light); }
  void color(int index) {
    if (index == 0) return grey(0.72);
    const Color linear = categorical_color(index - 1, colors);
    // Darker than on a body: points are small.
    cairo_set_source_rgb(cairo_, 0.8 * srgb_from_linear(linear[0]),
                         0.8 * srgb_from_linear(linear[1]), 0.8 * srgb_from_linear(linear[2]));
  }
  double pixel_x(double value) const {
    return left + x_.position(value) * (plot_.width - left - right);
  }
  double pixel_y(double value) const {
    return plot_.height - bottom - y_.position(value) * (plot_.height - top - bottom);
  }
  void line(double x0, double y0, double x1, double y1) {
    cairo_move_to(cairo_, x0, y0);
    cairo_line_to(cairo_, x1, y1);
    cairo_stroke(cairo_);
  }
  // `align` 0 starts at x, 0.5 is centred, 1 ends there.
  void text(double x, double y, double align, const std::string& words) {
    cairo_text_extents_t extents{};
    cairo_text_extents(cairo_, words.c_str(), &extents);
    cairo_move_to(cairo_, x - align * extents.x_advance, y);
    cairo_show_text(cairo_, words.c_str());
  }

  void draw_axes() {
    const double low = plot_.height - bottom, end = plot_.width - right;
    cairo_set_line_width(cairo_, 1.0);
    for (const double tick : x_.ticks()) {
      grey(0.9);
      line(pixel_x(tick), top, pixel_x(tick), low);
      grey(0.25);
      text(pixel_x(tick), low + tick_length + text_size, 0.5, ChartAxis::label(tick));
    }
    for (const double tick : y_.ticks()) {
      grey(0.9);
      line(left, pixel_y(tick), end, pixel_y(tick));
      grey(0.25);
      text(left - tick_length, pixel_y(tick) + 0.35 * text_size, 1.0, ChartAxis::label(tick));
    }
    grey(0.25);
    line(left, low, end, low);
    line(left, top, left, low);
    text(0.5 * (left + end), plot_.height - 0.9 * text_size, 0.5, plot_.x_label);
    cairo_save(cairo_);
    cairo_translate(cairo_, 1.3 * text_size, 0.5 * (top + low));
    cairo_rotate(cairo_, -0.5 * std::numbers::pi);
    text(0.0, 0.0, 0.5, plot_.y_label);
    cairo_restore(cairo_);
  }

  void draw_series(const ScatterSeries& series) {
    color(series.color);
    bool begun = false;
    for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k) {
      if (!x_.shows(series.x[k]) || !y_.shows(series.y[k])) continue;
      const double x = pixel_x(series.x[k]), y = pixel_y(series.y[k]);
      if (series.joined) {
        if (begun) {
          cairo_line_to(cairo_, x, y);
        } else {
          cairo_move_to(cairo_, x, y);
        }
        begun = true;
      } else {
        cairo_arc(cairo_, x, y, series.radius, 0.0, 2.0 * std::numbers::pi);
        cairo_fill(cairo_);
      }
    }
    if (series.joined) cairo_stroke(cairo_);
  }

  void draw_legend() {
    double y = top + line_height;
    for (const ScatterSeries& series : plot_.series) {
      if (series.name.empty()) continue;
      color(series.color);
      cairo_arc(cairo_, plot_.width - right - 6.0, y - 0.35 * text_size, 4.0, 0.0,
                2.0 * std::numbers::pi);
      cairo_fill(cairo_);
      grey(0.25);
      text(plot_.width - right - 16.0, y, 1.0, series.name);
      y += line_height;
    }
  }

  const ScatterPlot& plot_;
  cairo_t* cairo_;
  ChartAxis x_, y_;
};

void draw_on(const ScatterPlot& plot, cairo_surface_t* surface) {
  const Cairo cairo(cairo_create(surface), cairo_destroy);
  Painter(plot, cairo.get()).draw();
  if (cairo_status(cairo.get()) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("there is no memory to draw the plot");
}

std::string png_of(const ScatterPlot& plot) {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, plot.width, plot.height),
                        cairo_surface_destroy);
  draw_on(plot, surface.get());
  std::string bytes;
  if (cairo_surface_write_to_png_stream(surface.get(), append, &bytes) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("the plot cannot be encoded");
  return bytes;
}

std::string svg_of(const ScatterPlot& plot) {
  std::string text;
  const Surface surface(cairo_svg_surface_create_for_stream(append, &text, plot.width, plot.height),
                        cairo_surface_destroy);
  draw_on(plot, surface.get());
  cairo_surface_finish(surface.get());
  return text;
}

}  // namespace

void write_scatter_plot(const ScatterPlot& plot, const std::filesystem::path& path,
                        Overwrite overwrite) {
  if (path.extension() == ".png") return write_file(path, png_of(plot), overwrite);
  if (path.extension() == ".svg") return write_file(path, svg_of(plot), overwrite);
  throw std::invalid_argument(path.string() + ": the name of a plot must end in .png or .svg");
}

}  // namespace bodyline::io
