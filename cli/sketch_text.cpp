#include "cli/sketch_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace bodyline::cli {
namespace {

using Json = nlohmann::ordered_json;
using sketch::CurveReport;
using sketch::CurveSource;

std::string source_name(CurveSource source) {
  switch (source) {
    case CurveSource::drawn:
      return "drawn";
    case CurveSource::half_drawn:
      return "half drawn";
    case CurveSource::missing:
      break;
  }
  return "missing";
}

bool follows_drawing(const CurveReport& curve) {
  return std::any_of(curve.views.begin(), curve.views.end(),
                     [](const sketch::CurveView& view) { return view.drawn_speed; });
}

std::string line_of(const CurveReport& curve) {
  std::string views;
  double rms = 0.0;
  for (const sketch::CurveView& view : curve.views) {
    views += (views.empty() ? "" : ", ") + model::view_name(view.view);
    rms = std::max(rms, view.rms);
  }
  return fmt::format("{:<40} {:<10} {:<26} {:>7}  {}\n", curve.curve, source_name(curve.source),
                     views, curve.views.empty() ? "" : fmt::format("{:.2f}", rms),
                     curve.views.empty()      ? ""
                     : follows_drawing(curve) ? "drawing"
                                              : "template");
}

Json json_of(const CurveReport& curve, int degree) {
  Json views = Json::array();
  for (const sketch::CurveView& view : curve.views)
    views.push_back({{"view", model::view_name(view.view)},
                     {"rms_mm", view.rms},
                     {"p90_mm", view.p90},
                     {"drawn_speed", view.drawn_speed}});
  Json document{{"curve", curve.curve},
                {"degree", degree},
                {"source", source_name(curve.source)},
                {"views", views}};
  if (curve.source == CurveSource::drawn) {
    document["combined"] = {model::view_name(curve.combined[0]),
                            model::view_name(curve.combined[1])};
    document["axis"] = std::string(1, curve.axis);
    document["range_mm"] = curve.range;
    document["ends_apart_mm"] = curve.apart;
  }
  document["contradictions"] = curve.contradictions;
  return document;
}

std::vector<std::string> names_of(const sketch::SketchResult& result, CurveSource source) {
  std::vector<std::string> names;
  for (const CurveReport& curve : result.curves)
    if (curve.source == source) names.push_back(curve.curve);
  return names;
}

}  // namespace

std::string sketch_text(const sketch::SketchResult& result) {
  std::string text =
      fmt::format("{:<40} {:<10} {:<26} {:>7}  {}\n", "curve", "", "views", "rms mm", "speed from");
  for (const CurveReport& curve : result.curves) text += line_of(curve);
  if (const auto names = names_of(result, CurveSource::missing); !names.empty())
    text +=
        fmt::format("\nNot drawn, the template's brought to size: {}\n", fmt::join(names, ", "));
  if (const auto names = names_of(result, CurveSource::half_drawn); !names.empty())
    text += fmt::format(
        "\nDrawn in no two views that share an axis along which they advance, so partly the "
        "template's: {}\n",
        fmt::join(names, ", "));
  for (const CurveReport& curve : result.curves)
    for (const std::string& sentence : curve.contradictions)
      text += fmt::format("\n{}: {}.", curve.curve, sentence);
  if (has_contradictions(result)) text += "\n";
  return text;
}

Json sketch_json(const sketch::SketchResult& result) {
  Json curves = Json::array();
  for (std::size_t c = 0; c < result.curves.size(); ++c)
    curves.push_back(json_of(result.curves[c], int(result.model.curves[c].points.size()) - 1));
  return {{"curves", curves},
          {"missing", names_of(result, CurveSource::missing)},
          {"half_drawn", names_of(result, CurveSource::half_drawn)},
          {"unknown_names", result.unknown},
          {"rounds", result.rounds}};
}

bool has_contradictions(const sketch::SketchResult& result) {
  return std::any_of(result.curves.begin(), result.curves.end(),
                     [](const CurveReport& curve) { return !curve.contradictions.empty(); });
}

}  // namespace bodyline::cli
