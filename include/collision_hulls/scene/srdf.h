// Pairs of links that self-collision checks leave out, as SRDF keeps them and MoveIt's Setup Assistant writes them.
#pragma once

#include <string>
#include <vector>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

/// One `<disable_collisions>`.
struct DisabledPair {
  std::string link1, link2;
  std::string reason;  ///< "Adjacent", "Never", "Always", "Default", or what a user wrote ("User")
  std::string known;   ///< how it is known: "never within 0.31 m, proved"; written as a comment. Empty where it was read
};

struct DisabledPairs {
  std::vector<DisabledPair> pairs;  ///< those by default first, else in document order; none twice (in either order)
  std::vector<std::string> notes;   ///< what was left out: links that the robot does not have, as in SRDF files of variants of a robot
};

/// The disabled pairs of an SRDF, as MoveIt has them whatever their order: `<disable_default_collisions>` disables all pairs of a link,
/// `<enable_collisions>` takes one of these back, and `<disable_collisions>` disables a pair.
/// `path` (may be empty) stands in messages. Throws kNotXml, kNotAnSrdf; links without a name are kNotAnSrdf.
DisabledPairs parseDisabledPairs(const std::string& srdf_text, const RobotDescription& robot, const std::string& path = "");

/// The same of a file. Also throws kFileNotFound, kTooLarge.
DisabledPairs readDisabledPairs(const std::string& srdf_file, const RobotDescription& robot);

/// A document `<robot name="...">` with a `<disable_collisions>` for each pair, in the given order; to be merged into a robot's SRDF, or
/// used as one. What parseDisabledPairs() reads back is the same.
std::string srdfFragment(const std::string& robot_name, const std::vector<DisabledPair>& pairs);

}  // namespace collision_hulls
