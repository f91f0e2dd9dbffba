#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "check_models.hpp"
#include "model/construction.hpp"

/// Nets of model 1 against an independent construction: without lean, without seam correction.
namespace bodyline::testing {
namespace {

constexpr double oracle_mm = 1e-5;  // promised; the oracle is rounded to 1e-6
constexpr const char* oracle_path = BODYLINE_SOURCE_DIR "/tests/data/nets_model1.json";

double worst_distance(const nlohmann::json& net, const model::Face& face,
                      const std::vector<model::Vec3<double>>& nets) {
  double worst = 0.0;
  for (int i = 0; i <= face.degree_u; ++i) {
    for (int j = 0; j <= face.degree_v; ++j) {
      const model::Vec3<double>& p = nets[face.net + i * (face.degree_v + 1) + j];
      const nlohmann::json& q = net.at(i).at(j);
      const Eigen::Vector3d distance(p.x - q.at(0).get<double>(), p.y - q.at(1).get<double>(),
                                     p.z - q.at(2).get<double>());
      worst = std::max(worst, distance.norm());
    }
  }
  return worst;
}

void expect_nets(const nlohmann::json& nets, const std::vector<model::Face>& faces,
                 model::FaceKind kind, const std::vector<model::Vec3<double>>& built) {
  std::size_t compared = 0;
  for (const model::Face& face : faces) {
    if (face.kind != kind || !nets.contains(face.name)) continue;
    EXPECT_LE(worst_distance(nets.at(face.name), face, built), oracle_mm) << face.name;
    ++compared;
  }
  EXPECT_EQ(compared, nets.size());
  EXPECT_GT(compared, 0u);
}

TEST(Oracle, NetsOfModel1AreThoseOfTheIndependentConstruction) {
  std::ifstream file(oracle_path);
  ASSERT_TRUE(file) << oracle_path;
  const nlohmann::json oracle = nlohmann::json::parse(file);
  model::Model car = load_car("model1");
  // A model must lean at its pillar feet; the oracle does not, so the plan is made first.
  model::BodyPlan plan = model::plan_body(car);
  plan.seams.clear();
  for (model::Joint& joint : car.joints) joint.lean = {};
  model::Construction<double> construction(plan);
  const Eigen::VectorXd parameters = model::to_parameters(car, plan.layout);
  construction.build(parameters.data(), model::Stage::body);
  expect_nets(oracle.at("base"), plan.base_faces, model::FaceKind::patch, construction.nets);
  expect_nets(oracle.at("reserved"), plan.kept_faces, model::FaceKind::patch, construction.nets);
  expect_nets(oracle.at("transition"), plan.body_faces, model::FaceKind::transition,
              construction.nets);
}

}  // namespace
}  // namespace bodyline::testing
