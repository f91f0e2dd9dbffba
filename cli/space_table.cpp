#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "cli/output.hpp"
#include "cli/space_views.hpp"
#include "explore/variant_table.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  VariantChoice choice;
  Output output;
};

// A file that gets its name when it is complete; it may be larger than the memory.
class GrowingFile {
 public:
  explicit GrowingFile(const std::filesystem::path& path)
      : path_(path), temporary_(path.string() + ".part"), stream_(temporary_) {}
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile() {
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
  }

  std::ostream& stream() { return stream_; }
  void finish() {
    stream_.close();
    if (!stream_) throw std::runtime_error(path_.string() + ": cannot be written.");
    std::filesystem::rename(temporary_, path_);
  }

 private:
  std::filesystem::path path_, temporary_;
  std::ofstream stream_;
};

void run(Context& context, const Request& request, const std::string& path) {
  check_output(request.output, path, {".csv"});
  const explore::StoreReader store(path);
  const explore::VariantFilter filter(store, request.choice.where, request.choice.status);
  std::filesystem::path images = request.output.path;
  images.replace_extension();
  images += "_images";
  GrowingFile table(request.output.path);
  const std::uint64_t count = explore::write_variant_table(store, filter, table.stream(), images);
  table.finish();
  *context.out << fmt::format("{} variants: {}\n", count, request.output.path);
}

}  // namespace

void add_space_table(CLI::App& space, Context& context, const StorePath& store) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_view(space, "table", "Write variants as CSV, for Design Explorer, HiPlot, spreadsheets",
               "bodyline space sweep.h5 table -o sweep.csv --where 'bending<=4000'");
  add_variant_choice(*command, request->choice);
  add_output(*command, request->output, "Table, .csv");
  command->callback([request, store, &context] { run(context, *request, *store); });
}

}  // namespace bodyline::cli
