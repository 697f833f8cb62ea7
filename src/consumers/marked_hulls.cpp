// Descriptions that differ from the rewritten one in the <mesh> of each hull alone. The text is changed in place, so that everything else
// stays byte for byte.
#include "consumers/written_model.h"

namespace collision_hulls {
namespace {

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

std::string withMarkedHulls(const WrittenModel& model, const std::string& attributes, const std::string& content,
                            const std::string& of_root) {
  std::string urdf = model.result().urdf;
  const std::string end_tag = content.empty() ? "/>" : ">" + content + "</mesh>";
  for (const LinkDescription& link : model.robot().links) {
    for (const GeometryElement& element : link.collisions) {
      if (!model.hullOf(element)) continue;
      const std::size_t at = urdf.find("\"" + xmlEscaped(element.uri) + "\""), end = urdf.find("/>", at);
      if (at != std::string::npos && end != std::string::npos) urdf.replace(end, 2, attributes + end_tag);
    }
  }
  if (urdf.find(of_root.substr(1, of_root.find('=') - 1)) == std::string::npos) urdf.insert(endOfRootName(urdf), of_root);
  return urdf;
}

}  // namespace collision_hulls
