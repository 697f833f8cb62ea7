// Distance queries and inside-outside tests on a bounding-volume hierarchy of triangles.
//
// For example:
//
//     const TriangleBvh tree(mesh);
//     const double away = tree.nearest(p).distance;  // [m]
//     const bool inside = tree.windingNumber(p) > 0.5;
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <vector>

#include "collision_hulls/control.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

/// The point of triangle abc nearest to p (Ericson, Real-Time Collision Detection, 5.1.5). Its
/// distance from p is minimal up to rounding, even for slivers; degenerate triangles are allowed.
Eigen::Vector3d closestPoint(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                             const Eigen::Vector3d& c, const Eigen::Vector3d& p);

/// A bounding-volume tree over the triangles of a mesh, which check() has to let pass. Keeps copies
/// of them. Immutable. Without triangles, everything is infinitely far from it and nothing is
/// inside.
class TriangleBvh {
 public:
  /// What a tree keeps of its triangles, beside the triangles and their boxes.
  enum class Keeps {
    kFarView,  ///< what they look like from afar
    /// nothing, for a third less memory: facesOneWay() is false unless there are no triangles, and
    /// winding numbers are exact and take time in proportion to the triangles
    kNothing
  };

  /// `two_sided`: per triangle, whether either side may face outward (empty: none does). Throws
  /// kCancelled.
  explicit TriangleBvh(const TriangleMesh& mesh, const std::vector<char>& two_sided = {},
                       const RunControl& control = {}, Keeps keeps = Keeps::kFarView);

  /// As it was given to the constructor.
  const std::vector<char>& twoSided() const { return two_sided_; }

  struct Nearest {
    /// [m]; infinite if nothing lies within the limit
    double distance = std::numeric_limits<double>::infinity();
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    int triangle = -1;  ///< index in the mesh
  };
  /// The nearest point of the surface, if it is closer than `limit` [m]. Exact. `hint` (a
  /// triangle's index, or -1) is tried first: passing on a neighbouring query's answer is faster
  /// and gives the same distance, but of several triangles at that distance perhaps another.
  Nearest nearest(const Eigen::Vector3d& p, double limit = std::numeric_limits<double>::infinity(),
                  int hint = -1) const;

  /// The generalized winding number (Jacobson et al. 2013), with distant clusters replaced by
  /// dipoles (Barill et al. 2018): 1 inside a closed outward surface, 0 outside. It errs by at most
  /// kWindingError, apart from rounding: a cluster is replaced only where that provably errs by no
  /// more than its share.
  double windingNumber(const Eigen::Vector3d& p) const;
  static constexpr double kWindingError = 0.01;

  struct RoughWinding {
    double number = 0, error = 0;  ///< the true winding number differs by no more than `error`
  };
  /// The same, much faster, as it may err by as much as `allowed` (> 0).
  RoughWinding roughWindingNumber(const Eigen::Vector3d& p, double allowed) const;

  /// The winding number of a closed surface at aside(p): the signed crossings of a ray along z.
  /// Exact, and much faster than windingNumber(). It is that of p if p is further than blur() from
  /// the surface.
  int signedCrossings(const Eigen::Vector3d& p) const;
  /// A point near p whose ray hardly ever meets an edge, where crossings would be ambiguous.
  Eigen::Vector3d aside(const Eigen::Vector3d& p) const;
  /// [m] The resolution near the surface, 1e-9 of the tree's extent: an upper bound on the distance
  /// of aside(p) from p, and on the rounding of nearest().
  double blur() const;
  double extent() const;  ///< [m] longest side of the box around the triangles

  /// Whether the normals of all triangles within `radius` [m] of p lie in one open half-space and
  /// none of these triangles is two-sided or degenerate. May answer no where the answer is yes (if
  /// there are many triangles), but never the reverse.
  bool facesOneWay(const Eigen::Vector3d& p, double radius) const;

