// Fits of a bracket to a scene.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "collision_hulls/pipeline/fit_scene.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace fixtures {

/// A bracket on a link that does not move, and a block in its notch: inside its hull, and 3 cm clear of the bracket itself.
class FitRobotToScene : public ::testing::Test {
 protected:
  FitRobotToScene() {
    write(folder_ / "meshes/bracket.obj", obj(test_shapes::lBracket(0.2, 0.03, 0.1)));
    write(folder_ / "meshes/rubbish.stl", "no mesh at all");
    request_.scene = {"notch", {{"block", boxShape(Eigen::Vector3d::Constant(0.03)), at(0.075, 0.075, 0.05)}}};
    request_.samples = 100;
    options_.validate = false;
  }

  static Eigen::Isometry3d at(double x, double y, double z) { return Eigen::Isometry3d(Eigen::Translation3d(x, y, z)); }

  static bool isNoted(const RobotResult& result, const std::string& text) {
    const std::vector<std::string>& notes = result.report.notes;
    return std::any_of(notes.begin(), notes.end(), [&](const std::string& note) { return note.find(text) != std::string::npos; });
  }

  static std::string collision(const std::string& geometry) { return "    <collision>\n      " + geometry + "\n    </collision>\n"; }
  static std::string bracket() { return collision(meshTag("../meshes/bracket.obj")); }

  /// A link with this geometry, in whose notch a peg turns and slides a little, on two joints.
  static std::string pegInNotch(const std::string& base, const std::string& peg) {
    return link("base", base) + link("wheel", "") + link("peg", peg) +
           "<joint name=\"turn\" type=\"continuous\"><parent link=\"base\"/><child link=\"wheel\"/>"
           "<origin xyz=\"0.075 0.075 0.05\"/><axis xyz=\"0 0 1\"/></joint>"
           "<joint name=\"lift\" type=\"prismatic\"><parent link=\"wheel\"/><child link=\"peg\"/><axis xyz=\"0 0 1\"/>"
           "<limit lower=\"0\" upper=\"0.01\" effort=\"1\" velocity=\"1\"/></joint>";
  }

  RobotResult run(const std::string& links, const StepCallback& step = {}) {
    const RobotDescription robot = readRobotDescription(write(folder_ / "urdf/arm.urdf", fixtures::robot("arm", links)));
    return fitRobotToScene(robot, defaultPackageFinder(), request_, options_, folder_ / "out", {}, step);
  }

  TempFolder folder_;
  SceneRequest request_;
  Options options_;
};

}  // namespace fixtures
}  // namespace collision_hulls
