#pragma once

#include "study_support.hpp"

/// Studies of model 1 with an optimizer.
namespace bodyline::testing {

/// Some 40 variables.
inline const std::string few = R"(
shape = { vary = ["shape.hood.*", "shape.roof.*"], offset = [-0.1, 0.1] }
fullness = { vary = ["fullness.hood*"], range = [1.0, 2.0] }
roof = { vary = ["curve.roof__side_window[1-4].z"], offset = [-20, 20] }
)";
inline const std::string unfolded = "[checks]\nfolds = false\n[keep]\nblock = 16\n";

/// Beginnings of [optimizer].
inline const std::string nsga2 = "kind = \"nsga2\"\nminimize = [\"bending\", \"closeness\"]\n";
inline const std::string moead = "kind = \"moead\"\nminimize = [\"bending\", \"closeness\"]\n";
inline const std::string front = "kind = \"front\"\nminimize = [\"bending\", \"closeness\"]\n";
inline const std::string local = "kind = \"local\"\nminimize = [\"bending\"]\n";

/// The text of a study with such lines of [optimizer], further tables, and the lines of [variables]
/// and [metrics].
std::string text_of(const std::string& optimizer, const std::string& rest = unfolded,
                    const std::string& variables = few,
                    const std::string& metrics = "bending = {}\ncloseness = {}\nheight = {}");

}  // namespace bodyline::testing
