// The cache: results of earlier runs, found again by the content of everything they depend on.
//
// A key is a SHA-256 over the mesh file's content and extension, the scale and the options, and over this library: its version, the digest
// of its sources, and how it was compiled. Since the same input gives the same bytes, an entry equals what a new computation would give: if
// it is what such a computation stored under this key. That is what its seal proves (see CacheFolder), so a hit needs neither the mesh nor
// the certificate anew.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/decompose/hull_tree.h"
#include "pipeline/mesh_uses.h"
#include "storage/cache_folder.h"

namespace collision_hulls {

/// Key of one mesh's result: content and extension of its file, scale, and the options that change hulls.
std::string meshKey(const MeshTask& task, const LinkOptions& options, std::uint64_t seed);

/// Whether nobody asks for the bounds of the tree: it is walked for primitives, which are measured themselves.
bool takesTreeWithoutProof(const LinkOptions& options);

/// Key of one mesh's hull tree with leaves for `tolerance` [m]: as meshKey(), without the options that only choose a cut (tolerance and
/// number of hulls).
std::string treeKey(const MeshTask& task, const LinkOptions& options, std::uint64_t seed, double tolerance);

/// Key of a model's validation: link, element, key and pose of each use with hulls, and the seed. `keys`: one per use, in order; ignored
/// for uses without hulls.
std::string validationKey(const std::vector<MeshUse>& uses, const MeshResults& results, const std::vector<std::string>& keys,
                          std::size_t model, std::uint64_t seed);

/// Finds nothing if there is no entry, or if it is damaged or others could have written it; such an entry is removed and counted. Thread
/// safe; other processes may use the same folder at the same time.
class Cache {
 public:
  static constexpr std::uintmax_t kMostBytes = 1'000'000'000;

  /// See CacheFolder.
  explicit Cache(std::filesystem::path folder, std::uintmax_t most_bytes = kMostBytes);

  /// A mesh's result, without the solid, the times it took, and what only a scene adds. `sha256`: of the mesh's file.
  std::optional<MeshResult> findMesh(const std::string& key, const std::string& sha256);
  void storeMesh(const std::string& key, const MeshResult& result);

  std::optional<Validation> findValidation(const std::string& key);
  /// Skips a validation with timeouts, since another run may have none.
  void storeValidation(const std::string& key, const Validation& validation);

  std::optional<HullTree> findTree(const std::string& key);
  void storeTree(const std::string& key, const HullTree& tree);

  void trim() { folder_.trimNowAndThen(); }
  std::vector<std::string> notes() const { return folder_.notes(); }

 private:
  template <typename Value>
  std::optional<Value> find(const std::string& name, const std::function<bool(const Value&)>& fits = {});
  template <typename Value>
  void store(const std::string& name, const Value& value);

  CacheFolder folder_;
};

}  // namespace collision_hulls