  /// The corners of a triangle of the surface that `patch` meets, or passes so closely that
  /// rounding hides it; null only if it surely meets none.
  const std::array<Eigen::Vector3d, 3>* metBy(const std::array<Eigen::Vector3d, 3>& patch) const;

  /// The triangles whose boxes meet `box`, in ascending order; if they are more than `most`, any
  /// `most` + 1 of them.
  std::vector<int> trianglesNear(const Eigen::AlignedBox3d& box,
                                 std::size_t most = std::numeric_limits<std::size_t>::max()) const;

  /// The corners of a triangle, by its index in the mesh.
  const std::array<Eigen::Vector3d, 3>& corners(int triangle) const {
    return corners_[static_cast<std::size_t>(position_[static_cast<std::size_t>(triangle)])];
  }

  /// The indices of all triangles, in an order in which neighbours in space mostly follow each
  /// other.
  const std::vector<int>& byPlace() const { return index_; }

  bool empty() const { return corners_.empty(); }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    // leaf: triangles [first, first + count); inner node: children first, first + 1, and count 0
    int first = 0, count = 0;
  };
  /// What a node's triangles look like from afar.
  struct Cluster {
    double area = 0;
    // centroid, area vector
    Eigen::Vector3d dipole_centre = Eigen::Vector3d::Zero(), dipole = Eigen::Vector3d::Zero();
    // cone of the normals
    Eigen::Vector3d cone_axis = Eigen::Vector3d::Zero();
    double cone_angle = 0;  // [rad] half opening angle; pi: any direction
    double radius = 0;      // radius of the triangles about dipole_centre
  };
  /// Four boxes, of nodes or of triangles, tested together: in single precision, slightly enlarged.
  struct FourBoxes {
    std::array<Eigen::Array4f, 3> low, high;  // by axis, about `centre_`, in units of `unit_`
    // what each box holds: a FourBoxes, or ~k for the triangle at k in leaf order
    std::array<int, 4> child{};
    int count = 0;
  };
  // levels: a child has at most 3/4 of a node's leaves, which are no more than 2^31 / 4; and some
  // to spare. Stack sizes: one pending node on each level, or three.
  static constexpr int kDeepest = 96, kDeepestFours = 3 * kDeepest;
  struct PatchPlanes;
  struct Cone {
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    double angle = 0;  // [rad] half opening angle
  };
  /// A triangle that is to be put into the tree: its box, about `centre_`, in units of `unit_`.
  struct Item {
    Eigen::Array4f low = Eigen::Array4f::Zero(), high = low;  // the fourth is 0
    int triangle = 0;
    Eigen::Array4f twiceCentre() const { return low + high; }
  };
  struct Split {
    int axis;
    int left;  // that many leaves' triangles lie lower along the axis than the others
  };
  template <class Replace>
  double windingNumber(const Eigen::Vector3d& p, const Replace& replace) const;
  Cone cone(int position) const;
  void build(const TriangleMesh& mesh, std::vector<Item>& items, int node, int first, int count,
             int below, const RunControl& control);
  static Split split(const Item* items, int count);
  void fillLeaf(const TriangleMesh& mesh, const std::vector<Item>& items, Node& leaf);
  void fit(int node);
  void fitCluster(int node);
  int gather(int node, const RunControl& control);
  Eigen::Vector3f inUnits(const Eigen::Vector3d& p) const {
    return ((p - centre_) / unit_).cast<float>();
  }
  void fitCone(int node);

  std::vector<Node> nodes_;       // empty without a far view, once built
  std::vector<FourBoxes> fours_;  // the same nodes, some levels merged into one
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double unit_ = 1;                                      // [m]
  std::vector<Cluster> clusters_;                        // per node; empty without a far view
  std::vector<std::array<Eigen::Vector3d, 3>> corners_;  // in leaf order
  std::vector<int> index_;                               // leaf order to mesh
  std::vector<int> position_;                            // mesh to leaf order
  std::vector<char> two_sided_;                          // per triangle; empty: none
  Eigen::AlignedBox3d box_;                              // of all triangles
};

}  // namespace collision_hulls
