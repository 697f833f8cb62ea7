// <collision> elements replaced in the text of a description, everything else byte for byte.
//
// The text is never parsed and printed again: the spans of the <collision> elements are cut out, each with the white space
// before it, and the new elements are inserted with white space like their neighbours'. In elements that stay, the file name of a
// mesh that moved is exchanged in place.
#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "base/in_context.h"
#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"
#include "robot/collision_text.h"
#include "xml/xml_spans.h"
#include "xml/xml_tree.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kLongestOrigin = 300;  // [bytes] of an <origin> that new elements repeat: there may be many

bool replaced(const GeometryElement& collision, const LinkCollisions& by) {
  return !by.keep_primitives || collision.kind == GeometryElement::Kind::kMesh;
}

// Gives every new element a name that nothing else in the description has.
class Names {
 public:
  Names(const RobotDescription& robot, const std::map<std::string, LinkCollisions>& links) {
    for (const LinkDescription& link : robot.links) {
      const auto by = links.find(link.name);
      for (const GeometryElement& visual : link.visuals) taken_.insert(visual.name);
      for (const GeometryElement& collision : link.collisions) {
        if (by == links.end() || !replaced(collision, by->second)) taken_.insert(collision.name);
      }
    }
  }

  std::string unique(const std::string& wanted) {
    if (wanted.empty()) return wanted;
    std::string name = wanted;
    while (!taken_.insert(name).second) name = wanted + "_" + std::to_string(++used_[wanted] + 1);
    return name;
  }

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> used_;  // numbers tried per wanted name
};

// A place in the text and what comes there instead.
struct Edit {
  std::size_t begin = 0, end = 0;
  std::string text;
};

// One link: its spans, its meaning, and what its collision model becomes.
struct LinkText {
  const std::string& text;
  const std::vector<XmlElement>& elements;
  std::size_t index;  // of its <link> among the elements
  const LinkDescription& link;
  const LinkCollisions& by;

  const XmlElement& span() const { return elements[index]; }
  std::vector<std::size_t> children(const char* name) const { return childrenNamed(elements, index, name); }
  std::string spaceBefore(std::size_t offset) const {
    const std::size_t last = text.find_last_not_of(kXmlSpace, offset - 1);
    return text.substr(last + 1, offset - last - 1);
  }
};

// The spans that go, in order.
std::vector<XmlElement> removedSpans(const LinkText& at) {
  std::vector<XmlElement> removed;
  const std::vector<std::size_t> children = at.children("collision");
  for (std::size_t i = 0; i < children.size(); ++i) {
    if (replaced(at.link.collisions.at(i), at.by)) removed.push_back(at.elements[children[i]]);
  }
  return removed;
}

// The element whose indentation the new ones take: the first replaced, else the last <visual>, else the first child.
std::optional<XmlElement> neighbour(const LinkText& at, const std::vector<XmlElement>& removed) {
  if (!removed.empty()) return removed.front();
  const std::vector<std::size_t> visuals = at.children("visual");
  if (!visuals.empty()) return at.elements[visuals.back()];
  if (at.span().subtree_end > at.index + 1) return at.elements[at.index + 1];
  return std::nullopt;
}

Layout layoutOf(const LinkText& at, const std::vector<XmlElement>& removed) {
  const std::string space = at.spaceBefore(at.span().begin);
  const auto beside = neighbour(at, removed);
  return beside ? layoutBeside(at.spaceBefore(beside->begin), space) : layoutWithin(space);
}

// The bytes of each source <origin> that can be used again as they are, by the transform that they mean.
std::vector<KnownOrigin> knownOrigins(const LinkText& at) {
  std::vector<KnownOrigin> known;
  const auto add = [&](const char* name, const std::vector<GeometryElement>& meaning) {
    const std::vector<std::size_t> children = at.children(name);
    for (std::size_t i = 0; i < children.size(); ++i) {
      if (!meaning.at(i).fault.empty() || meaning.at(i).kind == GeometryElement::Kind::kNone) continue;
      const std::vector<std::size_t> origins = childrenNamed(at.elements, children[i], "origin");
      if (origins.empty() || !at.elements[origins.front()].self_closing) continue;
      const XmlElement& origin = at.elements[origins.front()];
      if (origin.end - origin.begin > kLongestOrigin) continue;
      known.push_back({meaning.at(i).origin, at.text.substr(origin.begin, origin.end - origin.begin)});
    }
  };
  add("visual", at.link.visuals);
  add("collision", at.link.collisions);
  return known;
}

// Nobody could read back a shape of no size.
void expectSize(const GeometryElement& shape) {
  const bool is_mesh = shape.kind == GeometryElement::Kind::kMesh;
  if (is_mesh ? (shape.scale.array() != 0).all() : isSolidPrimitive(shape)) return;
  throw Error(ErrorCode::kBadOption, is_mesh ? "a scale is 0; all three must be other numbers" : "a size is not above 0; all must be");
}

std::string newElements(const LinkText& at, const Layout& layout, Names& names) {
  const std::vector<KnownOrigin> origins = knownOrigins(at);
  std::string text;
  for (const CollisionElement& element : at.by.elements) {
    inContext("a new <collision> of link '" + at.link.name + "'", [&] {
      expectSize(element.geometry);
      text += collisionText({names.unique(element.name), element.geometry}, origins, layout);
    });
  }
  return text;
}

Edit openedLink(const LinkText& at, const std::string& added, const Layout& layout) {
  const std::size_t slash = at.span().tag_end - 2;
  const std::size_t begin = slash - at.spaceBefore(slash).size();
  return {begin, at.span().end, ">" + added + layout.lineEnd(-1) + "</link>"};
}

