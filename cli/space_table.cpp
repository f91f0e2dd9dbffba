#include <fmt/format.h>

#include <filesystem>

#include "cli/output.hpp"
#include "cli/space_views.hpp"
#include "explore/variant_table.hpp"
#include "io/file_stream.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  VariantChoice choice;
  Output output;
};

void run(Context& context, const Request& request, const std::string& path) {
  check_output(request.output, path, {".csv"});
  const explore::StoreReader store(path);
  const explore::VariantFilter filter(store, request.choice.where, request.choice.status);
  std::filesystem::path images = request.output.path;
  images.replace_extension();
  images += "_images";
  io::FileStream table(request.output.path,
                       request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
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
