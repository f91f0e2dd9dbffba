#include "explore/store_writer.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "explore/store_file.hpp"
#include "explore/store_image.hpp"
#include "io/input_error.hpp"
#include "io/write_file.hpp"

namespace bodyline::explore {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t most_waiting = 16;  // blocks

// The first measured file that is another; "" when there is none.
std::string changed_file(const std::vector<MeasuredFile>& then,
                         const std::vector<MeasuredFile>& now) {
  const std::size_t count = std::max(then.size(), now.size());
  for (std::size_t k = 0; k < count; ++k) {
    if (k < then.size() && k < now.size() && then[k] == now[k]) continue;
    return k < now.size() ? now[k].name : then[k].name;
  }
  return "";
}

void check_same(const fs::path& path, const StoreHeader& header, const Study& study) {
  if (header.version != BODYLINE_VERSION) {
    throw StoreError(path, "was made by version " + header.version +
                               " of the program, and this is " + BODYLINE_VERSION +
                               "; the rows would not be alike.");
  }
  const std::size_t count = std::min(header.inputs.size(), study.inputs.size());
  for (std::size_t k = 0; k < count; ++k) {
    if (header.inputs[k].text == study.inputs[k].text) continue;
    throw StoreError(
        path, "was made from another study: \"" + study.inputs[k].name + "\" has changed since.");
  }
  if (header.inputs.size() != study.inputs.size())
    throw StoreError(path, "was made from another study.");
  if (const std::string changed = changed_file(header.files, study.files); !changed.empty())
    throw StoreError(path, "was made from other files: \"" + changed + "\" has changed since.");
}

}  // namespace

// What the writer's thread and its caller share is guarded by the mutex.
struct StoreWriter::State {
  State(std::unique_ptr<AppendFile> file, const StoreReader& reader, const StoreOptions& given);
  ~State();

  void begin_block(std::uint64_t first);
  void push(EncodedBlock block);
  void run();
  bool wait_for_work(std::unique_lock<std::mutex>& lock, Clock::time_point first_waiting);
  void throw_failure();
  void stop(bool commit_first);

  StoreLayout layout;
  StoreOptions options;
  StoreFile file;
  std::uint64_t rows = 0;  // appended; of the caller's thread
  VariantRows incomplete;  // the block in hand, `count` of its rows filled; of the caller's thread
  std::atomic<std::uint64_t> committed{0};

  std::mutex mutex;
  std::condition_variable wake, room;
  std::deque<EncodedBlock> waiting;
  bool stopping = false, commit_at_end = false;
  std::exception_ptr failure;
  std::thread thread;  // last: it uses all of the above
};

StoreWriter::State::State(std::unique_ptr<AppendFile> open, const StoreReader& reader,
                          const StoreOptions& given)
    : layout(reader.layout()), options(given), file(std::move(open), reader), rows(reader.rows()) {
  committed = rows;
  const int rest = int(rows % std::uint64_t(layout.block_rows));
  begin_block(rows - std::uint64_t(rest));
  copy_rows(layout, reader.read(incomplete.first, rest, true), 0, incomplete, 0, rest);
  incomplete.count = rest;
  thread = std::thread([this] { run(); });
}

StoreWriter::State::~State() { stop(false); }

void StoreWriter::State::begin_block(std::uint64_t first) {
  incomplete = make_rows(layout, first, layout.block_rows);
  incomplete.count = 0;
}

void StoreWriter::State::stop(bool commit_first) {
  if (!thread.joinable()) return;
  {
    const std::lock_guard lock(mutex);
    stopping = true;
    commit_at_end = commit_first;
  }
  wake.notify_one();
  thread.join();
}

void StoreWriter::State::throw_failure() {
  const std::lock_guard lock(mutex);
  if (failure) std::rethrow_exception(failure);
}

void StoreWriter::State::push(EncodedBlock block) {
  {
    std::unique_lock lock(mutex);
    room.wait(lock, [&] { return waiting.size() < most_waiting || failure; });
    if (failure) std::rethrow_exception(failure);
    waiting.push_back(std::move(block));
  }
  wake.notify_one();
}

// False when what is written shall be committed now.
bool StoreWriter::State::wait_for_work(std::unique_lock<std::mutex>& lock,
                                       Clock::time_point commit_by) {
  return wake.wait_until(lock, commit_by, [&] { return stopping || !waiting.empty(); });
}

