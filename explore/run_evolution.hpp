#pragma once

#include "explore/variant_recorder.hpp"

namespace bodyline::explore {

/// Evolves a population by nsga2 or moead, as the study says; every variant is a row, generation
/// after generation. The first variant is the study's car. One that broke a constraint, folded or
/// could not be built counts as worse in every objective than any that did not, and the more so the
/// further it is from it.
RunProgress run_evolution(VariantRecorder& recorder);

}  // namespace bodyline::explore
