#include <filesystem>

#include "cli/output.hpp"
#include "cli/space_views.hpp"
#include "explore/merge_stores.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::vector<std::string> others;
  Output output;
};

void run(Context& context, const Request& request, const std::string& path) {
  check_output(request.output, path, {".h5", ".hdf5"});
  std::vector<std::filesystem::path> all{path};
  all.insert(all.end(), request.others.begin(), request.others.end());
  explore::merge_stores(all, request.output.path, request.output.overwrite);
  *context.out << "store: " << request.output.path << "\n";
}

}  // namespace

void add_space_merge(CLI::App& space, Context& context, const StorePath& store) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_view(space, "merge", "Put the variants of several stores of one kind into a new one",
               "bodyline space first.h5 merge second.h5 third.h5 -o all.h5");
  command->add_option("OTHERS", request->others, "Further stores")->required()->type_name("");
  add_output(*command, request->output, "Store of all variants, .h5");
  command->callback([request, store, &context] { run(context, *request, *store); });
}

}  // namespace bodyline::cli
