#include "io/model_file_names.hpp"

#include <algorithm>

#include "model/suggest.hpp"

namespace bodyline::io {
namespace {

constexpr std::size_t longest_name = 64;
constexpr std::size_t longest_quote = 60;
constexpr std::size_t most_listed = 10;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

bool is_name(std::string_view name) {
  if (name.empty() || name.size() > longest_name || !is_letter(name.front())) return false;
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text.substr(0, longest_quote)) {
    const auto code = static_cast<unsigned char>(c);
    result += code < 0x20 || code == 0x7f ? '?' : c;
  }
  // A cut inside a UTF-8 sequence would leave half a character.
  if (text.size() > longest_quote) {
    while (result.size() > 1 && (static_cast<unsigned char>(result.back()) & 0x80) != 0) {
      result.pop_back();
    }
    result += "...";
  }
  return result + "\"";
}

std::string suggestion(std::string_view wrong, std::span<const std::string> candidates) {
  constexpr std::size_t shortest_word = 3;
  if (wrong.size() < shortest_word || wrong.size() > longest_name) return "";
  const std::string* best = nullptr;
  std::size_t best_distance = std::max<std::size_t>(1, wrong.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = model::edit_distance(wrong, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = &candidate;
    }
  }
  return best == nullptr ? "" : " (did you mean " + in_quotes(*best) + "?)";
}

std::string listed(std::span<const std::string> names) {
  std::string result;
  for (std::size_t i = 0; i < names.size() && i < most_listed; ++i) {
    result += (i == 0 ? "" : ", ") + names[i];
  }
  if (names.size() <= most_listed) return result;
  return result + " and " + std::to_string(names.size() - most_listed) + " more";
}

}  // namespace bodyline::io
