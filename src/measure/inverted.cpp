// Finds the triangles in front of which a surface may enclose something inside out. All triangles at an edge belong to one part
// (edge-connected component), so each part is closed and has a winding number of its own; the surface's is their sum. Parts may cross one
// another.
//  1. Mark the triangles that may meet others of their part elsewhere than at common corners and edges (triangle_pairs.h).
//  2. The others form patches across edges that just two of them use, in opposite directions. Nothing of the part is crossed by walking
//     along a patch's front, so one probe tells the part's winding number in front of the whole patch. If it is negative, mark the patch.
//  3. A region where a part's winding number is negative is bounded by triangles that all face it, hence by marked ones. Its outer border
//     is connected, so the region lies in the box around a cluster of marked triangles that touch, unless their normals leave some
//     direction out: they then bound no region. Outside these boxes no part's winding number is negative.
// So a part's winding number is proved not to be negative in front of those of its triangles that are not marked, and of all triangles
// outside its boxes.
// Near-linear: each triangle is compared with those whose boxes meet its own.
#include "measure/inverted.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/looks.h"
#include "base/parallel.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "measure/triangle_pairs.h"
#include "mesh/edges.h"

namespace collision_hulls {

namespace {

constexpr double kProbeHeight = 1e-3;  // of the first probe over a triangle, roughly in lengths of its shortest altitude
constexpr int kProbes = 12;            // each half as high as the one before
constexpr double kLeastHeight = 4;     // of a probe, in widths of the blur

// Normals more nearly parallel than this do not give a direction across both; larger clusters are not examined; a cosine this small is 0.
constexpr double kParallel = 1e-6, kCosineRounding = 1e-12;
constexpr std::size_t kManyNormals = 40;

constexpr std::size_t kTrianglesOfBlock = 256;  // that one thread compares with those nearby, ...
constexpr std::size_t kAsOne = 4;               // ... which are looked up for so many at a time

Eigen::AlignedBox3d boxOf(const TriangleMesh& mesh, int t) {
  Eigen::AlignedBox3d box(mesh.corner(t, 0));
  return box.extend(mesh.corner(t, 1)).extend(mesh.corner(t, 2));
}

/// Whether surface with these normals may enclose a region: not if some direction is at no acute angle to any of them, for then nothing
/// bounds the region on that side. If there is such a direction, there is one at a right angle to two of the normals or, if all are
/// parallel, to one.
bool mayEnclose(const std::vector<Eigen::Vector3d>& normals) {
  const auto isLeftOut = [&](const Eigen::Vector3d& direction) {
    const double most = kCosineRounding * direction.norm();
    return most > 0 && std::all_of(normals.begin(), normals.end(), [&](const auto& n) { return n.dot(direction) <= most; });
  };
  if (normals.size() > kManyNormals) return true;
  for (const Eigen::Vector3d& a : normals) {
    for (int axis = 0; axis < 3; ++axis)
      if (isLeftOut(a.cross(Eigen::Vector3d::Unit(axis)))) return false;
    for (const Eigen::Vector3d& b : normals)
      if (a.cross(b).norm() > kParallel && isLeftOut(a.cross(b))) return false;
  }
  return true;
}

/// One part, with its own numbering of triangles and vertices.
class Part {
 public:
  Part(TriangleMesh mesh, const RunControl& control)
      : mesh_(std::move(mesh)),
        control_(control),
        tree_(mesh_, {}, control, TriangleBvh::Keeps::kNothing),
        marked_(mesh_.triangles.size()) {}

  const std::vector<char>& marked() const { return marked_; }

  /// Steps 1 and 2.
  void mark() {
    findMeetings();
    const Edges edges = findEdges(mesh_.triangles, mesh_.vertices.size(), control_);
    std::vector<char> seen = marked_;
    Looks look(control_);
    for (int t = 0; t < count(); ++t) {
      look();
      if (seen[static_cast<std::size_t>(t)]) continue;
      const std::vector<int> patch = patchFrom(t, edges, seen, look);
      const int largest =
          *std::max_element(patch.begin(), patch.end(), [&](int a, int b) { return look(), areaVector(a).norm() < areaVector(b).norm(); });
      if (isProper(largest)) continue;
      for (const int of_it : patch) marked_[static_cast<std::size_t>(of_it)] = 1;
    }
  }

