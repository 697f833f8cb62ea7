// A result to write, made by hand.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "collision_hulls/error.h"
#include "collision_hulls/pipeline/output.h"
#include "shapes.h"

namespace collision_hulls {
namespace fixtures {

inline ConvexHull box() {
  return convexHull(test_shapes::box(1, 2, 3).vertices);
}

/// A result of two links, made by hand.
inline RobotResult sample() {
  RobotResult result;
  result.robot_name = "My Arm";
  result.urdf = "<robot name=\"My Arm\"/>\n";
  for (const char* link : {"a", "b"}) {
    ElementReport row;
    row.link = link;
    for (const char* m : {"0", "1"}) row.files.push_back("meshes/" + std::string(link) + "/0_" + m + ".stl");
    result.report.links.push_back(row);
    ElementResult element;
    element.link = link;
    element.hulls = {box(), box()};
    result.elements.push_back(element);
  }
  return result;
}

/// Neither checkOutput() nor writeOutput() accepts it.
inline void expectError(const std::string& output, ErrorCode code) {
  for (const bool write : {false, true}) {
    try {
      RobotResult result = sample();
      if (write) {
        writeOutput(result, output);
      } else {
        checkOutput(output);
      }
      ADD_FAILURE() << output << " was accepted";
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), code) << e.what();
      EXPECT_NE(std::string(e.what()).find("choose another output"), std::string::npos) << e.what();
    }
  }
}

}  // namespace fixtures
}  // namespace collision_hulls
