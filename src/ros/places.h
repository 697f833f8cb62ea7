// Where the node reads and writes.
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "base/roots.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// The parameters that open doors: ~output_root, ~read_roots, ~package_path, ~base and ~output as they were at the node's start. Who sends
/// a request can set parameters, too: what changes later opens nothing.
class NodePlaces {
 public:
  /// Throws kBadOption for a value of the wrong type.
  explicit NodePlaces(const ros::NodeHandle& node);

  /// Where nodes of this node's namespace write by default, below ~output_root; empty: right there.
  static std::string namespaceFolder();

  /// Asks ROS for a package first, then looks for one that nodes wrote, then near a description and in ~package_path. Throws kBadOption for
  /// a folder there that is none.
  PackageFinder packageFinder(const std::string& near) const;

  const std::vector<std::string>& packagePath() const { return package_path_; }

  /// What a request may reach: for reading ~read_roots, ~package_path, packages, the description's folder and all that may be written; for
  /// writing what lies below ~output_root, and ~output.
  Roots roots() const;

  /// The folder that a request, or ~output, means, relative to ~output_root and without links. Throws kOutsideRoots while confined.
  std::string output(const std::string& wanted) const;

 private:
  std::string baseFolder() const;

  std::string output_root_, base_, output_;
  std::vector<std::string> read_roots_, package_path_;
};

}  // namespace collision_hulls
