#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "io/read_model.hpp"
#include "model/build.hpp"

/// Prints nets (with the coefficient of a Gregory term at the end), points, normals and mean
/// curvatures (mm, 1/m) of all faces of a model on a grid, as the library evaluates them, for the
/// test of the page's evaluation: face_points MODEL CELLS. Normals and curvatures are taken as far
/// inside a face as the page takes them.
int main(int argc, char** argv) {
  using namespace bodyline;
  if (argc != 3) return 2;
  constexpr double inset = 1e-3, mm_per_m = 1e3;
  const int cells = std::stoi(argv[2]);
  nlohmann::json faces = nlohmann::json::array();
  for (const model::Surface& face :
       model::build(io::read_model(argv[1]), model::Stage::body, model::Halves::left_and_central)) {
    nlohmann::json points, normals, curvatures, net;
    for (const Eigen::Vector3d& point : face.net) net.push_back({point.x(), point.y(), point.z()});
    if (face.blend) net.push_back({face.blend->x(), face.blend->y(), face.blend->z()});
    for (int k = 0; k < (cells + 1) * (cells + 1); ++k) {
      const int i = k / (cells + 1), j = k % (cells + 1);
      const double u = double(i) / cells, v = double(j) / cells;
      const Eigen::Vector3d point = model::jet(face, u, v, 0).d[0];
      points.push_back({point.x(), point.y(), point.z()});
      const double s = std::clamp(u, inset, 1.0 - inset), t = std::clamp(v, inset, 1.0 - inset);
      const Eigen::Vector3d normal = model::outward_normal(face, s, t);
      normals.push_back({normal.x(), normal.y(), normal.z()});
      curvatures.push_back(mm_per_m *
                           model::curvature(model::jet(face, s, t, 2), face.inward).mean);
    }
    faces.push_back({{"name", face.name},
                     {"net", net},
                     {"points", points},
                     {"normals", normals},
                     {"curvatures", curvatures}});
  }
  std::cout << faces.dump() << '\n';
}
