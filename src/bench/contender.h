// The contenders of a benchmark: our methods, and other programs on the same terms.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/job_runner.h"
#include "collision_hulls/decompose/decompose.h"

namespace collision_hulls {

/// Another program, as a command for /bin/sh with the placeholders {in} (OBJ), {out} (OBJ, one object per hull) and {tolerance} [m].
struct Peer {
  std::string name, command;
};

/// A method, or a peer.
struct Contender {
  std::string name;
  std::string effort;   ///< of a method that has efforts
  std::string command;  ///< of a peer; empty for a method
};

/// Every method, once per effort if it has efforts, then every peer.
std::vector<Contender> contenders(const std::vector<Method>& methods, const std::vector<Effort>& efforts, const std::vector<Peer>& peers);

/// What to make hulls of, and how. A peer reads the mesh from mesh.obj in the runner's folder, in metres.
struct HullsTask {
  nlohmann::json mesh;  ///< as a method reads it: "file" and "scale" of jobs.h
  double tolerance;     ///< [m]
  std::uint64_t seed;
  std::string hulls;                                   ///< OBJ file to write the hulls to; removed first if it exists
  double limit;                                        ///< [s]
  int max_vertices = DecomposeOptions{}.max_vertices;  ///< per hull of a method; 0: no cap
};

struct HullsMade {
  ChildResult used;
  JobOutcome outcome;  ///< also not ok if no hulls were written
};

/// Makes a contender's hulls in a process of its own.
HullsMade makeHulls(const JobRunner& runner, const Contender& contender, const HullsTask& task);

}  // namespace collision_hulls
