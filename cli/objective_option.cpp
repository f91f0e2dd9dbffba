#include "cli/objective_option.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace bodyline::cli {
namespace {

// The pieces between separators; an empty text is one empty piece.
std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> pieces;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = text.find(separator, begin);
    pieces.push_back(text.substr(begin, end - begin));
    if (end == std::string::npos) return pieces;
    begin = end + 1;
  }
}

double weight_from_text(const std::string& text, const std::string& term) {
  double weight = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, weight);
  if (error != std::errc{} || stop != end || !std::isfinite(weight) || weight < 0.0) {
    throw std::invalid_argument(fmt::format(
        "the weight '{}' of the objective term '{}' is not a number of 0 or more", text, term));
  }
  return weight;
}

model::Term term_from_text(const std::string& text, model::Stage stage) {
  model::Term term;
  term.stage = stage;
  const std::size_t equals = text.find('=');
  const std::string what = text.substr(0, equals);
  if (equals != std::string::npos) term.weight = weight_from_text(text.substr(equals + 1), what);
  const std::size_t at = what.find('@');
  term.kind = model::term_kind(what.substr(0, at));
  if (at == std::string::npos) return term;
  term.faces = split(what.substr(at + 1), '+');
  for (const std::string& face : term.faces) {
    if (face.empty()) throw std::invalid_argument("a face is missing after '@' in '" + what + "'");
  }
  if (term.kind == model::TermKind::closeness) {
    throw std::invalid_argument(
        "the objective term closeness is one of all curves and patches; "
        "it takes no faces");
  }
  return term;
}

}  // namespace

std::vector<model::Term> objective_from_text(const std::string& text, model::Stage stage) {
  std::vector<model::Term> terms;
  for (const std::string& piece : split(text, ',')) {
    terms.push_back(term_from_text(piece, stage));
    for (std::size_t k = 0; k + 1 < terms.size(); ++k) {
      if (term_key(terms[k]) != term_key(terms.back())) continue;
      throw std::invalid_argument("the objective has the term '" + term_key(terms[k]) + "' twice");
    }
  }
  return terms;
}

std::string term_key(const model::Term& term) {
  std::string key = model::term_name(term.kind);
  if (!term.faces.empty()) key += fmt::format("@{}", fmt::join(term.faces, "+"));
  return key;
}

std::string objective_help() {
  return fmt::format(
      "Terms and weights, NAME=WEIGHT or NAME@FACE+FACE=WEIGHT, separated by "
      "commas; terms are {}",
      fmt::join(model::term_names(), ", "));
}

}  // namespace bodyline::cli
