// What is measured: methods, and other programs on the same terms.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/job_runner.h"
#include "collision_hulls/decompose/decompose.h"

namespace collision_hulls {

/// Another program, as a command for /bin/sh: {in} (OBJ), {out} (OBJ, an object per hull) and {tolerance} [m] are filled in.
struct Peer {
  std::string name, command;
};

/// A method, or a peer.
struct Contender {
  std::string name;
  std::string effort;   ///< of a method that has one
  std::string command;  ///< of a peer
};

/// Every method, with each effort where it has one, then every peer.
std::vector<Contender> contenders(const std::vector<Method>& methods, const std::vector<Effort>& efforts, const std::vector<Peer>& peers);

/// What hulls are to be made of, and how. The runner's folder holds the mesh as a peer takes it: mesh.obj, in metres.
struct HullsTask {
  nlohmann::json mesh;  ///< as a method takes it: "file" and "scale" of jobs.h
  double tolerance;     ///< [m]
  std::uint64_t seed;
  std::string hulls;                                   ///< the file that the hulls go to, OBJ; one that is there is removed first
  double limit;                                        ///< [s]
  int max_vertices = DecomposeOptions{}.max_vertices;  ///< of a method's hulls; 0: no cap
};

struct HullsMade {
  ChildResult used;
  JobOutcome outcome;  ///< not ok, too, where no hulls were written
};

/// Lets a contender make hulls, in a process of its own.
HullsMade makeHulls(const JobRunner& runner, const Contender& contender, const HullsTask& task);

}  // namespace collision_hulls