std::size_t insertionPoint(const LinkText& at) {
  const std::vector<std::size_t> visuals = at.children("visual");
  return visuals.empty() ? at.span().tag_end : at.elements[visuals.back()].end;
}

// In the order of the text; the first one brings the new elements.
std::vector<Edit> editsOf(const LinkText& at, Names& names) {
  const std::vector<XmlElement> removed = removedSpans(at);
  const Layout layout = layoutOf(at, removed);
  const std::string added = newElements(at, layout, names);
  if (removed.empty() && added.empty()) return {};
  if (removed.empty() && at.span().self_closing) return {openedLink(at, added, layout)};
  if (removed.empty()) return {{insertionPoint(at), insertionPoint(at), added}};
  std::vector<Edit> edits;
  for (const XmlElement& element : removed) edits.push_back({element.begin - at.spaceBefore(element.begin).size(), element.end, ""});
  edits.front().text = added;
  return edits;
}

// The new file name of a mesh that moved; null for all else, which stays as it is.
const std::string* movedTo(const GeometryElement& element, const std::map<std::string, std::string>& moved) {
  if (element.kind != GeometryElement::Kind::kMesh || !element.fault.empty()) return nullptr;
  const auto found = moved.find(element.uri);
  return found == moved.end() ? nullptr : &found->second;
}

// The new file names of meshes that moved, in a link whose elements stay.
std::vector<Edit> movedMeshes(const std::string& text, const std::vector<XmlElement>& elements, std::size_t span,
                              const LinkDescription& link, const std::map<std::string, std::string>& moved) {
  std::vector<Edit> edits;
  const std::vector<std::size_t> collisions = childrenNamed(elements, span, "collision");
  for (std::size_t i = 0; i < collisions.size(); ++i) {
    const std::string* const uri = movedTo(link.collisions.at(i), moved);
    if (!uri) continue;
    const std::size_t geometry = childrenNamed(elements, collisions[i], "geometry").at(0);
    const std::size_t mesh = childrenNamed(elements, geometry, "mesh").at(0);
    if (const auto value = attributeValue(text, elements[mesh], "filename")) edits.push_back({value->begin, value->end, xmlEscaped(*uri)});
  }
  return edits;
}

std::string applied(const std::string& text, const std::vector<Edit>& edits) {
  std::string result;
  std::size_t done = 0;
  for (const Edit& edit : edits) {
    result.append(text, done, edit.begin - done);
    result += edit.text;
    done = edit.end;
  }
  return result.append(text, done, std::string::npos);
}

[[noreturn]] void failInternal(const std::string& reason) {
  throw Error(ErrorCode::kInternal, "rewriting <collision> elements: " + reason);
}

// Reads back what was written: the same links, each with the expected elements, and with its visuals as they were.
void checkWritten(const RobotDescription& before, const std::map<std::string, LinkCollisions>& links,
                  const std::map<std::string, std::string>& moved, const RobotDescription& after) {
  for (std::size_t i = 0; i < before.links.size(); ++i) {
    const LinkDescription& old_link = before.links[i];
    const auto by = links.find(old_link.name);
    std::vector<std::string> expected, found;
    for (const GeometryElement& visual : old_link.visuals) expected.push_back(visual.uri);
    for (const GeometryElement& collision : old_link.collisions) {
      const std::string* const now = by == links.end() ? movedTo(collision, moved) : nullptr;
      if (by == links.end() || !replaced(collision, by->second)) expected.push_back(now ? *now : collision.uri);
    }
    if (by != links.end()) {
      for (const CollisionElement& element : by->second.elements) expected.push_back(element.geometry.uri);
    }
    for (const auto* elements : {&after.links.at(i).visuals, &after.links[i].collisions})
      for (const GeometryElement& element : *elements) found.push_back(element.uri);
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    if (found != expected) failInternal("link '" + old_link.name + "' reads back with other elements than were written");
  }
}

void checkLinksExist(const RobotDescription& robot, const std::map<std::string, LinkCollisions>& links) {
  std::unordered_set<std::string> known;
  for (const LinkDescription& link : robot.links) known.insert(link.name);
  for (const auto& [name, by] : links) {
    if (!known.count(name))
      throw Error(ErrorCode::kBadOption, "the robot '" + robot.name + "' has no link '" + name + "'; name one of its links");
  }
}

}  // namespace

std::string rewriteCollisions(const RobotDescription& robot, const std::map<std::string, LinkCollisions>& links,
                              const std::map<std::string, std::string>& moved, const RunControl& control) {
  checkLinksExist(robot, links);
  const std::vector<XmlElement> elements = scanXml(robot.text).elements;
  const std::vector<std::size_t> spans = childrenNamed(elements, 0, "link");
  if (spans.size() != robot.links.size()) failInternal("text and links do not belong together");
  Names names(robot, links);
  std::vector<Edit> edits;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const auto by = links.find(robot.links[i].name);
    const std::vector<Edit> of_link = by == links.end() ? movedMeshes(robot.text, elements, spans[i], robot.links[i], moved)
                                                        : editsOf({robot.text, elements, spans[i], robot.links[i], by->second}, names);
    edits.insert(edits.end(), of_link.begin(), of_link.end());
  }
  const std::string written = applied(robot.text, edits);
  checkWritten(robot, links, moved, parseRobotDescription(written, robot.path, control));
  return written;
}

}  // namespace collision_hulls
