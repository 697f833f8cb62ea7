// Runs `decompose` in a folder with the package arm_description, whose description arm/urdf/arm.urdf has one link of one mesh.
#pragma once

#include <string>

#include "shapes.h"
#include "tools/program_test.h"

namespace collision_hulls {

class DecomposeProgramTest : public ProgramTest {
 protected:
  DecomposeProgramTest() : ProgramTest("decompose") {
    fixtures::write(folder_ / "arm/package.xml", "<package format=\"2\"><name>arm_description</name></package>");
    fixtures::write(folder_ / "arm/meshes/bracket.obj", fixtures::obj(test_shapes::lBracket(0.2, 0.03, 0.1)));
    fixtures::write(folder_ / "arm/meshes/rubbish.stl", "no mesh");
    addRobot("arm/urdf/arm.urdf", fixtures::link("base", collision("bracket.obj")));
  }

  static std::string collision(const std::string& mesh) {
    return "    <collision>" + fixtures::meshTag("package://arm_description/meshes/" + mesh) + "</collision>\n";
  }
  void addRobot(const std::string& file, const std::string& links) { fixtures::write(folder_ / file, fixtures::robot("arm", links)); }
};

}  // namespace collision_hulls
