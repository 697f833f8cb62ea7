// Stages that decomposing a robot and fitting it to a scene have in common, and checks of sizes before the long work.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/mesh/repair.h"
#include "pipeline/cache.h"
#include "pipeline/mesh_uses.h"

namespace collision_hulls {

/// Throws kBadOption for options that only a single mesh takes.
void checkForRobot(const Options& options);

/// Throws kBadOption for options that only a robot takes.
void checkForMesh(const std::string& path, const Options& options);

/// Throws kTooLarge for a mesh above 20 m where the tolerance has a length: its numbers are probably millimetres, and the work would take
/// minutes. `mesh` is what the message calls it, `remedy` how its numbers are scaled by 0.001.
void checkSize(const std::string& mesh, double diagonal, const Length& tolerance, const std::string& remedy);

/// What a tolerance is for a mesh [m]. Throws kEmptyMesh if that is nothing: a percentage, and all triangles lie in one point.
double toleranceFor(const TriangleMesh& mesh, const Length& tolerance);

/// The tolerance of a task's mesh whose original is known. Throws what checkSize() throws, and kTooLarge for a mesh whose size overflows;
/// kEmptyMesh and kBadOption for a tolerance that does not suit it.
void setTolerance(const MeshTask& task, const LinkOptions& options, MeshResult& result);

/// A mesh after stages 1 and 2, for the stages that follow.
struct ReadMesh {
  RepairedMesh repaired;
  double margin = 0;  ///< [m] how far original points may lie from the repaired mesh
};

/// A task's mesh, on which all of its variants work: read and repaired when the first asks for it. The hull trees that were used so far.
class SharedMesh {
 public:
  SharedMesh(const MeshTask& task, const Options& options, Cache& cache) : task_(task), options_(options), cache_(cache) {}

  /// Stages 1 and 2. `result` gets the original, its solid and what is known of it, as far as the work goes: a mesh that fails keeps it.
  /// Throws as setTolerance() does.
  const ReadMesh& read(const LinkOptions& options, const RunControl& control, MeshResult& result);

  /// Its hull tree, with leaves for `tolerance` [m]: known already, or from the cache, or built and stored there. After read().
  std::shared_ptr<const HullTree> tree(const LinkOptions& options, double tolerance, const RunControl& control);
  void letGo(const std::string& key) { trees_.erase(key); }  ///< of a treeKey()
  bool builtTree() const { return built_tree_; }

 private:
  const MeshTask& task_;
  const Options& options_;
  Cache& cache_;
  std::optional<ReadMesh> read_;
  MeshResult known_;                                              ///< once it is read: what all variants have in common
  std::map<std::string, std::shared_ptr<const HullTree>> trees_;  ///< by key
  bool built_tree_ = false;
};

/// What is known of certified hulls. `primitives`: how many of them, the last ones, stand for primitives, and are written as such.
HullFacts factsOf(const std::vector<ConvexHull>& hulls, std::size_t primitives, const Solid& solid, const Protrusion& proof,
                  const RunControl& control);

/// Stages 3 and 4 of a mesh that was read, for one variant of it: hulls, cut from the tree if there is one (null: decomposed), or what
/// `options.shapes` says, with what is proved of them. For primitives there must be a tree. `result` has what SharedMesh::read() gave, and
/// its tolerance. `uri`: of the mesh, for messages.
void decomposeAndCertify(const ReadMesh& read, const LinkOptions& options, const HullTree* tree, const std::string& uri, std::uint64_t seed,
                         const RunControl& control, MeshResult& result);

/// The same for hulls alone, whatever `options.shapes` says.
void decomposeHulls(const ReadMesh& read, const LinkOptions& options, const HullTree* tree, const std::string& uri, std::uint64_t seed,
                    const RunControl& control, MeshResult& result);

/// Stage 5, for the uses of a model that have hulls.
Validation validateUses(const std::vector<MeshUse>& uses, const MeshResults& results, std::size_t model, std::uint64_t seed,
                        const RunControl& control);

}  // namespace collision_hulls
