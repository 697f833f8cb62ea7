// Shifts by the box's centre and scales by a power of two.
#include "check/unit_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace collision_hulls {

namespace {

// Rounding error of our own distances: as a share of the element's size, and of its coordinates' size.
constexpr double kRounding = 1e-9, kCoordinateRounding = 8 * std::numeric_limits<double>::epsilon();

}  // namespace

UnitFrame::UnitFrame(const ValidationPair& pair) {
  Eigen::AlignedBox3d box = boundingBox(pair.original);
  for (const ConvexHull& hull : pair.hulls) box.extend(boundingBox(hull));
  centre_ = box.center();
  int exponent = 0;
  const double size = box.sizes().maxCoeff();
  if (std::isnormal(size)) std::frexp(size, &exponent);
  scale_ = std::ldexp(1.0, -exponent);
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  rounding_ = kRounding + kCoordinateRounding * largest * scale_;
}

TriangleMesh UnitFrame::units(TriangleMesh mesh) const {
  for (Eigen::Vector3d& v : mesh.vertices) {
    if (v.allFinite())
      v = (v - centre_) * scale_;
    else
      v.setZero();  // no triangle uses it
  }
  return mesh;
}

ConvexHull UnitFrame::units(ConvexHull hull) const {
  for (Eigen::Vector3d& v : hull.vertices) v = (v - centre_) * scale_;
  for (HalfSpace& face : hull.faces) face.offset = (face.offset - face.normal.dot(centre_)) * scale_;
  return hull;
}

std::vector<ConvexHull> UnitFrame::units(std::vector<ConvexHull> hulls) const {
  for (ConvexHull& hull : hulls) hull = units(std::move(hull));
  return hulls;
}

std::vector<Sphere> UnitFrame::units(std::vector<Sphere> spheres) const {
  for (Sphere& sphere : spheres) sphere = {units(sphere.centre), units(sphere.radius)};
  return spheres;
}

}  // namespace collision_hulls
