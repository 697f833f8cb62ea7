// Which elements of a link are decomposed.
#include <algorithm>

#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

std::optional<Source> sourceNamed(const std::string& name) {
  if (name == "auto") return Source::kAuto;
  if (name == "visual") return Source::kVisual;
  if (name == "collision") return Source::kCollision;
  return std::nullopt;
}

SourceElements sourceElements(const LinkDescription& link, Source source) {
  const auto has_geometry = [](const GeometryElement& element) { return element.kind != GeometryElement::Kind::kNone; };
  const bool no_collision = std::none_of(link.collisions.begin(), link.collisions.end(), has_geometry);
  const bool visual = source == Source::kVisual || (source == Source::kAuto && no_collision);
  return {visual, visual ? link.visuals : link.collisions};
}

bool isSolidPrimitive(const GeometryElement& element) {
  switch (element.kind) {
    case GeometryElement::Kind::kBox: return element.size.minCoeff() > 0;
    case GeometryElement::Kind::kSphere: return element.size.x() > 0;
    case GeometryElement::Kind::kCylinder: return element.size.head<2>().minCoeff() > 0;
    default: return false;
  }
}

}  // namespace collision_hulls
