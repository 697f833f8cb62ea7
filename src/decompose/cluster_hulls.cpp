// One exact hull per cluster. A loose segment that no hull contains joins the hull whose distance from the segment's further end is least;
// boxes prune that search.
#include "decompose/cluster_hulls.h"

#include <algorithm>
#include <limits>

#include "mesh/loose_segments.h"

namespace collision_hulls {

namespace {

using Points = std::vector<Eigen::Vector3d>;

/// The corners of a cluster's triangles, each once.
Points corners(const TriangleMesh& mesh, const std::vector<int>& cluster) {
  std::vector<int> indices;
  for (int t : cluster) indices.insert(indices.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  Points points;
  for (int v : indices) points.push_back(mesh.vertices[v]);
  return points;
}

/// The hull nearest to a segment, by the segment's further end; -1 if some hull contains it.
int nearestOutside(const std::vector<ConvexHull>& hulls, const std::vector<Eigen::AlignedBox3d>& boxes, const Segment& segment) {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t h = 0; h < hulls.size(); ++h) {
    const auto furthest = [&](const auto& distance) { return std::max<double>(distance(segment[0]), distance(segment[1])); };
    if (furthest([&](const Eigen::Vector3d& p) { return boxes[h].exteriorDistance(p); }) >= least) continue;
    if (furthest([&](const Eigen::Vector3d& p) { return planeDistance(hulls[h], p); }) <= 0) return -1;
    const double d = furthest([&](const Eigen::Vector3d& p) { return distance(hulls[h], p); });
    if (d < least) least = d, best = static_cast<int>(h);
  }
  return best;
}

}  // namespace

void addLoose(std::vector<ConvexHull>& hulls, const std::vector<Segment>& loose, const RunControl& control) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const ConvexHull& hull : hulls) boxes.push_back(boundingBox(hull));
  std::vector<Points> extra(hulls.size());
  for (const Segment& segment : loose) {
    control.check();
    const int h = nearestOutside(hulls, boxes, segment);
    if (h >= 0) extra[h].insert(extra[h].end(), segment.begin(), segment.end());
  }
  for (std::size_t h = 0; h < hulls.size(); ++h) {
    if (extra[h].empty()) continue;
    control.check();
    extra[h].insert(extra[h].end(), hulls[h].vertices.begin(), hulls[h].vertices.end());
    const double thickness = hulls[h].thickness;
    hulls[h] = convexHull(extra[h], control);
    hulls[h].thickness = std::max(hulls[h].thickness, thickness);
  }
}

std::vector<ConvexHull> clusterHulls(const RepairedMesh& mesh, const std::vector<std::vector<int>>& clusters, const RunControl& control) {
  if (clusters.empty()) return {convexHull(withLoose(mesh).vertices, control)};
  std::vector<ConvexHull> hulls;
  for (const std::vector<int>& cluster : clusters) {
    control.check();
    hulls.push_back(convexHull(corners(mesh.mesh, cluster), control));
  }
  addLoose(hulls, mesh.loose, control);
  return hulls;
}

}  // namespace collision_hulls
