// Runs on robots that a test makes of a few meshes: box.obj, bracket.obj, channel.obj, and rubbish.stl, which is none.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "collision_hulls/pipeline/decompose_robot.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {
namespace fixtures {

class RobotRun : public ::testing::Test {
 protected:
  RobotRun() {
    write(folder_ / "meshes/box.obj", obj(test_shapes::box(0.1, 0.2, 0.3)));
    write(folder_ / "meshes/bracket.obj", obj(test_shapes::lBracket(0.2, 0.03, 0.1)));
    write(folder_ / "meshes/channel.obj", obj(test_shapes::uChannel(0.2, 0.2, 0.02, 0.4)));
    write(folder_ / "meshes/rubbish.stl", "no mesh at all");
    options_.jobs = 2;
  }

  RobotDescription description(const std::string& links) {
    return readRobotDescription(write(folder_ / "urdf/arm.urdf", robot("arm", links)));
  }

  RobotResult run(const std::string& links, const RunControl& control = {}, const StepCallback& step = {}) {
    return decomposeRobot(description(links), defaultPackageFinder(), options_, folder_ / "out", control, step);
  }

  static std::string collision(const std::string& mesh, const std::string& more = "") {
    return "    <collision" + more + ">\n      <origin xyz=\"0 0 0.1\"/>\n      " + meshTag("../meshes/" + mesh) + "\n    </collision>\n";
  }
  static std::string visual(const std::string& mesh, const std::string& scale = "1 1 1") {
    return "    <visual>\n      " + meshTag("../meshes/" + mesh, " scale=\"" + scale + "\"") + "\n    </visual>\n";
  }

  TempFolder folder_;
  Options options_;
};

}  // namespace fixtures
}  // namespace collision_hulls
