// How the collision models of different methods behave in a physics engine.
//
//   for each mesh: find the poses in which it can stand (resting.h)
//     for each method, the mesh itself first: make its hulls, once
//       for each way to pass them to the engine, for each pose: drop the body on a table and push it (drop.h)
//   for a robot with the demo robot's gripper, for each method: rewrite the description, load it, close the gripper on a box (grip.h)
//
// Each step is a process of its own with a time limit.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/benchmark.h"
#include "physics/drop.h"
#include "physics/grip.h"

namespace collision_hulls {

/// A drop. Anything not measured is empty.
struct PhysicsRow {
  std::string mesh, method, way;  ///< method "original": the mesh itself
  int pose = 0;                   ///< 0: the most stable pose
  std::optional<std::size_t> hulls;
  std::optional<double> diagonal, stability;  ///< [m] of the mesh as read; [rad] of the pose
  std::string outcome = "ok";                 ///< of DropResult, or crash, timeout, error
  std::optional<DropResult> drop;
  std::string message;
};

struct GripRow {
  std::string robot, method;
  std::string outcome = "held";  ///< of GripResult, or crash, timeout, error
  std::optional<GripResult> grip;
  std::string message;
};

struct PhysicsOptions {
  std::vector<Method> methods = allMethods();
  std::vector<Peer> peers;
  Length tolerance = shareOf(0.02);
  std::size_t poses = 2;
  double time_limit = 120;  ///< [s] per step
  std::uint64_t seed = 1;
  std::string program;  ///< the executable that runs jobs: PROGRAM kJobCommand JOB_FILE RESULT_FILE; see doPhysicsJob
  std::string folder;   ///< for temporary files
};

/// Does a job of jobs.h, or one of these:
///   poses   "file", "scale", "most"                                  -> "diagonal", "stabilities"
///   drop    "file", "scale", "most", "pose", "hulls" (OBJ; empty: the mesh itself), "way", "work" (folder)  -> the fields of DropResult
///   grip    "robot" (INPUT), "method", "tolerance" (text), "seed", "work"                                   -> the fields of GripResult
void doPhysicsJob(const std::string& job_file, const std::string& result_file);

/// Run everything, one process at a time, and pass on each row once it is complete. They throw only for faults of their own.
void runDrops(const std::vector<BenchmarkMesh>& meshes, const PhysicsOptions& options, const std::function<void(const PhysicsRow&)>& row);
void runGrips(const std::string& robot, const PhysicsOptions& options, const std::function<void(const GripRow&)>& row);

/// The column names and a row, each as a line of physics.csv or grip.csv (RFC 4180).
std::string physicsHeader();
std::string toCsv(const PhysicsRow& row);
std::string gripHeader();
std::string toCsv(const GripRow& row);

}  // namespace collision_hulls
