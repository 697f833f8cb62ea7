// The geometry is that of primitives/primitive.h; here it speaks of elements of a description.
#include "fit/enclosing.h"

#include "collision_hulls/error.h"
#include "collision_hulls/scene/scene.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

PrimitiveKind kindOf(Kind kind) {
  switch (kind) {
    case Kind::kBox: return PrimitiveKind::kBox;
    case Kind::kSphere: return PrimitiveKind::kSphere;
    case Kind::kCylinder: return PrimitiveKind::kCylinder;
    case Kind::kMesh:
    case Kind::kNone: break;
  }
  throw Error(ErrorCode::kInternal, "an element that is not a primitive, where one is needed");
}

Primitive primitiveOf(const GeometryElement& element) {
  return {kindOf(element.kind), element.size, element.origin};
}

}  // namespace

GeometryElement elementOf(const Primitive& primitive) {
  GeometryElement element;
  switch (primitive.kind) {
    case PrimitiveKind::kBox: element.kind = Kind::kBox; break;
    case PrimitiveKind::kSphere: element.kind = Kind::kSphere; break;
    case PrimitiveKind::kCylinder: element.kind = Kind::kCylinder; break;
    case PrimitiveKind::kCapsule: throw Error(ErrorCode::kInternal, "URDF has no capsules");
  }
  element.size = primitive.size;
  element.origin = primitive.pose;
  return element;
}

GeometryElement enclosingPrimitive(Kind kind, const ConvexHull& hull) {
  return elementOf(enclosingPrimitive(kindOf(kind), hull));
}

double volume(const GeometryElement& primitive) {
  return volume(primitiveOf(primitive));
}

Eigen::Vector3d nearestPoint(const GeometryElement& primitive, const Eigen::Vector3d& p) {
  return nearestPoint(primitiveOf(primitive), p);
}

ConvexHull hullAbout(const GeometryElement& primitive) {
  const Eigen::Vector3d& size = primitive.size;
  ConvexHull about;
  switch (kindOf(primitive.kind)) {
    case PrimitiveKind::kBox: about = boxShape(size); break;
    case PrimitiveKind::kSphere: about = sphereShape(size.x()); break;
    default: about = cylinderShape(size.x(), size.y());
  }
  for (Eigen::Vector3d& v : about.vertices) v = primitive.origin * v;
  return convexHull(about.vertices);
}

}  // namespace collision_hulls
