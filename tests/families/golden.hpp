#pragma once

#include <Eigen/Core>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace bodyline::testing {

/// Reference numbers of an independent prototype (docs/families.md), by name.
inline nlohmann::json golden(const std::string& name) {
  std::ifstream stream(BODYLINE_SOURCE_DIR "/tests/data/families.json");
  if (!stream) throw std::runtime_error("tests/data/families.json cannot be read");
  return nlohmann::json::parse(stream).at(name);
}

inline Eigen::Vector3d golden_point(const nlohmann::json& xyz) {
  return {xyz.at(0).get<double>(), xyz.at(1).get<double>(), xyz.at(2).get<double>()};
}

/// They are printed with all digits; a few roundings lie between.
inline constexpr double golden_tolerance = 1e-13;

}  // namespace bodyline::testing
