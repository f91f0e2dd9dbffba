#pragma once

#include <Eigen/Core>

/// Colours. All are linear RGB (amounts of light, so that they may be averaged), 0 to 1 unless said
/// otherwise.
namespace bodyline::io {

using Color = Eigen::Array3f;

/// One channel from linear to sRGB and back, both 0 to 1; clamped.
float srgb_from_linear(float linear);
float linear_from_srgb(float srgb);

/// A colour given as three sRGB values from 0 to 255, as in a style sheet.
Color color_from_srgb(int red, int green, int blue);

/// OKLCh: perceptual lightness (0 to 1), chroma (0 to about 0.3) and hue in degrees. Chroma is
/// lowered where the screen could not show it.
Color color_from_oklch(double lightness, double chroma, double hue);

/// Diverging scale: -1 deep blue, 0 a light neutral, 1 deep red; equal steps look equally large.
/// Clamped.
Color diverging_color(double t);

/// Sequential scale from dark violet (0) over green to light yellow (1); lightness rises evenly.
/// Clamped.
Color sequential_color(double t);

/// Soft colours that are easy to tell apart; `count` of them, index 0 to count - 1.
Color categorical_color(int index, int count);

}  // namespace bodyline::io
