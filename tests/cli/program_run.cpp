#include "tests/cli/program_run.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace bodyline::testing {
namespace {

namespace fs = std::filesystem;

// In the child: standard output and error to files, then the program. Never returns.
[[noreturn]] void become(const fs::path& folder, std::vector<char*>& arguments,
                         const std::string& path, const fs::path& out, const fs::path& err) {
  const int input = ::open("/dev/null", O_RDONLY);
  const int out_file = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err_file = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(input, STDIN_FILENO);
  ::dup2(out_file, STDOUT_FILENO);
  ::dup2(err_file, STDERR_FILENO);
  ::setenv("PATH", path.c_str(), 1);
  if (::chdir(folder.c_str()) == 0) ::execvp(arguments.front(), arguments.data());
  ::_exit(127);
}

std::string path_with_program() {
  const char* const before = std::getenv("PATH");
  return fs::path(BODYLINE_PROGRAM).parent_path().string() + ":" + (before ? before : "/bin");
}

}  // namespace

struct StartedProgram::Streams {
  TemporaryFolder folder;
  fs::path out = folder.path() / "out", err = folder.path() / "err";
};

StartedProgram::StartedProgram(const fs::path& folder, const std::vector<std::string>& command)
    : streams_(std::make_unique<Streams>()) {
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const std::string path = path_with_program();
  child_ = ::fork();
  if (child_ < 0) throw std::runtime_error("cannot start a process");
  if (child_ == 0) become(folder, arguments, path, streams_->out, streams_->err);
}

StartedProgram::StartedProgram(StartedProgram&& other) noexcept
    : streams_(std::move(other.streams_)),
      child_(std::exchange(other.child_, -1)),
      status_(other.status_) {}

StartedProgram::~StartedProgram() {
  if (child_ < 0) return;
  ::kill(child_, SIGKILL);
  reap(0);
}

bool StartedProgram::reap(int options) {
  if (child_ >= 0 && ::waitpid(child_, &status_, options) == child_) child_ = -1;
  return child_ < 0;
}

void StartedProgram::signal(int number) const {
  if (child_ >= 0) ::kill(child_, number);
}

bool StartedProgram::catches(int number) const {
  const std::string status = text_of("/proc/" + std::to_string(child_) + "/status");
  const std::string key = "SigCgt:";
  const std::size_t at = status.find(key);
  if (child_ < 0 || at == std::string::npos) return false;
  return (std::stoull(status.substr(at + key.size()), nullptr, 16) >> (number - 1)) & 1U;
}

bool StartedProgram::runs() { return !reap(WNOHANG); }

std::string StartedProgram::out() const { return text_of(streams_->out); }

ProgramRun StartedProgram::wait() {
  reap(0);
  const int code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  return {code, text_of(streams_->out), text_of(streams_->err)};
}

ProgramRun run_in(const fs::path& folder, const std::vector<std::string>& command) {
  return StartedProgram(folder, command).wait();
}

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "bodyline_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

ProgramRun CommandLine::bodyline(std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin(), BODYLINE_PROGRAM);
  return run_in(folder_.path(), arguments);
}

nlohmann::json CommandLine::json(std::vector<std::string> arguments) const {
  const ProgramRun run = bodyline(std::move(arguments));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return nlohmann::json::parse(run.out);
}

void CommandLine::write(const std::string& name, const std::string& content) const {
  std::ofstream(file(name), std::ios::binary) << content;
}

std::vector<std::string> CommandLine::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_.path())) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string CommandLine::car(const std::string& name) {
  return std::string(BODYLINE_SOURCE_DIR) + "/cars/" + name + ".toml";
}

}  // namespace bodyline::testing
