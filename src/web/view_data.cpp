// Every mesh that differs is prepared once, on all threads: its original, thinned if the page would grow too large, and the tree of hulls
// that the slider cuts, whose leaves are the hulls as written. Links only refer to it, with their pose.
//
// In the JSON:  meshes: [{original: BLOCK, triangles, bound, cuts: of a hull tree of the run, nodes: [{at: BODY, bound, left, right}]}],
//               leaves first, left and right -1
//               models: [{name, elements: [{row, link, uri, status, mesh, primitives: how many of the last leaves are some, pose: 3 x 4
//               by rows, found, bound, worst, nearest, regions: [BLOCK]}], kept: [{at: BODY, pose}]}]
//               scene: BLOCK or null
// A BLOCK is {offset, vertices, triangles, index: bytes of an index, origin, step}, a BODY a BLOCK or {shape: box, sphere or cylinder, size
// and pose as in URDF}; lengths in metres.
#include "web/view_data.h"

#include <map>
#include <nlohmann/json.hpp>

#include "base/parallel.h"
#include "collision_hulls/decompose/region.h"
#include "collision_hulls/error.h"
#include "decompose/coarser/coarser_hulls.h"
#include "geometry/box_hull.h"
#include "geometry/bytes.h"
#include "web/drawn_mesh.h"

namespace collision_hulls {
namespace {

using nlohmann::json;

constexpr std::size_t kMostTriangles = 150000;      // of all originals in a page: some 2 MB
constexpr std::size_t kMostSceneTriangles = 50000;  // of a scene's bodies
constexpr std::size_t kMostKeptTriangles = 5000;    // of a mesh that is kept
constexpr std::size_t kFewTriangles = 300;          // that every original may keep
constexpr double kAround = 0.15;                    // of a mesh's diagonal: how far around it regions are drawn
constexpr std::size_t kMostMerged = 150;            // hulls of a mesh: the pairs to try grow with their square

/// A mesh that elements share.
struct SharedMeshView {
  const PageElement* element;
  double bound = 0;  // [m] of its hulls
  std::size_t most_triangles = 0;
  DrawnMesh original;
  HullTree tree;
};

/// The hulls alone, which stay as they are.
HullTree withoutMerging(const std::vector<ConvexHull>& hulls, double bound) {
  HullTree tree;
  tree.tolerance = bound;
  for (const ConvexHull& hull : hulls) tree.nodes.push_back({hull, bound, -1, -1, -1});
  return tree;
}

HullTree treeOf(const PageElement& element, double bound, const RunControl& control) {
  const std::vector<ConvexHull>& hulls = element.hulls;
  if (element.tree) return *element.tree;
  if (hulls.size() > kMostMerged) return withoutMerging(hulls, bound);
  try {
    return coarserHulls(hulls, bound, control);
  } catch (const Error& error) {  // a page is no reason to lose a result
    if (error.code() == ErrorCode::kCancelled) throw;
    return withoutMerging(hulls, bound);
  }
}

/// The meshes of a page, and which of them each element shows.
class Meshes {
 public:
  /// Index of the element's mesh.
  std::size_t take(const PageElement& element, const ElementReport& row) {
    const std::string key = toBytes(row.sha256, row.scale, row.protrusion, element.original.triangles.size(), element.primitives.size()) +
                            hullBytes(element.hulls);
    const auto [known, is_new] = index_.emplace(key, meshes_.size());
    if (is_new) meshes_.push_back({&element, row.protrusion, 0, {}, {}});
    return known->second;
  }

  void prepare(const RunControl& control) {
    std::size_t all = 0;
    for (const SharedMeshView& mesh : meshes_) all += mesh.element->original.triangles.size();
    forEach(meshes_.size(), [&](std::size_t i) {
      control.check();
      SharedMeshView& mesh = meshes_[i];
      const std::size_t triangles = mesh.element->original.triangles.size();
      const double share = all > kMostTriangles ? static_cast<double>(kMostTriangles) / static_cast<double>(all) : 1;
      const std::size_t most = std::max(kFewTriangles, static_cast<std::size_t>(share * static_cast<double>(triangles)));
      mesh.original = drawnMesh(mesh.element->original, most, control);
      mesh.tree = treeOf(*mesh.element, mesh.bound, control);
    });
  }

  const std::vector<SharedMeshView>& all() const { return meshes_; }

 private:
  static std::string hullBytes(const std::vector<ConvexHull>& hulls) {
    ByteWriter bytes;
    for (const ConvexHull& hull : hulls)
      for (const Eigen::Vector3d& vertex : hull.vertices) bytes(vertex.x(), vertex.y(), vertex.z());
    return bytes.take();
  }

