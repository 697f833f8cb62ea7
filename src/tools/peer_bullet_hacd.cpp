// peer_bullet_hacd in.obj out.obj tolerance: runs Bullet's HACD, the reference implementation of Mamou and Ghorbel 2009, for comparison.
#include <HACD/hacdHACD.h>

#include "collision_hulls/geometry/triangle_mesh.h"
#include "peer_program.h"

namespace collision_hulls {
namespace {

constexpr const char* kHelp =
    "Decomposes a mesh with HACD from Bullet's extras. The tolerance, in metres, becomes HACD's concavity, which is measured\n"
    "in a frame where the bounding box's diagonal is 2000: concavity = tolerance * 2000 / diagonal. At most 64 vertices per hull,\n"
    "at least one hull, and components are not connected. All else is as in Bullet's own demo: compacity weight 0.1, volume\n"
    "weight 0, no extra distance points.\n";

constexpr double kScale = 1000;  // HACD's default; half of the diagonal in its frame

std::vector<HACD::Vec3<HACD::Real>> pointsOf(const TriangleMesh& mesh) {
  std::vector<HACD::Vec3<HACD::Real>> points;
  for (const Eigen::Vector3d& v : mesh.vertices) points.emplace_back(v.x(), v.y(), v.z());
  return points;
}

std::vector<HACD::Vec3<long>> trianglesOf(const TriangleMesh& mesh) {
  std::vector<HACD::Vec3<long>> triangles;
  for (const Triangle& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  return triangles;
}

TriangleMesh part(HACD::HACD& hacd, std::size_t index) {
  std::vector<HACD::Vec3<HACD::Real>> points(hacd.GetNPointsCH(index));
  std::vector<HACD::Vec3<long>> triangles(hacd.GetNTrianglesCH(index));
  hacd.GetCH(index, points.data(), triangles.data());
  TriangleMesh result;
  for (const auto& p : points) result.vertices.emplace_back(p.X(), p.Y(), p.Z());
  for (const auto& t : triangles) result.triangles.push_back({static_cast<int>(t.X()), static_cast<int>(t.Y()), static_cast<int>(t.Z())});
  return result;
}

std::vector<TriangleMesh> decompose(const TriangleMesh& mesh, double tolerance) {
  auto points = pointsOf(mesh);
  auto triangles = trianglesOf(mesh);
  HACD::HACD hacd;
  hacd.SetPoints(points.data());
  hacd.SetNPoints(points.size());
  hacd.SetTriangles(triangles.data());
  hacd.SetNTriangles(triangles.size());
  hacd.SetScaleFactor(kScale);
  hacd.SetConcavity(tolerance * 2 * kScale / diagonal(mesh));
  hacd.SetNClusters(1);
  hacd.SetNVerticesPerCH(64);
  hacd.SetCompacityWeight(0.1);
  hacd.SetVolumeWeight(0);
  hacd.SetConnectDist(-1);
  hacd.SetAddExtraDistPoints(false);
  hacd.SetAddNeighboursDistPoints(false);
  hacd.SetAddFacesPoints(false);
  std::vector<TriangleMesh> parts;
  if (!hacd.Compute()) return parts;
  for (std::size_t i = 0; i < hacd.GetNClusters(); ++i) parts.push_back(part(hacd, i));
  return parts;
}

}  // namespace
}  // namespace collision_hulls

int main(int argc, char** argv) {
  return collision_hulls::peerMain(argc, argv, collision_hulls::kHelp, collision_hulls::decompose);
}
