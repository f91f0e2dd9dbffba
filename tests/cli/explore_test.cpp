// `explore` and `space`, as users run them.

#include <gmock/gmock.h>

#include <filesystem>
#include <sstream>

#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::HasSubstr;

class Explore : public testing::CommandLine {
 protected:
  void SetUp() override { write("study.toml", study("kind = \"sobol\"\ncount = 300")); }

  static std::string study(const std::string& sampler, const std::string& rest = "") {
    return "format = 1\nname = \"test\"\nmodel = \"" + car("model1") +
           "\"\n[variables]\n"
           "fullness = { vary = [\"fullness.hood*\"], range = [1.0, 3.05] }\n"
           "roof = { vary = [\"curve.roof__side_window[1-4].z\"], offset = [-20, 20] }\n"
           "[metrics]\nbending = {}\nheight = {}\n[checks]\nfolds = false\n[sampler]\n" +
           sampler + "\n" + rest;
  }
  // The same with an optimizer that makes bending small.
  static std::string optimizer_study(const std::string& optimizer) {
    std::string text = study("kind = \"star\"");
    text.replace(text.find("[sampler]"), std::string("[sampler]\nkind = \"star\"").size(),
                 "[optimizer]\nminimize = [\"bending\"]\n" + optimizer);
    return text;
  }
  void explore() { ASSERT_EQ(bodyline({"explore", "study.toml", "-o", "a.h5"}).exit_code, 0); }
};

TEST_F(Explore, MeasuresAllVariants) {
  const Json run = json({"explore", "study.toml", "-o", "a.h5", "--json"});
  EXPECT_EQ(run["done"], 300);
  int counted = 0;
  for (const auto& [status, count] : run["by_status"].items()) counted += count.get<int>();
  EXPECT_EQ(counted, 300);
  EXPECT_GT(run["by_status"]["fullness"], 0);
  const Json list = json({"space", "a.h5", "list", "--sort", "bending", "--status", "valid",
                          "--first", "1", "--json"});
  EXPECT_EQ(list["rows"], 300);
  EXPECT_EQ(list["variants"][0]["id"], run["best"]["id"]);
  EXPECT_EQ(list["variants"][0]["metrics"]["bending"], run["best"]["value"]);
}

TEST_F(Explore, ChecksAStudyWithoutWritingAnything) {
  const Json estimate = json({"explore", "study.toml", "--check", "--json"});
  EXPECT_EQ(estimate["variants"], 300);
  EXPECT_EQ(estimate["tried"].size(), 3u);
  EXPECT_GT(estimate["seconds"], 0.0);
  EXPECT_GT(estimate["bytes"], 300 * 8);
  EXPECT_THAT(files(), ::testing::ElementsAre("study.toml"));
}

TEST_F(Explore, ResumesACompleteStoreWithoutDoingAnything) {
  explore();
  const std::string before = text("a.h5");
  const Json again = json({"explore", "study.toml", "-o", "a.h5", "--resume", "--json"});
  EXPECT_EQ(again["measured"], 0);
  EXPECT_EQ(again["done"], 300);
  EXPECT_TRUE(text("a.h5") == before);
}

TEST_F(Explore, RefusesInOneSentence) {
  explore();
  const auto refused = [&](std::vector<std::string> arguments, const char* sentence) {
    const auto run = bodyline(std::move(arguments));
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, HasSubstr(sentence));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  };
  refused({"explore", "study.toml"}, "give the store to write");
  refused({"explore", "study.toml", "-o", "a.h5"}, "exists already");
  refused({"explore", "study.toml", "-o", "a.txt"}, "must end in .h5");
  refused({"explore", "none.toml", "-o", "b.h5"}, "none.toml: does not exist.");
  refused({"explore", "study.toml", "-o", "b.h5", "--resume"}, "b.h5: does not exist.");
  refused({"explore", "study.toml", "-o", "a.h5", "--resume", "--overwrite"}, "exclude each other");
  refused({"space", "study.toml", "list"}, "study.toml: is no HDF5 file.");
  refused({"space", "a.h5", "show", "300"}, "no variant 300");
  refused({"space", "a.h5", "list", "--sort", "bendin"}, "the nearest is 'bending'");
  refused({"space", "a.h5", "list", "--where", "bending<3"}, "is no condition");
  refused({"space", "a.h5", "list", "--status", "good"}, "is no status");
  refused({"space", "a.h5", "pareto", "--minimize", "bending"}, "two objectives or more");
  refused({"space", "a.h5", "plot", "height", "bending", "-o", "a.gif"}, "must end in .png");
  refused({"space", "a.h5", "sensitivity"}, "come from \"morris\" or \"saltelli\"");
  refused({"space", "a.h5", "pareto"}, "two objectives or more");
  refused({"space", "a.h5", "merge", "none.h5", "-o", "b.h5"}, "none.h5: does not exist.");
}

