// Outputs of earlier runs: the files in them that a new one must not lose.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/report/options.h"
#include "collision_hulls/robot/robot_description.h"
#include "pipeline/mesh_uses.h"

namespace collision_hulls {

/// Hulls of earlier outputs that a description keeps, for the output that takes their place.
struct KeptHulls {
  std::map<std::string, std::string> places;    ///< by URI: the file's path in the new output
  std::map<std::string, std::string> contents;  ///< by that path
};

/// The meshes in earlier outputs that the <collision> elements of all links but `replaced` name; `output` is the folder of the new
/// output, where an earlier one may be. Their paths in the new output differ from those in `taken`. Throws kTooLarge if they have more
/// than 1 GiB in all, what readFile() throws (base/read_file.h), and kCancelled.
KeptHulls keptHulls(const RobotDescription& robot, const std::set<std::string>& replaced, const std::vector<std::string>& taken,
                    const std::string& output, const PackageFinder& find_package, const RunControl& control = {});

/// The folder of an earlier output that holds one of these meshes; empty: there is none. `uris` are of `robot`, `output` as above. Throws
/// kCancelled.
std::string outputWithOneOf(const std::set<std::string>& uris, const RobotDescription& robot, const std::string& output,
                            const PackageFinder& find_package, const RunControl& control = {});

/// Throws kUnwritableOutput if an element that is used names a mesh in the folder that `output` replaces, so that the mesh would be lost: a
/// <visual> element, which stays as it is, or one that becomes hulls, which would take the place of what they were made from. Throws
/// kCancelled.
void refuseLosingOriginals(const RobotDescription& robot, const std::vector<MeshUse>& uses, const std::string& output,
                           const PackageFinder& find_package, const RunControl& control = {});

/// Throws kUnwritableOutput if the cache is on and lies in the folder that `output` replaces: it would be lost, and before that each of its
/// files would keep the next run from replacing the folder.
void refuseLosingCache(const Options& options, const std::string& output);

/// As refuseLosingOriginals(), for a file that is itself an input.
void refuseLosingInput(const std::string& input, const std::string& output);

}  // namespace collision_hulls
