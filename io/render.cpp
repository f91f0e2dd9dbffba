#include "io/render.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "io/render_legend.hpp"
#include "io/render_occlusion.hpp"
#include "io/render_painter.hpp"
#include "io/render_scene.hpp"
#include "io/tessellate.hpp"

namespace bodyline::io {
namespace {

constexpr int smallest = 64, largest = 8192;  // pixels
constexpr int most_samples = 64;
constexpr int tile = 32;                       // pixels per side
constexpr float visible_step = 5.0f / 255.0f;  // sRGB difference that calls for more rays

void check_size(int width, int height) {
  const auto [low, high] = std::minmax(width, height);
  if (low < smallest || high > largest) {
    throw std::invalid_argument("a picture of " + std::to_string(width) + "x" +
                                std::to_string(height) +
                                " pixels cannot be drawn: width and height must be from " +
                                std::to_string(smallest) + " to " + std::to_string(largest));
  }
}

void check(const std::vector<model::Surface>& faces, const RenderOptions& options) {
  if (faces.empty()) throw std::invalid_argument("there are no faces to draw");
  check_size(options.width, options.height);
  if (options.samples < 1 || options.samples > most_samples) {
    throw std::invalid_argument("samples per pixel must be from 1 to " +
                                std::to_string(most_samples) + ", not " +
                                std::to_string(options.samples));
  }
  if (options.curvature_range &&
      !(*options.curvature_range > 0.0 && std::isfinite(*options.curvature_range))) {
    throw std::invalid_argument("the curvature range of a picture must be a positive number");
  }
}

/// One ray through the middle of each pixel; colours are sRGB from 0 to 1.
struct FirstPass {
  int width = 0, height = 0;
  std::vector<Seen> pixels;

  Seen& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
  const Seen& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

Color to_srgb(const Color& linear) {
  return linear.unaryExpr([](float x) { return srgb_from_linear(x); });
}

// Mean of grid x grid rays through a pixel.
Color refined(const Painter& painter, int x, int y, int grid) {
  Color sum = Color::Zero();
  for (int k = 0; k < grid * grid; ++k) {
    sum += painter.look(x + (k % grid + 0.5) / grid, y + (k / grid + 0.5) / grid).color;
  }
  return to_srgb(sum / static_cast<float>(grid * grid));
}

// Whether something visible ends near the middle of a pixel. A change of face counts as well:
// between two large faces there may be one thinner than a pixel.
bool needs_refinement(const FirstPass& pass, int x, int y) {
  const Seen& here = pass.at(x, y);
  for (int k = 0; k < 9; ++k) {
    const int nx = std::clamp(x + k % 3 - 1, 0, pass.width - 1);
    const int ny = std::clamp(y + k / 3 - 1, 0, pass.height - 1);
    const Seen& there = pass.at(nx, ny);
    if (there.face != here.face) return true;
    if ((there.color - here.color).abs().maxCoeff() > visible_step) return true;
  }
  return false;
}

// What is added before rounding down, 0 to 1: an ordered pattern that hides the steps of soft
// gradients.
float dither(int x, int y) {
  constexpr int pattern[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
  return (static_cast<float>(pattern[y % 4][x % 4]) + 0.5f) / 16.0f * 0.999f;
}

/// Reports how much of two passes over all tiles is done.
class TileProgress {
 public:
  TileProgress(int tiles, const std::function<void(double)>& report)
      : total_(2 * tiles), report_(report) {}
  void tile_done() {
    if (!report_) return;
    const std::lock_guard lock(mutex_);
    report_(static_cast<double>(++done_) / total_);
  }

 private:
  int total_, done_ = 0;
  const std::function<void(double)>& report_;
  std::mutex mutex_;
};

template <class Action>
void for_each_pixel(int width, int height, TileProgress& progress, const Action& action) {
  const int columns = (width + tile - 1) / tile, rows = (height + tile - 1) / tile;
  tbb::parallel_for(0, columns * rows, [&](int t) {
    const int left = t % columns * tile, top = t / columns * tile;
    for (int y = top; y < std::min(top + tile, height); ++y) {
      for (int x = left; x < std::min(left + tile, width); ++x) action(x, y);
    }
    progress.tile_done();
  });
}

Picture traced(const Painter& painter, const RenderOptions& options) {
  const int width = options.width, height = options.height;
  const int grid = static_cast<int>(std::ceil(std::sqrt(options.samples) - 1e-9));
  FirstPass first{width, height, {}};
  first.pixels.resize(static_cast<std::size_t>(width) * height);
  Picture picture{width, height, {}};
  picture.rgb.resize(first.pixels.size() * 3);
  TileProgress progress(((width + tile - 1) / tile) * ((height + tile - 1) / tile),
                        options.on_progress);
  for_each_pixel(width, height, progress, [&](int x, int y) {
    const Seen seen = painter.look(x + 0.5, y + 0.5);
    first.at(x, y) = {to_srgb(seen.color), seen.face};
  });
  for_each_pixel(width, height, progress, [&](int x, int y) {
    const bool refine = grid > 1 && needs_refinement(first, x, y);
    const Color color = refine ? refined(painter, x, y, grid) : first.at(x, y).color;
    for (int c = 0; c < 3; ++c) {
      picture.rgb[3 * (static_cast<std::size_t>(y) * width + x) + c] =
          static_cast<std::uint8_t>(255.0f * color[c] + dither(x, y));
    }
  });
  return picture;
}

// Chords stay far below a pixel at the sizes allowed; all faces alike, so that no cracks open
// between them.
int cells_per_face(std::size_t faces) {
  if (faces > 1000) return 8;  // pieces of faces, each of them small
  return faces <= 40 ? 64 : 40;
}

// What is enough for a picture of some hundred pixels.
constexpr int quick_cells = 8;
constexpr OcclusionDetail quick_occlusion{2, 24, 16, 8, 16};

std::vector<Eigen::Vector3d> all_points(const std::vector<FaceGrid>& grids) {
  std::vector<Eigen::Vector3d> points;
  for (const FaceGrid& grid : grids)
    points.insert(points.end(), grid.points.begin(), grid.points.end());
  return points;
}

}  // namespace

PictureSize size_from_text(const std::string& text) {
  PictureSize size;
  const char* end = text.data() + text.size();
  const auto [middle, first_error] = std::from_chars(text.data(), end, size.width);
  if (first_error == std::errc{} && middle != end && *middle == 'x') {
    const auto [stop, second_error] = std::from_chars(middle + 1, end, size.height);
    if (second_error == std::errc{} && stop == end) {
      check_size(size.width, size.height);
      return size;
    }
  }
  throw std::invalid_argument(
      "'" + text + "' is not a picture size: give WIDTHxHEIGHT in pixels, for example 1600x900");
}

Picture render(const std::vector<model::Surface>& faces, const RenderOptions& options) {
  check(faces, options);
  const MapColors colors(faces, options.map, options.curvature_range, options.field);
  const std::vector<FaceGrid> grids =
      tessellate(faces, options.quick ? quick_cells : cells_per_face(faces.size()));
  const RayScene scene(grids);
  const Occlusion occlusion(scene, faces, grids,
                            options.quick ? quick_occlusion : OcclusionDetail{});
  const std::vector<Eigen::Vector3d> points = all_points(grids);
  const Camera camera(options.view, points,
                      body_frame(options.width, options.height, colors, !options.title.empty()));
  const Painter painter(faces, scene, occlusion, colors, camera, points, options.height);
  Picture picture = traced(painter, options);
  draw_legend(picture, colors, options.title);
  return picture;
}

}  // namespace bodyline::io
