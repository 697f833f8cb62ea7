// The geometry of a link, from one description: read, scaled, and in the link's frame.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "collision_hulls/verify/verify.h"
#include "verify/convex_parts.h"

namespace collision_hulls {

/// A mesh element as read and scaled.
struct MeshBody {
  TriangleMesh mesh;
  ConvexParts parts;  ///< of RESULT's
};

/// The elements of a link that count. Coordinates in metres, in the link's frame.
struct LinkBodies {
  std::vector<GeometryElement> primitives;  ///< boxes, spheres and cylinders
  std::vector<MeshBody> meshes;
  double resolution = 0;  ///< [m] what the reader may have rounded
  std::string fault;      ///< why they cannot be compared; empty: they can
  std::string fault_uri;  ///< of the mesh that is to blame; empty: a primitive is, or nothing

  bool empty() const { return primitives.empty() && meshes.empty(); }
  std::vector<ConvexHull> hulls() const;  ///< the meshes' convex components
  TriangleMesh rest() const;              ///< what else the meshes hold
  std::size_t restParts() const;
};

/// Reads the mesh files of a description, each once. Each element has a copy of its mesh, so all together may have as many triangles as
/// `limits` allows to one file.
class MeshFiles {
 public:
  /// `split`: find convex parts. `close_openings`: [m] as in closeOpenings().
  MeshFiles(const Description& description, const MeshLimits& limits, bool split, const RunControl& control, double close_openings = 0)
      : description_(description), limits_(limits), split_(split), close_openings_(close_openings), control_(control) {}

  /// The bodies of a link: a mesh that cannot be read, or is too large with all others, is a fault. Throws kCancelled.
  LinkBodies bodiesOf(const std::vector<GeometryElement>& elements);

 private:
  struct File {
    MeshBody body;
    double resolution = 0;
  };
  using Key = std::pair<std::string, std::vector<double>>;  // file and scale

  std::shared_ptr<const File> read(const GeometryElement& element);
  void count(std::size_t triangles, const std::string& path);
  void add(LinkBodies& bodies, const GeometryElement& element);

  const Description& description_;
  const MeshLimits limits_;
  const bool split_;
  const double close_openings_;
  const RunControl& control_;
  std::map<Key, std::shared_ptr<const File>> files_;
  std::size_t triangles_ = 0;  // of all elements so far
};

/// What is left of the elements of a link.
struct Remainder {
  LinkBodies bodies;
  double apart = 0;  ///< [m] no point of what was left out is further than this from the other list
};

/// Leaves out the meshes that another list holds equally, at the same place, and the primitives that differ from one of its by `gap` [m]
/// at most. Throws kCancelled.
Remainder without(const LinkBodies& bodies, const LinkBodies& others, double gap, const RunControl& control = {});

}  // namespace collision_hulls