void StoreWriter::State::run() {
  std::uint64_t written = committed;
  const auto period = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(options.commit_seconds));
  Clock::time_point commit_by = Clock::time_point::max();
  const auto commit = [&] {
    if (written != committed) file.commit(written);
    committed = written;
    commit_by = Clock::time_point::max();
  };
  try {
    std::unique_lock lock(mutex);
    while (true) {
      if (commit_by == Clock::time_point::max()) {
        wake.wait(lock, [&] { return stopping || !waiting.empty(); });
      } else if (!wait_for_work(lock, commit_by) || Clock::now() >= commit_by) {
        lock.unlock();
        commit();
        lock.lock();
        continue;
      }
      if (stopping && !commit_at_end) return;
      if (waiting.empty()) break;
      const EncodedBlock block = std::move(waiting.front());
      waiting.pop_front();
      lock.unlock();
      room.notify_one();
      file.write(block);
      if (commit_by == Clock::time_point::max()) commit_by = Clock::now() + period;
      written = block.first + std::uint64_t(block.rows);
      lock.lock();
    }
    lock.unlock();
    commit();
  } catch (...) {
    try {
      file.drop_unfinished();
    } catch (const StoreError&) {  // the first failure is the one to tell
    }
    const std::lock_guard lock(mutex);
    failure = std::current_exception();
    room.notify_all();
  }
}

StoreWriter::StoreWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
StoreWriter::~StoreWriter() = default;
StoreWriter::StoreWriter(StoreWriter&&) noexcept = default;

StoreWriter StoreWriter::create(const fs::path& path, const Study& study, const DesignSpace& space,
                                std::uint64_t planned, bool overwrite,
                                const StoreOptions& options) {
  const std::vector<std::byte> image = empty_store(study, space, planned, options.merged);
  // Of several that replace a store at once, one does, and it writes the store that it made: the
  // others meet this lock, or that of the writer, or the new file where there was none.
  std::optional<ReplaceLock> replaced;
  if (overwrite) replaced.emplace(path);
  try {
    io::write_file(path, {reinterpret_cast<const char*>(image.data()), image.size()},
                   replaced && replaced->exists() ? io::Overwrite::allowed : io::Overwrite::never);
  } catch (const io::InputError& error) {
    throw StoreError(path, error.sentence());
  }
  return open(path, study, options);
}

StoreWriter StoreWriter::resume(const fs::path& path, const Study& study,
                                const StoreOptions& options) {
  const bool merged = StoreReader(path).header().merged;  // says what is wrong with other files
  if (merged) {
    throw StoreError(path,
                     "was put together from several stores; a run cannot go on with it, but with "
                     "each of them.");
  }
  return open(path, study, options);
}

StoreWriter StoreWriter::open(const fs::path& path, const Study& study,
                              const StoreOptions& options) {
  auto file = std::make_unique<AppendFile>(path);
  const StoreReader reader(path);  // as it is now that nobody else writes
  check_same(path, reader.header(), study);
  return StoreWriter(std::make_unique<State>(std::move(file), reader, options));
}

const StoreLayout& StoreWriter::layout() const { return state_->layout; }
std::uint64_t StoreWriter::committed_rows() const { return state_->committed; }
std::uint64_t StoreWriter::rows() const { return state_->rows; }

VariantRows StoreWriter::take_incomplete_block() {
  VariantRows rows = std::move(state_->incomplete);
  state_->rows = rows.first;
  state_->begin_block(rows.first);
  return rows;
}

void StoreWriter::append(EncodedBlock block) {
  state_->rows = block.first + std::uint64_t(block.rows);
  state_->begin_block(state_->rows);
  state_->push(std::move(block));
}

void StoreWriter::append(const VariantRows& rows) {
  VariantRows& block = state_->incomplete;
  const int whole = state_->layout.block_rows;
  for (int taken = 0; taken < rows.count;) {
    const int count = std::min(whole - block.count, rows.count - taken);
    copy_rows(state_->layout, rows, taken, block, block.count, count);
    taken += count;
    block.count += count;
    state_->rows += std::uint64_t(count);
    if (block.count < whole) continue;
    state_->push(encode_block(state_->layout, block));
    state_->begin_block(state_->rows);
  }
  state_->throw_failure();
}

void StoreWriter::flush() {
  if (state_->incomplete.count > 0) state_->push(encode_block(state_->layout, state_->incomplete));
}

void StoreWriter::finish() {
  flush();
  state_->stop(true);
  state_->throw_failure();
}

}  // namespace bodyline::explore
