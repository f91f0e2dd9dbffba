#include "io/check_gltf.hpp"

#include <fmt/format.h>

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

}  // namespace

void check_gltf(const std::filesystem::path& path) {
  ScanInput input(path);
  const Json document = json_of_gltf(input);
  if (!document.is_object()) input.fail("is not a glTF file: its JSON is no object.");
  check_nodes(input, document);
  check_accessors(input, document);
}

}  // namespace bodyline::io
