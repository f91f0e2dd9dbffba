#include "io/write_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "io/model_file_names.hpp"
#include "model/number_text.hpp"

namespace bodyline::io {
namespace {

using model::Model;
using model::Side;

constexpr std::size_t longest_line = 100;

/// The item at an index; a model in memory may hold any index.
template <typename Item>
const Item& item(const std::vector<Item>& items, int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= items.size()) {
    throw std::invalid_argument("The model names a curve or patch that it does not have.");
  }
  return items[static_cast<std::size_t>(index)];
}

const std::string& valid_name(const std::string& name) {
  if (is_name(name)) return name;
  throw std::invalid_argument(in_quotes(name) + " cannot be written: " + name_rule + ".");
}

std::string number_text(double value) {
  if (!std::isfinite(value)) {
    throw std::invalid_argument("The model holds a number that is not finite.");
  }
  std::string text = model::number_text(value);
  // Digits alone are an integer in TOML: of 64 bits, and without a negative zero.
  const bool integer = text.find_first_not_of("-0123456789") == std::string::npos;
  constexpr std::size_t longest_integer = 18;
  if (text == "-0" || (integer && text.size() > longest_integer)) text += ".0";
  return text;
}

template <typename Numbers>
std::string numbers_text(const Numbers& numbers) {
  std::string text = "[";
  for (const double number : numbers) {
    text += (text.size() > 1 ? ", " : "") + number_text(number);
  }
  return text + "]";
}

std::string escaped(char c) {
  if (c == '\n') return "\\n";
  if (c == '\t') return "\\t";
  if (c == '\r') return "\\r";
  if (c == '"' || c == '\\') return std::string("\\") + c;
  const auto code = static_cast<unsigned char>(c);
  if (code >= 0x20 && code != 0x7f) return std::string(1, c);
  constexpr const char* digits = "0123456789ABCDEF";
  return std::string("\\u00") + digits[code / 16] + digits[code % 16];
}

/// A text in quotes; one that holds line ends is written over several lines.
std::string quoted_text(const std::string& text) {
  if (text.find('\n') == std::string::npos) {
    std::string line = "\"";
    for (const char c : text) line += escaped(c);
    return line + "\"";
  }
  std::string lines = "\"\"\"\n";
  for (std::size_t i = 0; i < text.size(); ++i) {
    // A single quote mark may stand as it is; more of them could end the text.
    const bool single_quote = text[i] == '"' && i + 1 < text.size() && text[i + 1] != '"';
    lines += text[i] == '\n' || single_quote ? std::string(1, text[i]) : escaped(text[i]);
  }
  return lines + "\"\"\"";
}

std::string names_text(const std::vector<std::string>& names) {
  std::string line = "[";
  for (const std::string& name : names) line += (line.size() > 1 ? ", \"" : "\"") + name + "\"";
  return line + "]";
}

template <typename Items>
std::string names_at(const Items& items, const std::vector<int>& indices) {
  std::vector<std::string> names;
  for (const int index : indices) names.push_back(item(items, index).name);
  return names_text(names);
}

/// Lines of "key = value" under a header.
class Lines {
 public:
  void header(const std::string& name) { text_ += (text_.empty() ? "[" : "\n[") + name + "]\n"; }
  void line(const std::string& key, const std::string& value) {
    text_ += key + " = " + value + "\n";
  }
  void note(const std::string& note) {
    if (!note.empty()) line("note", quoted_text(note));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string points_text(const std::vector<Eigen::Vector3d>& points) {
  std::string row = "[";
  std::string rows = "[\n";
  for (const Eigen::Vector3d& point : points) {
    const std::string coordinates = numbers_text(std::array{point.x(), point.y(), point.z()});
    row += (row.size() > 1 ? ", " : "") + coordinates;
    rows += "  " + coordinates + ",\n";
  }
  constexpr std::size_t key_and_bracket = std::string_view("points = ]").size();
  return row.size() + key_and_bracket <= longest_line ? row + "]" : rows + "]";
}

void write_header(const Model& model, Lines& lines) {
  lines.line("format", "1");
  lines.line("name", quoted_text(model.name));
  lines.line("units", "\"mm\"");
  lines.note(model.note);
}

void write_curve(const model::Curve& curve, Lines& lines) {
  lines.header("curves." + valid_name(curve.name));
  lines.line("points", points_text(curve.points));
  lines.note(curve.note);
}

bool same_bits(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return a == b && std::signbit(a[0]) == std::signbit(b[0]) &&
         std::signbit(a[1]) == std::signbit(b[1]);
}

void write_sides(const Model& model, const model::Patch& patch, Lines& lines) {
  for (const Side side : model::all_sides) {
    const auto& written = patch.sides[static_cast<std::size_t>(side)];
    const auto& v0 = patch.sides[static_cast<std::size_t>(Side::v0)];
    const bool is_mirror = patch.central && side == Side::v1;
    if (written.mirrored != is_mirror ||
        (is_mirror && (written.curve != v0.curve || written.reversed != v0.reversed))) {
      throw std::invalid_argument(
          "Patch " + in_quotes(patch.name) +
          " cannot be written: v1, and only v1, of a central patch mirrors v0.");
    }
    if (is_mirror) continue;
    std::string curve = written.reversed ? "\"-" : "\"";
    curve.append(item(model.curves, written.curve).name).append("\"");
    lines.line(model::side_name(side), curve);
  }
}

void write_patch(const Model& model, const model::Patch& patch, Lines& lines) {
  const model::Patch defaults;
  lines.header("patches." + valid_name(patch.name));
  if (patch.central) lines.line("central", "true");
  if (patch.basis != defaults.basis) lines.line("basis", quoted_text(patch.basis));
  write_sides(model, patch, lines);
  if (!same_bits(patch.cut_u, defaults.cut_u)) lines.line("cut.u", numbers_text(patch.cut_u));
  if (!same_bits(patch.cut_v, defaults.cut_v)) lines.line("cut.v", numbers_text(patch.cut_v));
  lines.line("shape.u", numbers_text(patch.shape_u));
  lines.line("shape.v", numbers_text(patch.shape_v));
  lines.note(patch.note);
}

std::string between_text(const Model& model, const model::PatchSide& a, const model::PatchSide& b) {
  return names_at(model.patches, {a.patch, b.patch});
}

void write_joint(const Model& model, const model::Joint& joint, Lines& lines) {
  constexpr std::array<double, 2> upright{0.0, 0.0};
  lines.header("joints." + valid_name(joint.name));
  lines.line("between", between_text(model, joint.a, joint.b));
  lines.line("fullness", numbers_text(joint.fullness));
  if (!same_bits(joint.lean[0], upright)) lines.line("lean.a", numbers_text(joint.lean[0]));
  if (!same_bits(joint.lean[1], upright)) lines.line("lean.b", numbers_text(joint.lean[1]));
  if (joint.continuity != model::Joint{}.continuity)
    lines.line("continuity", std::to_string(joint.continuity));
  if (joint.uncut) {
    const int patch = *joint.uncut == 0 ? joint.a.patch : joint.b.patch;
    lines.line("uncut", "\"" + item(model.patches, patch).name + "\"");
  }
  lines.note(joint.note);
}

void write_corner(const Model& model, const model::Corner& corner, Lines& lines) {
  lines.header("corners." + valid_name(corner.name));
  lines.line("patches", names_at(model.patches, corner.patches));
  if (corner.apex >= 0) lines.line("apex", "\"" + item(model.patches, corner.apex).name + "\"");
}

void write_wheels(const Model& model, Lines& lines) {
  if (model.front_arch.curves.empty() && model.rear_arch.curves.empty()) return;
  lines.header("wheels");
  for (const auto& [key, arch] :
       {std::pair("front", &model.front_arch), std::pair("rear", &model.rear_arch)}) {
    if (!arch->curves.empty()) lines.line(key, names_at(model.curves, arch->curves));
  }
}

}  // namespace

std::string write_model_text(const Model& model) {
  Lines lines;
  write_header(model, lines);
  for (const auto& curve : model.curves) write_curve(curve, lines);
  for (const auto& patch : model.patches) write_patch(model, patch, lines);
  for (const auto& joint : model.joints) write_joint(model, joint, lines);
  for (const auto& seam : model.seams) {
    lines.header("seams." + valid_name(seam.name));
    lines.line("between", between_text(model, seam.a, seam.b));
  }
  for (const auto& corner : model.corners) write_corner(model, corner, lines);
  write_wheels(model, lines);
  return lines.text();
}

void write_model(const Model& model, const std::filesystem::path& path, Overwrite overwrite) {
  write_file(path, write_model_text(model), overwrite);
}

}  // namespace bodyline::io
