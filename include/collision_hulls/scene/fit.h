// No more than a scene needs: the coarsest cut through each mesh's hull tree that does not change an answer.
//
// A model is adequate for a clearance c when every configuration in which the original robot keeps at least c from the scene and from
// itself is free for the model, too. Every cut covers its mesh, so that no model misses a collision; a coarse one has phantoms.
//
//   1. prove which pairs of bodies can never come within c; leave out what self-collision checks leave out
//   2. begin with one hull for each mesh: the root of its tree
//   3. ask samples: where the model is hit though the original is clear, open tree nodes, the cheapest cure first, until it is free
//   4. cure all counterexamples at once from the beginning, and close what can be closed
//   5. put the cheapest primitive in place of each hull: a sphere, a box or a cylinder about it; take back those that are hit in any sample
//      in which the hulls are not, however near, so that primitives add neither bodies nor false hits
//   6. before 5, and once more after it: ask fresh samples, and open or take back, until a whole batch has none that could be cured
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/check/solid.h"
#include "collision_hulls/control.h"
#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/robot/kinematics.h"
#include "collision_hulls/scene/scene.h"
#include "collision_hulls/scene/srdf.h"

namespace collision_hulls {

/// A mesh at every level of detail, in a frame of its own.
struct FitMesh {
  TriangleMesh original;               ///< as read and scaled
  std::shared_ptr<const Solid> solid;  ///< of it
  HullTree tree;
  double margin = 0;     ///< [m] that hulls are grown by when they are written, see fitCover()
  int max_vertices = 0;  ///< of a hull as written; 0: no cap
  int max_hulls = 0;     ///< of the mesh; 0: no cap
};

/// A mesh on a link.
struct FitElement {
  std::string name;                                          ///< for messages
  std::size_t link = 0;                                      ///< index in RobotDescription::links
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  ///< in the link's frame
  std::shared_ptr<const FitMesh> mesh;
};

/// A body of a link that stays as it is: a primitive of the description, in the link's frame.
struct KeptBody {
  std::size_t link = 0;
  ConvexHull hull;
};

struct FitProblem {
  RobotDescription robot;
  std::vector<FitElement> elements;
  std::vector<KeptBody> kept;
  Scene scene;
  std::vector<DisabledPair> disabled;         ///< pairs of links that are not looked at
  std::vector<Configuration> configurations;  ///< given ones; none: samples of all that the joints allow
};

struct FitOptions {
  double clearance = 0.01;      ///< [m] c, > 0
  std::size_t samples = 10000;  ///< of a batch that verifies
  std::uint64_t seed = 1;
  bool compare = false;    ///< measure other models beside the fitted one: takes longer
  bool primitives = true;  ///< spheres, boxes and cylinders may stand for hulls
};

/// Throws kBadOption.
void check(const FitOptions& options);

/// What became of an element.
struct FittedElement {
  std::vector<int> cut;                     ///< nodes of its tree; ascending, those that primitives stand for after the others
  std::vector<ConvexHull> hulls;            ///< of the cut, as written; they cover the mesh. Those of primitives are polyhedra about them
  std::vector<GeometryElement> primitives;  ///< of the last of the cut's nodes, in the mesh's frame; exactly as they are to be written
};

struct FittedLink {
  std::string link;
  std::size_t hulls = 0;
  std::string primitive;  ///< "box", or "2 boxes, 1 sphere"; empty where there is none
  std::string reason;     ///< "3 hulls: against shelf at 18 mm"
  bool proved = false;    ///< that it never comes within c of anything
};

/// A pair of links, or of a link and a body of the scene, that is not looked at.
struct LeftOutPair {
  std::string first, second;
  std::string reason;  ///< "Adjacent", "Disabled", "Default", "Always", "Never", "Fixed"
  std::string known;   ///< how it is known
  bool links = false;  ///< both are links
};

/// How often two bodies hit each other, over the samples that verify.
struct PairHits {
  std::string first, second;
  bool links = false;        ///< both are links
  std::size_t original = 0;  ///< samples in which the original hits
  std::size_t before = 0;    ///< samples in which the single hulls hit and the original does not
  std::size_t after = 0;     ///< the same of the fitted model
};

/// A model on the samples that verify; see src/scene/comparison.h for their names.
struct ModelRow {
  std::string model;
  double tolerance = 0;  ///< [m] of a uniform cut
  std::size_t hulls = 0, vertices = 0;
  std::size_t clear = 0, phantom = 0;        ///< samples in which the original keeps its clearance; of these, the model is hit
  std::size_t free = 0, false_hits = 0;      ///< samples in which the original is not hit; of these, the model is
  std::size_t missed = 0;                    ///< samples in which the original is hit and the model is not
  double collision_us = 0, distance_us = 0;  ///< [us] of a query, by a BoxedModel on one thread
  double tree_us = 0;                        ///< collision_us in FCL's dynamic trees
  double close_us = 0;                       ///< collision_us where the original is free, but nearer than the clearance; 0: it never is
};

/// What is known about a fitted model. Rates are of configurations, over the pairs that are looked at.
struct FitReport {
  std::string scene;
  double clearance = 0;             ///< [m]
  std::size_t samples = 0;          ///< that verify, not used for fitting unless they were given
  bool given = false;               ///< they were given
  std::size_t asked = 0;            ///< all samples that were asked for fitting
  std::size_t counterexamples = 0;  ///< that were found and cured
  std::size_t original_hits = 0;    ///< samples in which the original hits something
  std::size_t model_hits = 0;       ///< the same of the model
  std::size_t missed = 0;           ///< the original is hit and the model is not: must be 0
  std::size_t phantom = 0;          ///< the model is hit though the original is clear by the clearance
  double phantom_rate_bound = 0;    ///< of all configurations, at 95 % confidence; 0 where they were given
  std::size_t leaf_contacts = 0;    ///< counterexamples that the finest hulls of the trees still are
  std::string leaf_contact;         ///< the first of them
  std::size_t pairs = 0, proved_pairs = 0;
  double query_us = 0, original_query_us = 0;        ///< [us] whether a configuration is free, by a BoxedModel on one thread; pairs
                                                     ///< of links that are proved apart are not asked, as the SRDF says that is
                                                     ///< written
  double distance_us = 0, original_distance_us = 0;  ///< [us] how far it is from contact
  std::size_t hulls = 0, full_hulls = 0;             ///< of the model, primitives counted; of the trees' leaves
  std::size_t primitives = 0;                        ///< of the model
  std::string scene_contact;                         ///< the original at rest hits the scene there; empty: it does not
  std::size_t scene_hits = 0;                        ///< samples in which the original hits the scene
  std::vector<FittedLink> links;
  std::vector<LeftOutPair> left_out;
  std::vector<PairHits> self;  ///< of links alone, those with a phantom before or after
  std::vector<std::string> notes;
  std::vector<ModelRow> models;  ///< where they were compared
  double seconds = 0;
};

struct SceneFit {
  std::vector<FittedElement> elements;  ///< of the problem's
  std::vector<DisabledPair> disabled;   ///< as MoveIt's Setup Assistant would find them
  FitReport report;
};

/// Deterministic but for the times, whatever the number of threads. Throws kBadOption, kCancelled.
SceneFit fitScene(const FitProblem& problem, const FitOptions& options, const RunControl& control = {});

}  // namespace collision_hulls
