// An entry is the bytes of a value; the folder proves that they are what was stored under this name. Each struct lists its fields once, for
// writing and reading alike. An entry that cannot be read all the same, or that does not fit its mesh, is removed and counts as not found.
#include "pipeline/cache.h"

#include <memory>
#include <new>
#include <utility>

#include "collision_hulls/decompose/hull_tree_file.h"
#include "collision_hulls/error.h"
#include "geometry/bytes.h"
#include "pipeline/source_digest.h"
#include "robot/element_bytes.h"
#include "storage/sha256.h"

namespace collision_hulls {

// Structured bindings name every member, so a new member does not compile until someone decides whether entries contain it.

template <typename Archive>
void fields(Archive& archive, RepairCounts& counts) {
  auto& [welded, degenerate, duplicate, flipped, components, open_edges, nonmanifold_edges, weld_distance] = counts;
  archive(welded, degenerate, duplicate, flipped, components, open_edges, nonmanifold_edges, weld_distance);
}

template <typename Archive>
void fields(Archive& archive, MeshFacts& facts) {
  auto& [sha256, triangles, skipped_primitives, closed_openings, openings, widest_opening, repair, interior, volume, diagonal, tolerance] =
      facts;
  archive(sha256, triangles, skipped_primitives, closed_openings, openings, widest_opening, repair, interior, volume, diagonal, tolerance);
}

template <typename Archive>
void fields(Archive& archive, RegionProof& proof) {
  auto& [bound, found] = proof;
  archive(bound, found);
}

template <typename Archive>
void fields(Archive& archive, HullFacts& facts) {
  auto& [hulls, hull_vertices, least_hulls, primitives, uncovered, protrusion, protrusion_found, worst, worst_nearest, hull_volume,
         covered_share, nudge, thickness, regions] = facts;
  archive(hulls, hull_vertices, least_hulls, primitives, uncovered, protrusion, protrusion_found, worst, worst_nearest, hull_volume,
          covered_share, nudge, thickness, regions);
}

static std::shared_ptr<const HullTree> decodedTree(const std::string& bytes) {
  try {
    return std::make_shared<const HullTree>(decodeHullTree(bytes, "a mesh's tree"));
  } catch (const Error& error) {
    throw ByteFault(error.what());
  }
}

template <typename Archive>
void fields(Archive& archive, MeshResult& result) {
  auto& [mesh, model, status, reason, error, untried, seconds, cached, original, hulls, primitives, unneeded, segments, coarser, solid] =
      result;
  archive(mesh, model, status, reason, error, original, hulls, primitives);
  std::string tree = coarser ? encodeHullTree(*coarser) : "";
  archive(tree);
  if (!coarser && !tree.empty()) coarser = decodedTree(tree);
}

template <typename Archive>
void fields(Archive& archive, Validation& validation) {
  auto& [queries, missed, phantom, max_underestimate, exceptions, timeouts, nan, disagreements, mesh_query_us, hull_query_us, remarks] =
      validation;
  archive(queries, missed, phantom, max_underestimate, exceptions, timeouts, nan, disagreements, mesh_query_us, hull_query_us, remarks);
}

template <typename Archive>
void fields(Archive& archive, Length& length) {
  auto& [limit, share] = length;
  archive(limit, share);
}

namespace {

/// The digest of the sources stands for the format of entries, too: nobody has to count its changes.
template <typename... Values>
std::string keyOf(const std::string& kind, const Values&... values) {
  return sha256(toBytes(kind, std::string(version()), std::string(sourceDigest()), values...));
}

/// Identifies the mesh, with its openings closed. The file's extension is included, since it determines how the content is read.
std::string meshBytes(const MeshTask& task) {
  return toBytes(task.sha256, std::filesystem::path(task.file).extension().string(), task.scale, task.close_openings);
}

}  // namespace

std::string meshKey(const MeshTask& task, const LinkOptions& options, std::uint64_t seed) {
  const auto& [action, tolerance, method, effort, tree, fill, max_hulls, max_vertices, source, padding, close_openings, shapes, regions] =
      options;
  ByteWriter places;
  for (const Region& region : regions) {
    places(region.tolerance, region.sides.size());
    for (const HalfSpace& side : region.sides) places(side.normal, side.offset);
  }
  return keyOf("mesh", meshBytes(task), tolerance, method, effort, tree.has_value(), tree.value_or(Length{}), fill, max_hulls, max_vertices,
               padding, shapes, places.take(), seed);
}

bool takesTreeWithoutProof(const LinkOptions& options) {
  return options.shapes == Shapes::kPrimitives && !options.tree;
}

std::string treeKey(const MeshTask& task, const LinkOptions& options, std::uint64_t seed, double tolerance) {
  const std::string kind = takesTreeWithoutProof(options) ? "tree without proof" : "tree";
  return keyOf(kind, meshBytes(task), tolerance, options.method, options.effort, options.fill, options.max_vertices, seed);
}

std::string validationKey(const std::vector<MeshUse>& uses, const MeshResults& results, const std::vector<std::string>& keys,
                          std::size_t model, std::uint64_t seed) {
  ByteWriter pairs;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (uses[i].model != model || results[i]->hulls.empty()) continue;
    pairs(uses[i].link, uses[i].element, keys[i]);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) pairs(uses[i].pose(row, column));
    }
  }
  return keyOf("validation", pairs.take(), seed);
}

Cache::Cache(std::filesystem::path folder, std::uintmax_t most_bytes) : folder_(std::move(folder), most_bytes) {}

// Without memory for an entry there is none.
template <typename Value>
std::optional<Value> Cache::find(const std::string& name, const std::function<bool(const Value&)>& fits) try {
  const std::optional<std::string> bytes = folder_.find(name);
  if (!bytes) return std::nullopt;
  try {
    Value value;
    fromBytes(*bytes, value);
    if (!fits || fits(value)) return value;
  } catch (const ByteFault&) {  // then it is damaged
  }
  folder_.discard(name);
  return std::nullopt;
} catch (const std::bad_alloc&) {
  return std::nullopt;
}

template <typename Value>
void Cache::store(const std::string& name, const Value& value) try {
  folder_.store(name, toBytes(value));
} catch (const std::bad_alloc&) {
}

std::optional<MeshResult> Cache::findMesh(const std::string& key, const std::string& sha256) {
  return find<MeshResult>(key + ".mesh", [&](const MeshResult& known) { return known.mesh.sha256 == sha256; });
}

void Cache::storeMesh(const std::string& key, const MeshResult& result) {
  store(key + ".mesh", result);
}

std::optional<Validation> Cache::findValidation(const std::string& key) {
  return find<Validation>(key + ".validation");
}

void Cache::storeValidation(const std::string& key, const Validation& validation) {
  if (validation.timeouts == 0) store(key + ".validation", validation);
}

std::optional<HullTree> Cache::findTree(const std::string& key) try {
  const std::string name = key + ".tree";
  const std::optional<std::string> bytes = find<std::string>(name);
  if (!bytes) return std::nullopt;
  try {
    return decodeHullTree(*bytes, name);
  } catch (const Error&) {
    folder_.discard(name);
    return std::nullopt;
  }
} catch (const std::bad_alloc&) {
  return std::nullopt;
}

void Cache::storeTree(const std::string& key, const HullTree& tree) try {
  store(key + ".tree", encodeHullTree(tree));
} catch (const std::bad_alloc&) {
}

}  // namespace collision_hulls
