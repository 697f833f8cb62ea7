// A model of the robot asked as planners ask: the robot against the scene, then against itself, until the first contact.
#pragma once

#include <functional>
#include <vector>

#include "check/query_model.h"
#include "collision_hulls/check/boxed_model.h"
#include "scene/originals.h"
#include "scene/pair_rules.h"

namespace collision_hulls {

/// Not thread safe, and to be made while no other thread uses bodies of it: FCL writes to them then.
class PlannerModel {
 public:
  PlannerModel(const Assembly& assembly, const PairRules& rules, const Cuts& cuts);
  PlannerModel(const Assembly& assembly, const PairRules& rules, const Originals& originals);

  bool hit(const Places& places);
  bool hitInTrees(const Places& places);  ///< the same, asked of FCL's dynamic trees, in which MoveIt has its bodies
  double distance(const Places& places);  ///< [m] to the scene or itself; 0 in contact

 private:
  PlannerModel(const Assembly& assembly, const PairRules& rules);
  void add(const Assembly& assembly, std::size_t part, const QueryBody& body, const Eigen::Isometry3d& origin);

  void place(const Places& places);

  IgnoredPairs ignored_;
  BoxedModel robot_, scene_;
  QueryModel robot_tree_, scene_tree_;
  bool scene_placed_ = false, scene_tree_placed_ = false, empty_scene_ = true;
};

/// Which of the samples from `first` on hit a model; `make` gives one.
std::vector<char> hits(const Assembly& assembly, const std::function<PlannerModel()>& make, std::size_t first, std::size_t count,
                       const RunControl& control);

/// [us] that a question takes on one thread, whether a sample hits and how far it is from contact: means over the first of the samples, the
/// quickest of several rounds. 0 where there is no sample.
double collisionTime(const Assembly& assembly, PlannerModel& model, const std::vector<std::size_t>& samples, const RunControl& control);
double treeTime(const Assembly& assembly, PlannerModel& model, const std::vector<std::size_t>& samples, const RunControl& control);
double distanceTime(const Assembly& assembly, PlannerModel& model, const std::vector<std::size_t>& samples, const RunControl& control);

}  // namespace collision_hulls
