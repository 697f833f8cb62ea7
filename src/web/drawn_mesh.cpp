// Thinning joins the vertices in each cell of a coarse grid in their mean: triangles between them vanish, and equal ones are drawn once. It
// keeps what is large, stays near the surface, and never fails, which quadric simplification of foreign meshes may. Each round starts from
// what the last one left, so that the rounds together cost little more than the first.
#include "web/drawn_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/looks.h"

namespace collision_hulls {
namespace {

constexpr double kFurthest = 1e6;      // [m]
constexpr double kFirstCoarser = 3;    // cells per triangle's side, in the first round: details are smaller than the average
constexpr double kEachCoarser = 0.75;  // of the cells along an axis

using GridPoint = std::array<std::uint16_t, 3>;

bool isPoint(const Eigen::Vector3d& p) {
  return p.allFinite() && p.cwiseAbs().maxCoeff() <= kFurthest;
}

/// The triangles that can be drawn.
std::vector<Triangle> usable(const TriangleMesh& mesh, Looks& look) {
  const int count = static_cast<int>(mesh.vertices.size());
  std::vector<char> is_point;
  for (const Eigen::Vector3d& vertex : mesh.vertices) look(), is_point.push_back(isPoint(vertex) ? 1 : 0);
  const auto fits = [&](int v) { return v >= 0 && v < count && is_point[static_cast<std::size_t>(v)] != 0; };
  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh.triangles)
    if (look(); std::all_of(t.begin(), t.end(), fits)) triangles.push_back(t);
  return triangles;
}

/// Ordered as the points are.
std::uint64_t key(const GridPoint& p) {
  return (std::uint64_t{p[0]} << 32U) | (std::uint64_t{p[1]} << 16U) | p[2];
}

/// The indices of some points, those that are equal side by side.
using Order = std::vector<std::pair<std::uint64_t, int>>;

void sort(Order& order, Looks& look) {
  std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) { return look(), a < b; });
}

/// Joins equal points, and drops triangles with equal corners and points without triangles.
void weld(const std::vector<GridPoint>& points, const std::vector<Triangle>& triangles, Looks& look, DrawnMesh& mesh) {
  const auto point = [&](int v) -> const GridPoint& { return points[static_cast<std::size_t>(v)]; };
  const auto has_area = [&](const Triangle& t) {
    return look(), point(t[0]) != point(t[1]) && point(t[1]) != point(t[2]) && point(t[2]) != point(t[0]);
  };
  std::vector<Triangle> kept;
  std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(kept), has_area);
  std::vector<char> is_used(points.size(), 0);
  for (const Triangle& t : kept)
    for (const int v : t) look(), is_used[static_cast<std::size_t>(v)] = 1;
  Order order;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (look(); is_used[v]) order.emplace_back(key(points[v]), static_cast<int>(v));
  sort(order, look);
  std::vector<GridPoint> used;
  std::vector<int> index(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    look();
    if (i == 0 || order[i].first != order[i - 1].first) used.push_back(point(order[i].second));
    index[static_cast<std::size_t>(order[i].second)] = static_cast<int>(used.size()) - 1;
  }
  for (Triangle& t : kept)
    for (int& v : t) v = index[static_cast<std::size_t>(v)];
  mesh.vertices = std::move(used);
  mesh.triangles = std::move(kept);
}

Eigen::Vector3d gridPlace(const DrawnMesh& mesh, int vertex) {
  const GridPoint& p = mesh.vertices[static_cast<std::size_t>(vertex)];
  return {double(p[0]), double(p[1]), double(p[2])};
}

/// The same triangle, whichever corner it starts with.
void dropEqual(std::vector<Triangle>& triangles, Looks& look) {
  for (Triangle& t : triangles) look(), std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end(), [&](const Triangle& a, const Triangle& b) { return look(), a < b; });
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
}

