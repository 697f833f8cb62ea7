// Runs the steps listed in the header and turns each outcome into a row. A contender's hulls are made once and used for every way and pose.
#include "physics/physics.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/hull_objects.h"
#include "bench/json_file.h"
#include "bench/original.h"
#include "geometry/pi.h"
#include "storage/csv.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kDegree = kPi / 180;

constexpr const char* kOriginal = "original";

/// The mesh itself, then the methods and peers that make hulls of it.
std::vector<Contender> withOriginal(const PhysicsOptions& options) {
  std::vector<Contender> all = contenders(options.methods, {Effort::kQuick}, options.peers);
  all.insert(all.begin(), {kOriginal, "", ""});
  return all;
}

/// Drops one mesh after the other.
class Drops {
 public:
  explicit Drops(const PhysicsOptions& options) : options_(options), runner_(options.program, options.folder) {}

  void run(const BenchmarkMesh& mesh, const std::function<void(const PhysicsRow&)>& take) {
    mesh_ = toJob(mesh, {{"most", options_.poses}});
    PhysicsRow start;
    start.mesh = mesh.name;
    JobOutcome outcome;
    json found = result({{"job", "poses"}}, outcome);
    if (outcome.ok() && found["stabilities"].empty()) outcome = {"error", "the mesh cannot stand on any face"};
    if (outcome.ok()) {
      stabilities_ = found["stabilities"].get<std::vector<double>>();
      start.diagonal = found["diagonal"].get<double>();
      found = result({{"job", "prepare"}, {"cleaned", runner_.file("mesh.obj")}}, outcome);
    }
    for (const Contender& contender : withOriginal(options_)) {
      start.method = contender.name;
      if (outcome.ok()) {
        runContender(contender, start, take);
      } else {
        take(failed(start, outcome));
      }
    }
  }

 private:
  json result(json job, JobOutcome& outcome) const {
    job.update(mesh_);
    return runner_.result(job, outcome);
  }

  static PhysicsRow failed(PhysicsRow row, const JobOutcome& outcome) {
    row.outcome = outcome.status;
    row.message = outcome.message;
    return row;
  }

  void runContender(const Contender& contender, PhysicsRow start, const std::function<void(const PhysicsRow&)>& take) {
    const bool original = contender.name == kOriginal;
    const std::string hulls = runner_.file("hulls.obj");
    if (!original) {
      const double tolerance = options_.tolerance.metres(*start.diagonal);
      const JobOutcome made = makeHulls(runner_, contender, {mesh_, tolerance, options_.seed, hulls, options_.time_limit}).outcome;
      if (!made.ok()) return take(failed(start, made));
      try {
        start.hulls = readHullObjects(hulls).size();
      } catch (const Error& error) {
        return take(failed(start, {"error", error.what()}));
      }
    }
    for (const Way way : {Way::kConvex, Way::kMesh}) {
      if (original && way == Way::kConvex) continue;
      for (std::size_t pose = 0; pose < stabilities_.size(); ++pose) take(rowOf(way, pose, original ? "" : hulls, start));
    }
  }

  PhysicsRow rowOf(Way way, std::size_t pose, const std::string& hulls, PhysicsRow row) const {
    row.way = name(way);
    row.pose = static_cast<int>(pose);
    row.stability = stabilities_[pose];
    json job = {{"job", "drop"}, {"pose", pose}, {"hulls", hulls}, {"way", row.way}, {"work", runner_.file("")}};
    job.update(mesh_);
    const JobOutcome outcome = runner_.judge(runner_.run(job, options_.time_limit), options_.time_limit);
    if (!outcome.ok()) return failed(row, outcome);
    const json found = readJson(runner_.file("result.json"));
    const auto number = [&](const char* key) { return found[key].is_number() ? found[key].get<double>() : std::nan(""); };
    row.drop = DropResult{found["outcome"], number("tilt"),   number("height"),         number("penetration"), number("drift"),
                          number("slide"),  number("energy"), number("settle_seconds"), number("step_us"),     found["contacts"]};
    row.outcome = row.drop->outcome;
    return row;
  }

  const PhysicsOptions& options_;
  const JobRunner runner_;
  json mesh_;
  std::vector<double> stabilities_;
};

}  // namespace

void runDrops(const std::vector<BenchmarkMesh>& meshes, const PhysicsOptions& options, const std::function<void(const PhysicsRow&)>& row) {
  Drops drops(options);
  for (const BenchmarkMesh& mesh : meshes) drops.run(mesh, row);
}

void runGrips(const std::string& robot, const PhysicsOptions& options, const std::function<void(const GripRow&)>& take) {
  const JobRunner runner(options.program, options.folder);
  for (const Method method : options.methods) {
    GripRow row;
    row.robot = fs::path(robot).stem().string();
    row.method = name(method);
    const json job = {{"job", "grip"},        {"robot", robot},         {"method", row.method}, {"tolerance", toString(options.tolerance)},
                      {"seed", options.seed}, {"work", runner.file("")}};
    const JobOutcome outcome = runner.judge(runner.run(job, options.time_limit), options.time_limit);
    if (outcome.ok()) {
      const json found = readJson(runner.file("result.json"));
      row.grip = GripResult{found["outcome"], found["hulls"], found["slip"], found["turn"], found["opening"], found["step_us"]};
    }
    row.outcome = row.grip ? row.grip->outcome : outcome.status;
    row.message = outcome.message;
    take(row);
  }
}

std::string physicsHeader() {
  return "mesh,method,way,pose,outcome,hulls,tilt_degrees,height,penetration,drift,slide,energy,settle_seconds,contacts,step_us,diagonal,"
         "stability_degrees,message\n";
}

std::string toCsv(const PhysicsRow& row) {
  const auto measured = [&](double DropResult::*field) { return row.drop ? csvNumber((*row.drop).*field) : ""; };
  return csvLine({row.mesh, row.method, row.way, std::to_string(row.pose), row.outcome, row.hulls ? std::to_string(*row.hulls) : "",
                  row.drop ? csvNumber(row.drop->tilt / kDegree) : "", measured(&DropResult::height), measured(&DropResult::penetration),
                  measured(&DropResult::drift), measured(&DropResult::slide), measured(&DropResult::energy),
                  measured(&DropResult::settle_seconds), row.drop ? std::to_string(row.drop->contacts) : "", measured(&DropResult::step_us),
                  csvNumber(row.diagonal), row.stability ? csvNumber(*row.stability / kDegree) : "", row.message});
}

std::string gripHeader() {
  return "robot,method,outcome,hulls,slip,turn_degrees,opening,step_us,message\n";
}

std::string toCsv(const GripRow& row) {
  const auto measured = [&](double GripResult::*field) { return row.grip ? csvNumber((*row.grip).*field) : ""; };
  return csvLine({row.robot, row.method, row.outcome, row.grip ? std::to_string(row.grip->hulls) : "", measured(&GripResult::slip),
                  row.grip ? csvNumber(row.grip->turn / kDegree) : "", measured(&GripResult::opening), measured(&GripResult::step_us),
                  row.message});
}

}  // namespace collision_hulls
