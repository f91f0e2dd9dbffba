#include "io/write_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iterator>

#include "io/file_stream.hpp"
#include "io/input_error.hpp"
#include "tests/io/model_file_support.hpp"

namespace bodyline {
namespace {

using std::filesystem::path;

/// A folder of its own for each test.
class WriteFile : public ::testing::Test {
 protected:
  WriteFile() {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = std::filesystem::temp_directory_path() /
              ("bodyline_" + name + "_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~WriteFile() override { std::filesystem::remove_all(folder_); }

  std::ptrdiff_t files() const {
    return std::distance(std::filesystem::directory_iterator(folder_), {});
  }

  path folder_;
};

TEST_F(WriteFile, WritesTheContentAndLeavesNothingElse) {
  io::write_file(folder_ / "a.toml", "text\n");
  EXPECT_EQ(testing::file_text(folder_ / "a.toml"), "text\n");
  EXPECT_EQ(files(), 1);
}

TEST_F(WriteFile, DoesNotOverwriteUnlessAsked) {
  io::write_file(folder_ / "a.toml", "old");
  try {
    io::write_file(folder_ / "a.toml", "new");
    FAIL();
  } catch (const io::InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("exists already"));
  }
  EXPECT_EQ(testing::file_text(folder_ / "a.toml"), "old");
  io::write_file(folder_ / "a.toml", "new", io::Overwrite::allowed);
  EXPECT_EQ(testing::file_text(folder_ / "a.toml"), "new");
  EXPECT_EQ(files(), 1);
}

TEST_F(WriteFile, KeepsThePermissionsOfWhatItReplaces) {
  io::write_file(folder_ / "a.toml", "old");
  const auto read_only_by_owner =
      std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(folder_ / "a.toml", read_only_by_owner);
  io::write_file(folder_ / "a.toml", "new", io::Overwrite::allowed);
  EXPECT_EQ(std::filesystem::status(folder_ / "a.toml").permissions(), read_only_by_owner);
}

TEST_F(WriteFile, FollowsASymbolicLink) {
  io::write_file(folder_ / "a.toml", "old");
  std::filesystem::create_symlink("a.toml", folder_ / "link.toml");
  io::write_file(folder_ / "link.toml", "new", io::Overwrite::allowed);
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.toml"));
  EXPECT_EQ(testing::file_text(folder_ / "a.toml"), "new");
}

TEST_F(WriteFile, NamesTheFileThatCannotBeWritten) {
  for (const path& target : {folder_, folder_ / "missing" / "a.toml"}) {
    try {
      io::write_file(target, "text", io::Overwrite::allowed);
      FAIL() << target;
    } catch (const io::InputError& error) {
      EXPECT_THAT(error.what(), ::testing::StartsWith(target.string() + ": cannot be written"));
    }
  }
  EXPECT_EQ(files(), 0);
}

TEST_F(WriteFile, StreamsWhatIsLargerThanItsBuffer) {
  std::string expected;
  {
    io::FileStream file(folder_ / "a.csv", io::Overwrite::never);
    for (int line = 0; line < 50'000; ++line) {
      file.stream() << line << ",x\n";
      expected += std::to_string(line) + ",x\n";
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.csv"));
    file.finish();
  }
  EXPECT_EQ(testing::file_text(folder_ / "a.csv"), expected);
  EXPECT_EQ(files(), 1);
}

TEST_F(WriteFile, LeavesNothingOfAStreamThatIsNotFinished) {
  io::write_file(folder_ / "a.csv", "old");
  { io::FileStream(folder_ / "a.csv", io::Overwrite::allowed).stream() << "new"; }
  EXPECT_EQ(testing::file_text(folder_ / "a.csv"), "old");
  EXPECT_EQ(files(), 1);
  EXPECT_THROW(io::FileStream(folder_ / "a.csv", io::Overwrite::never), io::InputError);
}

TEST_F(WriteFile, AFullDiskEndsAStream) {
  // A limit for the size of a file stands for a disk that is full.
  struct rlimit before {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit small = before;
  small.rlim_cur = 1 << 17;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto write = [&] {
    io::FileStream file(folder_ / "a.csv", io::Overwrite::never);
    for (int line = 0; line < 100'000; ++line) file.stream() << line << "\n";
    file.finish();
  };
  EXPECT_THROW(write(), io::InputError);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(files(), 0);
}

}  // namespace
}  // namespace bodyline
