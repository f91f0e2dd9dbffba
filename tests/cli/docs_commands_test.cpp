#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

#include "tests/cli/program_run.hpp"

/// Every `sh` block of README.md and docs/*.md works: it runs line by line in a folder that holds
/// `cars` and `examples`, with `bodyline` on the PATH. A command that ends in "# exit 1" must end
/// so; all others must end well. Blocks that start with "./dev" set the machine up and are left
/// out.
namespace bodyline {
namespace {

namespace fs = std::filesystem;

struct Block {
  std::string file;
  int line = 0;
  std::string script;
};

void PrintTo(const Block& block, std::ostream* stream) { *stream << block.file; }

// "command  # exit 1" becomes a command that succeeds when the exit code is 1.
std::string with_expected_exit(const std::string& line) {
  const std::string mark = "# exit ";
  const std::size_t at = line.rfind(mark);
  if (at == std::string::npos) return line;
  return "code=0; { " + line.substr(0, at) +
         "; } || code=$?; test $code = " + line.substr(at + mark.size());
}

std::vector<Block> blocks_of(const fs::path& path) {
  std::ifstream stream(path);
  std::vector<Block> blocks;
  bool inside = false;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!inside && line == "```sh") {
      inside = true;
      blocks.push_back({path.filename().string(), number, ""});
    } else if (inside && line == "```") {
      inside = false;
    } else if (inside) {
      blocks.back().script += with_expected_exit(line) + "\n";
    }
  }
  return blocks;
}

std::vector<Block> all_blocks() {
  std::vector<fs::path> paths{fs::path(BODYLINE_SOURCE_DIR) / "README.md"};
  for (const auto& entry : fs::directory_iterator(fs::path(BODYLINE_SOURCE_DIR) / "docs")) {
    if (entry.path().extension() == ".md") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Block> blocks;
  for (const fs::path& path : paths) {
    for (Block& block : blocks_of(path)) {
      if (!block.script.starts_with("./dev")) blocks.push_back(std::move(block));
    }
  }
  return blocks;
}

std::string test_name(const Block& block) {
  std::string name = block.file + "_line_" + std::to_string(block.line);
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name;
}

class DocumentedCommands : public ::testing::TestWithParam<Block> {};

TEST_P(DocumentedCommands, Work) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"cars", "examples"})
    fs::copy(fs::path(BODYLINE_SOURCE_DIR) / name, folder.path() / name);
  const auto run = testing::run_in(folder.path(), {"bash", "-e", "-c", GetParam().script});
  EXPECT_EQ(run.exit_code, 0) << GetParam().script << run.err;
}

INSTANTIATE_TEST_SUITE_P(Each, DocumentedCommands, ::testing::ValuesIn(all_blocks()),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace bodyline
