#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cli/output.hpp"
#include "cli/space_pareto.hpp"
#include "cli/space_rows.hpp"
#include "cli/space_views.hpp"
#include "io/scatter_plot.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  VariantChoice choice;
  Objectives front;
  std::string x, y;
  Output output;
  bool log_x = false, log_y = false;
};

std::string label(const explore::StoreReader& store, const std::string& name) {
  const explore::StoreColumn column = explore::store_column(store, name);
  const std::string unit = column.is_metric
                               ? explore::metric_unit(store.study().metrics[column.index].kind)
                               : store.space().columns()[column.index].unit;
  return unit == "1" ? name : name + ", " + unit;
}

// Points by status, the valid ones on top.
std::vector<io::ScatterSeries> status_series(const explore::StoreReader& store,
                                             const Request& request) {
  const explore::StoreColumn x = explore::store_column(store, request.x),
                             y = explore::store_column(store, request.y);
  std::map<std::uint8_t, io::ScatterSeries> by_status;
  const explore::VariantFilter filter(store, request.choice.where, request.choice.status);
  explore::for_each_variant(store, filter, [&](const explore::VariantRows& rows, int row) {
    io::ScatterSeries& series = by_status[rows.status[row]];
    series.x.push_back(x.of(rows, row));
    series.y.push_back(y.of(rows, row));
  });
  std::vector<io::ScatterSeries> list;
  for (auto& [status, series] : by_status) {
    series.name = explore::status_name(explore::VariantStatus(status));
    series.color = status == 0 ? 1 : status == 1 ? 0 : status;
    list.insert(list.begin(), std::move(series));
  }
  return list;
}

io::ScatterSeries front_series(const explore::StoreReader& store, const Request& request) {
  io::ScatterSeries front;
  front.name = "no other is better";
  front.color = 7;
  front.radius = 3.5;
  const explore::StoreColumn x = explore::store_column(store, request.x),
                             y = explore::store_column(store, request.y);
  for (const std::uint64_t id : pareto_ids(store, request.choice, request.front)) {
    const explore::VariantRows one = store.read(id, 1);
    front.x.push_back(x.of(one, 0));
    front.y.push_back(y.of(one, 0));
  }
  return front;
}

void run(Context& context, Request request, const std::string& path) {
  check_output(request.output, path, {".png", ".svg"});
  const explore::StoreReader store(path);
  take_goals(store, request.front);
  io::ScatterPlot plot;
  plot.x_label = label(store, request.x);
  plot.y_label = label(store, request.y);
  plot.log_x = request.log_x;
  plot.log_y = request.log_y;
  plot.series = status_series(store, request);
  if (request.front.minimize.size() + request.front.maximize.size() > 1)
    plot.series.push_back(front_series(store, request));
  io::write_scatter_plot(plot, request.output.path,
                         request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
  *context.out << "plot: " << request.output.path << "\n";
}

}  // namespace

void add_space_plot(CLI::App& space, Context& context, const StorePath& store) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_view(space, "plot", "Draw one column over another",
               "bodyline space sweep.h5 plot height bending -o plot.png --minimize height,bending");
  command->add_option("X", request->x, "Metric or variable to the right")
      ->required()
      ->type_name("");
  command->add_option("Y", request->y, "Metric or variable upright")->required()->type_name("");
  add_output(*command, request->output, "Plot, .png or .svg");
  add_variant_choice(*command, request->choice);
  add_objectives(*command, request->front);
  command->add_flag("--log-x", request->log_x, "Logarithmic axis");
  command->add_flag("--log-y", request->log_y, "Logarithmic axis");
  command->callback([request, store, &context] { run(context, *request, *store); });
}

}  // namespace bodyline::cli