TEST_F(Explore, AVariantIsAModelWithItsNumbers) {
  explore();
  const Json list = json({"space", "a.h5", "list", "--status", "valid", "--first", "1", "--json"});
  const std::string id = std::to_string(list["variants"][0]["id"].get<int>());
  ASSERT_EQ(bodyline({"space", "a.h5", "model", id, "-o", "car.toml"}).exit_code, 0);
  const Json variant = json({"space", "a.h5", "show", id, "--json"});
  const Json listed = json({"variables", "car.toml", "--json"});
  std::size_t found = 0;
  for (const Json& variable : listed["variables"]) {
    const std::string name = variable["name"];
    if (!variant["variables"].contains(name)) continue;
    ++found;
    EXPECT_EQ(variable["value"], variant["variables"][name]);
  }
  EXPECT_EQ(found, variant["variables"].size());
  const Json value =
      json({"evaluate", "car.toml", "--objective", "bending=1", "--nodes", "8", "--json"});
  EXPECT_NEAR(value["value"].get<double>() / variant["metrics"]["bending"].get<double>(), 1.0,
              1e-12);
}

TEST_F(Explore, ATableIsAListOfTheSameVariants) {
  explore();
  ASSERT_EQ(bodyline({"space", "a.h5", "table", "-o", "a.csv"}).exit_code, 0);
  std::istringstream lines(text("a.csv"));
  std::string header;
  std::getline(lines, header);
  EXPECT_TRUE(header.starts_with("id,in:"));
  EXPECT_THAT(header, HasSubstr("out:bending,out:height,status,cause"));
  write("list.toml", study("kind = \"list\"\nfile = \"a.csv\""));
  ASSERT_EQ(bodyline({"explore", "list.toml", "-o", "b.h5"}).exit_code, 0);
  ASSERT_EQ(bodyline({"space", "b.h5", "table", "-o", "b.csv"}).exit_code, 0);
  EXPECT_EQ(text("a.csv"), text("b.csv"));
}

TEST_F(Explore, MergedStoresHaveAllVariants) {
  explore();
  write("more.toml", study("kind = \"random\"\ncount = 100"));
  ASSERT_EQ(bodyline({"explore", "more.toml", "-o", "b.h5"}).exit_code, 0);
  ASSERT_EQ(bodyline({"space", "a.h5", "merge", "b.h5", "-o", "c.h5"}).exit_code, 0);
  EXPECT_EQ(json({"space", "c.h5", "list", "--json"})["rows"], 400);
  const Json from = json({"space", "b.h5", "show", "7", "--json"});
  const Json to = json({"space", "c.h5", "show", "307", "--json"});
  EXPECT_EQ(from["variables"], to["variables"]);
  EXPECT_EQ(from["metrics"], to["metrics"]);
}

TEST_F(Explore, TheParetoSetIsNotDominated) {
  explore();
  const Json front = json({"space", "a.h5", "pareto", "--minimize", "bending", "--maximize",
                           "height", "--json"})["variants"];
  const Json all =
      json({"space", "a.h5", "list", "--first", "300", "--status", "valid", "--json"})["variants"];
  ASSERT_GT(front.size(), 1u);
  for (const Json& one : front) {
    for (const Json& other : all) {
      EXPECT_FALSE(other["metrics"]["bending"] < one["metrics"]["bending"] &&
                   other["metrics"]["height"] > one["metrics"]["height"]);
    }
  }
}

