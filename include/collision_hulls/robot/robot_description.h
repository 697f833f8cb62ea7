// Robot descriptions, in and out: URDF and xacro, packages, URIs, and new collision elements.
//
// For example:
//
//     const RobotDescription robot = readRobotDescription("arm.urdf");
//     const PackageFinder find_package = defaultPackageFinder(robot.path);
//     for (const GeometryElement& element : robot.links.front().visuals)
//       if (element.kind == GeometryElement::Kind::kMesh)
//         std::cout << resolveUri(element.uri, robot.path, find_package) << '\n';
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "collision_hulls/control.h"

namespace collision_hulls {

/// A geometry of a link: one `<visual>` or `<collision>` of the description.
struct GeometryElement {
  /// kNone: it has no geometry, as one of a material alone
  enum class Kind { kMesh, kBox, kSphere, kCylinder, kNone };
  Kind kind = Kind::kMesh;
  /// of a mesh, as written in the description
  std::string uri;
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();  ///< of a mesh
  /// [m] box: sides; sphere: radius, -, -; cylinder: radius, length, -
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  ///< element in the link's frame
  /// the element's name attribute, often empty
  std::string name;
  /// why the element cannot be used, with its line; kind is kMesh then and the rest may be missing.
  /// Empty: it can
  std::string fault;
};

struct LinkDescription {
  std::string name;
  std::vector<GeometryElement> visuals, collisions;  ///< in document order
  /// in the root link's frame, all joints at zero (or their nearest limit)
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::string parent;  ///< link; empty for the root
};

/// A joint of the description. Values in rad or m.
struct JointDescription {
  enum class Kind { kFixed, kRevolute, kContinuous, kPrismatic, kFloating, kPlanar };
  std::string name;
  Kind kind = Kind::kFixed;
  std::string parent, child;  ///< links
  /// of the joint, in the parent's frame
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  /// of unit length, in the joint's frame
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  /// -pi and pi where it is continuous; both 0 where the limits are missing or crossed
  double lower = 0, upper = 0;
  std::string mimic;  ///< the joint that this one follows; empty: none
  double mimic_multiplier = 1, mimic_offset = 0;
};

struct RobotDescription {
  std::string name;
  std::string text;  ///< the URDF, byte for byte as given
  /// file it came from; empty for a parameter or a service call
  std::string path;
  std::vector<LinkDescription> links;  ///< in document order
  /// a link's own joint to its parent; parents before children
  std::vector<JointDescription> joints = {};
  std::vector<std::string> notes = {};            ///< what is odd about it, though it can be read
  std::vector<std::string> xacro_arguments = {};  ///< that it was expanded with
};

/// Parses a URDF. `path` (may be empty) stands in messages and is what relative URIs are relative
/// to. An element that cannot be read has a fault; the others are read all the same. Throws
/// kNotXml, kNotARobot, kNoLinks, kTooLarge; the message gives line and reason where the parser
/// does. Parses in another process, as readMesh() does (mesh/mesh_io.h), and throws for that
/// kReaderFailed, kOutOfMemory, kOutOfTime, kCancelled.
RobotDescription parseRobotDescription(const std::string& urdf_text, const std::string& path = "",
                                       const RunControl& control = {});

/// Reads a .urdf, or a .xacro through the user's xacro program (kXacroMissing where there is none),
/// which finds the package that the file lies in, those beside it, and those of `package_path`, as
/// defaultPackageFinder() takes it. `xacro_arguments`: "NAME:=VALUE", values for a .xacro file's
/// arguments; kBadOption for those of another file, and for those that the file does not have.
/// Throws as parseRobotDescription(), kFileNotFound, kPackageNotFound for a package that the .xacro
/// file needs, and kNotARobot where xacro fails.
RobotDescription readRobotDescription(const std::string& path, const RunControl& control = {},
                                      const std::vector<std::string>& package_path = {},
                                      const std::vector<std::string>& xacro_arguments = {});

/// Finds packages, and files of packages that are not where their URIs say. Copies share one search
/// and its notes. Thread safe if the lookup is.
class PackageFinder {
 public:
  /// The folder of a package; nullopt for an unknown one.
  using Lookup = std::function<std::optional<std::string>(const std::string& package)>;

  PackageFinder();  ///< knows no package
  template <typename F, typename = std::enable_if_t<!std::is_base_of_v<PackageFinder, F>>>
  PackageFinder(F lookup) : PackageFinder(PackageFinder().askingFirst(std::move(lookup))) {}

  /// The same search after `lookup`, such as that of ROS.
  PackageFinder askingFirst(Lookup lookup) const;

  /// The folder of a package, or else one of the same name nearby, which leaves a note; nullopt if
  /// there is neither.
  std::optional<std::string> operator()(const std::string& package) const;

  /// The folder of a package; nullopt for an unknown one.
  std::optional<std::string> knownPackage(const std::string& package) const;

  /// The file that package://`package`/`rest` most likely means if the package is unknown or lacks
  /// it: NAME/rest, then rest, in the folders of the package path, then in those above `base` (a
  /// file) and above the description, from the nearest to the farthest, and in their folders
  /// meshes/. A bare file name counts only in the package path and in the two nearest folders.
  /// nullopt for a package that the package path names by NAME=DIR, and for a `rest` that leads out
  /// of its package. Leaves a note.
  std::optional<std::string> fileNearby(const std::string& package, const std::string& rest,
                                        const std::string& base) const;

