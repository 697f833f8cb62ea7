// The report of a run: report.json as a value. Field names are a contract that other tools read.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/check/validate.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/fit/fit.h"
#include "collision_hulls/mesh/repair.h"
#include "collision_hulls/report/options.h"

namespace collision_hulls {

/// The version of this library, as in package.xml.
const char* version();

enum class Status {
  kOk,
  kDegraded,
  kFailed,
  kKept,    ///< by Action::kKeep; the row's mesh was not read
  kRemoved  ///< the same for Action::kRemove
};
const char* name(Status status);  ///< "ok", "degraded", "failed", "kept", "removed"

struct StageSeconds {
  double read = 0, repair = 0, decompose = 0, certify = 0, write = 0;
};

/// What is known of a mesh once it is read and repaired. Lengths in metres, after scaling.
struct MeshFacts {
  std::string sha256;  ///< of its file; of a .gltf file with buffers in others, of all of them
  std::size_t triangles = 0, skipped_primitives = 0;
  /// LinkOptions::close_openings closed so many; what follows is of the closed mesh
  std::size_t closed_openings = 0;
  std::size_t openings = 0;   ///< those that are left, without slits; see openingsOf()
  double widest_opening = 0;  ///< of these
  RepairCounts repair;
  std::string interior;  ///< see Interior
  double volume = 0, diagonal = 0;
  double tolerance = 0;  ///< what the options' tolerance is for this mesh
};

/// What is known of a mesh's hulls once they are certified. Lengths in metres, in the mesh's frame.
struct HullFacts {
  std::size_t hulls = 0, hull_vertices = 0;
  /// Proved: no convex sets within the mesh's tolerance cover it with fewer; see leastHulls(). 1
  /// where it was not searched for, 0 for a failed mesh.
  std::size_t least_hulls = 0;
  /// Spheres, boxes and cylinders in place of hulls, by Options::shapes or fitScene().
  std::size_t primitives = 0;
  double uncovered = 0;  ///< always 0: hulls that leave surface uncovered are a failure
  double protrusion = 0, protrusion_found = 0;      ///< proved bound; largest distance found
  Eigen::Vector3d worst = Eigen::Vector3d::Zero();  ///< a point of a hull at the latter
  Eigen::Vector3d worst_nearest = Eigen::Vector3d::Zero();  ///< the point of S nearest to it
  double hull_volume = 0;
  double covered_share = 1;  ///< of the solid's inside that lies in the hulls; see coveredShare()
  double nudge = 0;      ///< how far hulls were moved outward for rounding (reader, weld, writer)
  double thickness = 0;  ///< given to flat hulls
  std::vector<RegionProof> regions;  ///< see CertifiedHulls; one for each of the mesh's regions
};

/// A row of the report: one mesh of one link. A link without hulls has one for each mesh of its
/// `<collision>` elements, or a single one without URI.
struct ElementReport : MeshFacts, HullFacts {
  std::string link;
  int element = 0;      ///< among the link's source elements, primitives counted
  bool visual = false;  ///< "source"
  std::string uri;
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Status status = Status::kOk;
  std::string reason;  ///< why degraded or failed; names item, value, limit and remedy
  std::string error;   ///< of a failed row: the name of its ErrorCode
  /// What the time limit cut short or left out; empty: nothing. Such rows are not cached.
  std::string untried;
  Method method = Method::kCertified;
  double padding = 0, close_openings = 0;  ///< [m]
  Shapes shapes = Shapes::kHulls;
  Effort effort = Effort::kQuick;
  int max_vertices = 64;              ///< that a hull might have; 0: no limit
  std::vector<Region> regions_given;  ///< of the mesh, in its frame
  /// A mesh that several links use is worked on once: the first row has the time, the others have
  /// 0.
  StageSeconds seconds;
  std::vector<std::string> files;  ///< relative to the output folder
  /// remembered from an earlier run; seconds.read is what finding it took
  bool cached = false;
};

/// What is known of one collision model of the robot.
struct ModelReport {
  std::string model;                 ///< its name; empty: it is the only one
  std::string urdf;                  ///< file of its description; empty for a single mesh
  std::vector<ElementReport> links;  ///< a row for every mesh of every link, in document order
  Validation validation;             ///< meaningful where options.validate; null in JSON otherwise
  bool validation_cached = false;    ///< remembered from an earlier run, times too
};

struct Report : ModelReport {
  std::string input_path, input_sha256;
  std::vector<std::string> xacro_arguments;  ///< that the input was expanded with
  Options options;
  std::vector<ModelReport> models;  ///< the others, if there are several
  std::vector<std::string> files;   ///< of the output beside those of the links and report.json
  std::optional<FitReport> scene;   ///< of a model that was fitted to a scene
  std::vector<std::string> notes;   ///< what to know about the result as a whole
  /// Links that were asked for and whose collision model are primitives of the description alone:
  /// no mesh can fail them.
  std::size_t primitive_links = 0;
  double seconds = 0;  ///< wall clock of the whole run
};

/// report.json's text, with the fields and totals of the contract.
std::string toJson(const Report& report, const RunControl& control = {});

/// The report for people: a table with a row for each mesh and their total, then the check, the
/// scene and the notes, in plain words. The reasons of failed rows are in failures().
std::string toTable(const Report& report);

/// A line for each failed row; a single one for all rows that miss the same package; and one if the
/// result is refuted.
std::vector<std::string> failures(const Report& report);

/// The first degraded row and its reason, with how many more `where` has, as a line with its end;
/// empty: there is none.
std::string degradedLine(const Report& report, const std::string& where = "report.json");

/// Whether a mesh failed or the result is refuted.
bool anyFailed(const Report& report);

/// Whether queries found what the proof rules out, in a check or in a scene.
bool isRefuted(const Report& report);

/// Whether nothing is worth writing: every mesh failed, there were some, and fewer links have
/// primitives alone.
bool allFailed(const Report& report);

}  // namespace collision_hulls
