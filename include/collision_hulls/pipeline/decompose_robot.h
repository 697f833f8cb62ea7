// The main flow: from a robot description, or one mesh, to validated convex collision models.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/report/options.h"
#include "collision_hulls/report/report.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

class Solid;

/// The result for one mesh of one link. Coordinates after `scale`, in the element's own frame
/// (before its `<origin>`).
struct ElementResult {
  ElementReport report;
  GeometryElement source;
  /// of the element's frame in the robot's zero configuration
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  TriangleMesh original;  ///< as read and scaled
  /// as written; empty if the status is failed
  std::vector<ConvexHull> hulls;
  /// in its frame; replace the files of the last hulls, which enclose them
  std::vector<GeometryElement> primitives;
  /// finer hulls that a scene did not need; empty without a scene
  std::vector<ConvexHull> unneeded;
  /// of `original`, during the run only; null if the hulls are from the cache
  std::shared_ptr<const Solid> solid;
};

struct RobotResult {
  Report report;
  std::vector<ElementResult> elements;  ///< same order as report.links
  std::string robot_name;               ///< or the mesh's stem
  /// rewritten description, URIs as the output package will hold them; empty for a single mesh
  std::string urdf;
  bool single_mesh = false;
  /// further files of the output package: path in it, content
  std::map<std::string, std::string> extra_files;
  /// hulls of earlier outputs that the description keeps: path in the package, content
  std::map<std::string, std::string> kept_files;
};

/// What a run is doing, for bars and feedback.
struct Step {
  /// "read", "decompose", "fit" and "certify" (to a scene), "validate"
  std::string stage;
  /// link of the mesh finished last; empty where there is none in this stage
  std::string item;
  std::size_t done = 0, total = 0, hulls = 0;  ///< meshes finished, all meshes, hulls so far
  /// share of the whole run done, in [0, 1], never decreasing; 1 at the end alone
  double fraction = 0;
  /// a rough estimate; negative where there is none yet
  double seconds_left = -1;
};
/// Called at the start of each stage, for each finished mesh, and at most every 0.2 s in between;
/// one call at a time, from any thread.
using StepCallback = std::function<void(const Step&)>;

/// The flow on one screen: for each mesh of each link read, repair, decompose, cover and round,
/// certify; then validate. One bad mesh is a failed row and loses nothing else (its link keeps its
/// `<collision>` elements as they were). `output` is the folder that the URIs in RobotResult::urdf
/// will refer to (see defaultOutput); nothing is written here. Throws kBadOption, kCancelled.
RobotResult decomposeRobot(const RobotDescription& robot, const PackageFinder& find_package,
                           const Options& options, const std::string& output,
                           const RunControl& control = {}, const StepCallback& step = {});

/// The same for one mesh file; the report has one row, whose link is the file's stem.
RobotResult decomposeMesh(const std::string& path, const Options& options,
                          const RunControl& control = {}, const StepCallback& step = {});

/// What the command line's INPUT refers to.
struct Input {
  enum class Kind { kRobot, kMesh } kind = Kind::kRobot;
  std::string path;  ///< mesh file
  RobotDescription robot;
  PackageFinder find_package;
};
/// INPUT: a package name, a .urdf or .xacro file, or a mesh file. `package_path`: see
/// defaultPackageFinder(). Throws the readers' errors; for a package with several descriptions the
/// message lists a command of `program` for each.
Input openInput(const std::string& input, const std::vector<std::string>& package_path = {},
                const std::string& program = "decompose");

/// "42 meshes of 17 links": what decompose() will read.
std::string workOn(const Input& input, const Options& options);

/// Decomposes the robot or mesh of `input`.
RobotResult decompose(const Input& input, const Options& options, const std::string& output,
                      const RunControl& control = {}, const StepCallback& step = {});

/// Default output folder: `./<robot>_collision`
std::string defaultOutput(const Input& input);

/// Writes the output package (or a single mesh's folder) and its report.json: into a temporary
/// folder beside `output`, read back and compared, then put in place with one rename (exchange) so
/// that a kill at any moment leaves the old or the new. Replaces an earlier output, whose files are
/// taken over where they have the same content; refuses (kNotOurOutput) a folder that is not one.
/// Fills seconds.write in the report. Where all meshes failed nothing is written, as an earlier
/// output may be of use: then false. Throws kUnwritableOutput, and kCancelled, which leaves
/// everything as it was.
bool writeOutput(RobotResult& result, const std::string& output, const RunControl& control = {});

/// Throws what writeOutput would throw for such a folder, before the long work. Leaves nothing
/// behind.
void checkOutput(const std::string& output);

/// How to use a written output, in lines for a terminal: where it is, how ROS finds it, and what
/// loads it.
std::string howToUse(const RobotResult& result, const std::string& output);

/// Writes the report alone, as JSON, in one rename. Throws kUnwritableOutput.
void writeReport(const Report& report, const std::string& file);

}  // namespace collision_hulls
