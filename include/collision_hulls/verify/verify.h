// Whether one robot description is a collision model of another, whoever made either: how much of
// each link's surface it leaves uncovered, how far it protrudes, and what planners would miss.
//
// For example:
//
//     const Description arm{readRobotDescription("arm.urdf"), defaultPackageFinder("arm.urdf")};
//     VerifyOptions options;
//     options.max_uncovered = 0;  // [m]
//     const Verification seen = verify(arm, arm, options);  // its visuals, its collision model
//     if (!passed(seen, options)) std::cerr << toTable(seen);
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

struct Description {
  RobotDescription robot;
  PackageFinder find_package;
};

/// A mesh file as a description: a robot of one link, "mesh", with the file as `<visual>` and as
/// `<collision>`. Does not read it.
Description describeMesh(const std::string& file);

/// Which elements of the original a model was made from.
struct MadeFrom {
  std::string report;             ///< the file that says so
  Source source = Source::kAuto;  ///< LinkOptions::source: kAuto prefers a link's `<collision>`
  double close_openings = 0;      ///< [m] what was closed before; the largest where links differ
  bool fitted = false;            ///< to a scene, by fit_scene and not decompose
  /// kVisual or kCollision, of the links whose meshes were decomposed
  std::map<std::string, Source> of_link;
};

/// What report.json says of the package in whose urdf/ the result's file lies; nullopt if there is
/// no report, or if its model was made from another description than the original.
std::optional<MadeFrom> madeFrom(const Description& original, const Description& result);

struct VerifyOptions {
  /// What counts of the original. kAuto: a link's `<visual>` elements if it has any, else its
  /// `<collision>` ones. Of the result, `<collision>` alone counts.
  Source source = Source::kAuto;
  std::optional<MadeFrom> made_from;  ///< counts instead of `source`; a note says so
  std::string links;  ///< regular expression that a link's whole name must match; empty: all
  /// [m] Openings of the original's shells up to this width are closed first; see closeOpenings().
  /// 0: none
  double close_openings = 0;
  /// [m] gates: a link that exceeds one does not pass. Without a gate any value does.
  std::optional<double> max_uncovered, max_protrusion;
  std::size_t configurations = 1000;  ///< of the robot, in which collisions are queried
  std::uint64_t seed = 1;
  /// threads, 0 or more; 0: one per core. The result is the same for any number
  int jobs = 0;
  MeshLimits mesh_limits;  ///< for the meshes of both
};

enum class LinkStatus {
  kOk,       ///< measured, and within the gates
  kOver,     ///< measured, and beyond a gate
  kMissing,  ///< the result has nothing where the original has geometry: all of it is uncovered
  kAdded,    ///< the original has nothing where the result has geometry: that has no bound
  kFailed    ///< not measured, as an element cannot be read
};
const char* name(LinkStatus status);  ///< "ok", "over", "missing", "added", "failed"

/// The largest of some distances.
struct Largest {
  double bound = 0;  ///< [m] proved: none is larger
  /// [m] one of them is at least as large, at `where`; near an opening of a solid, this is the
  /// distance to its surface
  double found = 0;
  Eigen::Vector3d where = Eigen::Vector3d::Zero();  ///< [m] in the link's frame
};

/// Coordinates are in the link's frame. Bodies overlap freely: what counts is their union.
struct LinkVerification {
  std::string link;
  LinkStatus status = LinkStatus::kOk;
  std::string reason;         ///< why it is not ok
  std::string uri;            ///< of the mesh that cannot be read, if that is why
  std::size_t triangles = 0;  ///< of the original, primitives included
  double diagonal = 0;        ///< [m] of the original's bounding box
  /// of the result: convex bodies, parts of meshes that are not convex, and spheres and cylinders
  std::size_t hulls = 0, meshes = 0, primitives = 0;
  Largest uncovered;   ///< distances from the original's surface to the result
  Largest protrusion;  ///< distances from the result to the original's solid (measure/solid.h)
  /// share of the original's area that is further from the result than a millionth of the diagonal,
  /// by 2,000 samples
  double uncovered_share = 0;
  /// collision queries in which the link took part: those that hit the original, those that the
  /// result missed, and those that hit the result alone
  std::size_t queries = 0, hits = 0, missed = 0, phantom = 0;
  double seconds = 0;
};

/// Two links, and the sampled configurations in which the result answers unlike the original.
struct PairVerification {
  std::string first, second;  ///< names
  /// configurations: all, those in which the original's links collide, those in which the result
  /// misses that, and those in which the result's alone collide
  std::size_t queries = 0, hits = 0, missed = 0, phantom = 0;
};

struct Verification {
  std::vector<LinkVerification> links;  ///< with geometry on either side, in the original's order
  /// pairs of links with a missed or a phantom query, those with most of them first; at most
  /// 1,000, and none for more than 2,000 links
  std::vector<PairVerification> pairs;
  std::size_t configurations = 0;
  std::size_t queries = 0, hits = 0, missed = 0, phantom = 0;  ///< of all links, each query once
  /// Queries that the bounds rule out: a miss by more than `uncovered`, a phantom further away than
  /// `protrusion`, by more than a micrometre. Must be 0.
  std::size_t contradictions = 0;
  std::vector<std::string> notes;
  double seconds = 0;
};

/// Compares two descriptions link by link, then by collision queries: in each of the sampled
/// configurations, between the links that can move against each other, and with a box that is put
/// near one of them.
///
/// A mesh of the result counts as what it is, its surface and what that encloses, although some
/// consumers take its convex hull. Its closed components that are convex up to some millionths of
/// their size count as hulls, however many are in one file. Boxes, spheres and cylinders are exact
/// where the result covers; where they protrude, and as parts of the original, round ones are
/// replaced by polyhedra whose error is part of the bound. A mesh or primitive that both sides hold
/// equally is covered and does not protrude.
///
/// For a robot with joints that Kinematics refuses, no configuration is tried, and a note says so.
///
/// Deterministic apart from times. A mesh that cannot be read fails its link. Throws kBadOption for
/// an option out of range, and where nothing can be compared: neither has geometry in the chosen
/// links, or each has it in links of its own alone; kCancelled.
Verification verify(const Description& original, const Description& result,
                    const VerifyOptions& options, const RunControl& control = {});

/// Whether every link is within the gates and was measured, and nothing contradicts the bounds. A
/// link that the result lacks fails only the gate on cover, and one that the original lacks only
/// that on protrusion.
bool passed(const Verification& verification, const VerifyOptions& options);

std::string toTable(const Verification& verification);
/// As JSON; what has no bound is null. `original` and `result`: what the two were read from.
std::string toJson(const Verification& verification, const VerifyOptions& options,
                   const std::string& original, const std::string& result);

}  // namespace collision_hulls
