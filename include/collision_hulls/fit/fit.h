// Fits a collision model to a scene: the coarsest cut through each mesh's hull tree that changes no
// answer.
//
// A model is adequate for a clearance c if it is free in every configuration in which the original
// robot keeps at least c from the scene and from itself. Every cut covers its mesh, so no model
// misses a collision; a coarse one has false collisions.
//
// What the robot has beside the meshes that it is fitted by (KeptBody) is in both as it is.
//
//   1. set aside what of the scene is too far away for any link; prove which pairs of bodies can
//      never come within c of each other; leave out the pairs that self-collision checking skips
//   2. start with one hull per mesh: the root of its tree
//   3. sample configurations: where the model collides though the original is clear, open tree
//      nodes (replace them by their children), the cheapest cure first, until the model is free
//   4. cure all counterexamples again from the roots, close every node (the reverse) that can stay
//      closed, and keep the smaller result
//   5. replace each hull by the cheapest primitive that encloses it, a sphere, box or cylinder;
//      take back each primitive that collides in a sample in which the hulls do not, whatever the
//      original's distance there, so that primitives add neither bodies nor false hits
//   6. before step 5 and again after it: draw fresh samples, and open or take back, until a whole
//      batch shows nothing that can be cured
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/measure/solid.h"
#include "collision_hulls/robot/kinematics.h"
#include "collision_hulls/scene/scene.h"
#include "collision_hulls/scene/srdf.h"

