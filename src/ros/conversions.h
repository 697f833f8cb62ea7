// Core types to messages, the only place where both meet.
#pragma once

#include <collision_hulls/DecomposeFeedback.h>
#include <collision_hulls/LinkReport.h>
#include <collision_hulls/RunTotals.h>
#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstddef>
#include <vector>

#include "collision_hulls/pipeline/decompose_robot.h"

namespace collision_hulls {

LinkReport toMessage(const ElementResult& element);
std::vector<LinkReport> toMessages(const RobotResult& result);
RunTotals toTotals(const Report& report);
DecomposeFeedback toMessage(const Step& step);

/// A line for each mesh that failed, then what was made: "7 hulls for 3 meshes".
std::string summary(const Report& report);

/// The colour of the n-th hull of a robot: hues spread by the golden ratio, so that neighbours in the list differ most and no two
/// are the same. Opaque.
std_msgs::ColorRGBA hullColour(std::size_t index);

/// All that there is to see of a result: per hull a TRIANGLE_LIST in `hulls/<link>`; per mesh its triangles, grey and translucent, in
/// `original/<link>`; in `unneeded/<link>`, grey, the finer hulls that a scene did not need; and where the hulls protrude, in
/// `worst/<link>` a sphere at the place of the largest protrusion found and an arrow from it to the nearest point of the solid. In the
/// links' frames, locked to them; the element's origin is the pose. The first marker deletes those of an earlier message.
visualization_msgs::MarkerArray toMarkers(const RobotResult& result);

}  // namespace collision_hulls