TEST_F(Explore, AFrontIsListedByTheGoalsOfItsStudy) {
  write("front.toml", optimizer_study("kind = \"front\"\nmaximize = [\"height\"]\npoints = 8"));
  const Json run = json({"explore", "front.toml", "-o", "f.h5", "--json"});
  EXPECT_GT(run["evaluations"], 8);
  EXPECT_EQ(run["done"], run["planned"]);
  const Json goals = json({"space", "f.h5", "pareto", "--json"});
  EXPECT_EQ(goals, json({"space", "f.h5", "pareto", "--minimize", "bending", "--maximize", "height",
                         "--json"}));
  // The reference is the worst of the front, so that its ends count nothing.
  EXPECT_GT(goals["hypervolume"], 0.0);
  double bending = 0.0, height = 1e9;
  for (const Json& variant : goals["variants"]) {
    bending = std::max(bending, variant["metrics"]["bending"].get<double>());
    height = std::min(height, variant["metrics"]["height"].get<double>());
  }
  EXPECT_EQ(goals["reference"], Json({bending, height}));
  const Json further =
      json({"space", "f.h5", "pareto", "--reference",
            std::to_string(bending + 1.0) + "," + std::to_string(height - 1.0), "--json"});
  EXPECT_GT(further["hypervolume"], goals["hypervolume"]);
  EXPECT_EQ(bodyline({"space", "f.h5", "pareto", "--reference", "1"}).exit_code, 2);
  const auto plot = [&](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> arguments{"space", "f.h5", "plot", "height", "bending", "-o", name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(bodyline(arguments).exit_code, 0);
    return text(name);
  };
  EXPECT_EQ(plot("f.svg", {}), plot("g.svg", {"--minimize", "bending", "--maximize", "height"}));
}

TEST_F(Explore, AnOptimizerCanBeCheckedAndResumed) {
  for (const std::string kind :
       {"kind = \"nsga2\"\nmaximize = [\"height\"]\npopulation = 8\ngenerations = 3",
        "kind = \"local\"\nstarts = { kind = \"sobol\", count = 3 }\nevaluations = 9"}) {
    write("o.toml", optimizer_study(kind));
    EXPECT_EQ(json({"explore", "o.toml", "--check", "--json"})["tried"].size(), 3u);
    ASSERT_EQ(bodyline({"explore", "o.toml", "-o", "o.h5", "--overwrite"}).exit_code, 0);
    const Json again = json({"explore", "o.toml", "-o", "o.h5", "--resume", "--json"});
    EXPECT_EQ(again["measured"], 0);
    EXPECT_EQ(again["done"], again["planned"]);
  }
}

TEST_F(Explore, TheExamplesAreStudies) {
  for (const std::string name : {"sweep", "family", "pareto"}) {
    const std::string path = std::string(BODYLINE_SOURCE_DIR) + "/examples/" + name + ".toml";
    EXPECT_EQ(json({"explore", path, "--check", "--json"})["study"], name);
  }
}

TEST_F(Explore, DrawsPlots) {
  explore();
  for (const std::string name : {"a.png", "a.svg"}) {
    ASSERT_EQ(bodyline({"space", "a.h5", "plot", "height", "bending", "-o", name, "--log-y",
                        "--minimize", "height,bending"})
                  .exit_code,
              0);
  }
  EXPECT_TRUE(text("a.png").starts_with("\x89PNG"));
  EXPECT_THAT(text("a.svg"), HasSubstr("<svg"));
}

TEST_F(Explore, SensitivitiesComeFromTheStore) {
  for (const std::string design :
       {"kind = \"morris\"\nlevels = 4\ntrajectories = 6", "kind = \"saltelli\"\ncount = 32"}) {
    write("design.toml", study(design));
    ASSERT_EQ(bodyline({"explore", "design.toml", "-o", "d.h5", "--overwrite"}).exit_code, 0);
    const Json found = json({"space", "d.h5", "sensitivity", "height", "--json"});
    // The roof alone makes the car high.
    for (const Json& factor : found["factors"]) {
      const Json& size = factor.contains("total") ? factor["total"] : factor["mu_star"];
      const bool roof = factor["factor"].get<std::string>().starts_with("curve.");
      EXPECT_TRUE(roof || std::abs(size["value"].get<double>()) < 1e-9) << factor;
    }
    EXPECT_GT(found["used"], 0);
  }
}

}  // namespace
}  // namespace bodyline
