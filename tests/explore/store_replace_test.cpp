// Several programs that replace one store at once (docs/store.md).

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "explore/append_file.hpp"
#include "store_support.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

namespace fs = std::filesystem;

constexpr int rows = 200;

explore::Study stored_study() { return small_study(rows, "[keep]\nblock = 64\n"); }

TEST(ReplacedStore, IsNotReplacedByTwoAtOnce) {
  const Folder folder;
  const explore::Study study = stored_study();
  const explore::DesignSpace space(study);
  new_store(folder / "a.h5", study, rows).finish();
  {
    const explore::ReplaceLock lock(folder / "a.h5");  // as of one who is about to replace it
    EXPECT_TRUE(lock.exists());
    EXPECT_THROW(explore::StoreWriter::create(folder / "a.h5", study, space, rows, true),
                 explore::StoreError);
    EXPECT_THROW(explore::StoreWriter::resume(folder / "a.h5", study), explore::StoreError);
  }
  explore::StoreWriter::create(folder / "a.h5", study, space, rows, true).finish();
}

// A pipe between processes that sends single letters.
class Letters {
 public:
  Letters() {
    if (::pipe(ends_.data()) != 0) throw std::runtime_error("no pipe");
  }
  Letters(const Letters&) = delete;
  Letters& operator=(const Letters&) = delete;
  ~Letters() {
    ::close(ends_[0]);
    only_receives();
  }
  /// Of a process that sends none: who waits must not wait for itself when all others have ended.
  void only_receives() {
    if (ends_[1] >= 0) ::close(std::exchange(ends_[1], -1));
  }
  void send(char letter) { ASSERT_EQ(::write(ends_[1], &letter, 1), 1); }
  /// '?' when nobody is left who could send one.
  char receive() {
    char letter = 0;
    return ::read(ends_[0], &letter, 1) == 1 ? letter : '?';
  }

 private:
  std::array<int, 2> ends_{};
};

struct Meeting {
  Letters start, answers, go_on;
};

// A program that replaces a store and fills it once all others have tried the same.
[[noreturn]] void replace_store(const fs::path& path, const explore::Study& study,
                                const explore::DesignSpace& space, Meeting& meeting) {
  meeting.start.only_receives();
  meeting.go_on.only_receives();
  meeting.start.receive();
  try {
    explore::StoreWriter store = explore::StoreWriter::create(path, study, space, rows, true);
    meeting.answers.send('y');
    meeting.go_on.receive();
    store.append(made_up_rows(store.layout(), 0, rows));
    store.finish();
  } catch (const explore::StoreError&) {
    meeting.answers.send('n');
    meeting.go_on.receive();
  }
  ::_exit(0);
}

// How many of so many programs that replace a store at once get it.
int writers_of(const fs::path& path, const explore::Study& study, int programs) {
  const explore::DesignSpace space(study);
  Meeting meeting;
  std::vector<pid_t> children;
  for (int k = 0; k < programs; ++k) {
    children.push_back(::fork());
    if (children.back() == 0) replace_store(path, study, space, meeting);
  }
  meeting.answers.only_receives();
  for (int k = 0; k < programs; ++k) meeting.start.send('s');
  int writers = 0;
  for (int k = 0; k < programs; ++k) writers += meeting.answers.receive() == 'y' ? 1 : 0;
  for (int k = 0; k < programs; ++k) meeting.go_on.send('g');
  for (const pid_t child : children) ::waitpid(child, nullptr, 0);
  return writers;
}

TEST(ReplacedStore, HasTheRowsOfTheOneWriterThatWasNotRefused) {
  constexpr int rounds = 40, programs = 4;
  const Folder folder;
  const explore::Study study = stored_study();
  int written = 0;
  for (int round = 0; round < rounds; ++round) {
    const fs::path path = folder / ("s" + std::to_string(round) + ".h5");
    if (round % 2 == 0) new_store(path, study, 7).finish();  // the others begin with no file
    const int writers = writers_of(path, study, programs);
    EXPECT_LE(writers, 1) << round;
    if (writers == 1) {
      EXPECT_TRUE(holds_rows(path, rows)) << round;
    }
    written += writers;
  }
  EXPECT_GT(written, rounds / 2);
}

TEST(ReplacedStore, MayBeWhatIsNoStore) {
  const Folder folder;
  std::ofstream(folder / "a.h5") << "something else";
  const explore::Study study = stored_study();
  const explore::DesignSpace space(study);
  explore::StoreWriter::create(folder / "a.h5", study, space, rows, true).finish();
  EXPECT_TRUE(holds_rows(folder / "a.h5", 0));
}

}  // namespace
}  // namespace bodyline::testing