DrawnMesh onFinestGrid(const TriangleMesh& mesh, Looks& look) {
  const std::vector<Triangle> triangles = usable(mesh, look);
  Eigen::AlignedBox3d box;
  for (const Triangle& t : triangles)
    for (const int v : t) box.extend(mesh.vertices[static_cast<std::size_t>(v)]);
  DrawnMesh drawn;
  if (box.isEmpty()) return drawn;
  drawn.origin = box.min();
  drawn.step = box.sizes().maxCoeff() / DrawnMesh::kMostCells;
  std::vector<GridPoint> points;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    look();
    GridPoint point{};
    const Eigen::Vector3d cells = drawn.step > 0 ? Eigen::Vector3d((vertex - drawn.origin) / drawn.step) : Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)  // of what no triangle uses, anything
      point[static_cast<std::size_t>(k)] =
          static_cast<std::uint16_t>(std::isfinite(cells[k]) ? std::clamp(std::round(cells[k]), 0.0, double{DrawnMesh::kMostCells}) : 0);
    points.push_back(point);
  }
  weld(points, triangles, look, drawn);
  return drawn;
}

/// Leaves one vertex, the mean, of those in each of so many cells along an axis.
void coarsen(double cells, Looks& look, DrawnMesh& mesh) {
  Order by_cell;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    look();
    GridPoint cell{};
    for (std::size_t k = 0; k < cell.size(); ++k)
      cell[k] = static_cast<std::uint16_t>(mesh.vertices[v][k] * cells / (DrawnMesh::kMostCells + 1.0));
    by_cell.emplace_back(key(cell), static_cast<int>(v));
  }
  sort(by_cell, look);
  std::vector<GridPoint> means(mesh.vertices.size());  // by vertex
  for (auto first = by_cell.begin(), last = first; first != by_cell.end(); first = last) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (last = first; last != by_cell.end() && last->first == first->first; ++last) look(), sum += gridPlace(mesh, last->second);
    sum /= static_cast<double>(last - first);
    for (auto member = first; member != last; ++member)
      for (int k = 0; k < 3; ++k)
        means[static_cast<std::size_t>(member->second)][static_cast<std::size_t>(k)] = static_cast<std::uint16_t>(std::lround(sum[k]));
  }
  weld(means, std::vector<Triangle>(mesh.triangles), look, mesh);
  dropEqual(mesh.triangles, look);
}

/// Cells along an axis that leave about as many triangles of a mesh that is finely divided everywhere.
double cellsFor(std::size_t triangles, const DrawnMesh& mesh) {
  const auto at = [&](int v) -> Eigen::Vector3d { return gridPlace(mesh, v) / DrawnMesh::kMostCells; };
  double area = 0;  // of the square of the mesh's extent
  for (const Triangle& t : mesh.triangles) area += (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).norm() / 2;
  return area > 0 ? kFirstCoarser * std::sqrt(static_cast<double>(triangles) / area) : DrawnMesh::kMostCells;
}

template <typename Index, typename Item>
void append(const std::vector<Item>& items, std::string& bytes) {
  for (const Item& item : items) {
    for (const auto value : item) {
      const auto index = static_cast<Index>(value);
      char raw[sizeof index];
      std::memcpy(raw, &index, sizeof index);
      bytes.append(raw, sizeof index);
    }
  }
  bytes.resize((bytes.size() + 3) / 4 * 4);
}

}  // namespace

DrawnMesh drawnMesh(const TriangleMesh& mesh, std::size_t most_triangles, const RunControl& control) {
  Looks look(control);
  DrawnMesh drawn = onFinestGrid(mesh, look);
  if (drawn.triangles.size() <= most_triangles) return drawn;
  for (double cells = std::min(kEachCoarser * DrawnMesh::kMostCells, cellsFor(most_triangles, drawn));
       drawn.triangles.size() > most_triangles && cells >= 1; cells *= kEachCoarser)
    coarsen(cells, look, drawn);
  return drawn;
}

int indexBytes(std::size_t vertices) {
  constexpr std::size_t kByte = 1U << 8U, kTwo = 1U << 16U;
  return vertices <= kByte ? 1 : vertices <= kTwo ? 2 : 4;
}

std::string toPageBytes(const DrawnMesh& mesh) {
  std::string bytes;
  append<std::uint16_t>(mesh.vertices, bytes);
  switch (indexBytes(mesh.vertices.size())) {
    case 1: append<std::uint8_t>(mesh.triangles, bytes); break;
    case 2: append<std::uint16_t>(mesh.triangles, bytes); break;
    default: append<std::uint32_t>(mesh.triangles, bytes);
  }
  return bytes;
}

}  // namespace collision_hulls
