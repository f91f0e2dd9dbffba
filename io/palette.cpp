#include "io/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bodyline::io {
namespace {

// OKLab to linear sRGB (B. Ottosson's published matrices); may leave 0..1.
Eigen::Array3d linear_from_oklab(double lightness, double a, double b) {
  const double l = lightness + 0.3963377774 * a + 0.2158037573 * b;
  const double m = lightness - 0.1055613458 * a - 0.0638541728 * b;
  const double s = lightness - 0.0894841775 * a - 1.2914855480 * b;
  const double l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
  return {4.0767416621 * l3 - 3.3077115913 * m3 + 0.2309699292 * s3,
          -1.2684380046 * l3 + 2.6097574011 * m3 - 0.3413193965 * s3,
          -0.0041960863 * l3 - 0.7034186147 * m3 + 1.7076147010 * s3};
}

bool shown_by_screen(const Eigen::Array3d& rgb) {
  constexpr double rounding = 1e-4;
  return rgb.minCoeff() >= -rounding && rgb.maxCoeff() <= 1.0 + rounding;
}

double mix(double a, double b, double t) { return a + (b - a) * t; }

}  // namespace

float srgb_from_linear(float linear) {
  const float x = std::clamp(linear, 0.0f, 1.0f);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

float linear_from_srgb(float srgb) {
  const float x = std::clamp(srgb, 0.0f, 1.0f);
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

Color color_from_srgb(int red, int green, int blue) {
  const auto channel = [](int c) { return linear_from_srgb(static_cast<float>(c) / 255.0f); };
  return {channel(red), channel(green), channel(blue)};
}

Color color_from_oklch(double lightness, double chroma, double hue) {
  const double angle = hue * std::numbers::pi / 180.0;
  const auto at = [&](double c) {
    return linear_from_oklab(lightness, c * std::cos(angle), c * std::sin(angle));
  };
  double shown = chroma;
  if (!shown_by_screen(at(chroma))) {
    double low = 0.0, high = chroma;
    for (int k = 0; k < 20; ++k) {
      shown = 0.5 * (low + high);
      (shown_by_screen(at(shown)) ? low : high) = shown;
    }
    shown = low;
  }
  return at(shown).max(0.0).min(1.0).cast<float>();
}

Color diverging_color(double t) {
  const double x = std::clamp(t, -1.0, 1.0), strength = std::abs(x);
  const double lightness = mix(0.93, x < 0.0 ? 0.42 : 0.48, strength);
  const double chroma = 0.19 * std::sin(0.5 * std::numbers::pi * std::min(1.0, 1.15 * strength));
  const double hue = x < 0.0 ? mix(235.0, 264.0, strength) : mix(55.0, 26.0, strength);
  return color_from_oklch(lightness, chroma, hue);
}

Color sequential_color(double t) {
  const double x = std::clamp(t, 0.0, 1.0);
  return color_from_oklch(mix(0.28, 0.93, x), mix(0.10, 0.14, x), mix(300.0, 100.0, x));
}

Color categorical_color(int index, int count) {
  constexpr std::array<double, 3> lightness{0.80, 0.72, 0.87}, chroma{0.090, 0.085, 0.070};
  // Neighbouring numbers take hues far apart, so that patches that touch do not look alike.
  const int step = count > 4 ? static_cast<int>(std::lround(count * 0.381966)) | 1 : 1;
  const double hue = 25.0 + 360.0 * ((index * step) % std::max(count, 1)) / std::max(count, 1);
  return color_from_oklch(lightness[index % 3], chroma[index % 3], hue);
}

}  // namespace bodyline::io
