#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "optimizer_support.hpp"

namespace bodyline::testing {
namespace {

struct Refused {
  const char* name;
  std::string text;
  const char* sentence;
};
void PrintTo(const Refused& refused, std::ostream* stream) { *stream << refused.name; }

class RefusedOptimizer : public ::testing::TestWithParam<Refused> {};

TEST_P(RefusedOptimizer, SaysWhere) {
  EXPECT_THAT(refusal(GetParam().text), ::testing::HasSubstr(GetParam().sentence));
}

const std::string some = "population = 12\ngenerations = 2";
const std::string starts = "starts = { kind = \"sobol\", count = 2 }";

INSTANTIATE_TEST_SUITE_P(
    Each, RefusedOptimizer,
    ::testing::Values(
        Refused{"SamplerToo", text_of(nsga2 + some, "[sampler]\nkind = \"star\""),
                "optimizer: and \"sampler\" exclude each other"},
        Refused{"UnknownKind", text_of("kind = \"nsga3\""),
                "\"nsga3\" is not an optimizer; the optimizers are local, nsga2, moead, front."},
        Refused{"NoGoal", text_of("kind = \"nsga2\"\n" + some),
                "optimizer.minimize: is missing, and \"maximize\" too"},
        Refused{"UnknownGoal", text_of("kind = \"nsga2\"\nminimize = [\"bendin\"]\n" + some),
                "there is no metric of this name"},
        Refused{"GoalTwice",
                text_of("kind = \"nsga2\"\nminimize = [\"bending\"]\nmaximize = [\"bending\"]\n" +
                        some),
                "optimizer.maximize: names \"bending\" twice"},
        Refused{"OneGoal", text_of("kind = \"nsga2\"\nminimize = [\"bending\"]\n" + some),
                "a front needs two or more"},
        Refused{"ThreeGoals",
                text_of("kind = \"front\"\nminimize = [\"bending\", \"closeness\", "
                        "\"height\"]\npoints = 9"),
                "name 3 metrics; a front by gradients is one of two"},
        Refused{"NoPopulation", text_of(nsga2 + "generations = 2"),
                "optimizer.population: is missing; the optimizer nsga2 needs it."},
        Refused{"ForeignKey", text_of(front + "points = 9\npopulation = 12"),
                "optimizer.population: is nothing that the optimizer front has."},
        Refused{"TooManyVariants", text_of(nsga2 + "population = 5000\ngenerations = 1000000"),
                ": optimizer: "},
        Refused{"OddPopulation", text_of(nsga2 + "population = 10\ngenerations = 2"),
                "must be a multiple of 4 for nsga2"},
        Refused{"UnknownKey", text_of(nsga2 + some + "\nsize = 3"), "optimizer.size: unknown key"},
        Refused{"BadStarts", text_of(local + "starts = { kind = \"sobol\" }"),
                "optimizer.starts.count: is missing; the sampler sobol needs it."},
        Refused{"Weights", text_of(local + starts + "\nweights = [1, 2]"), "optimizer.weights"},
        Refused{"NegativeWeight", text_of(local + starts + "\nweights = [-1]"),
                "must all be above 0"},
        Refused{"UnknownAlgorithm", text_of(local + starts + "\nalgorithm = \"newton\""),
                "the algorithms are nlopt-lbfgs"},
        Refused{
            "NoGradient",
            text_of("kind = \"front\"\nminimize = [\"bending\", \"volume\"]\npoints = 9", "", few,
                    "bending = {}\nvolume = {}"),
            "has no gradient, which the optimizer front needs; those that have one are bending, "
            "variation, area, fold, closeness, length"},
        Refused{"NoGradientOfAConstraint",
                text_of(local + starts, "[constraints]\nvolume = { most = 9 }", few,
                        "bending = {}\nvolume = {}"),
                "constraints.volume: names \"volume\""},
        Refused{"AlgorithmWithoutConstraints",
                text_of(local + starts + "\nalgorithm = \"nlopt-lbfgs\"",
                        "[constraints]\nheight = { most = 1300 }"),
                "is nlopt-lbfgs, which keeps no constraints"},
        Refused{"Residuals", text_of(local + starts + "\nalgorithm = \"ceres-lm\""),
                "needs residuals"},
        Refused{"Choice",
                "format = 1\nname = \"x\"\nchoice = [\"model1.toml\", \"model2.toml\"]\n[metrics]\n"
                "bending = {}\ncloseness = {}\n[optimizer]\n" +
                    front + "points = 9",
                "choice: jumps from car to car"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace bodyline::testing
