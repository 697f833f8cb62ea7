// Queries of a model compared with those of the meshes, with known answers.
#include <gtest/gtest.h>

#include <cmath>

#include "bench/queries/query_job.h"
#include "bench/queries/query_scene.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "pipeline/fixtures.h"
#include "solids.h"

namespace collision_hulls {
namespace {

using nlohmann::json;
using namespace test_shapes;

class Query : public ::testing::Test {
 protected:
  json part(std::size_t link, const TriangleMesh& mesh, const std::vector<ConvexHull>& hulls, const Eigen::Vector3d& place = {0, 0, 0}) {
    const std::string name = std::to_string(parts_++);
    return {{"link", link},
            {"origin", {1, 0, 0, place.x(), 0, 1, 0, place.y(), 0, 0, 1, place.z()}},
            {"file", fixtures::write(folder_ / (name + ".obj"), fixtures::obj(mesh))},
            {"scale", {1, 1, 1}},
            {"hulls", fixtures::write(folder_ / (name + "_hulls.obj"), encodeHullsObj(hulls, "hull"))}};
  }

  /// Queries the original first, then the hulls.
  json ask(const std::string& workload, const json& parts, const std::string& urdf = "") {
    json job = {{"workload", workload}, {"urdf", urdf},    {"parts", parts}, {"answers", folder_ / "answers.json"}, {"seed", 1},
                {"states", 60},         {"original", true}};
    original_ = query(job);
    job["original"] = false;
    return query(job);
  }

  fixtures::TempFolder folder_;
  json original_;
  int parts_ = 0;
};

TEST_F(Query, HullsEqualToTheMesh) {
  const json result = ask("scene", json::array({part(0, box(1, 1, 1), {boxHull({0, 0, 0}, {1, 1, 1})})}));
  EXPECT_GT(original_["hit_rate"], 0.0);
  EXPECT_LT(original_["hit_rate"], 1.0);
  EXPECT_GT(original_["collisions_per_second"], 0.0);
  EXPECT_GT(original_["tree_collisions_per_second"], 0.0);
  EXPECT_GT(original_["distances_per_second"], 0.0);
  EXPECT_FALSE(original_.contains("phantom_rate"));
  EXPECT_EQ(result["bodies"], 1);
  EXPECT_EQ(result["phantom_rate"], 0.0);
  EXPECT_EQ(result["missed"], 0);
  EXPECT_LT(result["distance_error_max"], 1e-5);
}

TEST_F(Query, HullsThatAreTooLarge) {  // by 0.2 all round: too near by 0.2 at a face, and by sqrt(3) times that at a corner
  const json result = ask("scene", json::array({part(0, box(1, 1, 1), {boxHull({-0.2, -0.2, -0.2}, {1.2, 1.2, 1.2})})}));
  EXPECT_GT(result["phantom_rate"], 0.0);
  EXPECT_EQ(result["missed"], 0);
  EXPECT_GT(result["distance_error_mean"], 0.1);
  EXPECT_LE(result["distance_error_max"], 0.2 * std::sqrt(3.0) + 1e-5);
}

TEST_F(Query, HullsThatAreTooSmall) {
  const json result = ask("scene", json::array({part(0, box(1, 1, 1), {boxHull({0.4, 0.4, 0.4}, {0.6, 0.6, 0.6})})}));
  EXPECT_EQ(result["phantom_rate"], 0.0);
  EXPECT_GT(result["missed"], 0);
}

TEST_F(Query, IsRepeatableExceptForTimes) {
  const json parts = json::array({part(0, uChannel(), {hullOf(uChannel())})});
  json first = ask("scene", parts), second = ask("scene", parts);
  for (json* result : {&first, &second})
    for (const char* time : {"collisions_per_second", "tree_collisions_per_second", "distances_per_second"}) result->erase(time);
  EXPECT_EQ(first, second);
}

// Three cubes in a row on two sliders; the outer two are 0.5 m apart at rest and come within 0.1 m of each other.
TEST_F(Query, RobotAgainstItself) {
  const auto slider = [](const std::string& parent, const std::string& child) {
    return "<joint name=\"to_" + child + "\" type=\"prismatic\"><parent link=\"" + parent + "\"/><child link=\"" + child +
           "\"/><limit lower=\"-0.2\" upper=\"0\" effort=\"1\" velocity=\"1\"/></joint>";
  };
  const std::string urdf =
      fixtures::write(folder_ / "row.urdf", "<robot name=\"row\"><link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>" +
                                                slider("a", "b") + slider("b", "c") + "</robot>");
  const auto row = [&](const ConvexHull& hull) {
    return json::array(
        {part(0, box(1, 1, 1), {hull}), part(1, box(1, 1, 1), {hull}, {0.75, 0, 0}), part(2, box(1, 1, 1), {hull}, {1.5, 0, 0})});
  };
  const json exact = ask("self", row(boxHull({0, 0, 0}, {1, 1, 1})), urdf);
  EXPECT_EQ(original_["hit_rate"], 0.0) << "neighbours overlap, which does not count";
  EXPECT_EQ(exact["phantom_rate"], 0.0);
  EXPECT_LT(exact["distance_error_max"], 1e-5);
  const json larger = ask("self", row(boxHull({-0.02, 0, 0}, {1.02, 1, 1})), urdf);
  EXPECT_EQ(larger["phantom_rate"], 0.0);
  EXPECT_NEAR(larger["distance_error_mean"].get<double>(), 0.04, 1e-5);
  const json huge = ask("self", row(boxHull({-0.3, 0, 0}, {1.3, 1, 1})), urdf);
  EXPECT_EQ(huge["phantom_rate"], 1.0);
}

TEST(QueryScene, IsWithinReachAndRepeatable) {
  const Surroundings reach{2, -1, 1};
  const std::vector<ConvexHull> scene = clutteredScene(reach, 1), again = clutteredScene(reach, 1), other = clutteredScene(reach, 2);
  ASSERT_EQ(scene.size(), again.size());
  bool differs = false;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    EXPECT_EQ(scene[i].vertices, again[i].vertices);
    differs |= scene[i].vertices != other[i].vertices;
    EXPECT_LT(boundingBox(scene[i]).exteriorDistance(Eigen::Vector3d::Zero()), 2 * reach.radius);
  }
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace collision_hulls
