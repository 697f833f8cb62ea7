// Which meshes a run works on, which links use them, and which of them are the same.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "collision_hulls/config/link_decisions.h"
#include "collision_hulls/control.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/report/options.h"
#include "collision_hulls/report/report.h"
#include "collision_hulls/robot/robot_description.h"
#include "pipeline/mesh_result.h"

namespace collision_hulls {

/// A mesh of a link, as a description names it. One mesh may have many uses. A link that is kept or removed has one for each mesh of its
/// <collision> elements, or a single one without URI.
struct MeshUse {
  std::size_t model = 0;  ///< index in Options::models
  std::string link;
  LinkOptions options;
  int element = 0;                                         ///< see ElementReport
  bool visual = false;                                     ///< see ElementReport
  GeometryElement source;                                  ///< has the mesh's URI and scale
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< see ElementResult
};

/// Every mesh of every chosen link, in document order, model by model. `decisions`: of each model.
std::vector<MeshUse> meshUses(const RobotDescription& robot, const std::vector<LinkDecisions>& decisions);

/// How many of these meshes become hulls.
std::size_t decomposedUses(const std::vector<MeshUse>& uses);

/// Notes on meshes that LinkOptions::source leaves out, and on a robot in which it finds none.
std::vector<std::string> notesOnUses(const RobotDescription& robot, const LinkDecisions& decisions, const Options& options);

/// What becomes of a link's <collision> elements.
enum class CollisionFate {
  kStay,     ///< all of them
  kGo,       ///< without others in their place
  kReplaced  ///< the meshes by hulls; primitives stay where the source is the <collision> elements, else the solid ones of the source come
};

/// Of a link with these options (null: it was not chosen). `failed`: one of its meshes did. They stay then; if there are none, the hulls of
/// the other meshes come.
CollisionFate collisionFate(const LinkDescription& link, const LinkOptions* options, bool failed = false);

/// How many links have primitives that become, or stay, their collision model, and no mesh.
std::size_t primitiveLinks(const RobotDescription& robot, const LinkDecisions& decisions);

/// On a robot whose collision meshes all became single hulls, though it has other visual meshes. `rows`: of its report.
std::vector<std::string> notesOnConvex(const RobotDescription& robot, const std::vector<ElementReport>& rows);

/// On links that are kept and have nothing that collides.
std::vector<std::string> notesOnBare(const RobotDescription& robot, const LinkDecisions& decisions);

/// On visual primitives without a size, which get no collision geometry.
std::vector<std::string> notesOnFlat(const RobotDescription& robot, const LinkDecisions& decisions);

/// On settings and regions that no mesh is left for.
std::vector<std::string> notesOnIdle(const RobotDescription& robot, const LinkDecisions& decisions, const Options& options,
                                     const RunControl& control = {});

/// Uses (indices, ascending) of a mesh with the same options.
struct MeshVariant {
  LinkOptions options;
  std::vector<std::size_t> uses;
};

/// A mesh to work on, with the same content, kind of file, scale and openings to close.
struct MeshTask {
  std::string file;
  std::string uri;  ///< as its first use names it
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  double close_openings = 0;  ///< see LinkOptions
  std::string sha256;
  std::uintmax_t bytes = 0;
  std::vector<MeshVariant> variants;  ///< in the order of their first uses
};

struct MeshTasks {
  std::vector<MeshTask> tasks;  ///< largest file first, so that no long task begins last
  MeshResults done;             ///< by use: where there is no file a failed result, and one for each that is kept or removed; else null
};

/// Where a mesh's file is. Throws Error.
using UriResolver = std::function<std::string(const std::string& uri)>;

/// resolveUri() for the meshes of a robot, with a look at the control for each. All three must outlive it.
UriResolver resolverFor(const RobotDescription& robot, const PackageFinder& find_package, const RunControl& control);

/// Finds and hashes the files of the meshes, and joins equal ones.
MeshTasks meshTasks(const std::vector<MeshUse>& uses, const UriResolver& resolve, const MeshLimits& limits, const RunControl& control);

/// In proportion to the time that the tasks take, roughly: the time spreads much less than the files' sizes.
std::vector<double> expectedCosts(const std::vector<MeshTask>& tasks);

/// The content of a task's file, for parseMesh(). Throws what readMeshBytes() throws, and kFileNotFound if it is no longer what was hashed:
/// the cache would keep the result under a wrong key.
std::string contentOf(const MeshTask& task, const MeshLimits& limits, const RunControl& control);

}  // namespace collision_hulls
