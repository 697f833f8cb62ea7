// The options of a run, as values. The command line, the services and the node's parameters all
// become these.
//
// For example:
//
//     Options options;
//     options.tolerance = parseLength("1cm,5%");  // of each mesh the smaller one
//     options.links = "arm_.*";
//     check(options);
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "collision_hulls/decompose/decompose.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// A length, a share of each mesh's bounding-box diagonal, or the smaller of both. A part that is
/// not set is infinite.
struct Length {
  static constexpr double kUnset = std::numeric_limits<double>::infinity();
  double limit = kUnset;  ///< [m]
  double share = kUnset;  ///< of the diagonal: 0.01 for 1 %
  /// [m] for a mesh with this diagonal [m].
  double metres(double diagonal) const {
    return share == kUnset ? limit : std::min(limit, share * diagonal);
  }
};
constexpr bool operator==(const Length& a, const Length& b) {
  return a.limit == b.limit && a.share == b.share;
}
constexpr Length lengthOf(double metres) {
  return {metres, Length::kUnset};
}
constexpr Length shareOf(double share) {
  return {Length::kUnset, share};
}

/// Reads "5mm", "0.5 cm", "0.005", "0.005m", "1%", or "1cm,5%" and "5%,1cm" for the smaller of
/// both. Units: m, cm, mm, um, in, %. A number without a unit is in metres; in a pair the length
/// needs its unit, so that "1,5%" is not read as 1 m and 5 %. Throws kBadOption for anything else,
/// for a value that is not positive or not finite, and for a percentage above 100; the message
/// names the `option` and says what it takes.
Length parseLength(const std::string& text, const std::string& option = "tolerance");
/// As parseLength(), up to 1 m; for lengths that are more, as 5 where 5mm was meant, the message
/// quotes the text and says what was probably meant.
Length parseTolerance(const std::string& text, const std::string& option = "tolerance");
std::string toString(const Length& length);  ///< parseLength reads it back: "5mm", "1%", "1cm,5%"

/// [m] Reads a length alone, without shares and pairs. Throws as parseLength.
double parseMetres(const std::string& text, const std::string& option);
/// As parseMetres(), but 0 is allowed.
double parseMetresOrZero(const std::string& text, const std::string& option);
/// As parseMetresOrZero(), up to 1 m like parseTolerance(). For all short lengths that may be 0.
double parsePadding(const std::string& text, const std::string& option = "padding");

enum class UriStyle { kPackage, kFile, kRelative };
const char* name(UriStyle style);  ///< "package", "file", "relative"
std::optional<UriStyle> uriStyleNamed(const std::string& name);
const char* name(Source source);  ///< "auto", "visual", "collision"

/// What becomes of a link's `<collision>` elements.
enum class Action {
  kDecompose,  ///< hulls take their place
  kKeep,       ///< they stay as they are
  kRemove      ///< they go
};
const char* name(Action action);  ///< "decompose", "keep", "remove"
std::optional<Action> actionNamed(const std::string& name);

/// The bodies that a link's collision model consists of.
enum class Shapes {
  kHulls,
  kMixed,       ///< a primitive in place of each hull, or of all, that it can replace
  kPrimitives,  ///< spheres, boxes and cylinders alone, as large as the tolerance lets them be
  kSpheres,     ///< as many as it takes
  kSphere,      ///< this one and the following: a single one, whatever its bound
  kBox,
  kCylinder,
  kCapsule  ///< in URDF a cylinder and two spheres
};
const char* name(Shapes shapes);  ///< "hulls", "mixed", "primitives", "spheres", "sphere", ...
std::optional<Shapes> shapesNamed(const std::string& name);
const std::vector<Shapes>& allShapes();
bool isSingle(Shapes shapes);  ///< kSphere and the following

/// What can be chosen link by link. It holds for all elements of the link.
struct LinkOptions {
  Action action = Action::kDecompose;
  /// acceptable protrusion, and that as a share of the mesh's diagonal: the smaller one counts
  Length tolerance{0.01, 0.05};
  Method method = Method::kCertified;
  Effort effort = Effort::kQuick;
  /// cut the hulls from a tree whose leaves are this fine, kept in the cache (certified)
  std::optional<Length> tree;
  bool fill = false;      ///< cover the inside of closed meshes as well (certified)
  int max_hulls = 0;      ///< per mesh; 0: no limit
  int max_vertices = 64;  ///< per hull, at least 8; 0: no limit
  Source source = Source::kAuto;
  /// [m] >= 0: the hulls hold everything within this distance of the surface, and may protrude
  /// further by it
  double padding = 0;
  /// [m] >= 0: openings of shells no wider than this are closed first; see closeOpenings()
  double close_openings = 0;
  Shapes shapes = Shapes::kHulls;
  std::vector<Region> regions;  ///< in the frame of what the options are for: the link, or its mesh
};