  /// Step 3.
  std::vector<Eigen::AlignedBox3d> boxesAroundClusters() const {
    Looks look(control_);
    DisjointSets sets(mesh_.triangles.size());
    for (const auto& [t, u] : meetings_) look(), sets.join(t, u);
    std::vector<int> at_vertex(mesh_.vertices.size(), -1);
    for (int t = 0; t < count(); ++t) {
      look();
      if (!marked_[static_cast<std::size_t>(t)]) continue;
      for (const int v : mesh_.triangles[static_cast<std::size_t>(t)]) {
        int& other = at_vertex[static_cast<std::size_t>(v)];
        if (other >= 0) sets.join(t, other);
        other = t;
      }
    }
    std::vector<std::pair<int, int>> members;  // of clusters
    for (int t = 0; t < count(); ++t)
      if (marked_[static_cast<std::size_t>(t)]) look(), members.emplace_back(sets.find(t), t);
    std::sort(members.begin(), members.end(), [&](const auto& a, const auto& b) { return look(), a < b; });
    std::vector<Eigen::AlignedBox3d> boxes;
    for (auto member = members.begin(); member != members.end();) {
      std::vector<Eigen::Vector3d> normals;
      Eigen::AlignedBox3d box;
      for (const int cluster = member->first; member != members.end() && member->first == cluster; ++member) {
        look();
        normals.push_back(areaVector(member->second).normalized());
        box.extend(boxOf(mesh_, member->second));
      }
      if (mayEnclose(normals)) boxes.push_back(box);
    }
    return boxes;
  }

 private:
  int count() const { return static_cast<int>(mesh_.triangles.size()); }
  Eigen::Vector3d areaVector(int t) const {
    return (mesh_.corner(t, 1) - mesh_.corner(t, 0)).cross(mesh_.corner(t, 2) - mesh_.corner(t, 0));
  }

  void findMeetings() {
    const double extent = boundingBox(mesh_).sizes().maxCoeff();
    const std::vector<int>& order = tree_.byPlace();
    std::vector<Meetings> met((order.size() + kTrianglesOfBlock - 1) / kTrianglesOfBlock);
    forEach(met.size(), [&](std::size_t block) {
      control_.check();
      Looks look(control_);
      const std::size_t end = std::min(order.size(), (block + 1) * kTrianglesOfBlock);
      for (std::size_t first = block * kTrianglesOfBlock; first < end; first += kAsOne)
        addMeetings(&order[first], std::min(kAsOne, end - first), extent, look, met[block]);
    });
    for (const Meetings& of_block : met)
      for (const auto& [t, u] : of_block) {
        meetings_.emplace_back(t, u);
        marked_[static_cast<std::size_t>(t)] = marked_[static_cast<std::size_t>(u)] = 1;
      }
  }

  using Meetings = std::vector<std::pair<int, int>>;

  /// Of up to kAsOne triangles, each with those of higher index.
  void addMeetings(const int* triangles, std::size_t count, double extent, Looks& look, Meetings& met) const {
    std::array<Eigen::AlignedBox3d, kAsOne> boxes;
    Eigen::AlignedBox3d all;
    for (std::size_t i = 0; i < count; ++i) all.extend(boxes[i] = boxOf(mesh_, triangles[i]));
    for (const int u : tree_.trianglesNear(all)) {
      const Eigen::AlignedBox3d box = boxOf(mesh_, u);
      for (std::size_t i = 0; i < count; ++i) {
        const int t = triangles[i];
        if (look(); u > t && boxes[i].intersects(box) && !meetOnlyAsNeighbours(mesh_, t, u, extent)) met.emplace_back(t, u);
      }
    }
  }

