// A model of the robot asked as planners ask: the robot against the scene, then against itself, until the first contact.
#pragma once

#include <functional>
#include <vector>

#include "check/query_model.h"
#include "collision_hulls/check/boxed_model.h"
#include "scene/originals.h"
#include "scene/pair_rules.h"

namespace collision_hulls {

/// Behind boxes, see BoxedModel. Not thread safe.
class PlannerModel {
 public:
  PlannerModel(const Assembly& assembly, const PairRules& rules, const Cuts& cuts);
  PlannerModel(const Assembly& assembly, const PairRules& rules, const Originals& originals);

  bool hit(const Places& places);
  double distance(const Places& places);  ///< [m] to the scene or itself; 0 in contact

 private:
  void place(const Places& places);

  BoxedModel robot_, scene_;
  bool scene_placed_ = false;
};

/// The same in FCL's dynamic trees, in which MoveIt has its bodies. Not thread safe, and to be made while no other thread uses bodies of
/// it: FCL writes to them then.
class TreeModel {
 public:
  TreeModel(const Assembly& assembly, const PairRules& rules, const Cuts& cuts);
  TreeModel(const Assembly& assembly, const PairRules& rules, const Originals& originals);

  bool hit(const Places& places);

 private:
  QueryModel robot_, scene_;
  IgnoredPairs ignored_;
  bool scene_placed_ = false;
};

/// Which of the samples from `first` on hit a model; `make` gives one.
std::vector<char> hits(const Assembly& assembly, const std::function<PlannerModel()>& make, std::size_t first, std::size_t count,
                       const RunControl& control);

/// [us] that a question takes on one thread, whether a sample hits and how far it is from contact: means over the first of the samples, the
/// quickest of several rounds. 0 where there is no sample.
double collisionTime(const Assembly& assembly, PlannerModel& model, const std::vector<std::size_t>& samples, const RunControl& control);
double collisionTime(const Assembly& assembly, TreeModel& model, const std::vector<std::size_t>& samples, const RunControl& control);
double distanceTime(const Assembly& assembly, PlannerModel& model, const std::vector<std::size_t>& samples, const RunControl& control);

}  // namespace collision_hulls
