#include "explore/thumbnail.hpp"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "explore/store_layout.hpp"
#include "io/render.hpp"
#include "model/net_surface.hpp"

namespace bodyline::explore {
namespace {

constexpr int samples = 4;

}  // namespace

void draw_thumbnail(const model::BodyPlan& plan, const double* nets, int width,
                    std::span<std::uint8_t> pixels) {
  std::vector<model::Surface> faces = model::net_surfaces(plan, model::Stage::body, nets);
  const std::size_t left_and_central = faces.size();
  for (std::size_t f = 0; f < left_and_central; ++f) {
    if (!faces[f].central) faces.push_back(model::mirror_image(faces[f]));
  }
  const bool finite =
      std::all_of(nets, nets + 3 * plan.point_count, [](double x) { return std::isfinite(x); });
  if (!finite) return;
  io::RenderOptions options;
  options.width = width;
  options.height = int(thumbnail_shape(width).front());
  options.quick = true;
  options.samples = samples;
  // Waiting for its own tasks, a thread must not begin another variant with the same evaluator.
  tbb::this_task_arena::isolate([&] {
    const io::Picture picture = io::render(faces, options);
    std::copy(picture.rgb.begin(), picture.rgb.end(), pixels.begin());
  });
}

}  // namespace bodyline::explore
