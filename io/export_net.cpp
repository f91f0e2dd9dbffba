#include "io/export_net.hpp"

#include <nlohmann/json.hpp>

#include "io/export_extension.hpp"
#include "io/export_step.hpp"
#include "io/mesh_files.hpp"
#include "io/net_mesh.hpp"
#include "io/net_shell.hpp"

namespace bodyline::io {
namespace {

using Json = nlohmann::ordered_json;

std::string cad_text(const std::string& extension, const model::FaceNet& net,
                     ExportReport& report) {
  std::vector<std::string> names;
  for (const model::NetFace& face : net.faces) names.push_back(face.surface.name);
  const QuietCad quiet;
  const CadShell shell = make_shell(net);
  const bool iges = extension == ".iges" || extension == ".igs";
  CadFile file = iges ? iges_file(shell, names, net.name) : step_file(shell, names, net.name);
  report.max_deviation_mm = file.max_deviation_mm;
  report.not_polynomial = std::move(file.not_polynomial);
  return std::move(file.text);
}

Json point_json(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

Json face_json(const model::SplineFace& face) {
  Json net = Json::array();
  for (int i = 0; i < face.count_u(); ++i) {
    Json row = Json::array();
    for (int j = 0; j < face.count_v(); ++j) row.push_back(point_json(face.point(i, j)));
    net.push_back(std::move(row));
  }
  Json json{{"degree", {face.degree_u, face.degree_v}},
            {"breaks", {face.breaks_u, face.breaks_v}},
            {"net", std::move(net)}};
  if (face.blend) json["blend"] = point_json(*face.blend);
  return json;
}

}  // namespace

ExportReport export_net(const model::FaceNet& net, const std::filesystem::path& path,
                        const ExportOptions& options, const std::string& json) {
  const std::string extension = known_extension(path);
  refuse_existing(path, options.overwrite);
  ExportReport report;
  report.faces = static_cast<int>(net.faces.size());
  std::string text;
  if (extension == ".json") {
    text = json;
  } else if (is_cad(extension)) {
    text = cad_text(extension, net, report);
  } else {
    const Mesh mesh = make_mesh(net, {.tolerance_mm = options.tolerance_mm});
    report.max_deviation_mm = mesh.max_deviation_mm;
    report.triangles = static_cast<long>(mesh.triangles.size());
    text = mesh_file(mesh, extension);
  }
  write_file(path, text, options.overwrite);
  return report;
}

std::string net_json_text(const model::FaceNet& net) {
  Json json{{"name", net.name}, {"faces", Json::object()}, {"edges", Json::array()}};
  for (const model::NetFace& face : net.faces)
    json["faces"][face.surface.name] = face_json(face.surface);
  for (const model::NetEdge& edge : net.edges) {
    Json points = Json::array();
    for (const Eigen::Vector3d& p : edge.curve.points) points.push_back(point_json(p));
    json["edges"].push_back({{"degree", edge.curve.degree},
                             {"breaks", edge.curve.breaks},
                             {"points", std::move(points)}});
  }
  return json.dump();
}

}  // namespace bodyline::io
