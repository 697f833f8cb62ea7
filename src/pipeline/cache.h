// The cache: results of earlier runs, found again by the content of all that they depend on.
//
// A key is a SHA-256 over the mesh file's content and extension, scale and options, and over this library: its version, the digest of its
// sources, and how it was compiled. Since the same input gives the same bytes, an entry is what the work would give.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "collision_hulls/decompose/hull_tree.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "pipeline/cache_folder.h"

namespace collision_hulls {

/// What the result of one mesh depends on: content (`row.sha256`) and extension of its file, scale, and options that change hulls.
std::string elementKey(const ElementReport& row, const std::string& file, const Options& options);

/// What a validation depends on: each element that has hulls, by its name, key and pose, and the seed.
/// `keys`: of the elements, in their order; anything for those without hulls.
std::string validationKey(const std::vector<ElementResult>& elements, const std::vector<std::string>& keys, const Options& options);

/// What the hull tree of one mesh depends on, with leaves for `tolerance` [m]: as elementKey(), without the options that choose a cut
/// (tolerance and number of hulls).
std::string treeKey(const ElementReport& row, const std::string& file, const Options& options, double tolerance);

/// Finds nothing where there is nothing or where the entry is damaged, which is counted, and the entry removed. Thread safe; other
/// processes may use the same folder at the same time.
class Cache {
 public:
  static constexpr std::uintmax_t kMostBytes = 1'000'000'000;

  /// See CacheFolder.
  explicit Cache(std::filesystem::path folder, std::uintmax_t most_bytes = kMostBytes);

  /// A mesh's result, without what says where in a robot it stands and how long it took.
  std::optional<ElementResult> findElement(const std::string& key);
  void storeElement(const std::string& key, const ElementResult& element);

  std::optional<Validation> findValidation(const std::string& key);
  /// But for one with timeouts, which another run may not have.
  void storeValidation(const std::string& key, const Validation& validation);

  std::optional<HullTree> findTree(const std::string& key);
  void storeTree(const std::string& key, const HullTree& tree);

  void trim() { folder_.trim(); }
  std::vector<std::string> notes() const { return folder_.notes(); }

 private:
  template <typename Value>
  std::optional<Value> find(const std::string& name);
  template <typename Value>
  void store(const std::string& name, const Value& value);

  CacheFolder folder_;
};

}  // namespace collision_hulls
