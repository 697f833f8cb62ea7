// What a planner gains by a collision model: the same queries, with one model of the robot after the other.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "planning/checker.h"
#include "planning/planner.h"
#include "planning/robot_model.h"

namespace collision_hulls {

struct PlanOptions {
  std::size_t queries = 50;              ///< a scene
  std::uint32_t seed = 1;                ///< > 0; of the queries and of the planner
  std::string joints;                    ///< regular expression on their names; empty: all that move
  std::map<std::string, double> others;  ///< [rad or m] where joints stand that are not planned
  PlannerSettings planner;               ///< its seed is set query by query
  std::vector<std::string> models = allModels();
  std::vector<CheckerKind> checkers{CheckerKind::kBoxes, CheckerKind::kTrees, CheckerKind::kMoveIt};
  ModelRequest request;
};

/// Throws kBadOption naming the option, its value and its range.
void check(const PlanOptions& options);

/// One query, planned with one model.
struct PlanRow {
  std::string scene, model;
  CheckerKind checker = CheckerKind::kBoxes;
  std::size_t query = 0;  ///< from 0
  Plan::Outcome outcome = Plan::Outcome::kTimeout;
  double seconds = 0;        ///< of planning; meaningful unless lost
  double check_seconds = 0;  ///< of these in collision checks, with forward kinematics
  std::size_t checks = 0;
  std::size_t path_states = 0;  ///< of the found path, at a tenth of the planner's step
  std::size_t path_hits = 0;    ///< of these, states in which the original meshes collide
  /// of a lost query: the first pair of links that touch each other at its start, else at its goal, "wrist and hand"; "the scene" if only
  /// that is touched
  std::string lost_to = {};
};

/// A model in a scene.
struct ModelSize {
  std::string scene, model;
  std::size_t bodies = 0, primitives = 0, triangles = 0;  ///< triangles: of all bodies but primitives
};

struct PlanResults {
  std::vector<ModelSize> sizes;
  std::vector<PlanRow> rows;
};

/// Plans in each scene. The starts and goals are free with the original meshes behind boxes; a model may find one of them in collision, and
/// has then lost the query. For each query, every model and checker plans in turn, beginning with another one each time, so that a busy
/// machine disturbs all alike. Links that the planned joints do not move against each other, or against the scene, are not compared. `take`
/// gets each row at once. Deterministic apart from times and what time limits cut short. Throws kBadOption, and what ModelMaker and
/// drawQueries() throw.
PlanResults runPlanBenchmark(const Input& robot, const std::vector<Scene>& scenes, const PlanOptions& options,
                             const std::function<void(const PlanRow&)>& take);

}  // namespace collision_hulls
