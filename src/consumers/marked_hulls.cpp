// Descriptions that differ from the rewritten one in the <mesh> of each hull alone. The text is changed in place, so that everything else
// stays byte for byte.
#include <set>

#include "consumers/written_model.h"
#include "xml/xml_spans.h"

namespace collision_hulls {
namespace {

/// The URIs of hulls, as the text has them.
std::set<std::string> hullUris(const WrittenModel& model) {
  std::set<std::string> uris;
  for (const LinkDescription& link : model.robot().links)
    for (const GeometryElement& element : link.collisions)
      if (model.hullOf(element)) uris.insert(xmlEscaped(element.uri));
  return uris;
}

}  // namespace

std::string withMarkedHulls(const WrittenModel& model, const std::string& attributes, const std::string& content,
                            const std::string& of_root) {
  const std::string& written = model.result().urdf;
  const std::string end_tag = content.empty() ? "/>" : ">" + content + "</mesh>";
  const std::set<std::string> uris = hullUris(model);
  const std::vector<XmlElement> elements = scanXml(written).elements;
  const XmlElement& root = elements.front();
  std::size_t taken = root.begin + 1 + root.name.size();
  std::string urdf = written.substr(0, taken);
  if (!attributeValue(written, root, of_root.substr(1, of_root.find('=') - 1))) urdf += of_root;
  for (const XmlElement& element : elements) {
    const auto uri = element.name == "mesh" && element.self_closing ? attributeValue(written, element, "filename") : std::nullopt;
    if (!uri || uris.count(written.substr(uri->begin, uri->end - uri->begin)) == 0) continue;
    const std::size_t end = element.tag_end - 2;  // of "/>"
    urdf += written.substr(taken, end - taken) + attributes + end_tag;
    taken = element.tag_end;
  }
  return urdf + written.substr(taken);
}

}  // namespace collision_hulls
