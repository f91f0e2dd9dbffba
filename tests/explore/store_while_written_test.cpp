// A store that is read, or written by another program, while it is written (docs/store.md).

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "store_support.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

using ::testing::HasSubstr;

using explore::Study;

constexpr int rows = 1000;

Study stored_study(const std::string& keep) { return small_study(rows, "[keep]\n" + keep); }

TEST(Store, HasOneWriter) {
  const Folder folder;
  const Study study = stored_study("block = 64");
  explore::StoreWriter store = new_store(folder / "a.h5", study, rows);
  try {
    explore::StoreWriter::resume(folder / "a.h5", study);
    FAIL() << "a second writer";
  } catch (const explore::StoreError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.h5: is being written by another program"));
  }
  const explore::DesignSpace space(study);
  EXPECT_THROW(explore::StoreWriter::create(folder / "a.h5", study, space, rows, true),
               explore::StoreError);
  append_made_up(store, rows, 100);
  store.finish();
  EXPECT_TRUE(holds_rows(folder / "a.h5", rows));
}

TEST(Store, CanBeReadWhileItIsWritten) {
  const Folder folder;
  const Study study = stored_study("block = 64");
  explore::StoreWriter store = new_store(folder / "a.h5", study, rows, {.commit_seconds = 0.0});
  std::uint64_t seen = 0;
  for (int block = 0; block < 8; ++block) {
    append_made_up(store, 64, 64);
    while (store.committed_rows() < store.rows()) std::this_thread::yield();
    const explore::StoreReader reader(folder / "a.h5");
    EXPECT_GT(reader.rows(), seen);
    seen = reader.rows();
    EXPECT_TRUE(holds_rows(folder / "a.h5", seen));
  }
}

// A reader that opened the file before goes on seeing what was there then.
TEST(Store, AReaderKeepsWhatItSaw) {
  const Folder folder;
  const Study study = stored_study("block = 64");
  explore::StoreWriter store = new_store(folder / "a.h5", study, rows, {.commit_seconds = 0.0});
  append_made_up(store, 128, 64);
  while (store.committed_rows() < 128) std::this_thread::yield();
  const explore::StoreReader reader(folder / "a.h5");
  append_made_up(store, 512, 64);
  while (store.committed_rows() < 640) std::this_thread::yield();
  EXPECT_EQ(reader.rows(), 128u);
  EXPECT_TRUE(same_rows(reader.read(0, 128, true), made_up_rows(reader.layout(), 0, 128)));
}

// Commits follow each other without a pause, and the file is opened in their midst.
TEST(Store, CanBeOpenedInTheMiddleOfACommit) {
  constexpr int many = 6400, looks = 60;
  const Folder folder;
  const Study study = stored_study("block = 64");
  explore::StoreWriter store = new_store(folder / "a.h5", study, many, {.commit_seconds = 0.0});
  std::atomic<bool> enough{false};
  std::thread writer([&] {
    while (!enough && store.rows() < many) {
      append_made_up(store, 64, 64);
      while (store.committed_rows() < store.rows()) std::this_thread::yield();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  });
  std::string sentence;
  for (int look = 0; look < looks && sentence.empty(); ++look) {
    try {
      const explore::StoreReader reader(folder / "a.h5");
      const int seen = int(reader.rows());
      if (!same_rows(reader.read(0, seen, true), made_up_rows(reader.layout(), 0, seen)))
        sentence = "other rows";
    } catch (const std::exception& error) {
      sentence = error.what();
    }
  }
  enough = true;
  writer.join();
  EXPECT_EQ(sentence, "");
}

// A reader that goes on long after it opened the file, as the snippet of docs/store.md has it.
TEST(Store, CanBeFollowedWithAnHdf5Library) {
  const Folder folder;
  const Study study = stored_study("block = 64");
  explore::StoreWriter store = new_store(folder / "a.h5", study, rows, {.commit_seconds = 0.0});
  append_made_up(store, 128, 64);
  while (store.committed_rows() < 128) std::this_thread::yield();
  const hid_t file = H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t metrics = H5Dopen2(file, "metrics", H5P_DEFAULT);
  append_made_up(store, 512, 64);
  while (store.committed_rows() < 640) std::this_thread::yield();
  const int width = int(study.metrics.size());
  std::vector<double> found(std::size_t(128 * width));
  const hid_t selected = H5Dget_space(metrics);
  const hsize_t start[]{0, 0}, count[]{128, hsize_t(width)};
  H5Sselect_hyperslab(selected, H5S_SELECT_SET, start, nullptr, count, nullptr);
  const hid_t memory = H5Screate_simple(2, count, nullptr);
  EXPECT_GE(H5Dread(metrics, H5T_NATIVE_DOUBLE, memory, selected, H5P_DEFAULT, found.data()), 0);
  EXPECT_EQ(found, made_up_rows(store.layout(), 0, 128).metrics);
  H5Sclose(memory);
  H5Sclose(selected);
  H5Dclose(metrics);
  H5Fclose(file);
}

}  // namespace
}  // namespace bodyline::testing
