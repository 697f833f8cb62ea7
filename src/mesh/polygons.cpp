// From a file's polygons to triangles, in two passes: first points and corners as they come, four bytes a number, then the result, whose
// size is known by then. Files may list points after the polygons that use them, and most use a point several times.
#include "mesh/polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/at.h"
#include "base/decimal.h"
#include "collision_hulls/error.h"
#include "mesh/formats/number.h"
#include "mesh/triangulate.h"

namespace collision_hulls {
namespace {

/// Single precision must resolve at least this share of a mesh's diagonal.
constexpr double kCoarsestResolution = 1e-3;

constexpr std::size_t kCallsBetweenChecks = 1 << 16;

/// Cutting ears off a polygon takes time with the square of its corners: a second for these.
constexpr std::size_t kMostCorners = 20'000;

[[noreturn]] void failTooLarge(const std::string& path, std::size_t most) {
  throw Error(ErrorCode::kTooLarge,
              path + ": more triangles than the limit of " + std::to_string(most) + "; simplify the mesh or raise the limit");
}

}  // namespace

double singlePrecisionResolution(const TriangleMesh& mesh, double largest, const std::string& path) {
  if (!(largest > 0)) return 0;
  const double result =
      std::ldexp(1.0, std::max(std::ilogb(largest), std::numeric_limits<float>::min_exponent - 1) - std::numeric_limits<float>::digits);
  const double size = diagonal(mesh);
  if (size > 0 && result > kCoarsestResolution * size)
    throw Error(ErrorCode::kTooFarFromOrigin, (path.empty() ? "" : path + ": ") + "the mesh is " + decimal(size, 4) +
                                                  " m across and up to " + decimal(largest, 4) +
                                                  " m away from its origin, where single precision resolves only " + decimal(result, 4) +
                                                  " m; move the mesh to its origin");
  return result;
}

void failNotFinite(const std::string& path, std::size_t vertex, std::size_t face) {
  throw Error(ErrorCode::kNonFiniteCoordinate,
              path + ": vertex " + std::to_string(vertex) + " (of face " + std::to_string(face) +
                  ", both counted from 0) has a coordinate that is not a finite number of single precision; export it again");
}

void failNoTriangle(const std::string& path, std::size_t skipped) {
  throw Error(ErrorCode::kEmptyMesh, path + ": holds no triangle (" + std::to_string(skipped) +
                                         " lines and points, which have no surface); export it with its faces");
}

PolygonSink::PolygonSink(LoadedMesh* result, const std::string& path, std::size_t max_triangles, const RunControl& control)
    : result_(*result), path_(path), max_triangles_(std::min(max_triangles, kMostTriangles)), control_(control) {}

void PolygonSink::add(const std::vector<int>& polygon) {
  if (added_++ % kCallsBetweenChecks == 0) control_.check();
  std::vector<Triangle>& triangles = result_.mesh.triangles;
  if (polygon.size() < 3) {
    ++result_.skipped_primitives;
    return;
  }
  if (triangles.size() + polygon.size() - 2 > max_triangles_) failTooLarge(path_, max_triangles_);
  if (polygon.size() == 3) {
    triangles.push_back({polygon[0], polygon[1], polygon[2]});
    return;
  }
  if (polygon.size() > kMostCorners)
    throw Error(ErrorCode::kTooLarge, path_ + ": a polygon of " + std::to_string(polygon.size()) + " corners, above the limit of " +
                                          std::to_string(kMostCorners) + "; export it as triangles");
  std::vector<Eigen::Vector3d> corners;
  for (const int v : polygon) corners.push_back(result_.mesh.vertices[at(v)]);
  const std::vector<Triangle> cut = triangulate(corners, control_), other = otherReading(corners, cut);
  if (triangles.size() + cut.size() + 2 * other.size() > max_triangles_) failTooLarge(path_, max_triangles_);
  for (const Triangle& t : cut) triangles.push_back({polygon[at(t[0])], polygon[at(t[1])], polygon[at(t[2])]});
  for (const Triangle& t : other) {  // both ways round, as a wall: it has to be covered, but encloses nothing
    triangles.push_back({polygon[at(t[0])], polygon[at(t[1])], polygon[at(t[2])]});
    triangles.push_back({polygon[at(t[0])], polygon[at(t[2])], polygon[at(t[1])]});
  }
}

void Polygons::addPoint(double x, double y, double z) {
  if (points_.size() == static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw Error(ErrorCode::kTooLarge, path_ + ": more than " + std::to_string(points_.size()) + " vertices; simplify the mesh");
  points_.emplace_back(toSingle(x), toSingle(y), toSingle(z));
}

void Polygons::addCorner(int point) {
  if (corners_.size() % kCallsBetweenChecks == 0) control_.check();
  corners_.push_back(point);
  ++open_;
  const std::size_t most = std::min(max_triangles_, kMostTriangles);
  if (open_ > 2 && ++triangles_ > most) failTooLarge(path_, most);
}

void Polygons::endPolygon() {
  if (open_ < 3) {
    corners_.resize(corners_.size() - at(open_));
    ++skipped_;
  } else {
    sizes_.push_back(open_);
  }
  open_ = 0;
}

void Polygons::beginPart() {
  if (parts_.back() < sizes_.size()) parts_.push_back(sizes_.size());
}

void Polygons::reserve(std::size_t points, std::size_t polygons) {
  points_.reserve(points);
  corners_.reserve(3 * polygons);
  sizes_.reserve(polygons);
}

LoadedMesh Polygons::triangles(Vertices vertices) const {
  if (sizes_.empty()) failNoTriangle(path_, skipped_);
  LoadedMesh result;
  result.skipped_primitives = skipped_;
  result.submeshes = static_cast<int>(parts_.size() - (parts_.back() == sizes_.size() ? 1 : 0));
  result.mesh.vertices.reserve(vertices == Vertices::kShared ? std::min(points_.size(), corners_.size()) : corners_.size());
  result.mesh.triangles.reserve(triangles_);
  PolygonSink sink(&result, path_, max_triangles_, control_);
  std::vector<int> number(vertices == Vertices::kShared ? points_.size() : 0, -1);  // of each point: its vertex, -1 before its first use
  float largest = 0;
  std::size_t corner = 0;
  std::vector<int> polygon;
  for (std::size_t face = 0; face < sizes_.size(); ++face) {
    polygon.clear();
    for (int k = 0; k < sizes_[face]; ++k, ++corner) {
      const std::size_t point = at(corners_[corner]);
      polygon.push_back(number.empty() || number[point] < 0 ? static_cast<int>(result.mesh.vertices.size()) : number[point]);
      if (at(polygon.back()) < result.mesh.vertices.size()) continue;
      if (!points_[point].allFinite()) failNotFinite(path_, point, face);
      if (!number.empty()) number[point] = polygon.back();
      result.mesh.vertices.push_back(points_[point].cast<double>());
      largest = std::max(largest, points_[point].cwiseAbs().maxCoeff());
    }
    sink.add(polygon);
  }
  result.resolution = singlePrecisionResolution(result.mesh, largest, path_);
  return result;
}

}  // namespace collision_hulls
