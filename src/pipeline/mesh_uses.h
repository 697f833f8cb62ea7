// Which meshes a run works on, which links use them, and which of them are the same.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/report/options.h"
#include "collision_hulls/robot/robot_description.h"
#include "pipeline/mesh_result.h"

namespace collision_hulls {

/// Tells whether Options::links chooses a link.
class LinkChoice {
 public:
  /// Throws kBadOption where the expression matches no link of the robot.
  LinkChoice(const std::string& expression, const RobotDescription& robot);
  bool operator()(const std::string& link) const { return matches_(link); }

 private:
  std::function<bool(const std::string&)> matches_;
};

/// A mesh of a link, as a description names it. One mesh may have many uses.
struct MeshUse {
  std::string link;
  int element = 0;                                         ///< see ElementReport
  bool visual = false;                                     ///< see ElementReport
  GeometryElement source;                                  ///< has the mesh's URI and scale
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< see ElementResult
};

/// Every mesh of every chosen link, in document order.
std::vector<MeshUse> meshUses(const RobotDescription& robot, const Options& options);

/// Notes on meshes that Options::source leaves out, and on a robot in which it finds none.
std::vector<std::string> notesOnUses(const RobotDescription& robot, const std::vector<MeshUse>& uses, const Options& options);

/// A mesh to work on, for all uses (indices) with the same content, kind of file and scale.
struct MeshTask {
  std::string file;
  std::string uri;  ///< as its first use names it
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  std::string sha256;
  std::uintmax_t bytes = 0;
  std::vector<std::size_t> uses;  ///< ascending
};

struct MeshTasks {
  std::vector<MeshTask> tasks;  ///< largest file first, so that no long task begins last
  MeshResults failed;           ///< by use: a failed result where there is no file; else null
};

/// Where a mesh's file is. Throws Error.
using UriResolver = std::function<std::string(const std::string& uri)>;

/// Finds and hashes the files of the meshes, and joins equal ones.
MeshTasks meshTasks(const std::vector<MeshUse>& uses, const UriResolver& resolve, const RunControl& control);

/// In proportion to the time that the tasks take, roughly: the time spreads much less than the files' sizes.
std::vector<double> expectedCosts(const std::vector<MeshTask>& tasks);

/// The content of a task's file. Throws what readFile() throws, and kFileNotFound if it is no longer what was hashed: the cache would keep
/// the result under a wrong key.
std::string contentOf(const MeshTask& task, const RunControl& control);

}  // namespace collision_hulls
