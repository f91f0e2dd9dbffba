#pragma once

#include <bit>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

#include "model/model.hpp"

/// What the tests of the model file share.
namespace bodyline::testing {

inline const std::array<std::string, 3> car_names{"template", "model1", "model2"};

inline std::string car_path(const std::string& name) {
  return std::string(BODYLINE_SOURCE_DIR) + "/cars/" + name + ".toml";
}

inline std::string file_text(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Every number of a model, in a fixed order, as its bits.
inline std::vector<std::uint64_t> number_bits(const model::Model& model) {
  std::vector<std::uint64_t> bits;
  const auto append = [&bits](const auto& numbers) {
    for (const double number : numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
  };
  for (const auto& curve : model.curves) {
    for (const auto& point : curve.points) append(std::array{point.x(), point.y(), point.z()});
  }
  for (const auto& patch : model.patches) {
    append(patch.shape_u);
    append(patch.shape_v);
    append(patch.cut_u);
    append(patch.cut_v);
  }
  for (const auto& joint : model.joints) {
    append(joint.fullness);
    append(joint.lean[0]);
    append(joint.lean[1]);
  }
  return bits;
}

/// Every name, text and index of a model, in a fixed order.
inline std::vector<std::string> words(const model::Model& model) {
  std::vector<std::string> list{model.name, model.note, model.units};
  const auto side_text = [](const model::PatchSide& side) {
    return std::to_string(side.patch) + model::side_name(side.side);
  };
  const auto append_all = [&list](const std::vector<int>& indices) {
    for (const int index : indices) list.push_back(std::to_string(index));
    list.emplace_back("end");
  };
  for (const auto& curve : model.curves) {
    list.insert(list.end(), {curve.name, curve.note, std::to_string(curve.points.size())});
  }
  for (const auto& patch : model.patches) {
    list.insert(list.end(), {patch.name, patch.note, patch.basis, patch.central ? "central" : "",
                             std::to_string(patch.shape_u.size())});
    for (const auto& side : patch.sides) {
      list.push_back(std::to_string(side.curve) + (side.reversed ? "r" : "") +
                     (side.mirrored ? "m" : ""));
    }
  }
  for (const auto& joint : model.joints) {
    list.insert(list.end(), {joint.name, side_text(joint.a), side_text(joint.b),
                             std::to_string(joint.continuity), joint.note,
                             joint.uncut ? std::to_string(*joint.uncut) : ""});
  }
  for (const auto& seam : model.seams) {
    list.insert(list.end(), {seam.name, side_text(seam.a), side_text(seam.b)});
  }
  for (const auto& corner : model.corners) {
    list.insert(list.end(), {corner.name, std::to_string(corner.apex)});
    append_all(corner.patches);
  }
  append_all(model.front_arch.curves);
  append_all(model.rear_arch.curves);
  return list;
}

}  // namespace bodyline::testing
