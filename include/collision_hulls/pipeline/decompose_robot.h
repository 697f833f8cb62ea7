// The main flow: from a robot description, or one mesh, to validated convex collision models.
//
// For example:
//
//     #include "collision_hulls/pipeline/output.h"
//
//     const Input input = openInput("arm.urdf");
//     RobotResult result = decompose(input, Options(), "arm_collision");
//     const bool written = writeOutput(result, "arm_collision");  // false: all meshes failed
#pragma once

#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/pipeline/input.h"
#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

/// The flow on one screen: for each mesh of each link read, repair, decompose, cover and round,
/// certify; then validate. One bad mesh is a failed row and loses nothing else (its link keeps its
/// `<collision>` elements as they were). `output` is the folder that the URIs in RobotResult::urdf
/// will refer to (see defaultOutput); nothing is written here (see writeOutput). Throws kBadOption
/// as check() of the options and LinkDecisions; kUnwritableOutput for an `output` that is empty, or
/// would take the place of a mesh that is read, or of the cache; kTooLarge for a model of too many
/// hulls; kInternal if the new description does not read back as it was meant; kCancelled. Other
/// faults of a mesh or a file are told in its row.
RobotResult decomposeRobot(const RobotDescription& robot, const PackageFinder& find_package,
                           const Options& options, const std::string& output,
                           const RunControl& control = {}, const StepCallback& step = {});

/// The same for one mesh file; the report has one row, whose link is the file's stem. Throws
/// kBadOption, kCancelled.
RobotResult decomposeMesh(const std::string& path, const Options& options,
                          const RunControl& control = {}, const StepCallback& step = {});

/// Decomposes the robot or mesh of `input`. Throws as these, and kUnwritableOutput for an `output`
/// that would take the place of the mesh file or the cache.
RobotResult decompose(const Input& input, const Options& options, const std::string& output,
                      const RunControl& control = {}, const StepCallback& step = {});

}  // namespace collision_hulls
