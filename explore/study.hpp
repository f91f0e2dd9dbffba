#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "explore/metric_kind.hpp"
#include "model/model.hpp"
#include "model/surface.hpp"
#include "optimize/algorithm.hpp"

/// Families of variants: what varies, what is measured, where it is kept (docs/exploring.md).
namespace bodyline::explore {

/// A file that a study names, or the study itself.
struct StudyInput {
  std::string name;  ///< as the study writes it
  std::string text;
};

/// A scan or drawing that a metric measures against; its content is not kept.
struct MeasuredFile {
  std::string name;  ///< as the study writes it
  std::uint64_t bytes = 0;
  std::string digest;  ///< of its content, to see changes (CRC-64); "" where it cannot be read
  friend bool operator==(const MeasuredFile&, const MeasuredFile&) = default;
};

/// A car that variants start from.
struct BaseModel {
  std::string name;  ///< of its file, without folder and extension
  model::Model model;
};

/// What variants start from.
enum class BaseKind {
  model,   ///< one car
  choice,  ///< one of several, a variable of its own
  blend    ///< a weighted mean of several, the weights variables that add up to 1
};

/// How the two numbers of a range are meant.
enum class RangeKind {
  bounds,  ///< there are none: the bounds of the search (VariableBounds)
  value,   ///< of the variable itself
  offset,  ///< added to the base's value
  factor,  ///< times the base's value
  width    ///< of cuts: the strip that is cut away, a part of the patch
};

/// Variables that vary alike.
struct VariableGroup {
  std::string name;
  std::vector<std::string> vary;  ///< patterns of names
  RangeKind kind = RangeKind::bounds;
  std::array<double, 2> range{0.0, 0.0};  ///< not used with `bounds`
  /// All move together, by offset or factor, and are one variable with the group's name.
  bool linked = false;
  std::vector<double> weights;  ///< of a link's patterns: times the offset; 1 each when empty
  friend bool operator==(const VariableGroup&, const VariableGroup&) = default;
};

/// One column of the results.
struct MetricSpec {
  std::string name;
  MetricKind kind = MetricKind::bending;
  model::Stage stage = model::Stage::body;
  std::vector<std::string> faces;  ///< of an energy: patterns, all when empty; of a rake: one name
  std::string scan;                ///< file, of the distance to a scan
  int points = 2000;               ///< of the scan that are used
  bool posed = false;              ///< the scan lies on the models as it is, in mm
  std::string views;               ///< files of drawn outlines, as io/parse_views.hpp reads them
  friend bool operator==(const MetricSpec&, const MetricSpec&) = default;
};

/// A metric that must lie in a range; a variant that breaks it is recorded as infeasible.
struct Constraint {
  std::string metric;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  friend bool operator==(const Constraint&, const Constraint&) = default;
};

enum class SamplerKind {
  factorial,      ///< all combinations of `levels` values of every variable
  sobol,          ///< Sobol's sequence
  halton,         ///< Halton's sequence
  latin,          ///< one variant in each of `count` strata of every variable
  latin_maximin,  ///< the same, with variants far from each other
  random,         ///< independent, uniform
  one_at_a_time,  ///< the base, then `levels` values of each variable with the others at the base
  star,           ///< the middle, then both ends of each variable with the others in the middle
  list,           ///< read from a CSV file
  morris,         ///< `trajectories` for Morris's elementary effects
  saltelli        ///< for the indices of Sobol and Saltelli
};

struct SamplerSpec {
  SamplerKind kind = SamplerKind::sobol;
  std::uint64_t count = 0;  ///< variants; of saltelli: base points
  std::uint64_t seed = 1;
  int levels = 0;             ///< of factorial, one_at_a_time and morris
  bool scrambled = true;      ///< sobol, halton and saltelli
  int trajectories = 0;       ///< of morris
  bool second_order = false;  ///< of saltelli: rows for indices of pairs too
  std::string file;           ///< of list
};

enum class OptimizerKind {
  local,  ///< a search by gradients from each start of a sampler
  nsga2,  ///< evolution of a population towards a front (Deb and others, 2002)
  moead,  ///< the same by decomposition (Zhang and Li, 2007)
  front   ///< a front of two objectives by their gradients, from point to point
};

/// A metric that should be small: `weight` times it; large for a negative weight.
struct Goal {
  std::string metric;
  double weight = 1.0;
};

/// What chooses variants by the results of others.
struct OptimizerSpec {
  OptimizerKind kind = OptimizerKind::nsga2;
  std::vector<Goal> goals;  ///< of local: terms of one sum; else objectives, of weight 1 or -1
  std::uint64_t seed = 1;   ///< of nsga2 and moead
  int population = 0;       ///< of nsga2 and moead
  int generations = 0;      ///< after the first population
  int points = 0;           ///< of front: rows
  int evaluations = 0;      ///< of local and front: at most, of each row
  optimize::Algorithm algorithm = optimize::Algorithm::nlopt_lbfgs;  ///< of local
};

/// What is stored beyond variables, metrics, status and seconds.
struct Keep {
  bool nets = false;        ///< points of all nets, as 32-bit numbers
  int thumbnail_width = 0;  ///< pixels; 0: no pictures
  bool compressed = true;
  int block = 0;  ///< rows of a chunk, a power of two; 0: about 1 MiB each
};

struct Checks {
  bool folds = true;  ///< look at 64 normals of every face
  friend bool operator==(const Checks&, const Checks&) = default;
};

/// All that `bodyline explore` needs to know.
struct Study {
  std::string name;
  std::string note;
  std::filesystem::path folder;  ///< that names of files are relative to
  BaseKind base = BaseKind::model;
  std::vector<BaseModel> models;  ///< one, or those of the choice or blend
  std::vector<VariableGroup> variables;
  std::vector<MetricSpec> metrics;
  std::vector<Constraint> constraints;
  SamplerSpec sampler;  ///< with an optimizer: of its starts
  std::optional<OptimizerSpec> optimizer;
  Checks checks;
  Keep keep;
  int nodes = 8;                    ///< Gauss nodes per direction on each face, for the energies
  std::vector<StudyInput> inputs;   ///< the study's own text first, then what it reads
  std::vector<MeasuredFile> files;  ///< what metrics measure against, each once
};

}  // namespace bodyline::explore