  std::map<std::string, std::size_t> index_;
  std::vector<SharedMeshView> meshes_;
};

json toJson(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

json toJson(const Eigen::Isometry3d& pose) {
  json rows = json::array();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) rows.push_back(pose(i, j));
  return rows;
}

/// Appends the bytes, and says where they are.
json block(const DrawnMesh& mesh, std::string& geometry) {
  json place = {{"offset", geometry.size()},          {"vertices", mesh.vertices.size()},
                {"triangles", mesh.triangles.size()}, {"index", indexBytes(mesh.vertices.size())},
                {"origin", toJson(mesh.origin)},      {"step", mesh.step}};
  geometry += toPageBytes(mesh);
  return place;
}

json block(const ConvexHull& hull, std::string& geometry) {
  return block(drawnMesh(surface(hull), hull.triangles.size()), geometry);
}

json shapeJson(const GeometryElement& primitive, const Eigen::Isometry3d& pose) {
  const char* const name = primitive.kind == GeometryElement::Kind::kSphere ? "sphere"
                           : primitive.kind == GeometryElement::Kind::kBox  ? "box"
                                                                            : "cylinder";
  return {{"shape", name}, {"size", toJson(primitive.size)}, {"pose", toJson(pose)}};
}

/// The primitive that a leaf stands for; null: it is a hull.
const GeometryElement* primitiveAt(std::size_t node, const PageElement& element) {
  const std::size_t leaves = element.hulls.size(), primitives = element.primitives.size();
  return node < leaves && node + primitives >= leaves ? &element.primitives[node + primitives - leaves] : nullptr;
}

json meshJson(const SharedMeshView& mesh, std::string& geometry) {
  json nodes = json::array();
  for (const HullNode& node : mesh.tree.nodes) {
    const GeometryElement* const primitive = primitiveAt(nodes.size(), *mesh.element);
    const json at = primitive ? shapeJson(*primitive, primitive->origin) : block(node.hull, geometry);
    nodes.push_back({{"at", at}, {"bound", node.protrusion}, {"left", node.left}, {"right", node.right}});
  }
  return {{"original", block(mesh.original, geometry)},
          {"cuts", mesh.element->tree != nullptr},
          {"triangles", mesh.element->original.triangles.size()},
          {"bound", mesh.bound},
          {"nodes", nodes}};
}

/// What is near the mesh of its regions: a half-space has no end.
json regionsJson(const ElementReport& row, const PageElement& element, std::string& geometry) {
  Eigen::AlignedBox3d box = boundingBox(element.original);
  for (const ConvexHull& hull : element.hulls) box.extend(boundingBox(hull));
  json regions = json::array();
  if (box.isEmpty()) return regions;
  const Eigen::Vector3d more = Eigen::Vector3d::Constant(kAround * box.diagonal().norm());
  const ConvexHull around = hullOfBox(box.min() - more, box.max() + more);
  for (const Region& region : row.regions_given)
    if (const std::optional<ConvexHull> part = partIn(around, region)) regions.push_back(block(*part, geometry));
  return regions;
}

json elementJson(std::size_t row_index, const ElementReport& row, const PageElement& element, std::size_t mesh) {
  return {{"row", row_index},
          {"link", row.link},
          {"uri", row.uri},
          {"status", name(row.status)},
          {"mesh", mesh},
          {"primitives", row.primitives},
          {"pose", toJson(element.pose)},
          {"found", row.protrusion_found},
          {"bound", row.protrusion},
          {"worst", toJson(row.worst)},
          {"nearest", toJson(row.worst_nearest)}};
}

/// Names in a description may be no UTF-8, which JSON cannot hold: such bytes are shown as U+FFFD. Non-finite numbers become null.
std::string text(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

json keptJson(const PageBody& body, std::string& geometry, const RunControl& control) {
  const json at = body.element.kind == GeometryElement::Kind::kMesh ? block(drawnMesh(body.surface, kMostKeptTriangles, control), geometry)
                                                                    : shapeJson(body.element, Eigen::Isometry3d::Identity());
  return {{"at", at}, {"pose", toJson(body.pose)}};
}

}  // namespace

/// Elements become text one by one: those of a large robot take ten times as much memory as a document.
ViewData viewData(const PageContent& content, const RunControl& control) {
  Meshes meshes;
  ViewData data;
  std::string models;
  for (const PageModel& model : content.models) {
    std::string elements;
    for (std::size_t i = 0; i < model.elements.size(); ++i) {
      control.check();
      const ElementReport& row = model.report.links[i];
      json element = elementJson(i, row, model.elements[i], meshes.take(model.elements[i], row));
      element["regions"] = regionsJson(row, model.elements[i], data.geometry);
      elements += (elements.empty() ? "" : ",") + text(element);
    }
    json kept = json::array();
    for (const PageBody& body : model.kept) kept.push_back(keptJson(body, data.geometry, control));
    models += (models.empty() ? "" : ",") + std::string("{\"elements\":[") + elements + "],\"name\":" + text(model.report.model) +
              ",\"kept\":" + text(kept) + "}";
  }
  meshes.prepare(control);
  json all = json::array();
  for (const SharedMeshView& mesh : meshes.all()) all.push_back(meshJson(mesh, data.geometry));
  const json scene =
      content.scene.triangles.empty() ? json() : block(drawnMesh(content.scene, kMostSceneTriangles, control), data.geometry);
  data.json = "{\"meshes\":" + text(all) + ",\"models\":[" + models + "],\"scene\":" + text(scene) + "}";
  return data;
}

}  // namespace collision_hulls
