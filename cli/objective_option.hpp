#pragma once

#include <string>
#include <vector>

#include "model/objective.hpp"
#include "model/surface.hpp"

namespace bodyline::cli {

/// Reads an objective: terms separated by commas, each NAME, NAME=WEIGHT or NAME@FACES=WEIGHT,
/// where FACES are patterns of face names joined by '+'. A weight is a number not below 0, 1 when
/// left out. "bending=1,variation@hood+roof=0.1". All terms get the stage. Throws
/// std::invalid_argument for anything else and for a term given twice.
std::vector<model::Term> objective_from_text(const std::string& text, model::Stage stage);

/// The term as the user wrote it, without its weight: "bending", "variation@hood+roof".
std::string term_key(const model::Term& term);

/// What --help says of an objective.
std::string objective_help();

}  // namespace bodyline::cli
