#include <gtest/gtest.h>

#include <set>

#include "export_read_back.hpp"
#include "io/export_step.hpp"
#include "io/mesh.hpp"
#include "io/read_model.hpp"
#include "mesh_laws.hpp"
#include "model/build.hpp"

namespace bodyline {
namespace {

using namespace test;
using model::Stage;

/// The cars of the paper, and one with patches of other families, at every stage.
class ExportedCar : public testing::TestWithParam<const char*> {
 protected:
  std::vector<model::Surface> faces(Stage stage) const {
    return model::build(io::read_model(std::string(BODYLINE_SOURCE_DIR "/") + GetParam() + ".toml"),
                        stage);
  }
};

// 77 faces have 308 sides: 134 curves between two faces, 6 sides that are points, and 34 free sides
// along the wheel arches and the bottom.
const std::map<int, int> body_edges{{1, 34}, {2, 134}};

TEST_P(ExportedCar, StepReadsBackAs77NamedFacesInOneShell) {
  const auto body = faces(Stage::body);
  ASSERT_EQ(body.size(), 77u);
  const io::CadFile file = io::step_file(body, GetParam());
  const ReadBack back = read_step(file.text);
  expect_same_faces(body, back);
  EXPECT_EQ(edges_by_faces(back.shape), body_edges);
  EXPECT_EQ(file.not_polynomial.size(), 4u);
}

TEST_P(ExportedCar, IgesReadsBackAs77NamedFacesInOneShell) {
  const auto body = faces(Stage::body);
  const ReadBack back = read_iges(io::iges_file(body, GetParam()).text);
  expect_same_faces(body, back);
  EXPECT_EQ(edges_by_faces(back.shape), body_edges);
}

TEST_P(ExportedCar, StepOfBaseIsOneShell) {
  const auto base = faces(Stage::base);
  expect_same_faces(base, read_step(io::step_file(base, GetParam()).text));
}

TEST_P(ExportedCar, StepOfKeptHasEveryFace) {
  const auto kept = faces(Stage::kept);
  EXPECT_EQ(read_step(io::step_file(kept, GetParam()).text).faces.size(), kept.size());
}

// The wheel arches and the bottom are one loop around the car.
TEST_P(ExportedCar, MeshIsClosedButForOneLoop) {
  for (Stage stage : {Stage::base, Stage::body}) {
    const io::Mesh mesh = io::make_mesh(faces(stage), {.tolerance_mm = 1.0});
    EXPECT_EQ(count_free_loops(mesh.triangles), 1) << model::stage_name(stage);
    expect_no_vertex_on_free_edges(mesh, 1e-3);
  }
}

// Single precision at 5 m resolves 5e-4 mm; the strips' cells are some 0.1 mm by 10 mm at their
// narrowest.
TEST_P(ExportedCar, MeshHasNoDegenerateTriangles) {
  for (Stage stage : {Stage::base, Stage::kept, Stage::body})
    EXPECT_GT(worst_shape(io::make_mesh(faces(stage))), 1e-5) << model::stage_name(stage);
}

TEST_P(ExportedCar, MeshStaysWithinTheTolerance) {
  for (double tolerance : {1.0, 0.1})
    EXPECT_LE(io::make_mesh(faces(Stage::body), {.tolerance_mm = tolerance}).max_deviation_mm,
              tolerance);
}

TEST_P(ExportedCar, MeshOfTheSmoothBodySharesItsNormals) {
  const io::Mesh mesh = io::make_mesh(faces(Stage::body), {.tolerance_mm = 1.0});
  std::set<std::pair<int, int>> pairs;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) pairs.emplace(mesh.triangles[t][k], mesh.triangle_normals[t][k]);
  EXPECT_EQ(pairs.size(), mesh.points.size());
}

INSTANTIATE_TEST_SUITE_P(Cars, ExportedCar,
                         testing::Values("cars/template", "cars/model1", "cars/model2",
                                         "examples/families"),
                         [](const auto& car) {
                           const std::string path = car.param;
                           return path.substr(path.find('/') + 1);
                         });

}  // namespace
}  // namespace bodyline
