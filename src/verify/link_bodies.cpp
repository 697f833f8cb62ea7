// A link whose mesh cannot be read has a fault and no numbers: half of its geometry would give wrong ones.
#include "verify/link_bodies.h"

#include <algorithm>
#include <limits>
#include <set>

#include "collision_hulls/error.h"
#include "collision_hulls/mesh/openings.h"
#include "verify/round_shapes.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

ConvexParts moved(const ConvexParts& parts, const Eigen::Isometry3d& pose) {
  ConvexParts result{{}, transformed(parts.rest, pose), parts.rest_parts, parts.beyond};
  for (const ConvexHull& hull : parts.hulls) result.hulls.push_back(transformed(hull, pose));
  return result;
}

bool equalMeshes(const TriangleMesh& a, const TriangleMesh& b) {
  return a.triangles == b.triangles && a.vertices == b.vertices;
}

/// An order of meshes. Those at different places differ in their first vertex, so few are compared as a whole.
struct Before {
  bool operator()(const TriangleMesh* a, const TriangleMesh* b) const {
    if (a->vertices.size() != b->vertices.size()) return a->vertices.size() < b->vertices.size();
    const auto [u, v] = std::mismatch(a->vertices.begin(), a->vertices.end(), b->vertices.begin());
    if (u != a->vertices.end()) return std::lexicographical_compare(u->data(), u->data() + 3, v->data(), v->data() + 3);
    return a->triangles < b->triangles;
  }
};

/// Primitives by a number that changes little between those nearly alike. Of others few are that near: its weights have no common measure.
class KnownPrimitives {
 public:
  explicit KnownPrimitives(const std::vector<GeometryElement>& primitives) {
    for (const GeometryElement& primitive : primitives) by_number_.emplace(number(primitive), &primitive);
  }

  /// [m] apartAtMost() of the primitive and the one most like it; of those that differ by more than `gap` it may miss some.
  double apart(const GeometryElement& primitive, double gap, const RunControl& control) const {
    // The number changes by less than three times apartAtMost(); of equal ones by rounding, in size and place.
    constexpr double kSteepest = 3, kSlack = 1e-8, kRounding = 1e-14;
    const double at = number(primitive), reach = kSteepest * gap + kSlack * primitive.size.maxCoeff() +
                                                 kRounding * primitive.origin.translation().cwiseAbs().maxCoeff();
    double least = std::numeric_limits<double>::infinity();
    for (auto other = by_number_.lower_bound(at - reach); other != by_number_.end() && other->first <= at + reach && least > 0; ++other) {
      control.check();
      least = std::min(least, apartAtMost(*other->second, primitive));
    }
    return least;
  }

 private:
  static double number(const GeometryElement& primitive) {
    return primitive.size.dot(Eigen::Vector3d(0.9129, 0.7071, 0.3717)) +
           primitive.origin.translation().dot(Eigen::Vector3d(0.8312, 0.5477, 0.2887));
  }

  std::multimap<double, const GeometryElement*> by_number_;
};

}  // namespace

std::shared_ptr<const MeshFiles::File> MeshFiles::read(const GeometryElement& element) {
  const std::string path = resolveUri(element.uri, description_.robot.path, description_.find_package);
  const Key key{path, {element.scale.x(), element.scale.y(), element.scale.z()}};
  const auto known = files_.find(key);
  if (known != files_.end()) {
    count(known->second->body.mesh.triangles.size(), path);
    return known->second;
  }
  const LoadedMesh loaded = readMesh(path, limits_, control_);
  count(loaded.mesh.triangles.size(), path);
  const auto file = std::make_shared<File>();
  file->body.mesh = closeOpenings(scaled(loaded.mesh, element.scale), close_openings_, control_);
  file->resolution = readingError(loaded.resolution) * element.scale.cwiseAbs().maxCoeff();
  if (split_) file->body.parts = convexParts(file->body.mesh, control_);
  return files_[key] = file;
}

/// What is refused does not count: a smaller mesh may still fit.
void MeshFiles::count(std::size_t triangles, const std::string& path) {
  if (triangles > limits_.max_triangles - triangles_)
    throw Error(ErrorCode::kTooLarge, "'" + path + "' has " + std::to_string(triangles) + " triangles, and the elements before it " +
                                          std::to_string(triangles_) + ", above the limit of " + std::to_string(limits_.max_triangles) +
                                          " for all elements of a description, a mesh that is used twice counted twice; simplify it, or "
                                          "compare fewer links at once (--links)");
  triangles_ += triangles;
}

void MeshFiles::add(LinkBodies& bodies, const GeometryElement& element) {
  if (!element.fault.empty()) throw Error(ErrorCode::kBadGeometry, element.fault);
  if (element.kind == Kind::kNone) return;
  if (element.kind != Kind::kMesh) return bodies.primitives.push_back(element);
  const std::shared_ptr<const File> file = read(element);
  bodies.meshes.push_back({transformed(file->body.mesh, element.origin), moved(file->body.parts, element.origin)});
  bodies.resolution = std::max(bodies.resolution, file->resolution);
}

LinkBodies MeshFiles::bodiesOf(const std::vector<GeometryElement>& elements) {
  LinkBodies bodies;
  for (const GeometryElement& element : elements) {
    control_.check();
    try {
      add(bodies, element);
    } catch (const Error& e) {
      if (e.code() == ErrorCode::kCancelled) throw;
      bodies.fault = e.what();
      bodies.fault_uri = element.uri;
      return bodies;
    }
  }
  return bodies;
}

std::vector<ConvexHull> LinkBodies::hulls() const {
  std::vector<ConvexHull> all;
  for (const MeshBody& body : meshes) all.insert(all.end(), body.parts.hulls.begin(), body.parts.hulls.end());
  return all;
}

TriangleMesh LinkBodies::rest() const {
  TriangleMesh all;
  for (const MeshBody& body : meshes) append(all, body.parts.rest);
  return all;
}

std::size_t LinkBodies::restParts() const {
  std::size_t sum = 0;
  for (const MeshBody& body : meshes) sum += body.parts.rest_parts;
  return sum;
}

Remainder without(const LinkBodies& bodies, const LinkBodies& others, double gap, const RunControl& control) {
  Remainder result;
  result.bodies.resolution = bodies.resolution;
  const KnownPrimitives known_ones(others.primitives);
  for (const GeometryElement& primitive : bodies.primitives) {
    control.check();
    const double apart = known_ones.apart(primitive, gap, control);
    if (apart <= gap)
      result.apart = std::max(result.apart, apart);
    else
      result.bodies.primitives.push_back(primitive);
  }
  std::set<const TriangleMesh*, Before> meshes;
  for (const MeshBody& other : others.meshes) control.check(), meshes.insert(&other.mesh);
  for (const MeshBody& body : bodies.meshes) {
    control.check();
    const auto known = meshes.find(&body.mesh);
    // What overflowed has no order, so the order alone proves nothing.
    if (known == meshes.end() || !equalMeshes(**known, body.mesh)) result.bodies.meshes.push_back(body);
  }
  return result;
}

}  // namespace collision_hulls
