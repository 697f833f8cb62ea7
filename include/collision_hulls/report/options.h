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
std::string toString(const Length& length);  ///< parseLength reads it back: "5mm", "1%", "1cm,5%"

/// [m] Reads a length alone, without shares and pairs. Throws as parseLength.
double parseMetres(const std::string& text, const std::string& option);

enum class UriStyle { kPackage, kFile, kRelative };
std::optional<UriStyle> uriStyleNamed(const std::string& name);

struct Options {
  Length tolerance{0.01, 0.05};
  Method method = Method::kCertified;
  Effort effort = Effort::kQuick;
  /// cut the hulls from a tree whose leaves are this fine, kept in the cache (certified)
  std::optional<Length> tree;
  bool fill = false;      ///< cover the inside of closed meshes as well (certified)
  bool segments = false;  ///< give the clusters of triangles as well (hacd)
  int max_hulls = 0;      ///< per mesh; 0: no cap
  int max_vertices = 64;  ///< per hull; 0: no cap
  /// regular expression (ECMAScript) that a link's whole name must match; empty: all
  std::string links;
  Source source = Source::kAuto;
  /// of a single mesh, > 0: 0.001 for one in millimetres; a robot's description has its own scales
  double scale = 1;
  MeshFormat format = MeshFormat::kStl;
  UriStyle uri = UriStyle::kPackage;
  std::string package_name;  ///< of the output; empty: as its folder is called
  int jobs = 0;              ///< threads; 0: as many as cores
  bool validate = true;
  bool cache = true;
  /// let a run that lacked memory or time for some meshes replace an output that has all of them
  bool replace_complete = false;
  std::uint64_t seed = 1;
  int reader_memory = 512;  ///< [MiB] of MeshLimits, for the robot's meshes
  int reader_time = 4;      ///< [s] of MeshLimits
};

std::string methodChoices();  ///< the names of all methods, for messages
std::string effortChoices();  ///< the same for efforts

/// Throws kBadOption naming the option, its value and its range. A tolerance above 1 m is a mistake
/// in its unit.
void check(const Options& options);

/// Sets both caps to what a consumer of the hulls documents: "fcl", "moveit", "bullet", "physx" or
/// "gazebo"; the source has each value and where it comes from. Throws kBadOption for another name.
void applyProfile(const std::string& profile, Options& options);

}  // namespace collision_hulls
