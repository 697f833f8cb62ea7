// Scales one element and its hulls to unit size and builds everything that queries need, once: FCL's tree, our own tree, and the solid.
// Triangles without area are kept apart because FCL's answers about them are wrong.
#include "check/pair_model.h"

#include <algorithm>
#include <utility>

#include "base/looks.h"
#include "base/parallel.h"
#include "collision_hulls/mesh/repair.h"
#include "mesh/weld.h"

namespace collision_hulls {

namespace {

constexpr double kThinnest = 1e-12;  // a thinner triangle (height over length) has no area

bool hasArea(const TriangleMesh& mesh, int t) {
  const Eigen::Vector3d u = mesh.corner(t, 1) - mesh.corner(t, 0), v = mesh.corner(t, 2) - mesh.corner(t, 0);
  const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
  return u.cross(v).norm() > kThinnest * longest;
}

void append(TriangleMesh& mesh, const std::array<Eigen::Vector3d, 3>& corners) {
  const int i = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({i, i + 1, i + 2});
}

/// The triangles that have an area up to rounding, or the others.
TriangleMesh selected(const TriangleMesh& mesh, bool with_area, const RunControl& control) {
  TriangleMesh result;
  Looks look(control);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    if (look(); hasArea(mesh, t) == with_area) append(result, {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
  return result;
}

/// The same triangles; vertices at one place become one. Formats that list each triangle's corners, as STL does, have six times as many,
/// and FCL copies them.
TriangleMesh withSharedVertices(TriangleMesh mesh, const RunControl& control) {
  if (mesh.vertices.size() <= mesh.triangles.size()) return mesh;
  std::vector<int> number = weld(mesh, 0, control).representative;  // -1: unused
  int kept = 0;
  Looks look(control);
  for (std::size_t v = 0; v < number.size(); ++v) {
    look();
    const int first = number[v];
    if (first != static_cast<int>(v)) {
      if (first >= 0) number[v] = number[static_cast<std::size_t>(first)];
      continue;
    }
    mesh.vertices[static_cast<std::size_t>(kept)] = mesh.vertices[v];
    number[v] = kept++;
  }
  mesh.vertices.resize(static_cast<std::size_t>(kept));
  mesh.vertices.shrink_to_fit();
  for (Triangle& t : mesh.triangles)
    for (int& v : t) look(), v = number[static_cast<std::size_t>(v)];
  return mesh;
}

/// The hulls, the last of them shrunk until they lie in the spheres.
std::vector<ConvexHull> within(std::vector<ConvexHull> hulls, const std::vector<Sphere>& spheres) {
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    ConvexHull& hull = hulls[hulls.size() - spheres.size() + i];
    for (Eigen::Vector3d& v : hull.vertices) v = spheres[i].centre + spheres[i].radius * (v - spheres[i].centre).normalized();
    hull = convexHull(hull.vertices);
  }
  return hulls;
}

}  // namespace

PairModel::PairModel(ValidationPair& pair, const std::vector<ProbeShape>& box_shapes, const std::vector<Neighbour>& near,
                     const RunControl& control)
    : name(pair.name),
      solid(pair.solid ? pair.solid : std::make_shared<const Solid>(repair(pair.original, {}, control), control)),
      frame(pair),
      original(withSharedVertices(frame.units(std::move(pair.original)), control)),
      hulls(frame.units(pair.hulls)),
      spheres(frame.units(pair.spheres)),
      boxes(box_shapes),
      without_area(selected(original, false, control)),
      inner(within(hulls, spheres)),
      sampler(original, inner),
      tolerance(kFclTolerance + frame.rounding()),
      to_solid_(pair.solid ? pair.solid_pose.inverse() : Eigen::Isometry3d::Identity()) {
  if (!without_area.triangles.empty()) with_area_ = selected(original, true, control);
  atOnce([&] { fcl_original = std::make_unique<FclMesh>(withArea(), control); },
         [&] {
           bvh = std::make_unique<TriangleBvh>(withArea(), std::vector<char>(), control, TriangleBvh::Keeps::kNothing);
           bvh_without_area = std::make_unique<TriangleBvh>(without_area, std::vector<char>(), control, TriangleBvh::Keeps::kNothing);
         });
  allowed = frame.units(pair.protrusion) + tolerance + frame.units(solid->weldDistance());
  for (const Eigen::Vector3d& p : solid->componentPoints()) component_points.push_back(frame.units(to_solid_.inverse() * p));
  for (const Neighbour& neighbour : near) neighbours.emplace_back("hull of " + neighbour.name, frame.units(*neighbour.hull));
  for (const ConvexHull& hull : hulls) {
    fcl_hulls.emplace_back(hull);
    hull_boxes.push_back(boundingBox(hull));
  }
}

TriangleMesh PairModel::nearestWithArea(const Eigen::Vector3d& p) const {
  TriangleMesh result;
  append(result, bvh->corners(bvh->nearest(p).triangle));
  return result;
}

TriangleMesh PairModel::withAreaNear(const Eigen::AlignedBox3d& box) const {
  TriangleMesh result;
  for (const int t : bvh->trianglesNear(box)) append(result, bvh->corners(t));
  return result;
}

const Sphere* PairModel::sphereAt(std::size_t hull) const {
  const std::size_t first = hulls.size() - spheres.size();
  return hull < first ? nullptr : &spheres[hull - first];
}

bool PairModel::inSolid(const Eigen::Vector3d& p) const {
  return solid->contains(to_solid_ * frame.metres(p));
}

bool PairModel::hasOpenings() const {
  return solid->hasOpenings();
}

}  // namespace collision_hulls
