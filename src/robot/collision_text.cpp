// Writes <collision> elements in the style of the description around them: its line ends, its indentation, and its own <origin> tags
// byte for byte where the transform is the same.
#include "robot/collision_text.h"

#include "geometry/roll_pitch_yaw.h"
#include "robot/number_text.h"
#include "xml/xml_tree.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kLongestIndent = 100;  // [bytes] that new elements take over: each has it six times

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + xmlEscaped(value) + "\"";
}

std::string shapeText(const GeometryElement& shape) {
  switch (shape.kind) {
    case GeometryElement::Kind::kBox: return "<box" + attribute("size", vectorText(shape.size)) + "/>";
    case GeometryElement::Kind::kSphere: return "<sphere" + attribute("radius", numberText(shape.size.x())) + "/>";
    case GeometryElement::Kind::kCylinder:
      return "<cylinder" + attribute("radius", numberText(shape.size.x())) + attribute("length", numberText(shape.size.y())) + "/>";
    case GeometryElement::Kind::kMesh:
    case GeometryElement::Kind::kNone: break;
  }
  const bool scaled = shape.scale != Eigen::Vector3d::Ones();
  return "<mesh" + attribute("filename", shape.uri) + (scaled ? attribute("scale", vectorText(shape.scale)) : "") + "/>";
}

std::string originText(const Eigen::Isometry3d& origin, const std::vector<KnownOrigin>& origins) {
  if (origin.matrix() == Eigen::Matrix4d::Identity()) return "";
  for (const KnownOrigin& known : origins) {
    if (known.transform.matrix() == origin.matrix()) return known.text;
  }
  const std::string rpy = vectorText(rollPitchYaw(origin.linear()));
  return "<origin" + attribute("xyz", vectorText(origin.translation())) + attribute("rpy", rpy) + "/>";
}

bool hasLineEnd(const std::string& space) {
  return space.find('\n') != std::string::npos;
}

std::string indentIn(const std::string& space) {
  return space.substr(space.find_last_of("\r\n") + 1, kLongestIndent);
}

std::string lineEndIn(const std::string& space) {
  return space.find("\r\n") == std::string::npos ? "\n" : "\r\n";
}

std::string usualStep(const std::string& indent) {
  return indent.find('\t') == std::string::npos ? "  " : "\t";
}

}  // namespace

std::string Layout::lineEnd(int level) const {
  if (one_line) return "";
  std::string space = newline + (level < 0 ? link_indent : indent);
  for (int i = 0; i < level; ++i) space += step;
  return space;
}

Layout layoutBeside(const std::string& space, const std::string& link_space) {
  if (!hasLineEnd(space)) return {true, "", "", "", ""};
  const std::string indent = indentIn(space), link_indent = hasLineEnd(link_space) ? indentIn(link_space) : "";
  const bool deeper = indent.size() > link_indent.size() && indent.compare(0, link_indent.size(), link_indent) == 0;
  const bool told = deeper && hasLineEnd(link_space);
  return {false, lineEndIn(space), link_indent, indent, told ? indent.substr(link_indent.size()) : usualStep(indent)};
}

Layout layoutWithin(const std::string& link_space) {
  if (!hasLineEnd(link_space)) return {true, "", "", "", ""};
  const std::string link_indent = indentIn(link_space), step = usualStep(link_indent);
  return {false, lineEndIn(link_space), link_indent, link_indent + step, step};
}

std::string collisionText(const CollisionElement& element, const std::vector<KnownOrigin>& origins, const Layout& layout) {
  const std::string origin = originText(element.geometry.origin, origins);
  std::string text = layout.lineEnd(0) + "<collision" + (element.name.empty() ? "" : attribute("name", element.name)) + ">";
  if (!origin.empty()) text += layout.lineEnd(1) + origin;
  text += layout.lineEnd(1) + "<geometry>";
  text += layout.lineEnd(2) + shapeText(element.geometry);
  text += layout.lineEnd(1) + "</geometry>";
  return text + layout.lineEnd(0) + "</collision>";
}

}  // namespace collision_hulls
