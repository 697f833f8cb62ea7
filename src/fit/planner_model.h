// A model of the robot, queried as planners do: the robot against the scene, then against itself, up to the first contact.
#pragma once

#include <functional>
#include <vector>

#include "collision_hulls/query/boxed_model.h"
#include "fit/originals.h"
#include "fit/pair_rules.h"
#include "query/query_model.h"

namespace collision_hulls {

/// Uses BoxedModel. Not thread safe.
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

/// The same with FCL's dynamic trees, as in MoveIt. Not thread safe; while one is constructed, no other thread may use its bodies, since
/// FCL writes to them.
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

/// In which samples, from `first` on, the model collides; `make` returns a model for one thread.
std::vector<char> hits(const Assembly& assembly, const std::function<PlannerModel()>& make, std::size_t first, std::size_t count,
                       const RunControl& control);

/// [us] per query on one thread, for collision or for distance to contact: the mean over the first samples, in the quickest of several
/// rounds. 0 if there are no samples.
double collisionTime(const Assembly& assembly, PlannerModel& model, const std::vector<std::size_t>& samples, const RunControl& control);
double collisionTime(const Assembly& assembly, TreeModel& model, const std::vector<std::size_t>& samples, const RunControl& control);
double distanceTime(const Assembly& assembly, PlannerModel& model, const std::vector<std::size_t>& samples, const RunControl& control);

}  // namespace collision_hulls