/// Some of a link's options; those that are not set stay as they were.
struct LinkSettings {
  std::optional<Action> action;
  std::optional<Length> tolerance;
  std::optional<Method> method;
  std::optional<Effort> effort;
  std::optional<bool> fill;
  std::optional<int> max_hulls, max_vertices;
  std::optional<Source> source;
  std::optional<double> padding, close_openings;
  std::optional<Shapes> shapes;
};

/// Settings for the links whose whole name a regular expression matches.
struct LinkRule {
  std::string pattern;  ///< ECMAScript
  LinkSettings settings;
  std::string place;  ///< where it is written, for messages: "'panda.yaml', line 3"
};

/// A box [m], [rad]: fixed-axis roll, pitch and yaw about its centre, as in URDF.
struct RegionBox {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(), size = Eigen::Vector3d::Zero();
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();
};

/// The points p with normal . p >= offset [m].
struct RegionHalfSpace {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double offset = 0;
};

/// A region of the links whose whole name a regular expression matches, in the frame of each.
struct RegionRule {
  std::string pattern;  ///< ECMAScript; empty for a single mesh, in whose frame it is then
  std::variant<RegionBox, RegionHalfSpace> shape;
  double tolerance = kRegionSlack;  ///< [m]
  std::string name;                 ///< for reports; empty: "1" for the first, and so on
  std::string place;                ///< as LinkRule::place
};

/// One of several models that a run makes of a robot, each with its own tolerance.
struct ModelOptions {
  std::string name;
  Length tolerance;
};

/// What the base holds is the default of all links.
struct Options : LinkOptions {
  std::vector<LinkRule> rules;  ///< the last that matches a link counts, setting by setting
  std::vector<RegionRule> region_rules;  ///< all that match a link hold
  std::vector<ModelOptions> models;      ///< empty: one, with `tolerance`
  bool segments = false;                 ///< give the clusters of triangles as well (hacd)
  /// regular expression (ECMAScript) that a link's whole name must match; empty: all. Links that it
  /// does not match are left alone, whatever the rules say
  std::string links;
  std::string links_place;  ///< as LinkRule::place; empty: an option named it
  /// of a single mesh, > 0: 0.001 for one in millimetres; a robot's description has its own scales
  double scale = 1;
  MeshFormat format = MeshFormat::kStl;
  UriStyle uri = UriStyle::kPackage;
  /// let relative file names of the elements that stay lead to the same files from the output
  bool rebase = false;
  std::string package_name;  ///< of the output; empty: as its folder is called
  int jobs = 0;              ///< threads; 0: as many as cores
  bool validate = true;
  bool cache = true;
  bool html = true;  ///< write report.html beside report.json
  /// let a run that lacked memory or time for some meshes replace an output that has all of them
  bool replace_complete = false;
  std::uint64_t seed = 1;
  int reader_memory = 512;  ///< [MiB] of MeshLimits, for the robot's meshes
  int reader_time = 4;      ///< [s] of MeshLimits
  /// [s] for reading all meshes and making their hulls by certified, which share it; 0: no limit.
  /// Validating and writing come on top. Refused with a tree, another method, and shapes other
  /// than hulls and mixed; links that have such settings of their own ignore it
  double time_limit = 0;
};

/// [s] Reads "5s", "500ms", "2min", "1h", seconds alone, or 0. Throws kBadOption for anything else.
/// `option`: what the message calls it.
double parseSeconds(const std::string& text, const std::string& option);

std::string methodChoices();  ///< the names of all methods, for messages
std::string effortChoices();  ///< the same for efforts
std::string shapesChoices();  ///< and for shapes

/// Throws kBadOption for a tolerance that is not positive or above 1 m, a mistake in its unit.
/// `option`: what the message calls it.
void checkTolerance(const Length& tolerance, const std::string& option = "tolerance");
void checkLimits(const LinkOptions& options);  ///< throws kBadOption for a limit out of range
/// Throws kBadOption where `shapes` contradicts another setting.
void checkShapes(const LinkOptions& options);

/// Throws kBadOption for an option out of range and for options that contradict each other, naming
/// the option, its value and its range. Rules and regions are checked once there is a robot, see
/// LinkDecisions.
void check(const Options& options);

/// Sets max_hulls and max_vertices to what a consumer of the hulls documents: "fcl", "moveit",
/// "bullet", "physx" or "gazebo"; the source has each value and where it comes from. Where a
/// consumer documents none, there is no limit on hulls, and that on vertices is the default. Throws
/// kBadOption for another name.
void applyProfile(const std::string& profile, Options& options);

}  // namespace collision_hulls
