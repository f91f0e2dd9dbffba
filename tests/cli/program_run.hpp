#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// Running the program as a user does, in a folder of its own.
namespace bodyline::testing {

/// What a run of a program left.
struct ProgramRun {
  int exit_code = -1;  ///< 128 + signal when a signal ended it
  std::string out, err;
};

/// Runs a program with arguments in a folder; the folder of `bodyline` comes first on its PATH.
ProgramRun run_in(const std::filesystem::path& folder, const std::vector<std::string>& command);

/// A program that runs beside the test, started as by run_in; ended and awaited with the object.
class StartedProgram {
 public:
  StartedProgram(const std::filesystem::path& folder, const std::vector<std::string>& command);
  ~StartedProgram();
  StartedProgram(StartedProgram&& other) noexcept;
  void signal(int number) const;
  bool catches(int number) const;  ///< whether it has a handler for a signal (Linux)
  bool runs();                     ///< whether it has not ended yet
  std::string out() const;         ///< standard output so far
  ProgramRun wait();

 private:
  bool reap(int options);
  struct Streams;
  std::unique_ptr<Streams> streams_;
  int child_ = -1, status_ = 0;
};

std::string text_of(const std::filesystem::path& path);

/// An empty folder for the life of the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A test that runs `bodyline` in an empty folder.
class CommandLine : public ::testing::Test {
 protected:
  ProgramRun bodyline(std::vector<std::string> arguments) const;
  /// Standard output of a run that must end well, as JSON.
  nlohmann::json json(std::vector<std::string> arguments) const;
  std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }
  std::string text(const std::string& name) const { return text_of(file(name)); }
  void write(const std::string& name, const std::string& content) const;
  /// Names of all files in the folder.
  std::vector<std::string> files() const;
  /// Path of a car of the repository.
  static std::string car(const std::string& name);

 private:
  TemporaryFolder folder_;
};

}  // namespace bodyline::testing
