#include "io/svg_transform.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/scan_words.hpp"
#include "io/svg_scanner.hpp"

namespace bodyline::io {
namespace {

using Eigen::Affine2d;
using Eigen::Vector2d;

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

Affine2d matrix(const std::vector<double>& n) {
  Affine2d result = Affine2d::Identity();
  result.linear() << n[0], n[2], n[1], n[3];
  result.translation() << n[4], n[5];
  return result;
}

Affine2d rotation(const std::vector<double>& n) {
  const Vector2d centre = n.size() == 3 ? Vector2d(n[1], n[2]) : Vector2d(0.0, 0.0);
  return Eigen::Translation2d(centre) * Eigen::Rotation2Dd(radians(n[0])) *
         Eigen::Translation2d(-centre);
}

Affine2d named_transform(std::string_view name, const std::vector<double>& n) {
  const std::size_t count = n.size();
  if (name == "matrix" && count == 6) return matrix(n);
  if (name == "translate" && (count == 1 || count == 2))
    return Affine2d(Eigen::Translation2d(n[0], count == 2 ? n[1] : 0.0));
  if (name == "scale" && (count == 1 || count == 2))
    return Affine2d(Eigen::Scaling(n[0], count == 2 ? n[1] : n[0]));
  if (name == "rotate" && (count == 1 || count == 3)) return rotation(n);
  if (name == "skewX" && count == 1) return matrix({1.0, 0.0, std::tan(radians(n[0])), 1.0, 0, 0});
  if (name == "skewY" && count == 1) return matrix({1.0, std::tan(radians(n[0])), 0.0, 1.0, 0, 0});
  throw std::invalid_argument(shown_word(name) + " with " + std::to_string(count) +
                              " numbers is no transform");
}

}  // namespace

Affine2d svg_transform(std::string_view text) {
  constexpr std::size_t most_numbers = 6;
  Affine2d result = Affine2d::Identity();
  SvgScanner scanner(text);
  while (!scanner.at_end()) {
    const std::string_view name = scanner.word();
    if (name == "none" && scanner.at_end()) break;
    if (scanner.at_end() || scanner.character() != '(')
      throw std::invalid_argument("the transform lacks a '(' before " + shown_word(scanner.rest()));
    std::vector<double> numbers;
    while (scanner.at_number() && numbers.size() < most_numbers) {
      numbers.push_back(scanner.number());
      scanner.skip_separator();
    }
    if (scanner.at_end() || scanner.character() != ')')
      throw std::invalid_argument("the transform lacks a ')' after " + shown_word(name));
    result = result * named_transform(name, numbers);
    scanner.skip_separator();
  }
  return result;
}

}  // namespace bodyline::io
