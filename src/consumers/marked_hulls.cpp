// Descriptions that differ from the rewritten one in the <mesh> of each hull alone. The text is changed in place, so that everything else
// stays byte for byte.
#include <set>
#include <string_view>
#include <vector>

#include "consumers/written_model.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kLongestUri = 32'768;  // [bytes] with what XML escapes

/// Where the root element's name ends; comments may hold the same text.
std::size_t endOfRootName(const std::string& urdf) {
  constexpr std::string_view kRoot = "<robot";
  std::size_t root = urdf.find(kRoot);
  for (std::size_t comment = urdf.find("<!--"); root != std::string::npos && comment < root; comment = urdf.find("<!--", comment)) {
    comment = urdf.find("-->", comment);
    if (comment == std::string::npos) break;
    if (root < comment) root = urdf.find(kRoot, comment);
  }
  return root == std::string::npos ? 0 : root + kRoot.size();
}

/// Where each hull's <mesh .../> ends, in ascending order: behind the quoted text that is its URI.
std::vector<std::size_t> endsOfHulls(const WrittenModel& model, const std::string& urdf) {
  std::set<std::string> uris;
  for (const LinkDescription& link : model.robot().links)
    for (const GeometryElement& element : link.collisions)
      if (model.hullOf(element)) uris.insert(xmlEscaped(element.uri));
  std::vector<std::size_t> ends;
  for (std::size_t quote = urdf.find('"'); quote != std::string::npos;) {
    const std::size_t next = urdf.find('"', quote + 1);
    if (next == std::string::npos) break;
    if (next - quote <= kLongestUri && uris.count(urdf.substr(quote + 1, next - quote - 1)) > 0) {
      const std::size_t end = urdf.find("/>", next);
      if (end != std::string::npos && end < urdf.find('<', next)) ends.push_back(end);
    }
    quote = next;
  }
  return ends;
}

}  // namespace

std::string withMarkedHulls(const WrittenModel& model, const std::string& attributes, const std::string& content,
                            const std::string& of_root) {
  const std::string& written = model.result().urdf;
  const std::string end_tag = content.empty() ? "/>" : ">" + content + "</mesh>";
  std::string urdf;
  std::size_t taken = 0;
  for (const std::size_t end : endsOfHulls(model, written)) {
    urdf += written.substr(taken, end - taken) + attributes + end_tag;
    taken = end + 2;
  }
  urdf += written.substr(taken);
  if (urdf.find(of_root.substr(1, of_root.find('=') - 1)) == std::string::npos) urdf.insert(endOfRootName(urdf), of_root);
  return urdf;
}

}  // namespace collision_hulls
