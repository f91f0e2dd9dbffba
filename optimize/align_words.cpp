#include "optimize/align_words.hpp"

#include <cstdio>

namespace bodyline::optimize {
namespace {

constexpr double worth_a_word = 0.92;  // doubt

const char* side_words(MissingSide side) {
  if (side == MissingSide::none) return "both sides are there";
  return side == MissingSide::left ? "the left side is missing" : "the right side is missing";
}

std::string end_words(MissingEnd end, const std::string& reference) {
  if (end == MissingEnd::none) return "";
  const std::string which = end == MissingEnd::front  ? "FRONT OF THE CAR IS"
                            : end == MissingEnd::rear ? "REAR OF THE CAR IS"
                                                      : "FRONT AND REAR OF THE CAR ARE";
  return "THE " + which +
         " NOT IN THE SCAN: length, overhang and wheelbase cannot be told from it; a fit gives "
         "what is missing the proportions of " +
         reference + ".";
}

}  // namespace

std::string align_warning(const AlignResult& result, const std::string& reference) {
  std::string words = end_words(result.missing_end, reference);
  if (result.pose_is_doubtful)
    words += std::string(words.empty() ? "" : " ") +
             "AT THE GIVEN POSE THE SCAN DOES NOT LIE LIKE A CAR: look at the result.";
  return words;
}

std::string align_words(const AlignResult& result, const std::string& reference) {
  char text[320];
  std::snprintf(
      text, sizeof text,
      "The unit is %s. %.0f %% of the points lie on %.80s stretched to the scan, and they "
      "cover %.0f %% of it; %s.",
      result.unit.c_str(), 100.0 * result.fit, reference.c_str(), 100.0 * result.coverage,
      side_words(result.missing));
  std::string words = text;
  if (result.ground > 0.0) {
    std::snprintf(text, sizeof text, " %.0f %% of the points lie on the ground and are left out.",
                  100.0 * result.ground);
    words += text;
  }
  if (result.symmetry_mm > 0.0) {
    std::snprintf(text, sizeof text, " Left and right differ by %.1f mm.", result.symmetry_mm);
    words += text;
  }
  if (!result.warning.empty()) words += " " + result.warning;
  if (result.doubt > worth_a_word)
    words += " Another orientation fits nearly as well: look at the result, or give the pose.";
  return words;
}

}  // namespace bodyline::optimize
