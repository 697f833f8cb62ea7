// Which elements of a link are decomposed.
#include "collision_hulls/robot/robot_description.h"

namespace collision_hulls {

std::optional<Source> sourceNamed(const std::string& name) {
  if (name == "auto") return Source::kAuto;
  if (name == "visual") return Source::kVisual;
  if (name == "collision") return Source::kCollision;
  return std::nullopt;
}

SourceElements sourceElements(const LinkDescription& link, Source source) {
  const bool visual = source == Source::kVisual || (source == Source::kAuto && link.collisions.empty());
  return {visual, visual ? link.visuals : link.collisions};
}

}  // namespace collision_hulls
