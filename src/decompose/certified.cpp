#include "collision_hulls/decompose/certified.h"

#include <cmath>

#include "collision_hulls/decompose/reduce_vertices.h"
#include "decompose/merging.h"

namespace collision_hulls {

namespace {

constexpr double kCuttingShare = 0.7;  // of the time, for progress

/// The mesh moved so that `middle` is the origin: near it coordinates are finest, however far away the mesh lies.
RepairedMesh about(const Eigen::Vector3d& middle, RepairedMesh mesh) {
  for (Eigen::Vector3d& v : mesh.mesh.vertices) v -= middle;
  for (Eigen::Vector3d& p : mesh.loose) p -= middle;
  return mesh;
}

void moveBack(ConvexHull& hull, const Eigen::Vector3d& middle) {
  for (Eigen::Vector3d& v : hull.vertices) v += middle;
  for (HalfSpace& face : hull.faces) face.offset += face.normal.dot(middle);
}

Eigen::AlignedBox3d boxOf(const RepairedMesh& mesh) {
  Eigen::AlignedBox3d box = boundingBox(mesh.mesh);
  for (const Eigen::Vector3d& p : mesh.loose) box.extend(p);
  return box;
}

/// What both entry points need: the solid, and an oracle about it.
struct Job {
  Job(const RepairedMesh& mesh, double tolerance, const RunControl& run)
      : solid(mesh), control(run), oracle(solid, boxOf(mesh), tolerance, run) {}

  HullTree tree(const RepairedMesh& mesh, int max_vertices, bool to_root) {
    const std::vector<Leaf> leaves = cutIntoLeaves(mesh, oracle, max_vertices, [&](double done) { control.report(kCuttingShare * done); });
    return merged(leaves, oracle, to_root, [&](double done) { control.report(kCuttingShare + (1 - kCuttingShare) * done); });
  }

  Solid solid;
  const RunControl& control;
  ProtrusionOracle oracle;
};

/// The hull of a node with its vertices capped; where that protrudes too far, those of its children instead, unless the number of
/// hulls is capped too.
void addCapped(const HullTree& tree, int id, const DecomposeOptions& options, ProtrusionOracle& oracle, Decomposition& result) {
  const HullNode& node = tree.nodes[static_cast<std::size_t>(id)];
  if (options.max_vertices == 0 || node.hull.vertices.size() <= static_cast<std::size_t>(options.max_vertices)) {
    result.hulls.push_back(node.hull);
    return;
  }
  const ConvexHull reduced = reduceVertices(node.hull, options.max_vertices).hull;
  const bool within = std::isfinite(oracle.within(reduced, node.protrusion));
  const bool may_open = options.max_hulls == 0 && node.left >= 0;
  if (!within && may_open) {
    addCapped(tree, node.left, options, oracle, result);
    addCapped(tree, node.right, options, oracle, result);
    return;
  }
  result.capped = result.capped || !within;
  result.hulls.push_back(reduced);
}

}  // namespace

Decomposition certified(const RepairedMesh& original, const DecomposeOptions& options, const RunControl& control) {
  const Eigen::Vector3d middle = boxOf(original).center();
  const RepairedMesh mesh = about(middle, original);
  Job job(mesh, options.tolerance, control);
  HullTree tree = job.tree(mesh, options.max_vertices, false);
  std::vector<int> cut = rootsOf(tree);
  Decomposition result;
  if (options.max_hulls > 0 && cut.size() > static_cast<std::size_t>(options.max_hulls)) {
    tree = job.tree(mesh, options.max_vertices, true);
    cut = tree.cutTo(options.max_hulls);
    result.capped = true;
  }
  for (int id : cut) addCapped(tree, id, options, job.oracle, result);
  for (ConvexHull& hull : result.hulls) moveBack(hull, middle);
  control.report(1);
  return result;
}

HullTree hullTree(const RepairedMesh& mesh, double tolerance, int max_vertices, const RunControl& control) {
  if (!(tolerance > 0 && std::isfinite(tolerance)))
    throw Error(ErrorCode::kBadOption, "tolerance is " + std::to_string(tolerance) + " m; it must be a positive length");
  if (mesh.mesh.triangles.empty() && mesh.loose.empty())
    throw Error(ErrorCode::kEmptyMesh, "the mesh has no triangle; a hull tree needs at least one");
  const Eigen::Vector3d middle = boxOf(mesh).center();
  const RepairedMesh local = about(middle, mesh);
  HullTree tree = Job(local, tolerance, control).tree(local, max_vertices, true);
  for (HullNode& node : tree.nodes) moveBack(node.hull, middle);
  return tree;
}

}  // namespace collision_hulls
