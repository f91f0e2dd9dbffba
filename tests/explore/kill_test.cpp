// A run is killed (kill -9) at random moments, in a process of its own, and gone on with.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "explore/philox.hpp"
#include "explore/run_study.hpp"
#include "store_support.hpp"
#include "study_support.hpp"

namespace bodyline::testing {
namespace {

namespace fs = std::filesystem;

constexpr int rows = 20000, kills = 200;

explore::Study killed_study() { return small_study(rows, "[keep]\nblock = 64"); }

// The whole study, or what is left of it.
void run(const fs::path& path, bool resume) {
  const explore::Study study = killed_study();
  const auto plan = std::make_shared<explore::VariantPlan>(study);
  const auto source = explore::make_source(plan->study, plan->space);
  const explore::StoreOptions often{.commit_seconds = 0.0};
  explore::StoreWriter store =
      resume ? explore::StoreWriter::resume(path, study, often)
             : explore::StoreWriter::create(path, study, plan->space, rows, false, often);
  explore::RunOptions options;
  options.threads = 2;
  explore::run_study(plan, *source, store, options);
  store.finish();
}

pid_t start(const fs::path& path, bool resume) {
  const pid_t child = fork();
  if (child != 0) return child;
  try {
    run(path, resume);
  } catch (...) {
    _exit(1);
  }
  _exit(0);
}

// How a child came to its end: anything else than the first two is a failure of the run.
enum class End { finished, killed, failed };

End end_of(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return End::finished;
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL ? End::killed : End::failed;
}

// Opens a store with h5py and h5dump; prints the committed rows and a digest of them.
constexpr const char* script = R"(
import hashlib, subprocess, sys
import h5py, numpy
whole = h5py.File(sys.argv[1], 'r')
tables = ['variables', 'metrics', 'status', 'cause']
data = {name: whole[name][:] for name in tables}
assert whole['committed_rows'][()] == len(data['variables']) == whole.attrs['planned_rows']
assert list(whole['metrics'].dims[1]['name'][:]) == [b'bending', b'height']
assert whole['variables'].dims[1]['unit'][0] in (b'mm', b'1')
for path in sys.argv[2:]:
    with h5py.File(path, 'r') as store:
        rows = store['committed_rows'][()]
        for name in tables:
            assert store[name].shape[0] >= rows, path
            assert store[name][:rows].tobytes() == data[name][:rows].tobytes(), (path, name)
    for what in (['-H'], ['-d', '/status']):
        subprocess.run(['h5dump'] + what + [path], check=True, stdout=subprocess.DEVNULL)
print('fine')
)";

TEST(Kill, AtAnyMomentLosesNothingCommittedAndCanBeResumed) {
  const Folder folder;
  ASSERT_EQ(end_of(start(folder / "whole.h5", false)), End::finished);
  const explore::VariantRows whole = all_rows(folder / "whole.h5");
  ASSERT_EQ(whole.count, rows);

  const explore::PlacedRandom random(17, 99);
  const fs::path killed = folder / "killed.h5";
  std::string copies;
  std::uint64_t committed = 0;
  int moments = 0, runs = 0;
  for (int kill_number = 0; moments < kills; ++kill_number) {
    const bool resume = fs::exists(killed);
    if (!resume) committed = 0;
    const pid_t child = start(killed, resume);
    // Up to 60 ms: from before the store is there to the middle of the work.
    usleep(unsigned(60000.0 * random.uniform(std::uint64_t(kill_number), 0)[0]));
    ::kill(child, SIGKILL);
    const End end = end_of(child);
    ASSERT_NE(end, End::failed) << "a run that was not killed did not finish";
    if (!fs::exists(killed)) continue;
    ++moments;
    const explore::StoreReader reader(killed);
    EXPECT_GE(reader.rows(), committed);
    committed = reader.rows();
    const explore::VariantRows found = reader.read(0, int(committed));
    const std::size_t columns = found.values.size() / std::max<std::size_t>(1, committed);
    EXPECT_TRUE(std::equal(found.metrics.begin(), found.metrics.end(), whole.metrics.begin()));
    EXPECT_TRUE(std::equal(found.values.begin(), found.values.end(), whole.values.begin()))
        << columns;
    const fs::path copy = folder / (std::to_string(moments) + ".h5");
    fs::copy_file(killed, copy);
    copies += " " + copy.string();
    if (end == End::killed) continue;
    EXPECT_TRUE(same_rows(all_rows(killed), whole));
    fs::remove(killed);
    ++runs;
  }
  // At last without a kill.
  ASSERT_EQ(end_of(start(killed, fs::exists(killed))), End::finished);
  EXPECT_TRUE(same_rows(all_rows(killed), whole));

  std::ofstream(folder / "look.py") << script;
  const std::string command = "/usr/bin/python3 " + (folder / "look.py").string() + " " +
                              (folder / "whole.h5").string() + copies;
  EXPECT_EQ(std::system(command.c_str()), 0) << "h5py and h5dump";
}

}  // namespace
}  // namespace bodyline::testing
