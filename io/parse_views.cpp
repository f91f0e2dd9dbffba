#include "io/parse_views.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

struct NoseName {
  Nose nose;
  const char* name;
};

constexpr std::array<NoseName, 4> noses{
    {{Nose::left, "left"}, {Nose::right, "right"}, {Nose::up, "up"}, {Nose::down, "down"}}};

// Takes ":nose-right" off the end.
void take_nose(ViewFile& file) {
  const std::string mark = ":nose-";
  const std::size_t at = file.path.rfind(mark);
  if (at == file.path.npos) return;
  file.nose = nose_of(file.path.substr(at + mark.size()));
  if (!nose_fits(file.view, file.nose))
    throw std::invalid_argument("the nose does not point " + nose_name(file.nose) + " in a view " +
                                model::view_name(file.view));
  file.path.resize(at);
}

// Takes "@2.5" off the end.
void take_scale(ViewFile& file) {
  const std::size_t at = file.path.rfind('@');
  if (at == file.path.npos) return;
  double scale = 0.0;
  if (!number_from_word(std::string_view(file.path).substr(at + 1), scale)) return;  // of the name
  if (!(scale > 0.0) || !std::isfinite(scale))
    throw std::invalid_argument("a scale is a number above 0, in mm per unit of the drawing, not " +
                                shown_word(file.path.substr(at + 1)));
  file.scale = scale;
  file.path.resize(at);
}

ViewFile parse_view(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos)
    throw std::invalid_argument(shown_word(text) +
                                " lacks a view: write side=FILE, front=FILE, "
                                "rear=FILE or top=FILE");
  ViewFile file;
  file.view = model::view_of(text.substr(0, equals));
  file.path = text.substr(equals + 1);
  take_nose(file);
  take_scale(file);
  if (file.path.empty())
    throw std::invalid_argument("the view " + model::view_name(file.view) + " has no file");
  return file;
}

}  // namespace

std::vector<ViewFile> parse_views(const std::string& text) {
  std::vector<ViewFile> files;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    files.push_back(parse_view(part));
    const auto same = [&](const ViewFile& file) { return file.view == files.back().view; };
    if (std::count_if(files.begin(), files.end(), same) > 1)
      throw std::invalid_argument("the view " + model::view_name(files.back().view) +
                                  " is given twice");
  }
  if (files.empty()) throw std::invalid_argument("no view is given");
  return files;
}

bool nose_fits(model::View view, Nose nose) {
  if (view == model::View::top || nose == Nose::left) return true;
  return view == model::View::side && nose == Nose::right;
}

std::string nose_name(Nose nose) {
  for (const NoseName& entry : noses)
    if (entry.nose == nose) return entry.name;
  return "";
}

Nose nose_of(const std::string& name) {
  for (const NoseName& entry : noses)
    if (name == entry.name) return entry.nose;
  throw std::invalid_argument(shown_word(name) +
                              " is no way a nose points; those are left, right, up and down");
}

}  // namespace bodyline::io
