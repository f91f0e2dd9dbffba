#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

#include "store_support.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

using explore::Study;

constexpr int rows = 1000;

Study stored_study(const std::string& keep) { return small_study(rows, "[keep]\n" + keep); }

void append_made_up(explore::StoreWriter& store, int count, int at_once) {
  for (int done = 0; done < count; done += at_once)
    store.append(made_up_rows(store.layout(), store.rows(), std::min(at_once, count - done)));
}

std::string sentence_of(const fs::path& path) {
  try {
    explore::StoreReader reader(path);
    reader.read(0, int(reader.rows()), true);
  } catch (const explore::StoreError& error) {
    return error.what();
  }
  return "";
}

std::string resume_sentence(const fs::path& path, const Study& study) {
  try {
    explore::StoreWriter::resume(path, study);
  } catch (const explore::StoreError& error) {
    return error.what();
  }
  return "";
}

class EveryLayout : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryLayout, KeepsEveryRow) {
  const Folder folder;
  const Study study = stored_study(GetParam());
  {
    explore::StoreWriter store = new_store(folder / "a.h5", study, rows);
    append_made_up(store, rows, 37);
    store.finish();
    EXPECT_EQ(store.committed_rows(), std::uint64_t(rows));
  }
  EXPECT_TRUE(holds_rows(folder / "a.h5", rows));
}

TEST_P(EveryLayout, GoesOnWhereItStopped) {
  const Folder folder;
  const Study study = stored_study(GetParam());
  int written = 0;
  for (const int part : {1, 63, 64, 100, 1, 500}) {
    explore::StoreWriter store = written == 0
                                     ? new_store(folder / "a.h5", study, rows)
                                     : explore::StoreWriter::resume(folder / "a.h5", study);
    EXPECT_EQ(store.rows(), std::uint64_t(written));
    append_made_up(store, part, 29);
    store.finish();
    written += part;
    EXPECT_TRUE(holds_rows(folder / "a.h5", std::uint64_t(written)));
  }
}

INSTANTIATE_TEST_SUITE_P(Each, EveryLayout,
                         ::testing::Values("block = 64", "block = 64\ncompressed = false",
                                           "block = 128\nnets = true", "block = 1", "block = 4096"),
                         [](const auto& test) { return "layout" + std::to_string(test.index); });

// More than 64 x 64 chunks: the index has three levels.
TEST(Store, KeepsManyBlocks) {
  constexpr int many = 4500;
  const Folder folder;
  const Study study = stored_study("block = 1");
  {
    explore::StoreWriter store = new_store(folder / "a.h5", study, many, {.commit_seconds = 0.01});
    append_made_up(store, many / 2, 1);
    store.finish();
  }
  {
    explore::StoreWriter store = explore::StoreWriter::resume(folder / "a.h5", study);
    append_made_up(store, many - many / 2, 1000);
    store.finish();
  }
  EXPECT_TRUE(holds_rows(folder / "a.h5", many));
}

TEST(Store, WithoutAnEndKeepsWhatWasCommitted) {
  const Folder folder;
  const Study study = stored_study("block = 64");
  std::uint64_t committed = 0;
  {
    explore::StoreWriter store = new_store(folder / "a.h5", study, rows, {.commit_seconds = 0.0});
    append_made_up(store, 640, 64);
    while (store.committed_rows() == 0) std::this_thread::yield();
    committed = store.committed_rows();
  }
  const explore::StoreReader reader(folder / "a.h5");
  EXPECT_GE(reader.rows(), committed);
  EXPECT_TRUE(holds_rows(folder / "a.h5", reader.rows()));
}

TEST(Store, OfTheSameStudyHasTheSameBytes) {
  const Folder folder;
  const auto make = [&](const std::string& name) {
    explore::StoreWriter store =
        new_store(folder / name, stored_study("nets = true"), rows, {.commit_seconds = 1e6});
    append_made_up(store, rows, 100);
    store.finish();
    std::ifstream stream(folder / name, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(stream), {}};
  };
  EXPECT_EQ(make("a.h5"), make("b.h5"));
}

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

