// What a store of variants keeps, and with what it goes on (docs/store.md).

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace bodyline::testing
