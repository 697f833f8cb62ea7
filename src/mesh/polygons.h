// Polygons on their way from a file to triangles.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {

/// Keeps three corners per triangle within the range of int.
constexpr std::size_t kMostTriangles = std::numeric_limits<int>::max() / 3;

/// What the largest single-precision number of a mesh leaves unknown: LoadedMesh::resolution. `largest` [m] is the largest number that
/// single precision rounded. `path`: of the mesh, for the message; may be empty. Throws kTooFarFromOrigin.
double singlePrecisionResolution(const TriangleMesh& mesh, double largest, const std::string& path);

/// Throws kNonFiniteCoordinate.
[[noreturn]] void failNotFinite(const std::string& path, std::size_t vertex, std::size_t face);

/// Throws kEmptyMesh.
[[noreturn]] void failNoTriangle(const std::string& path, std::size_t skipped);

/// Adds polygons to a mesh as triangles.
class PolygonSink {
 public:
  /// `path` and `control` must outlive the sink.
  PolygonSink(LoadedMesh* result, const std::string& path, std::size_t max_triangles, const RunControl& control);

  /// Adds the triangles of a polygon, given by indices of the result's vertices; with fewer than three corners it counts as skipped. What
  /// other programs take it for is added as well, if that is another surface: as walls, triangles in both directions.
  /// Throws kTooLarge, kCancelled.
  void add(const std::vector<int>& polygon);

 private:
  LoadedMesh& result_;
  const std::string& path_;
  std::size_t max_triangles_;
  const RunControl& control_;
  std::size_t added_ = 0;
};

/// A file's polygons as it lists them. Points may come after the polygons that use them.
class Polygons {
 public:
  /// Whether polygons share the result's vertices, or each has its own.
  enum class Vertices { kShared, kSeparate };

  /// `path` and `control` must outlive this.
  Polygons(const std::string& path, std::size_t max_triangles, const RunControl& control)
      : path_(path), max_triangles_(max_triangles), control_(control) {}

  /// Adds a point, rounded to single precision; it may lie at infinity or be no number as long as no polygon uses it. Throws kTooLarge.
  void addPoint(double x, double y, double z);
  /// Adds a corner to the current polygon: an index of a point, which must exist by the time of triangles(). Throws kTooLarge, kCancelled.
  void addCorner(int point);
  void endPolygon();
  void beginPart();                                              ///< the following polygons are another sub-mesh
  void skip(std::size_t primitives) { skipped_ += primitives; }  ///< lines and points

  std::size_t points() const { return points_.size(); }
  void reserve(std::size_t points, std::size_t polygons);

  /// The triangles, in order; vertices in the order of their first use. Throws kNonFiniteCoordinate, kEmptyMesh, kTooFarFromOrigin,
  /// kCancelled.
  LoadedMesh triangles(Vertices vertices) const;

 private:
  const std::string& path_;
  std::size_t max_triangles_;
  const RunControl& control_;
  std::vector<Eigen::Vector3f> points_;
  std::vector<int> corners_;           // of all polygons, one after another
  std::vector<int> sizes_;             // corners of each polygon
  std::vector<std::size_t> parts_{0};  // the first polygon of each
  int open_ = 0;                       // corners of the current polygon
  std::size_t triangles_ = 0;
  std::size_t skipped_ = 0;
};

}  // namespace collision_hulls
