// Times are of solved queries alone. For ratios, pairs of a model's query and the original's are compared, since queries differ by more
// than models do.
#include "planning/plan_table.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "bench/machine.h"
#include "storage/csv.h"

namespace collision_hulls {
namespace {

using nlohmann::json;
using Rows = std::vector<const PlanRow*>;

bool solved(const PlanRow& row) {
  return row.outcome == Plan::Outcome::kSolved;
}

template <typename Value>
std::vector<double> ofSolved(const Rows& rows, const Value& value) {
  std::vector<double> values;
  for (const PlanRow* row : rows)
    if (solved(*row)) values.push_back(value(*row));
  return values;
}

std::size_t count(const Rows& rows, Plan::Outcome outcome) {
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [&](const PlanRow* row) { return row->outcome == outcome; }));
}

/// How many times faster than the original, query by query.
std::vector<double> gains(const Rows& rows, const Rows& originals) {
  std::map<std::size_t, double> seconds;
  for (const PlanRow* row : originals)
    if (solved(*row)) seconds[row->query] = row->seconds;
  std::vector<double> values;
  for (const PlanRow* row : rows)
    if (solved(*row) && seconds.count(row->query)) values.push_back(seconds[row->query] / row->seconds);
  return values;
}

/// How many queries each pair of links loses.
json lostTo(const Rows& rows) {
  std::map<std::string, std::size_t> counts;
  for (const PlanRow* row : rows)
    if (!row->lost_to.empty()) ++counts[row->lost_to];
  return counts;
}

json summaryOf(const ModelSize& size, CheckerKind checker, const Rows& rows, const Rows& originals) {
  const auto some = [&](const auto& value) { return quartiles(ofSolved(rows, value)); };
  const auto hit = [](const PlanRow* row) { return row->path_hits > 0; };
  return {{"scene", size.scene},
          {"checker", name(checker)},
          {"model", size.model},
          {"bodies", size.bodies},
          {"primitives", size.primitives},
          {"triangles", size.triangles},
          {"queries", rows.size()},
          {"solved", count(rows, Plan::Outcome::kSolved)},
          {"lost", count(rows, Plan::Outcome::kLost)},
          {"timeout", count(rows, Plan::Outcome::kTimeout)},
          {"planning_ms", some([](const PlanRow& row) { return 1e3 * row.seconds; })},
          {"checking_share", some([](const PlanRow& row) { return row.check_seconds / row.seconds; })},
          {"check_us", some([](const PlanRow& row) { return 1e6 * row.check_seconds / static_cast<double>(row.checks); })},
          {"checks", some([](const PlanRow& row) { return static_cast<double>(row.checks); })},
          {"times_faster", quartiles(gains(rows, originals))},
          {"lost_to", lostTo(rows)},
          {"paths_hit", std::count_if(rows.begin(), rows.end(), hit)}};
}

Rows rowsOf(const PlanResults& results, const std::string& scene, const std::string& model, CheckerKind checker) {
  Rows rows;
  for (const PlanRow& row : results.rows)
    if (row.scene == scene && row.model == model && row.checker == checker) rows.push_back(&row);
  return rows;
}

}  // namespace

std::string planHeader() {
  return "scene,checker,query,model,outcome,planning_s,checking_s,checks,path_states,path_hits,lost_to\n";
}

std::string toCsv(const PlanRow& row) {
  const bool lost = row.outcome == Plan::Outcome::kLost;
  const auto number = [&](double value) { return lost ? "" : csvNumber(value); };
  const auto text = [&](std::size_t value) { return lost ? "" : std::to_string(value); };
  return csvLine({row.scene, name(row.checker), std::to_string(row.query), row.model, name(row.outcome), number(row.seconds),
                  number(row.check_seconds), text(row.checks), text(row.path_states), text(row.path_hits), row.lost_to});
}

json quartiles(std::vector<double> values) {
  if (values.empty()) return nullptr;
  std::sort(values.begin(), values.end());
  json five = json::array();
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    five.push_back(values[below] + (place - std::floor(place)) * (values[above] - values[below]));
  }
  return five;
}

json planSummary(const PlanResults& results, const std::string& robot, const std::vector<JointVariable>& joints,
                 const PlanOptions& options) {
  json names = json::array(), models = json::array();
  for (const JointVariable& joint : joints) names.push_back(joint.name);
  for (const ModelSize& size : results.sizes) {
    for (const CheckerKind checker : options.checkers)
      models.push_back(
          summaryOf(size, checker, rowsOf(results, size.scene, size.model, checker), rowsOf(results, size.scene, kOriginalModel, checker)));
  }
  return {{"robot", robot},
          {"joints", names},
          {"queries", options.queries},
          {"seed", options.seed},
          {"time_limit", options.planner.time_limit},
          {"step", options.planner.step},
          {"clearance", options.request.clearance},
          {"tolerance", toString(options.request.options.tolerance)},
          {"machine", describeMachine()},
          {"models", models}};
}

}  // namespace collision_hulls
