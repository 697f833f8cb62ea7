// The collision models that methods make, in a physics engine.
//
//   for each mesh: the poses that it can stand in (resting.h)
//     for each method, the mesh itself first: its hulls, once
//       for each way to give them to the engine, for each pose: drop it on a table and push it (drop.h)
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

/// A drop. What could not be measured is left empty.
struct PhysicsRow {
  std::string mesh, method, way;  ///< the method "original": the mesh itself
  int pose = 0;                   ///< 0: the most stable one
  std::optional<std::size_t> hulls;
  std::optional<double> diagonal, stability;  ///< [m] of the mesh as it was read; [rad] of the pose
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
  double time_limit = 120;  ///< [s] of each step
  std::uint64_t seed = 1;
  std::string program;  ///< the executable that does jobs: PROGRAM kJobCommand JOB_FILE RESULT_FILE; see doPhysicsJob
  std::string folder;   ///< for temporary files
};

/// Does a job of jobs.h, or one of these:
///   poses   "file", "scale", "most"                                  -> "diagonal", "stabilities"
///   drop    "file", "scale", "most", "pose", "hulls" (OBJ; empty: the mesh itself), "way", "work" (folder)  -> what DropResult has
///   grip    "robot" (INPUT), "method", "tolerance" (text), "seed", "work"                                   -> what GripResult has
void doPhysicsJob(const std::string& job_file, const std::string& result_file);

/// Runs everything, one process at a time, and hands over each row once it is complete. Throws for faults of its own alone.
void runDrops(const std::vector<BenchmarkMesh>& meshes, const PhysicsOptions& options, const std::function<void(const PhysicsRow&)>& row);
void runGrips(const std::string& robot, const PhysicsOptions& options, const std::function<void(const GripRow&)>& row);

/// Column names, and a row, each as a line of physics.csv or grip.csv (RFC 4180).
std::string physicsHeader();
std::string toCsv(const PhysicsRow& row);
std::string gripHeader();
std::string toCsv(const GripRow& row);

}  // namespace collision_hulls
