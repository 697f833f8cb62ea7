// Drake's URDF parser makes a geometry::Convex of a <mesh> with <drake:declare_convex/> (multibody/parsing/detail_urdf_geometry.cc). The
// description is otherwise the same, byte for byte.
#include "consumers/written_model.h"
#include "storage/names.h"
#include "xml/xml_tree.h"

namespace collision_hulls {
namespace {

constexpr const char* kNamespace = " xmlns:drake=\"http://drake.mit.edu\"";

/// Where the root element's name ends; comments may hold the same text.
std::size_t endOfRootName(const std::string& urdf) {
  for (std::size_t at = 0;;) {
    const std::size_t root = urdf.find("<robot", at), comment = urdf.find("<!--", at);
    if (root == std::string::npos || comment == std::string::npos || root < comment) return root == std::string::npos ? 0 : root + 6;
    at = urdf.find("-->", comment);
    if (at == std::string::npos) return root + 6;
  }
}

}  // namespace

ConsumerFiles drakeFiles(const WrittenModel& model) {
  std::string urdf = model.result().urdf;
  for (const LinkDescription& link : model.robot().links) {
    for (const GeometryElement& element : link.collisions) {
      if (!model.hullOf(element)) continue;
      const std::size_t at = urdf.find("\"" + xmlEscaped(element.uri) + "\""), end = urdf.find("/>", at);
      if (at != std::string::npos && end != std::string::npos) urdf.replace(end, 2, "><drake:declare_convex/></mesh>");
    }
  }
  if (urdf.find("xmlns:drake") == std::string::npos) urdf.insert(endOfRootName(urdf), kNamespace);
  return {{"urdf/" + fileName(model.robot().name) + "_drake.urdf", urdf}};
}

}  // namespace collision_hulls
