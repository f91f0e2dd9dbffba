// Files that are no store, or no longer one (docs/store.md).

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <fstream>

#include "store_support.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

using explore::Study;

constexpr int rows = 1000;

Study stored_study(const std::string& keep) { return small_study(rows, "[keep]\n" + keep); }

std::string sentence_of(const fs::path& path) {
  try {
    explore::StoreReader reader(path);
    reader.read(0, int(reader.rows()), true);
  } catch (const explore::StoreError& error) {
    return error.what();
  }
  return "";
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

// A store with all its rows; its size in bytes.
std::uintmax_t finished_store(const fs::path& path) {
  {
    explore::StoreWriter store = new_store(path, stored_study("block = 64"), rows);
    append_made_up(store, rows, 100);
    store.finish();
  }
  return fs::file_size(path);
}

// Whatever its length, a store that was cut off is refused with a sentence.
TEST(Store, SaysThatItIsCutOff) {
  const Folder folder;
  const std::uintmax_t size = finished_store(folder / "a.h5");
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
  const std::uintmax_t size = finished_store(folder / "a.h5");
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
