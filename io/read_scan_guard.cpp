#include "io/read_scan_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "io/scalar_type.hpp"
#include "io/scan_input.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

using Json = nlohmann::json;

constexpr int deepest_json = 64;

// A vertex "0 0 0" and a face "3 0 1 2" take more than four bytes, as text or as numbers.
constexpr std::uint64_t bytes_an_element = 4;

// The first two whole numbers of an OFF file are the counts of vertices and of faces.
void check_off(ScanInput& input) {
  std::string_view line;
  int counts = 0;
  while (counts < 2 && input.filled_line(line)) {
    for (auto word = next_word(line); counts < 2 && !word.empty(); word = next_word(line)) {
      if (word.starts_with('#')) break;
      std::uint64_t count = 0;
      if (!whole_from_word(word, count)) continue;
      ++counts;
      if (count <= input.size() / bytes_an_element) continue;
      input.fail_line(
          fmt::format("announces {} vertices or faces, more than the file can hold.", count));
    }
  }
}

// ASCII files begin with "solid"; so do some binary ones, whose size tells.
void check_stl(ScanInput& input) {
  constexpr std::size_t head = 80, facet = 50;
  std::string_view line;
  const bool binary_size = input.size() >= head + 4 && (input.size() - head - 4) % facet == 0;
  if (binary_size || !input.line(line) || next_word(line) != "solid") return;
  bool ends = false;
  while (input.filled_line(line)) ends = next_word(line).starts_with("end");
  if (!ends) input.fail_line("is cut off: an STL file in ASCII ends with \"endsolid\".");
}

std::string text_of_gltf(ScanInput& input) {
  std::uint64_t size = input.size();
  if (lower_extension(input.path()) == ".glb") {
    const char* const head = input.bytes(20);
    if (head == nullptr || std::string_view(head, 4) != "glTF") {
      input.fail("is not a GLB file: it does not begin with \"glTF\".");
    }
    size = static_cast<std::uint64_t>(
        scalar_from_bytes(head + 12, ScalarType::uint32, ByteOrder::little));
  }
  const std::uint64_t left = input.size() - input.offset();
  if (size > left) input.fail(fmt::format("is cut off: it lacks {} bytes.", size - left));
  return std::string(input.bytes(size), size);
}

Json json_of_gltf(ScanInput& input) {
  const std::string text = text_of_gltf(input);
  const auto check_depth = [&input](int depth, Json::parse_event_t, const Json&) {
    if (depth > deepest_json) input.fail("is nested too deep.");
    return true;
  };
  try {
    return Json::parse(text, check_depth);
  } catch (const Json::parse_error& error) {
    input.fail(fmt::format("its JSON is damaged at byte {}.", error.byte));
  }
}

const Json& entries(const ScanInput& input, const Json& document, const char* key) {
  static const Json none = Json::array();
  const auto found = document.find(key);
  if (found == document.end()) return none;
  if (!found->is_array()) {
    input.fail(fmt::format("its {} are no array, as glTF 2.0 wants them.", key));
  }
  return *found;
}

// A node with two parents would let a small file describe a body of any size.
void check_nodes(const ScanInput& input, const Json& document) {
  std::set<Json> children;
  for (const Json& node : entries(input, document, "nodes")) {
    if (!node.is_object()) input.fail("one of its nodes is no object.");
    for (const Json& child : entries(input, node, "children")) {
      if (!children.insert(child).second) {
        input.fail(fmt::format("its node {} has two parents.", child.dump()));
      }
    }
  }
}

// Numbers come from the buffers, but those of an accessor without a buffer are zeros.
void check_accessors(const ScanInput& input, const Json& document) {
  for (const Json& accessor : entries(input, document, "accessors")) {
    if (!accessor.is_object()) input.fail("one of its accessors is no object.");
    const auto count = accessor.find("count");
    if (accessor.contains("bufferView") || count == accessor.end()) continue;
    if (count->is_number() && count->get<double>() <= static_cast<double>(input.size())) continue;
    input.fail(fmt::format("an accessor of {} numbers has no data.", count->dump()));
  }
}

void check_gltf(ScanInput& input) {
  const Json document = json_of_gltf(input);
  if (!document.is_object()) input.fail("is not a glTF file: its JSON is no object.");
  check_nodes(input, document);
  check_accessors(input, document);
}

}  // namespace

void check_before_assimp(const std::filesystem::path& path) {
  ScanInput input(path);
  const std::string extension = lower_extension(path);
  if (extension == ".off") check_off(input);
  if (extension == ".stl") check_stl(input);
  if (extension == ".gltf" || extension == ".glb") check_gltf(input);
}

}  // namespace bodyline::io
