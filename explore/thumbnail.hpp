#pragma once

#include <cstdint>
#include <span>

#include "model/body_plan.hpp"

namespace bodyline::explore {

/// A small shaded picture of the closed body with these nets, thumbnail_shape(width) bytes.
void draw_thumbnail(const model::BodyPlan& plan, const double* nets, int width,
                    std::span<std::uint8_t> pixels);

}  // namespace bodyline::explore
