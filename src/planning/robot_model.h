// A robot's collision models: its original meshes, and what takes their place.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "collision_hulls/pipeline/fit_scene.h"
#include "collision_hulls/query/boxed_model.h"

namespace collision_hulls {

/// A body of a link: a mesh, a hull, or a primitive, whose own frame is the link's then.
struct ModelBody {
  std::size_t link = 0;  ///< index in RobotDescription::links
  std::variant<TriangleMesh, ConvexHull, GeometryElement> shape;
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  ///< in the link's frame
};

struct RobotModel {
  std::string name;
  std::vector<ModelBody> bodies;
};

constexpr const char* kOriginalModel = "original";

/// "original" (the meshes), "single_hull" (one for each mesh), "default" (the default options' hulls), "fitted" (to the scene), "spheres".
std::vector<std::string> allModels();
void checkModels(const std::vector<std::string>& names);  ///< throws kBadOption for a name that is none of these

struct ModelRequest {
  double clearance = 0.01;      ///< [m] of the fitted model
  std::size_t samples = 10000;  ///< of the fit
  Options options;              ///< of all models: tolerance, cache, jobs
};

/// The models of a robot that do not depend on the scene, and the names of links for the others.
struct SceneModels {
  std::vector<RobotModel> models;  ///< in the order of the names
  IgnoredPairs ignored;            ///< of links, and of links and bodies of the scene, which are numbered after the links
};

/// Makes models of a robot and fits those that are to be fitted to a scene. All are checked for the same pairs: without those that the fit
/// leaves out or finds never to meet, by the original meshes, and that it would disable in an SRDF. What does not depend on the scene is
/// made once.
class ModelMaker {
 public:
  /// `names`: of the models. Throws as checkModels().
  ModelMaker(const Input& robot, const std::vector<std::string>& names, const ModelRequest& options);

  /// Throws what fitRobotToScene() and decomposeRobot() throw, and the error of the first mesh that failed.
  SceneModels make(const Scene& scene);

 private:
  RobotResult decomposed(const std::string& name) const;
  RobotModel modelOf(const std::string& name, const RobotResult& result) const;

  const Input& robot_;
  const std::vector<std::string> names_;
  const ModelRequest options_;
  std::vector<RobotModel> made_;  // without those that depend on the scene
};

}  // namespace collision_hulls