namespace collision_hulls {

/// A mesh at every level of detail, in its own frame.
struct FitMesh {
  TriangleMesh original;               ///< as read and scaled
  std::shared_ptr<const Solid> solid;  ///< its solid
  HullTree tree;
  double margin = 0;     ///< [m] by which hulls grow when written, see roundOutward()
  int max_vertices = 0;  ///< per hull as written; 0: no limit
  int max_hulls = 0;     ///< per mesh; 0: no limit
};

/// A mesh on a link.
struct FitElement {
  std::string name;                                          ///< used in messages
  std::size_t link = 0;                                      ///< index in RobotDescription::links
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  ///< in the link's frame
  std::shared_ptr<const FitMesh> mesh;
};

/// A body that stays as it is, in its link's frame: a primitive of the robot description, or a mesh
/// that no hulls replace.
struct KeptBody {
  std::size_t link = 0;
  std::variant<ConvexHull, TriangleMesh> shape;
};

struct FitProblem {
  RobotDescription robot;
  std::vector<FitElement> elements;
  std::vector<KeptBody> kept;
  Scene scene;
  std::vector<DisabledPair> disabled;  ///< pairs of links that are not checked
  /// to fit to, of finite values; empty: samples from the joints' whole ranges
  std::vector<Configuration> configurations;
  /// If joints are held, by limits without room that they will not have where the model is used:
  /// the robot's rest configuration with its own limits. Pairs of links that touch in it are left
  /// out, and SceneFit::disabled names no pair that always or never meets, which may be so only
  /// while joints are held. Empty: no joint is held.
  Configuration rest_unheld = {};
};

struct FitOptions {
  double clearance = 0.01;      ///< [m] c, > 0
  std::size_t samples = 10000;  ///< per verification batch; 1 to 10 million
  std::uint64_t seed = 1;
  bool compare = false;    ///< also measure other models, which takes longer
  bool primitives = true;  ///< allow spheres, boxes and cylinders in place of hulls
};

/// Throws kBadOption for a value outside its range.
void check(const FitOptions& options);

/// The fitted model of an element.
struct FittedElement {
  /// nodes of its tree, ascending; nodes that a primitive replaces come last
  std::vector<int> cut;
  /// one per node of the cut, as written; together they cover the mesh. Where a primitive replaces
  /// the node: a polyhedron around it
  std::vector<ConvexHull> hulls;
  /// for the last nodes of the cut, in the mesh's frame, exactly as they will be written
  std::vector<GeometryElement> primitives;
};

struct FittedLink {
  std::string link;
  std::size_t hulls = 0;
  std::string primitive;  ///< "box", or "2 boxes, 1 sphere"; empty: none
  std::string reason;     ///< "3 hulls: against shelf at 18 mm"
  bool proved = false;    ///< never comes within c of anything
};

/// A pair of links, or of a link and a body of the scene, that is not checked.
struct LeftOutPair {
  std::string first, second;
  std::string reason;   ///< "Adjacent", "Disabled", "Default", "Always", "Never", "Fixed"
  std::string known;    ///< how that is known
  bool links = false;   ///< both are links
  bool at_rest = true;  ///< they are in contact with all joints at rest, too; said of "Always"
};

/// How often two links, or a link and a body of the scene, collide over the verification samples.
struct PairHits {
  std::string first, second;
  bool links = false;        ///< both are links
  std::size_t original = 0;  ///< samples in which the originals collide
  std::size_t before = 0;    ///< samples in which the single hulls collide and the originals do not
  std::size_t after = 0;     ///< the same for the fitted model
};

/// A model on the verification samples; src/fit/comparison.h lists the models.
struct ModelRow {
  std::string model;
  double tolerance = 0;  ///< [m] of a uniform cut
  std::size_t hulls = 0, vertices = 0;
  /// samples in which the original keeps its clearance; of these, the model collides
  std::size_t clear = 0, phantom = 0;
  /// samples in which the original does not collide; of these, the model does
  std::size_t free = 0, false_hits = 0;
  /// samples in which the original collides and the model does not
  std::size_t missed = 0;
  double collision_us = 0, distance_us = 0;  ///< [us] per query, with a BoxedModel on one thread
  double tree_us = 0;                        ///< collision_us with FCL's dynamic trees
  /// collision_us where the original is free but nearer than the clearance; 0: nowhere
  double close_us = 0;
};

/// What is known about a fitted model. Rates are shares of configurations, over the pairs that are
/// checked.
struct FitReport {
  std::string scene;
  double clearance = 0;  ///< [m]
  /// for verification; not used for fitting, unless the configurations were given
  std::size_t samples = 0;
  bool given = false;                  ///< the configurations were given
  std::map<std::string, double> held;  ///< [rad or m] joints that did not move, by name
  std::size_t asked = 0;               ///< samples evaluated while fitting
  std::size_t counterexamples = 0;     ///< found and cured
  std::size_t original_hits = 0;       ///< samples in which the original collides
  std::size_t model_hits = 0;          ///< samples in which the model collides
  /// samples in which the original collides and the model does not: must be 0
  std::size_t missed = 0;
  /// samples in which the model collides though the original keeps its clearance
  std::size_t phantom = 0;
  /// upper bound on the share that these are of all configurations, and not only of those in which
  /// the original keeps its clearance; at most 1, at 95 % confidence, however many batches of
  /// samples were tried until one verified the model; 0 if the configurations were given
  double phantom_rate_bound = 0;
  /// of the first `clear_of` samples, those in which the original keeps its clearance: what false
  /// collisions are counted among
  std::size_t clear = 0, clear_of = 0;
  /// counterexamples that even the finest hulls of the trees do not cure
  std::size_t leaf_contacts = 0;
  std::string leaf_contact;  ///< the pairs that have most of them, with the distance in one
  std::size_t pairs = 0, proved_pairs = 0;
  /// bodies of the scene that are too far away for any link: beyond twice its reach from its first
  /// joint. Such pairs are proved, and the times of queries are without them
  std::size_t far_bodies = 0;
  /// [us] to decide whether a configuration is free, with a BoxedModel on one thread; skips the
  /// pairs of links that are proved apart, as the written SRDF does
  double query_us = 0, original_query_us = 0;
  double distance_us = 0, original_distance_us = 0;  ///< [us] to compute the distance to contact
  /// of the model, primitives included; leaves of all trees
  std::size_t hulls = 0, full_hulls = 0;
  std::size_t primitives = 0;  ///< of the model
  /// where the original at rest collides with the scene, as in "base against shelf" or, if a body
  /// lies inside a link's mesh, "peg inside base"; empty: nowhere
  std::string scene_contact;
  /// samples in which the original collides with the scene, and the first of them, as in
  /// "number 12, base against shelf"
  std::size_t scene_hits = 0;
  std::string first_scene_hit;
  std::string most_scene_hits;  ///< the pair that has most of them: "base against shelf, in 30"
  std::vector<FittedLink> links;
  std::vector<LeftOutPair> left_out;
  std::vector<PairHits> self;  ///< pairs of links that have a false collision before or after
  std::vector<std::string> notes;
  std::vector<ModelRow> models;  ///< empty unless FitOptions::compare
  double seconds = 0;
};

struct SceneFit {
  std::vector<FittedElement> elements;  ///< one per element of the problem
  std::vector<DisabledPair> disabled;   ///< the pairs that MoveIt's Setup Assistant would disable
  FitReport report;
};

/// Leaves FitReport::held empty. Deterministic except for the times, whatever the number of
/// threads. Throws kBadOption as check(), for a problem without elements, and for configurations as
/// Kinematics::check(); kNotARobot as Kinematics; kTooLarge for more than two million pairs of
/// links and bodies; kCancelled.
SceneFit fitScene(const FitProblem& problem, const FitOptions& options,
                  const RunControl& control = {});

}  // namespace collision_hulls
