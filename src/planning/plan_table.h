// The results of planning as tables: a row for each query, and a summary for each model.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "planning/plan_benchmark.h"

namespace collision_hulls {

/// The column names and a row, each as a line of queries.csv (RFC 4180).
std::string planHeader();
std::string toCsv(const PlanRow& row);

/// The least, the quartiles and the largest of some values, interpolated linearly; null where there are none.
nlohmann::json quartiles(std::vector<double> values);

/// "robot", "joints", the options, "machine", and in "models" an object for each scene, checker and model: its size, how many queries were
/// solved, lost (and to which pairs of links) and out of time, quartiles over the solved ones of planning time [ms], share of checks, time
/// per check [us] and number of checks; "times_faster": quartiles of the original's planning time over the model's, query by query, where
/// both solved it; and in how many found paths the original collides.
nlohmann::json planSummary(const PlanResults& results, const std::string& robot, const std::vector<JointVariable>& joints,
                           const PlanOptions& options);

}  // namespace collision_hulls
