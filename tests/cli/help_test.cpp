#include <gmock/gmock.h>

#include <sstream>

#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

using ::testing::HasSubstr;

class Help : public testing::CommandLine {
 protected:
  // The commands that `bodyline --help` lists.
  std::vector<std::string> commands() const {
    std::istringstream help(bodyline({"--help"}).out);
    std::vector<std::string> names;
    bool listing = false;
    for (std::string line; std::getline(help, line);) {
      if (listing && line.starts_with("  ")) {
        std::istringstream words(line);
        words >> names.emplace_back();
      }
      if (line == "Commands:") listing = true;
    }
    return names;
  }
};

TEST_F(Help, ListsTheCommands) {
  EXPECT_THAT(commands(), ::testing::IsSupersetOf(
                              {"variables", "set", "evaluate", "render", "export", "convert"}));
}

TEST_F(Help, OfEveryCommandShowsAnExampleThatStartsWithIt) {
  for (const std::string& command : commands()) {
    const auto run = bodyline({command, "--help"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_THAT(run.out, HasSubstr("Example:\n  bodyline " + command + " ")) << command;
  }
}

// The line after "Example:" is a command line that works.
TEST_F(Help, ExamplesWork) {
  for (const char* folder : {"cars", "examples"})
    std::filesystem::copy(std::filesystem::path(BODYLINE_SOURCE_DIR) / folder, file(folder));
  // What fit and deviation take comes from scan, and fitted.toml from the user.
  std::filesystem::copy(car("model1"), file("fitted.toml"));
  testing::run_in(file("."),
                  {"sh", "-c", "bodyline scan cars/model1.toml -o scan.ply --points 20000"});
  for (const std::string& command : commands()) {
    const std::string help = bodyline({command, "--help"}).out;
    const std::size_t begin = help.find("Example:\n") + 9;
    const std::string example = help.substr(begin, help.find('\n', begin) - begin);
    const auto run = testing::run_in(file("."), {"sh", "-c", example});
    // `check` may have findings
    EXPECT_LE(run.exit_code, command == "check" ? 1 : 0) << example << "\n" << run.err;
  }
}

TEST_F(Help, VersionIsOneLine) {
  const auto run = bodyline({"--version"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, ::testing::MatchesRegex("bodyline [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

}  // namespace
}  // namespace bodyline
