#include "sketch/contradictions.hpp"

#include <algorithm>
#include <sstream>

namespace bodyline::sketch {
namespace {

using model::View;
using model::view_name;

std::string sentence(const std::string& begin, double distance, const std::string& end) {
  std::ostringstream text;
  text.precision(0);
  text << std::fixed << begin << distance << end;
  return text.str();
}

bool concerns(const ViewCheck& check, View view) {
  return check.other == view || check.pair[0] == view || check.pair[1] == view;
}

// Whether all that fails concerns a view, and nothing that holds does.
bool is_suspect(View view, std::span<const ViewCheck> checks, double tolerance) {
  return std::all_of(checks.begin(), checks.end(), [&](const ViewCheck& check) {
    return concerns(check, view) == (check.distance > tolerance);
  });
}

std::string check_sentence(const ViewCheck& worst, std::span<const ViewCheck> checks,
                           double tolerance) {
  std::vector<View> suspects;
  for (const View view : model::all_views())
    if (is_suspect(view, checks, tolerance)) suspects.push_back(view);
  return sentence("a tenth of what the views " + view_name(worst.pair[0]) + " and " +
                      view_name(worst.pair[1]) + " tell together is ",
                  worst.distance,
                  " mm and more away from the line in the view " + view_name(worst.other) +
                      (suspects.size() == 1
                           ? "; the view " + view_name(suspects.front()) + " is the one in doubt"
                           : ""));
}

}  // namespace

std::vector<std::string> contradictions(const CurveReport& report, double length,
                                        std::span<const ViewCheck> checks, double tolerance) {
  std::vector<std::string> sentences;
  for (const CurveView& view : report.views)
    if (view.p90 > tolerance)
      sentences.push_back(
          sentence("a tenth of the line drawn in the view " + view_name(view.view) + " is ",
                   view.p90, " mm and more away from the curve that meets all views best"));
  const auto worst = std::max_element(
      checks.begin(), checks.end(),
      [](const ViewCheck& a, const ViewCheck& b) { return a.distance < b.distance; });
  if (worst != checks.end() && worst->distance > tolerance)
    sentences.push_back(check_sentence(*worst, checks, tolerance));
  const double allowed = std::max(tolerance, careless_ends * length);
  if (report.source == CurveSource::drawn && report.apart > allowed)
    sentences.push_back(sentence("its ends in the views " + view_name(report.combined[0]) +
                                     " and " + view_name(report.combined[1]) + " differ in " +
                                     report.axis + " by up to ",
                                 report.apart, " mm"));
  return sentences;
}

}  // namespace bodyline::sketch
