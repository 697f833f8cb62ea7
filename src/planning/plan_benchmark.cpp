// Runs the queries. Every check is timed by itself: two readings of the clock, some tens of nanoseconds, are part of the planning time of
// all models alike.
#include "planning/plan_benchmark.h"

#include <memory>

#include "base/decimal.h"
#include "base/stopwatch.h"
#include "collision_hulls/error.h"
#include "planning/plan_queries.h"

namespace collision_hulls {
namespace {

constexpr double kFiner = 0.1;  // of the planner's step, to look at paths

/// A checker that counts and times what it is asked.
class TimedChecker {
 public:
  TimedChecker(const JointSpace& space, std::unique_ptr<Checker> checker) : space_(space), checker_(std::move(checker)) {}

  bool isFree(const JointValues& values) {
    Stopwatch clock;
    const bool free = !checker_->collides(space_.poses(values));
    seconds_ += clock.lap();
    ++checks_;
    return free;
  }
  void reset() {
    seconds_ = 0;
    checks_ = 0;
  }
  double seconds() const { return seconds_; }
  std::size_t checks() const { return checks_; }

 private:
  const JointSpace& space_;
  std::unique_ptr<Checker> checker_;
  double seconds_ = 0;
  std::size_t checks_ = 0;
};

/// A model with a checker.
struct Contender {
  const RobotModel& model;
  CheckerKind kind;
  TimedChecker checker;
};

ModelSize sizeOf(const RobotModel& model, const std::string& scene) {
  ModelSize size{scene, model.name};
  size.bodies = model.bodies.size();
  for (const ModelBody& body : model.bodies) {
    if (const auto* mesh = std::get_if<TriangleMesh>(&body.shape)) size.triangles += mesh->triangles.size();
    if (const auto* hull = std::get_if<ConvexHull>(&body.shape)) size.triangles += hull->triangles.size();
    size.primitives += std::holds_alternative<GeometryElement>(body.shape);
  }
  return size;
}

/// What the planned joints do not move against each other, no model is asked about.
void ignoreUnmoved(const JointSpace& space, std::size_t links, const Scene& scene, IgnoredPairs& ignored) {
  for (std::size_t link = 0; link < links; ++link) {
    for (std::size_t other = link + 1; other < links; ++other)
      if (!space.moves(link, other)) ignored.ignore(link, other);
    for (std::size_t body = 0; body < scene.bodies.size() && !space.moves(link); ++body) ignored.ignore(link, links + body);
  }
}

/// All queries in one scene.
class SceneRun {
 public:
  SceneRun(const Input& robot, const Kinematics& kinematics, const JointSpace& space, const Scene& scene, const SceneModels& made,
           const PlanOptions& options)
      : robot_(robot.robot), space_(space), scene_(scene.name), made_(made), options_(options) {
    const std::size_t links = robot.robot.links.size();
    for (const RobotModel& model : made.models) {
      for (const CheckerKind kind : options.checkers)
        contenders_.push_back({model, kind, {space, makeChecker(kind, model, links, scene, made.ignored)}});
      if (model.name == kOriginalModel)
        truth_ = std::make_unique<TimedChecker>(space, makeChecker(CheckerKind::kBoxes, model, links, scene, made.ignored));
    }
    queries_ = drawQueries(kinematics, space, truth(), options.planner.step, options.queries, options.seed);
  }

  void run(const std::function<void(const PlanRow&)>& take) {
    for (std::size_t query = 0; query < queries_.size(); ++query)
      for (std::size_t i = 0; i < contenders_.size(); ++i) take(rowOf(query, contenders_[(query + i) % contenders_.size()]));
  }

 private:
  IsFree truth() {
    return [this](const JointValues& values) { return truth_->isFree(values); };
  }

  PlanRow rowOf(std::size_t query, Contender& contender) {
    PlannerSettings settings = options_.planner;
    settings.seed = options_.seed + static_cast<std::uint32_t>(query);
    TimedChecker& checker = contender.checker;
    checker.reset();
    const Plan found = plan(
        space_.joints(), queries_[query].start, queries_[query].goal, [&](const JointValues& values) { return checker.isFree(values); },
        settings);
    PlanRow row{scene_, contender.model.name, contender.kind, query, found.outcome, found.seconds, checker.seconds(), checker.checks()};
    const std::vector<JointValues> path = alongPath(space_.joints(), found.path, kFiner * settings.step);
    row.path_states = path.size();
    row.path_hits = hits(path, truth());
    if (found.outcome == Plan::Outcome::kLost) row.lost_to = lostTo(query, contender.model);
    return row;
  }

  std::string lostTo(std::size_t query, const RobotModel& model) const {
    for (const JointValues& state : {queries_[query].start, queries_[query].goal})
      for (const auto& [a, b] : touchingLinks(model, made_.ignored, space_.poses(state)))
        return robot_.links[a].name + " and " + robot_.links[b].name;
    return "the scene";
  }

  const RobotDescription& robot_;
  const JointSpace& space_;
  const std::string scene_;
  const SceneModels& made_;
  const PlanOptions& options_;
  std::vector<Contender> contenders_;
  std::unique_ptr<TimedChecker> truth_;
  std::vector<PlanQuery> queries_;
};

void expectBetween(const std::string& option, double value, double least, double most) {
  if (value >= least && value <= most) return;
  throw Error(ErrorCode::kBadOption, option + " " + fixedDecimal(value) + " is out of range: use a number from " + fixedDecimal(least) +
                                         " to " + fixedDecimal(most));
}

}  // namespace

void check(const PlanOptions& options) {
  expectBetween("queries", static_cast<double>(options.queries), 1, 1e6);
  expectBetween("seed", options.seed, 1, 1e9);
  expectBetween("time limit", options.planner.time_limit, 1e-3, 3600);
  expectBetween("step", options.planner.step, 1e-5, 0.5);
  if (options.checkers.empty()) throw Error(ErrorCode::kBadOption, "no checker: use some of boxes, trees, moveit");
  checkModels(options.models);
  if (options.models.empty() || options.models.front() != kOriginalModel)
    throw Error(ErrorCode::kBadOption,
                std::string("the models must begin with '") + kOriginalModel + "', which the others are compared with");
}

PlanResults runPlanBenchmark(const Input& robot, const std::vector<Scene>& scenes, const PlanOptions& options,
                             const std::function<void(const PlanRow&)>& take) {
  check(options);
  const Kinematics kinematics(robot.robot);
  const JointSpace space(kinematics, options.joints, options.others);
  ModelMaker maker(robot, options.models, options.request);
  PlanResults results;
  for (const Scene& scene : scenes) {
    SceneModels made = maker.make(scene);
    ignoreUnmoved(space, robot.robot.links.size(), scene, made.ignored);
    for (const RobotModel& model : made.models) results.sizes.push_back(sizeOf(model, scene.name));
    SceneRun(robot, kinematics, space, scene, made, options).run([&](const PlanRow& row) {
      results.rows.push_back(row);
      take(row);
    });
  }
  return results;
}

}  // namespace collision_hulls
