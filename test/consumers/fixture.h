// A robot of three links, and what consumers are given of it.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "collision_hulls/consumers/consumers.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "pipeline/fixtures.h"
#include "shapes.h"

namespace collision_hulls {

class Consumers : public ::testing::Test {
 protected:
  Consumers() : mesh_(fixtures::write(folder_ / "cube.obj", fixtures::obj(test_shapes::box(0.1, 0.1, 0.1)))) { options_.validate = false; }

  /// Three links in a row, 0.5 m apart, that turn about z.
  std::string threeLinks(const std::string& last) const {
    const std::string cube = "<collision name=\"&lt;cube&gt;\">" + fixtures::meshTag(mesh_) + "</collision>";
    std::string text = "<?xml version=\"1.0\"?>\n<!-- <robot> -->\n<robot name=\"three\">\n";
    for (const char* name : {"a", "b"}) text += "  <link name=\"" + std::string(name) + "\">" + cube + "</link>\n";
    text += "  <link name=\"c\">" + last + "</link>\n";
    for (const std::string pair : {"ab", "bc"})
      text += "  <joint name=\"" + pair + "\" type=\"revolute\"><parent link=\"" + pair[0] + "\"/><child link=\"" + pair[1] +
              "\"/><origin xyz=\"0.5 0 0\"/><axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" effort=\"5\" velocity=\"2\"/></joint>\n";
    return text + "</robot>\n";
  }

  RobotResult decomposed(const std::string& urdf) const {
    return decomposeRobot(parseRobotDescription(urdf), PackageFinder(), options_, folder_ / "three_c");
  }

  std::string fileOf(Consumer consumer, const std::string& urdf, const std::string& file) {
    RobotResult result = decomposed(urdf);
    addConsumerFiles({consumer}, folder_ / "three_c", result);
    EXPECT_EQ(result.extra_files.count(file), 1u) << file;
    return result.extra_files[file];
  }
  std::string cube() const { return "<collision>" + fixtures::meshTag(mesh_) + "</collision>"; }

  /// What is noted on a consumer's files.
  std::string notesOf(Consumer consumer, const std::string& urdf) {
    RobotResult result = decomposed(urdf);
    addConsumerFiles({consumer}, folder_ / "three_c", result);
    std::string all;
    for (const std::string& note : result.report.notes)
      if (note.rfind("--for ", 0) == 0) all += note + "\n";
    return all;
  }

  fixtures::TempFolder folder_;
  const std::string mesh_;
  Options options_;
};

}  // namespace collision_hulls
