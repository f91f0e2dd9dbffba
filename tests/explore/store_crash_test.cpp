// What happens to a store when its writer is stopped between any two writes, in the middle of one,
// or by a full disk. The functions of the system that write are replaced by ones that look on.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <functional>

#include "store_support.hpp"
#include "study_support.hpp"

namespace {

// Called before every write and in its middle.
std::function<void()> on_write;                 // NOLINT: the system's functions have no object
std::function<bool(std::size_t)> is_disk_full;  // NOLINT
bool is_rest = false;                           // NOLINT: the second half of a write comes next

}  // namespace

extern "C" ssize_t pwrite(int file, const void* data, size_t count, off_t offset) {
  if (is_disk_full && is_disk_full(count)) {
    errno = ENOSPC;
    return -1;
  }
  if (on_write) {
    on_write();
    is_rest = !is_rest && count > 8;  // single numbers are written at once
    if (is_rest) count /= 2;          // whoever writes goes on with the rest
  }
  return syscall(SYS_pwrite64, file, data, count, offset);
}

namespace bodyline::testing {
namespace {

namespace fs = std::filesystem;

constexpr int rows = 400, block = 32;

explore::Study stored_study() {
  return small_study(rows, "[keep]\nblock = " + std::to_string(block));
}

class Watched : public ::testing::Test {
 protected:
  ~Watched() override {
    on_write = nullptr;
    is_disk_full = nullptr;
  }
  const Folder folder;
  const explore::Study study = stored_study();
};

// The number of committed rows in the file, and whether all of them are there.
std::uint64_t intact_rows(const fs::path& path) {
  const explore::StoreReader reader(path);
  EXPECT_TRUE(holds_rows(path, reader.rows()));
  return reader.rows();
}

TEST_F(Watched, IsWholeAfterEveryWriteAndInItsMiddle) {
  std::uint64_t last = 0;
  int looks = 0;
  {
    explore::StoreWriter store = new_store(folder / "a.h5", study, rows, {.commit_seconds = 0.0});
    on_write = [&] {
      ++looks;
      fs::copy_file(folder / "a.h5", folder / "copy.h5", fs::copy_options::overwrite_existing);
      const std::uint64_t found = intact_rows(folder / "copy.h5");
      EXPECT_GE(found, last);  // nothing committed is lost
      last = found;
    };
    // Rows that leave the last chunk of most commits incomplete.
    for (int done = 0; done < rows; done += 40) {
      store.append(made_up_rows(store.layout(), store.rows(), 40));
      // The writer alone may use the HDF5 library now.
      while (store.committed_rows() + std::uint64_t(block) <= store.rows()) usleep(100);
    }
    store.finish();
  }
  on_write = nullptr;
  EXPECT_EQ(intact_rows(folder / "a.h5"), std::uint64_t(rows));
  EXPECT_GT(looks, 300);
}

// Every state between two writes can be gone on with, and ends in the same rows.
TEST_F(Watched, CanBeResumedFromEveryState) {
  std::vector<fs::path> states;
  {
    explore::StoreWriter store = new_store(folder / "a.h5", study, rows, {.commit_seconds = 0.0});
    on_write = [&] {
      states.push_back(folder / ("state" + std::to_string(states.size()) + ".h5"));
      fs::copy_file(folder / "a.h5", states.back());
    };
    for (int done = 0; done < 120; done += 40) {
      store.append(made_up_rows(store.layout(), store.rows(), 40));
      while (store.committed_rows() + std::uint64_t(block) <= store.rows()) usleep(100);
    }
    store.finish();
  }
  on_write = nullptr;
  ASSERT_GT(states.size(), 100u);
  for (const fs::path& state : states) {
    explore::StoreWriter store = explore::StoreWriter::resume(state, study);
    store.append(made_up_rows(store.layout(), store.rows(), rows - int(store.rows())));
    store.finish();
    EXPECT_TRUE(holds_rows(state, rows)) << state;
    fs::remove(state);
  }
}

TEST_F(Watched, AFullDiskIsToldAndLosesNothing) {
  for (const std::size_t room : {1000u, 5000u, 20000u, 40000u}) {
    const fs::path path = folder / (std::to_string(room) + ".h5");
    std::size_t used = 0;
    std::string sentence;
    {
      explore::StoreWriter store = new_store(path, study, rows, {.commit_seconds = 0.0});
      is_disk_full = [&](std::size_t count) {
        used += count;
        return used > room;
      };
      try {
        for (int done = 0; done < rows; done += 40)
          store.append(made_up_rows(store.layout(), store.rows(), 40));
        store.finish();
      } catch (const explore::StoreError& error) {
        sentence = error.what();
      }
    }
    is_disk_full = nullptr;
    EXPECT_THAT(sentence, ::testing::HasSubstr("cannot be written: No space left on device."));
    EXPECT_LT(intact_rows(path), std::uint64_t(rows));
    explore::StoreWriter store = explore::StoreWriter::resume(path, study);
    store.append(made_up_rows(store.layout(), store.rows(), rows - int(store.rows())));
    store.finish();
    EXPECT_TRUE(holds_rows(path, rows));
  }
}

}  // namespace
}  // namespace bodyline::testing
