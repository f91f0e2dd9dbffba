#include <sqlite3.h>

#include <memory>
#include <stdexcept>

#include "bench/peers/store_peers.hpp"

namespace bodyline::bench {
namespace {

void check(int code) {
  if (code != SQLITE_OK && code != SQLITE_DONE) throw std::runtime_error(sqlite3_errstr(code));
}

struct Close {
  void operator()(sqlite3* base) const { sqlite3_close(base); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

void run(sqlite3* base, const std::string& text) {
  check(sqlite3_exec(base, text.c_str(), nullptr, nullptr, nullptr));
}

}  // namespace

void write_sqlite(const std::filesystem::path& path, SqliteWay way, int columns,
                  std::span<const double> rows) {
  sqlite3* opened = nullptr;
  check(sqlite3_open(path.c_str(), &opened));
  const std::unique_ptr<sqlite3, Close> base(opened);
  if (way == SqliteWay::one_by_one_unsafe) run(opened, "PRAGMA synchronous = OFF");
  std::string names, marks;
  for (int k = 0; k < columns; ++k) {
    names += (k ? ", c" : "c") + std::to_string(k) + " REAL";
    marks += k ? ",?" : "?";
  }
  run(opened, "CREATE TABLE variants (" + names + ")");
  sqlite3_stmt* prepared = nullptr;
  check(sqlite3_prepare_v2(opened, ("INSERT INTO variants VALUES (" + marks + ")").c_str(), -1,
                           &prepared, nullptr));
  const std::unique_ptr<sqlite3_stmt, Close> insert(prepared);
  if (way == SqliteWay::bulk) run(opened, "BEGIN");
  for (std::size_t first = 0; first < rows.size(); first += std::size_t(columns)) {
    for (int k = 0; k < columns; ++k)
      check(sqlite3_bind_double(prepared, k + 1, rows[first + std::size_t(k)]));
    check(sqlite3_step(prepared));
    check(sqlite3_reset(prepared));
  }
  if (way == SqliteWay::bulk) run(opened, "COMMIT");
}

}  // namespace bodyline::bench