// A program of someone else's may have put a table there whose numbers are wider.
TEST(Store, RefusesATableWithOtherNumbers) {
  const Folder folder;
  {
    explore::StoreWriter store = new_store(folder / "a.h5", stored_study("block = 64"), rows);
    append_made_up(store, rows, 100);
    store.finish();
  }
  const hid_t file = H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Ldelete(file, "status", H5P_DEFAULT);
  const hsize_t extent = rows;
  const hid_t space = H5Screate_simple(1, &extent, nullptr);
  H5Dclose(H5Dcreate2(file, "status", H5T_STD_U64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  H5Sclose(space);
  H5Fclose(file);
  EXPECT_THAT(sentence_of(folder / "a.h5"), HasSubstr("the dataset status has other numbers"));
}

TEST(Store, IsNotReplacedUnlessAsked) {
  const Folder folder;
  const Study study = stored_study("block = 64");
  new_store(folder / "a.h5", study, rows).finish();
  EXPECT_THROW(new_store(folder / "a.h5", study, rows), explore::StoreError);
  const explore::DesignSpace space(study);
  explore::StoreWriter::create(folder / "a.h5", study, space, 7, true).finish();
  EXPECT_EQ(explore::StoreReader(folder / "a.h5").header().planned, 7u);
}

TEST(Store, GoesOnWithItsOwnStudyOnly) {
  const Folder folder;
  new_store(folder / "a.h5", stored_study("block = 64"), rows).finish();
  try {
    explore::StoreWriter::resume(folder / "a.h5", stored_study("block = 32"));
    FAIL() << "another study";
  } catch (const explore::StoreError& error) {
    EXPECT_THAT(error.what(), HasSubstr("was made from another study: \"study.toml\" has changed"));
  }
}

TEST(Store, GoesOnWithItsOwnScansOnly) {
  const Folder folder;
  Study study = stored_study("block = 64");
  study.files = {{"a.xyz", 9, "995dc9bbdf1939fa"}, {"b.svg", 1ull << 40, "0123456789abcdef"}};
  new_store(folder / "a.h5", study, rows).finish();
  EXPECT_EQ(explore::StoreReader(folder / "a.h5").header().files, study.files);
  explore::StoreWriter::resume(folder / "a.h5", study).finish();
  const std::vector<explore::MeasuredFile> same = study.files;
  study.files[1].digest[0] = '1';
  EXPECT_THAT(resume_sentence(folder / "a.h5", study), HasSubstr("\"b.svg\" has changed since"));
  study.files = same;
  ++study.files[0].bytes;
  EXPECT_THAT(resume_sentence(folder / "a.h5", study), HasSubstr("\"a.xyz\" has changed since"));
  study.files = {same[0]};
  EXPECT_THAT(resume_sentence(folder / "a.h5", study), HasSubstr("\"b.svg\" has changed since"));
}

TEST(Store, GivesItsStudyBack) {
  const Folder folder;
  const Study study = stored_study("block = 64\nnets = true");
  new_store(folder / "a.h5", study, rows).finish();
  const explore::StoreReader reader(folder / "a.h5");
  EXPECT_EQ(reader.study().inputs.front().text, study.inputs.front().text);
  EXPECT_EQ(reader.study().name, "test");
  EXPECT_EQ(reader.space().column_count(), explore::DesignSpace(study).column_count());
  EXPECT_EQ(reader.header().planned, std::uint64_t(rows));
  EXPECT_THAT(reader.header().causes, ::testing::Contains("hood__windshield"));
}

TEST(Store, SaysWhatIsWrongWithAFile) {
  const Folder folder;
  EXPECT_THAT(sentence_of(folder / "none.h5"), HasSubstr("does not exist."));
  EXPECT_THAT(sentence_of(folder.path()), HasSubstr("is no file."));
  std::ofstream(folder / "text.h5") << "Dear Sir or Madam, this is no store at all.";
  EXPECT_THAT(sentence_of(folder / "text.h5"), HasSubstr("is no HDF5 file."));
  std::ofstream(folder / "empty.h5").flush();
  EXPECT_THAT(sentence_of(folder / "empty.h5"), HasSubstr("is no HDF5 file."));
  EXPECT_THROW(explore::StoreWriter::resume(folder / "text.h5", stored_study("")),
               explore::StoreError);
}

// Whatever its length, a store that was cut off is refused with a sentence.
TEST(Store, SaysThatItIsCutOff) {
  const Folder folder;
  {
    explore::StoreWriter store = new_store(folder / "a.h5", stored_study("block = 64"), rows);
    append_made_up(store, rows, 100);
    store.finish();
  }
  const std::uintmax_t size = fs::file_size(folder / "a.h5");
  for (const double part : {0.0001, 0.01, 0.3, 0.7, 0.99, 0.99999}) {
    fs::copy_file(folder / "a.h5", folder / "cut.h5", fs::copy_options::overwrite_existing);
    fs::resize_file(folder / "cut.h5", std::uintmax_t(part * double(size)));
    EXPECT_THAT(sentence_of(folder / "cut.h5"),
                ::testing::AnyOf(HasSubstr("is cut off"), HasSubstr("is no HDF5 file")));
    EXPECT_THROW(explore::StoreWriter::resume(folder / "cut.h5", stored_study("block = 64")),
                 explore::StoreError);
  }
}

// Bytes that are overwritten anywhere give a sentence or, where they do not matter, the rows.
TEST(Store, SurvivesDamage) {
  const Folder folder;
  {
    explore::StoreWriter store = new_store(folder / "a.h5", stored_study("block = 64"), rows);
    append_made_up(store, rows, 100);
    store.finish();
  }
  const std::uintmax_t size = fs::file_size(folder / "a.h5");
  for (int n = 0; n < 200; ++n) {
    fs::copy_file(folder / "a.h5", folder / "bad.h5", fs::copy_options::overwrite_existing);
    {
      std::fstream stream(folder / "bad.h5", std::ios::in | std::ios::out | std::ios::binary);
      stream.seekp(std::streamoff(size * std::uintmax_t(n) / 200));
      for (int k = 0; k < 16; ++k) stream.put(char(n * 37 + k * 11));
    }
    const std::string sentence = sentence_of(folder / "bad.h5");
    EXPECT_THAT(sentence, ::testing::AnyOf(::testing::IsEmpty(), HasSubstr("bad.h5: ")));
  }
}

}  // namespace
}  // namespace bodyline::testing
