#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/output.hpp"
#include "cli/print_json.hpp"
#include "cli/space_rows.hpp"
#include "cli/space_views.hpp"
#include "io/write_model.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::uint64_t id = 0;
  Output output;
  bool json = false;
};

void show(Context& context, const Request& request, const std::string& path) {
  const explore::StoreReader store(path);
  check_id(store, request.id);
  if (request.json) {
    print_json(context, variant_json(store, request.id));
    return;
  }
  std::string text = variants_text(store, {request.id});
  const explore::VariantRows one = store.read(request.id, 1);
  std::size_t width = 8;
  for (const explore::Column& column : store.space().columns())
    width = std::max(width, column.name.size());
  text += fmt::format("\n{:<{}}  {:>13}  {:>12}  {:>12}  {:>12}\n", "variable", width, "value",
                      "start", "lower", "upper");
  for (std::size_t k = 0; k < one.values.size(); ++k) {
    const explore::Column& column = store.space().columns()[k];
    text += fmt::format("{:<{}}  {:>13.8g}  {:>12.6g}  {:>12.6g}  {:>12.6g}\n", column.name, width,
                        one.values[k], column.start, column.lower, column.upper);
  }
  *context.out << text;
}

void write(Context& context, const Request& request, const std::string& path) {
  check_output(request.output, path, {".toml"});
  const explore::StoreReader store(path);
  check_id(store, request.id);
  const std::string name = fmt::format("{} variant {}", store.study().name, request.id);
  const explore::VariantRows one = store.read(request.id, 1);
  io::write_model(store.space().variant(one.values, name), request.output.path,
                  request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
  *context.out << fmt::format("variant {}: {}\n", request.id, request.output.path);
}

void add_id(CLI::App& command, Request& request) {
  command.add_option("ID", request.id, "Number of the variant, from 0")->required()->type_name("");
}

}  // namespace

void add_space_show(CLI::App& space, Context& context, const StorePath& store) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_view(space, "show", "Show all numbers of a variant", "bodyline space sweep.h5 show 17");
  add_id(*command, *request);
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, store, &context] { show(context, *request, *store); });
}

void add_space_model(CLI::App& space, Context& context, const StorePath& store) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command = add_view(space, "model", "Write a variant as a model",
                                     "bodyline space sweep.h5 model 17 -o car.toml");
  add_id(*command, *request);
  add_output(*command, request->output, "Model, .toml");
  command->callback([request, store, &context] { write(context, *request, *store); });
}

}  // namespace bodyline::cli