  std::vector<int> patchFrom(int seed, const Edges& edges, std::vector<char>& seen, Looks& look) const {
    std::vector<int> patch{seed};
    seen[static_cast<std::size_t>(seed)] = 1;
    for (std::size_t next = 0; next < patch.size(); ++next) {
      look();
      for (int h = 3 * patch[next]; h < 3 * patch[next] + 3; ++h) {
        const int twin = edges.twin[static_cast<std::size_t>(h)];
        if (twin < 0 || startOf(mesh_.triangles, twin) != endOf(mesh_.triangles, h) || seen[static_cast<std::size_t>(twin / 3)]) continue;
        seen[static_cast<std::size_t>(twin / 3)] = 1;
        patch.push_back(twin / 3);
      }
    }
    return patch;
  }

  /// Whether the winding number just in front of a triangle's middle is not negative, told at a point to which nothing is nearer than the
  /// triangle; false if there is no such point.
  bool isProper(int t) const {
    const Eigen::Vector3d normal = areaVector(t), foot = (mesh_.corner(t, 0) + mesh_.corner(t, 1) + mesh_.corner(t, 2)) / 3;
    double height = kProbeHeight * std::sqrt(normal.norm());
    for (int i = 0; i < kProbes && height > kLeastHeight * tree_.blur(); ++i, height /= 2) {
      const Eigen::Vector3d p = foot + height * normal.normalized();
      if (tree_.nearest(p).triangle == t) return tree_.signedCrossings(p) >= 0;
    }
    return false;
  }

  const TriangleMesh mesh_;
  const RunControl& control_;
  const TriangleBvh tree_;
  std::vector<char> marked_;
  Meetings meetings_;
};

/// A surface's parts.
struct Parts {
  std::vector<int> of;                    // the part of each triangle
  std::vector<std::vector<int>> members;  // the triangles of each part
  std::vector<TriangleMesh> meshes;       // the same with numberings of their own
};

Parts partsOf(const TriangleMesh& surface, const RunControl& control) {
  Edges edges = findEdges(surface.triangles, surface.vertices.size(), control);
  Parts parts{std::move(edges.component), std::vector<std::vector<int>>(edges.components), std::vector<TriangleMesh>(edges.components)};
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    parts.members[static_cast<std::size_t>(parts.of[t])].push_back(static_cast<int>(t));
  std::vector<int> number(surface.vertices.size(), -1);
  Looks look(control);
  for (std::size_t c = 0; c < parts.meshes.size(); ++c) {
    TriangleMesh& part = parts.meshes[c];
    std::vector<int> used;
    for (const int t : parts.members[c]) {
      look();
      Triangle triangle = surface.triangles[static_cast<std::size_t>(t)];
      for (int& v : triangle) {
        int& mine = number[static_cast<std::size_t>(v)];
        if (mine < 0) {
          mine = static_cast<int>(part.vertices.size());
          part.vertices.push_back(surface.vertices[static_cast<std::size_t>(v)]);
          used.push_back(v);
        }
        v = mine;
      }
      part.triangles.push_back(triangle);
    }
    for (const int v : used) number[static_cast<std::size_t>(v)] = -1;
  }
  return parts;
}

}  // namespace

std::vector<char> mayFaceInverted(const TriangleMesh& surface, const RunControl& control) {
  Parts parts = partsOf(surface, control);
  std::vector<std::vector<Eigen::AlignedBox3d>> boxes(parts.meshes.size());
  std::vector<char> marked(surface.triangles.size(), 0), result(surface.triangles.size(), 0);
  forEach(parts.meshes.size(), [&](std::size_t c) {
    control.check();
    Part part(std::move(parts.meshes[c]), control);
    part.mark();
    boxes[c] = part.boxesAroundClusters();
    for (std::size_t i = 0; i < parts.members[c].size(); ++i) marked[static_cast<std::size_t>(parts.members[c][i])] = part.marked()[i];
  });
  if (std::all_of(boxes.begin(), boxes.end(), [](const auto& of_part) { return of_part.empty(); })) return result;
  const TriangleBvh tree(surface, {}, control, TriangleBvh::Keeps::kNothing);
  Looks look(control);
  for (std::size_t c = 0; c < boxes.size(); ++c)
    for (const Eigen::AlignedBox3d& box : boxes[c])
      for (const int t : tree.trianglesNear(box)) {
        look();
        const auto i = static_cast<std::size_t>(t);
        if (marked[i] || parts.of[i] != static_cast<int>(c)) result[i] = 1;
      }
  return result;
}

}  // namespace collision_hulls