  /// For messages: the folder that was used so far in place of an unknown package; empty: none.
  std::string standIn(const std::string& package) const;

  /// For messages: the file whose path differs from this one in the case of letters (ASCII), and
  /// that where fileNearby() looks. nullopt: there is none, or its folder may not be read.
  std::optional<std::string> inOtherCase(const std::string& path) const;
  std::optional<std::string> nearbyInOtherCase(const std::string& package, const std::string& rest,
                                               const std::string& base) const;

  /// The real folder of the package in ROS_PACKAGE_PATH or the package path that holds a path
  /// without links; empty if none does.
  std::string packageWith(const std::string& path) const;

  /// Which folders were used in place of packages, and which manifests could not be read; so far.
  std::vector<std::string> notes() const;

 private:
  friend PackageFinder defaultPackageFinder(const std::string& near,
                                            const std::vector<std::string>& package_path);
  class Search;
  explicit PackageFinder(std::shared_ptr<Search> search);

  Lookup first_;
  std::shared_ptr<Search> search_;
};

/// Looks among the packages that enclose `near` (a file or folder; may be empty), then in
/// ROS_PACKAGE_PATH (crawling as rospack does: a folder with package.xml is a package;
/// CATKIN_IGNORE stops), then for `share/<package>` in CMAKE_PREFIX_PATH, then among the packages
/// in `package_path`, and last for a folder of the package's name in `package_path` and above
/// `near`. An item of `package_path` is DIR or NAME=DIR; the latter wins over all of these. Throws
/// kBadOption for an item whose folder does not exist.
PackageFinder defaultPackageFinder(const std::string& near = "",
                                   const std::vector<std::string>& package_path = {});

/// The file that a URI means: package://, model:// (Gazebo's and Drake's word, taken for
/// package://), file://, an absolute path, or one relative to the folder of `base` (a file). A file
/// of a package that is not where its URI says may be one nearby: see PackageFinder::fileNearby(),
/// which leaves a note. Throws kPackageNotFound (names the package and how to make it known) and
/// kFileNotFound.
std::string resolveUri(const std::string& uri, const std::string& base,
                       const PackageFinder& find_package);

/// The file:// URI of an absolute path. Characters that a URI may not hold (RFC 3986) are written
/// like "%20"; bytes beyond ASCII stay as they are.
std::string fileUri(const std::string& path);

/// The NAME of package://NAME/... or model://NAME/...; nullopt for other URIs.
std::optional<std::string> packageOf(const std::string& uri);

/// Whether resolveUri's answer depends on `base`.
bool isRelativeUri(const std::string& uri);

/// The robot descriptions in a package's urdf/ and robots/ folders (.urdf before .xacro, sorted;
/// those that others include last), without files that hold nothing but what others include, such
/// as macros, properties and materials; where there are only such files, those of the whole
/// package.
std::vector<std::string> robotDescriptionsIn(const std::string& package_folder);

/// The descriptions that a search found.
struct FoundDescriptions {
  std::vector<std::string> files;
  /// how many files and folders were looked at before the search was cut short; 0: it saw all
  std::size_t cut_after = 0;
  bool are_parts = false;  ///< none seems to make a robot: they define macros for other files
};

/// The same of all folders below one, hidden ones aside; for packages that keep them elsewhere.
/// Looks at 20,000 files and folders at most, and up to 6 folders deep.
FoundDescriptions robotDescriptionsBelow(const std::string& folder);

/// auto: a link's collision elements if it has any, else its visual ones
enum class Source { kAuto, kVisual, kCollision };
std::optional<Source> sourceNamed(const std::string& name);

/// Which elements of a link are decomposed, and whether they are visual or collision ones.
struct SourceElements {
  bool visual = false;
  std::vector<GeometryElement> elements;
};
SourceElements sourceElements(const LinkDescription& link, Source source);

/// Whether an element is a primitive whose sizes are all above 0; nothing can hit another one.
bool isSolidPrimitive(const GeometryElement& element);

/// A `<collision>` to be written: a mesh by its URI at an origin, or a primitive.
struct CollisionElement {
  std::string name;
  GeometryElement geometry;
};

/// What a link's collision model becomes.
struct LinkCollisions {
  std::vector<CollisionElement> elements;  ///< written as new `<collision>` elements, in this order
  /// the link's `<collision>` elements without a mesh stay, byte for byte; else they go too
  bool keep_primitives = false;
};

/// The description with the `<collision>` elements of the given links replaced; links that are not
/// given keep theirs. Everything else stays byte for byte: comments, unknown tags, order, line
/// ends. New elements are indented like their neighbours and stand where the first replaced one
/// stood (after the last `<visual>`, else first in the link, where there was none). A name that is
/// taken elsewhere in the description gets a number added. Mesh URIs in the `<collision>` elements
/// that stay become what `moved` says of them, if it does. Throws kBadOption for a link that the
/// robot does not have and for an origin, a scale or a size that cannot be written, kCancelled, and
/// kInternal if the text does not read back as it was meant.
std::string rewriteCollisions(const RobotDescription& robot,
                              const std::map<std::string, LinkCollisions>& links,
                              const std::map<std::string, std::string>& moved = {},
                              const RunControl& control = {});

}  // namespace collision_hulls
