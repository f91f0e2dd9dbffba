#include "model/name_matches.hpp"

#include <algorithm>
#include <cctype>

namespace bodyline::model {
namespace {

// A set such as [1-2] or [013]: digits and ranges only, more than a single digit. Returns its
// length or 0.
std::size_t digit_set_length(const std::string& pattern, std::size_t at) {
  const std::size_t close = pattern.find(']', at);
  if (close == std::string::npos || close - at < 3) return 0;
  for (std::size_t k = at + 1; k < close; ++k) {
    if (!std::isdigit(static_cast<unsigned char>(pattern[k])) && pattern[k] != '-') return 0;
  }
  return close - at + 1;
}

bool in_digit_set(const std::string& pattern, std::size_t at, std::size_t length, char digit) {
  for (std::size_t k = at + 1; k + 1 < at + length; ++k) {
    if (k + 3 < at + length && pattern[k + 1] == '-') {
      if (digit >= pattern[k] && digit <= pattern[k + 2]) return true;
      k += 2;
    } else if (pattern[k] == digit) {
      return true;
    }
  }
  return false;
}

// Matches pattern[p..] against name[n..]; `*` by recursion, so the depth is the number of stars.
bool matches_from(const std::string& pattern, std::size_t p, const std::string& name,
                  std::size_t n) {
  while (p < pattern.size()) {
    const char c = pattern[p];
    if (c == '*') {
      while (p + 1 < pattern.size() && pattern[p + 1] == '*') ++p;
      for (std::size_t k = n; k <= name.size(); ++k) {
        if (matches_from(pattern, p + 1, name, k)) return true;
      }
      return false;
    }
    const std::size_t set = c == '[' ? digit_set_length(pattern, p) : 0;
    if (set > 0) {
      // name must hold "[digit]" here
      if (n + 2 >= name.size() || name[n] != '[' || name[n + 2] != ']') return false;
      if (!in_digit_set(pattern, p, set, name[n + 1])) return false;
      p += set, n += 3;
      continue;
    }
    if (n >= name.size() || (c != '?' && c != name[n])) return false;
    ++p, ++n;
  }
  return n == name.size();
}

}  // namespace

bool name_matches(const std::string& pattern, const std::string& name) {
  return matches_from(pattern, 0, name, 0);
}

bool name_is_chosen(std::span<const std::string> patterns, const std::string& name) {
  return patterns.empty() ||
         std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return name_matches(pattern, name); });
}

}  // namespace bodyline::model
