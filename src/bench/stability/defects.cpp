// One function per kind of defect. Each takes a valid mesh and draws only from the given generator, so a seed gives the same mesh
// everywhere.
#include "bench/stability/defects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/at.h"
#include "decompose/surface_piece.h"

namespace collision_hulls {

namespace {

constexpr double kSliversAmong = 0.1, kFinsAmong = 0.05;  // shares of the triangles that get one
constexpr double kSpeck = 0.01;                           // size of a small component, in D

bool chosen(double share, Random& random) {
  return random.uniform(0, 1) < share;
}

Eigen::Vector3d centre(const TriangleMesh& mesh, std::size_t t) {
  const int triangle = static_cast<int>(t);
  return (mesh.corner(triangle, 0) + mesh.corner(triangle, 1) + mesh.corner(triangle, 2)) / 3;
}

double area(const TriangleMesh& mesh, std::size_t t) {
  const int triangle = static_cast<int>(t);
  return (mesh.corner(triangle, 1) - mesh.corner(triangle, 0)).cross(mesh.corner(triangle, 2) - mesh.corner(triangle, 0)).norm() / 2;
}

int addVertex(TriangleMesh& mesh, const Eigen::Vector3d& p) {
  mesh.vertices.push_back(p);
  return static_cast<int>(mesh.vertices.size()) - 1;
}

TriangleMesh unwelded(const TriangleMesh& mesh) {
  TriangleMesh result;
  for (const Triangle& t : mesh.triangles) {
    Triangle own{};
    for (std::size_t k = 0; k < 3; ++k) own[k] = addVertex(result, mesh.vertices[at(t[k])]);
    result.triangles.push_back(own);
  }
  return result;
}

TriangleMesh duplicated(const TriangleMesh& mesh, double share, Random& random) {
  TriangleMesh result = mesh;
  for (const Triangle& t : mesh.triangles)
    if (chosen(share, random)) result.triangles.push_back(t);
  return result;
}

TriangleMesh flipped(TriangleMesh mesh, double share, Random& random) {
  for (Triangle& t : mesh.triangles)
    if (chosen(share, random)) std::swap(t[1], t[2]);
  return mesh;
}

/// Adds triangles without area: at random with a repeated corner, or with a corner in the middle of an edge.
TriangleMesh withZeroArea(const TriangleMesh& mesh, double share, Random& random) {
  TriangleMesh result = mesh;
  for (const Triangle& t : mesh.triangles) {
    if (!chosen(share, random)) continue;
    const bool twice = random.below(2) == 0;
    const int third = twice ? t[1] : addVertex(result, (mesh.vertices[at(t[0])] + mesh.vertices[at(t[1])]) / 2);
    result.triangles.push_back({t[0], t[1], third});
  }
  return result;
}

/// Splits triangles at a point in their plane next to the middle of an edge, into one sliver and two others.
TriangleMesh withSlivers(const TriangleMesh& mesh, double height, Random& random) {
  TriangleMesh result{mesh.vertices, {}};
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[at(t[0])], &b = mesh.vertices[at(t[1])], &c = mesh.vertices[at(t[2])];
    if (!chosen(kSliversAmong, random) || a == b) {
      result.triangles.push_back(t);
      continue;
    }
    const Eigen::Vector3d middle = (a + b) / 2, inward = c - middle;
    const double share = inward.norm() > 0 ? height * (b - a).norm() / inward.norm() : 0;
    const int p = addVertex(result, middle + share * inward);
    for (const Triangle& part : {Triangle{t[0], t[1], p}, Triangle{t[1], t[2], p}, Triangle{t[2], t[0], p}})
      result.triangles.push_back(part);
  }
  return result;
}

/// Removes the triangles nearest to a random one, but never all.
TriangleMesh withHole(const TriangleMesh& mesh, double share, Random& random) {
  const std::size_t count = mesh.triangles.size();
  const Eigen::Vector3d place = centre(mesh, random.below(count));
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return (centre(mesh, i) - place).squaredNorm() < (centre(mesh, j) - place).squaredNorm();
  });
  const std::size_t missing = std::min(count - 1, std::max<std::size_t>(1, static_cast<std::size_t>(share * static_cast<double>(count))));
  std::sort(order.begin() + static_cast<std::ptrdiff_t>(missing), order.end());
  TriangleMesh result{mesh.vertices, {}};
  for (std::size_t i = missing; i < count; ++i) result.triangles.push_back(mesh.triangles[order[i]]);
  return result;
}

