// Writes what a run gives: the output package, or a single mesh's folder.
#pragma once

#include <string>

#include "collision_hulls/control.h"
#include "collision_hulls/pipeline/result.h"

namespace collision_hulls {

/// Writes the output and its report.json: into a temporary folder beside `output`, read back and
/// compared, then put in place with one rename (exchange) so that a kill at any moment leaves the
/// old or the new. Replaces an earlier output, whose files are taken over where they have the same
/// content; refuses (kNotOurOutput) a folder that is not one. Fills seconds.write in the report.
/// If all meshes failed, writes nothing, since an earlier output may still be of use, and returns
/// false. Throws kBadOption where a robot's URIs refer to another place than `output`, kCancelled,
/// and kUnwritableOutput, also where this run lacked memory or time for some meshes, the earlier
/// output has them all, and Options::replace_complete is not set. All leave everything as it was.
bool writeOutput(RobotResult& result, const std::string& output, const RunControl& control = {});

/// Throws what writeOutput would throw for such a folder, before the long work; kUnwritableOutput
/// for an empty name. Leaves nothing behind.
void checkOutput(const std::string& output, const RunControl& control = {});

/// How to use a written output, in lines for a terminal: where it is, how ROS finds it, and what
/// loads it. `package_path`: where packages were found that ROS may not find, see
/// defaultPackageFinder().
std::string howToUse(const RobotResult& result, const std::string& output,
                     const std::vector<std::string>& package_path = {});

/// Writes the report alone, as JSON, in one rename; into a pipe at the pace of its reader. Throws
/// kUnwritableOutput, kCancelled.
void writeReport(const Report& report, const std::string& file, const RunControl& control = {});

}  // namespace collision_hulls
