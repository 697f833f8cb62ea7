// Pairs of links that self-collision checking skips, as SRDF stores them and MoveIt's Setup
// Assistant writes them.
//
// For example:
//
//     const DisabledPairs disabled = readDisabledPairs("arm.srdf", robot);
//     for (const DisabledPair& pair : disabled.pairs)
//       std::cout << pair.link1 << ' ' << pair.link2 << '\n';
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/primitives/spheres.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// One `<disable_collisions>`.
struct DisabledPair {
  std::string link1, link2;
  std::string reason;  ///< "Adjacent", "Never", "Always", "Default", or what a user wrote ("User")
  /// how this is known: "never within 0.31 m, proved"; written as a comment. Empty if the pair was
  /// read
  std::string known;
};

struct DisabledPairs {
  /// pairs disabled by default first, the others in document order; no pair twice, in either order
  std::vector<DisabledPair> pairs;
  /// what was ignored: links that the robot does not have, as in an SRDF for several variants of a
  /// robot; and that the SRDF names another robot
  std::vector<std::string> notes;
};

/// The disabled pairs of an SRDF. As in MoveIt, the order of elements does not matter:
/// `<disable_default_collisions>` disables all pairs of a link, `<enable_collisions>` enables one
/// of these again, and `<disable_collisions>` disables a pair. `path` (may be empty) appears in
/// messages. Parsed in another process, as meshes are. Throws kNotXml; kNotAnSrdf, also for a link
/// without a name, for more than a million pairs, and where none of the pairs is of this robot;
/// kReaderFailed, kOutOfMemory, kOutOfTime, kCancelled.
DisabledPairs parseDisabledPairs(const std::string& srdf_text, const RobotDescription& robot,
                                 const std::string& path = "", const RunControl& control = {});

/// The same for a file. Also throws kFileNotFound, kTooLarge.
DisabledPairs readDisabledPairs(const std::string& srdf_file, const RobotDescription& robot,
                                const RunControl& control = {});

/// The spheres that stand for a link, in its frame [m].
struct SphereApproximation {
  std::string link;
  std::vector<Sphere> spheres;
};

/// A document `<robot name="...">` with one `<disable_collisions>` per pair, and one
/// `<link_sphere_approximation>` per link with spheres, in the given order, to merge into a robot's
/// SRDF or to use as one. parseDisabledPairs() reads the same pairs back.
std::string srdfFragment(const std::string& robot_name, const std::vector<DisabledPair>& pairs,
                         const std::vector<SphereApproximation>& spheres = {});

}  // namespace collision_hulls