TriangleMesh withFins(const TriangleMesh& mesh, double height, Random& random) {
  TriangleMesh result = mesh;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Eigen::Vector3d &a = mesh.vertices[at(t[0])], &b = mesh.vertices[at(t[1])], &c = mesh.vertices[at(t[2])];
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const bool here = i == 0 || chosen(kFinsAmong, random);
    if (here && normal.norm() > 0) result.triangles.push_back({t[0], t[1], addVertex(result, (a + b) / 2 + height * normal.normalized())});
  }
  return result;
}

TriangleMesh withCopy(const TriangleMesh& mesh, double size, const Eigen::Vector3d& offset) {
  const Eigen::Vector3d middle = boundingBox(mesh).center();
  TriangleMesh copy = mesh, result = mesh;
  for (Eigen::Vector3d& v : copy.vertices) v = middle + size * (v - middle) + offset;
  append(result, copy);
  return result;
}

TriangleMesh tetrahedron(const Eigen::Vector3d& place, double size, Random& random) {
  const Eigen::Matrix3d turn = random.rotation().toRotationMatrix();
  TriangleMesh result;
  result.vertices = {place, place + size * turn.col(0), place + size * turn.col(1), place + size * turn.col(2)};
  result.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return result;
}

TriangleMesh withSpecks(const TriangleMesh& mesh, int count, Random& random) {
  TriangleMesh result = mesh;
  const double size = kSpeck * diagonal(mesh);
  for (int i = 0; i < count; ++i) append(result, tetrahedron(centre(mesh, random.below(mesh.triangles.size())), size, random));
  return result;
}

/// Simplified to a share of the vertices; unchanged if that would leave no triangle.
TriangleMesh decimated(const TriangleMesh& mesh, double share) {
  const TriangleMesh coarse = simplified(mesh, static_cast<std::size_t>(std::max(1.0, share * static_cast<double>(mesh.vertices.size()))));
  return coarse.triangles.empty() ? mesh : coarse;
}

TriangleMesh largestTriangle(const TriangleMesh& mesh) {
  std::size_t largest = 0;
  for (std::size_t t = 1; t < mesh.triangles.size(); ++t)
    if (area(mesh, t) > area(mesh, largest)) largest = t;
  return {mesh.vertices, {mesh.triangles[largest]}};
}

TriangleMesh withNan(TriangleMesh mesh, Random& random) {
  const Triangle& t = mesh.triangles[random.below(mesh.triangles.size())];
  mesh.vertices[at(t[0])].y() = std::numeric_limits<double>::quiet_NaN();
  return mesh;
}

}  // namespace

TriangleMesh defective(const TriangleMesh& mesh, const Trouble& trouble, Random& random) {
  const double amount = trouble.amount;
  switch (trouble.kind) {
    case TroubleKind::kUnwelded: return unwelded(mesh);
    case TroubleKind::kDuplicate: return duplicated(mesh, amount, random);
    case TroubleKind::kFlipped: return flipped(mesh, amount, random);
    case TroubleKind::kZeroArea: return withZeroArea(mesh, amount, random);
    case TroubleKind::kSliver: return withSlivers(mesh, amount, random);
    case TroubleKind::kDecimation: return decimated(mesh, amount);
    case TroubleKind::kHole: return withHole(mesh, amount, random);
    case TroubleKind::kFin: return withFins(mesh, amount * diagonal(mesh), random);
    case TroubleKind::kSelfCrossing: return withCopy(mesh, 1, amount * diagonal(mesh) * random.direction());
    case TroubleKind::kNested: return withCopy(mesh, amount, Eigen::Vector3d::Zero());
    case TroubleKind::kManyComponents: return withSpecks(mesh, static_cast<int>(amount), random);
    case TroubleKind::kOneTriangle: return largestTriangle(mesh);
    case TroubleKind::kNan: return withNan(mesh, random);
    default: return mesh;
  }
}

}  // namespace collision_hulls
