// A carriage with a gap that travels along z over a post, and scenes to fit it to, with known answers.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "collision_hulls/decompose/certified.h"
#include "collision_hulls/fit/fit.h"
#include "collision_hulls/mesh/repair.h"
#include "shapes.h"

namespace collision_hulls {
namespace fit_fixtures {

/// A channel 0.4 m wide, 0.3 m deep and 1 m long in z, with walls 6 cm thick, at the origin of its own frame: three convex parts.
inline TriangleMesh channel() {
  return test_shapes::uChannel(0.4, 0.3, 0.06, 1);
}

inline std::shared_ptr<FitMesh> fitMesh(const TriangleMesh& mesh, double tolerance = 0.02) {
  const auto result = std::make_shared<FitMesh>();
  const RepairedMesh repaired = repair(mesh);
  result->original = mesh;
  result->solid = std::make_shared<const Solid>(repaired);
  DecomposeOptions options;
  options.tolerance = tolerance;
  result->tree = hullTree(repaired, options);
  result->margin = 1e-6;
  result->max_vertices = 64;
  return result;
}

/// A base without geometry, and links c0, c1, ... that each slide along z from it, by `travel` [m] either way.
inline RobotDescription carriages(int count, double travel = 2) {
  std::string text = "<robot name='rail'><link name='base'/>";
  for (int i = 0; i < count; ++i) {
    const std::string n = std::to_string(i), limit = std::to_string(travel);
    text += "<link name='c" + n + "'/><joint name='j" + n + "' type='prismatic'><parent link='base'/><child link='c" + n +
            "'/><axis xyz='0 0 1'/><limit lower='-" + limit + "' upper='" + limit + "' effort='1' velocity='1'/></joint>";
  }
  return parseRobotDescription(text + "</robot>");
}

inline SceneBody boxBody(const std::string& name, const Eigen::Vector3d& size, const Eigen::Vector3d& place) {
  return {name, boxShape(size), Eigen::Isometry3d(Eigen::Translation3d(place))};
}

/// The middle of the channel's gap, halfway along.
inline Eigen::Vector3d gap() {
  const TriangleMesh mesh = channel();
  const Eigen::AlignedBox3d box = boundingBox(mesh);
  return box.center();
}

/// The channel with its tree, built once.
inline std::shared_ptr<const FitMesh> channelMesh() {
  static const std::shared_ptr<const FitMesh> mesh = fitMesh(channel());
  return mesh;
}

/// One carriage with the channel, and a post 10 cm thick in its gap, over which the channel slides without ever touching it.
inline FitProblem overPost() {
  FitProblem problem;
  problem.robot = carriages(1);
  problem.elements.push_back({"c0/0", 1, Eigen::Isometry3d::Identity(), channelMesh()});
  problem.scene.name = "post";
  problem.scene.bodies.push_back(boxBody("post", {0.1, 0.1, 0.1}, gap()));
  return problem;
}

inline FitOptions fitOptions(double clearance = 0.01, std::size_t samples = 1000) {
  FitOptions options;
  options.clearance = clearance;
  options.samples = samples;
  return options;
}

}  // namespace fit_fixtures
}  // namespace collision_hulls
