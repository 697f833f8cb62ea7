// The main flow: from a robot description, or one mesh, to validated convex collision models.
//
// For example:
//
//     #include "collision_hulls/pipeline/output.h"
//
//     const Input input = openInput("arm.urdf");
//     RobotResult result = decompose(input, Options(), "arm_collision");
//     writeOutput(result, "arm_collision");
#pragma once

#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/pipeline/input.h"
#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

/// The flow on one screen: for each mesh of each link read, repair, decompose, cover and round,
/// certify; then validate. One bad mesh is a failed row and loses nothing else (its link keeps its
/// `<collision>` elements as they were). `output` is the folder that the URIs in RobotResult::urdf
/// will refer to (see defaultOutput); nothing is written here (see writeOutput). Throws kBadOption,
/// kUnwritableOutput for an empty `output`, kCancelled.
RobotResult decomposeRobot(const RobotDescription& robot, const PackageFinder& find_package,
                           const Options& options, const std::string& output,
                           const RunControl& control = {}, const StepCallback& step = {});

/// The same for one mesh file; the report has one row, whose link is the file's stem.
RobotResult decomposeMesh(const std::string& path, const Options& options,
                          const RunControl& control = {}, const StepCallback& step = {});

/// Decomposes the robot or mesh of `input`.
RobotResult decompose(const Input& input, const Options& options, const std::string& output,
                      const RunControl& control = {}, const StepCallback& step = {});

}  // namespace collision_hulls
