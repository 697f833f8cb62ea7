// Distance, and inside or outside, over a bounding-volume tree of triangles.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// The point of triangle abc nearest to p (Ericson, Real-Time Collision Detection, 5.1.5). Its distance from p is the least up to
/// rounding, of slivers too; degenerate triangles are allowed.
Eigen::Vector3d closestPoint(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& p);

/// A bounding-volume tree over a mesh's triangles. Keeps copies of them; immutable and thread safe.
class TriangleBvh {
 public:
  /// `two_sided`: per triangle, whether both of its sides may face outward (empty: none).
  explicit TriangleBvh(const TriangleMesh& mesh, const std::vector<char>& two_sided = {});

  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();  ///< [m]; infinite where nothing lies within the limit
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    int triangle = -1;  ///< index in the mesh
  };
  /// The nearest point of the surface that is closer than `limit` [m]. Exact. `hint`, a triangle's index or -1, is tried
  /// first: neighbouring queries that pass on each other's answer are faster, with the same result.
  Nearest nearest(const Eigen::Vector3d& p, double limit = std::numeric_limits<double>::infinity(), int hint = -1) const;

  /// The generalized winding number (Jacobson et al. 2013), far clusters replaced by dipoles (Barill et al. 2018): 1 inside a
  /// closed outward surface, 0 outside, with an error of about 0.01.
  double windingNumber(const Eigen::Vector3d& p) const;

  /// The winding number of closed surfaces, exactly: signed crossings of a ray from p along z. Much faster. Within 1e-9 of the
  /// tree's extent of the surface the answer may be that of the other side.
  int signedCrossings(const Eigen::Vector3d& p) const;

  /// Whether the normals of all triangles within `radius` [m] of p lie in one open half-space, no two-sided or degenerate one
  /// among them. May say no where it is so (many triangles); never yes where it is not.
  bool facesOneWay(const Eigen::Vector3d& p, double radius) const;

  /// A bound of the distance to the solid that the triangles enclose, over the convex hull of `corners` [m]; `radius` about p must
  /// hold, for each of its points outside, the nearest point of the surface. Infinite where the triangles there do not face one
  /// way. For x outside with nearest point y, x - y lies in the cone of the normals n_i at y, all of which have a cosine of c at
  /// least with some direction; hence |x - y| <= max_i n_i . (x - y) / c, and each of those is linear in x.
  /// `foremost`, if given, gets the triangle i that the largest of them is of.
  double frontBound(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& p, double radius, int* foremost = nullptr) const;

  /// The triangles whose boxes meet a box, ascending.
  std::vector<int> trianglesNear(const Eigen::AlignedBox3d& box) const;

  /// The corners of a triangle, by its index in the mesh.
  const std::array<Eigen::Vector3d, 3>& corners(int triangle) const {
    return corners_[static_cast<std::size_t>(position_[static_cast<std::size_t>(triangle)])];
  }

  bool empty() const { return corners_.empty(); }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int first = 0, count = 0;  // leaf: triangles [first, first + count); inner: children first, first + 1 and count 0
  };
  /// What a node's triangles are like from afar.
  struct Cluster {
    double area = 0;
    Eigen::Vector3d dipole_centre = Eigen::Vector3d::Zero(), dipole = Eigen::Vector3d::Zero();  // centroid, area vector
    Eigen::Vector3d cone_axis = Eigen::Vector3d::Zero();                                        // cone of the normals
    double cone_angle = 0;                                                                      // [rad] half opening; pi: any direction
    double radius = 0;                                                                          // of the triangles about dipole_centre
  };
  /// Four boxes at once, in single precision and a little larger than they are: of nodes, or of triangles.
  struct FourBoxes {
    std::array<Eigen::Array4f, 3> low, high;  // by axis, about `centre_`, in units of `unit_`
    std::array<int, 4> child{};               // its four boxes; ~k: the triangle at k in leaf order
    int count = 0;
  };
  static constexpr int kDeepest = 96;           // nodes put off: one on each of log2(2^31 / 4) levels, and many to spare
  static constexpr int kDeepestFours = 3 * 24;  // three are put off on each of log4(2^31 / 4) levels, and some to spare
  struct Cone {
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    double angle = 0;  // [rad] half opening
  };
  struct Centre {
    Eigen::Vector3d at;
    int triangle;
  };
  Cone cone(int position) const;
  void build(const TriangleMesh& mesh, std::vector<Centre>& centres, int node, int first, int count, int below);
  void fillLeaf(const TriangleMesh& mesh, const std::vector<Centre>& centres, Node& leaf);
  void fit(int node);
  int gather(int node);
  Eigen::Vector3f inUnits(const Eigen::Vector3d& p) const { return ((p - centre_) / unit_).cast<float>(); }
  void fitCone(int node);
  template <class Visit, class Skip>
  bool forEachNear(const Eigen::Vector3d& p, double radius, double narrow, Visit visit, Skip skip) const;

  std::vector<Node> nodes_;
  std::vector<FourBoxes> fours_;  // the nodes again, two levels in one
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double unit_ = 1;                                      // [m]
  std::vector<Cluster> clusters_;                        // of the nodes
  std::vector<std::array<Eigen::Vector3d, 3>> corners_;  // in leaf order
  std::vector<int> index_;                               // leaf order to mesh
  std::vector<int> position_;                            // mesh to leaf order
  std::vector<char> two_sided_;                          // by triangle; empty: none
};

}  // namespace collision_hulls
