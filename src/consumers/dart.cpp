// A SKEL file for DART. Each hull is a <mesh>, of which DART makes triangles. The one convex shape that such a file can name is
// <multi_sphere>, the hull of spheres, of which those with radius 0 are points. But Bullet's detector, the only one that knows it, takes
// its margin of 4 cm off that shape, by which hulls thinner than 8 cm are inside out: bodies do not rest on them.
//
// A SKEL file places bodies in the world at zero positions, joints at the origin of their child. Its angles turn about x, y and z in this
// order, as rows of URDF's do about z, y and x. It has no mimic joints.
#include <algorithm>
#include <map>

#include "consumers/written_model.h"
#include "geometry/roll_pitch_yaw.h"
#include "robot/number_text.h"
#include "storage/names.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;
using JointKind = JointDescription::Kind;

std::string transformation(const Eigen::Isometry3d& pose) {
  return tag("transformation", positionText(pose) + " " + vectorText(-rollPitchYaw(pose.linear().transpose())));
}

class SkelWriter {
 public:
  explicit SkelWriter(const WrittenModel& model) : model_(model) {}

  std::string text() {
    std::map<std::string, Eigen::Isometry3d> places;
    for (const LinkDescription& link : model_.robot().links) places[link.name] = Eigen::Isometry3d::Identity();
    for (const JointDescription& joint : model_.robot().joints) places[joint.child] = places[joint.parent] * joint.origin;
    std::string text = "<?xml version=\"1.0\"?>\n<skel version=\"1.0\">\n  <world" + nameAttribute(model_.robot().name) +
                       ">\n    <physics>\n      <time_step>0.001</time_step>\n      <gravity>0 0 -9.81</gravity>\n    </physics>\n" +
                       "    <skeleton" + nameAttribute(model_.robot().name) + ">\n";
    for (const LinkDescription& link : model_.robot().links)
      if (!isTheWorld(link.name)) text += bodyText(link, places[link.name]);
    for (const std::string& root : model_.roots())
      if (!isTheWorld(root)) text += rootText(root);
    for (const JointDescription& joint : model_.robot().joints) text += jointText(joint);
    return text + "    </skeleton>\n  </world>\n</skel>\n";
  }

 private:
  /// The surroundings have no body, but one of their name may have geometry.
  bool isTheWorld(const std::string& link) const { return nameOf(link) == kWorld; }

  std::string nameOf(const std::string& link) const {
    return model_.nameBesideWorld(link, [](const LinkDescription& named) { return !named.collisions.empty(); });
  }

  std::string bodyText(const LinkDescription& link, const Eigen::Isometry3d& place) const {
    std::string text =
        "      <body" + nameAttribute(nameOf(link.name)) + ">\n        " + transformation(place) + "\n" + inertiaText(link.name);
    for (const GeometryElement& element : link.collisions) text += shapeText(element);
    return text + "      </body>\n";
  }

  std::string inertiaText(const std::string& link) const {
    const Inertial* const given = model_.inertialOf(link);
    if (!given) return "";
    const Eigen::Matrix3d axes = given->principal.linear(), tensor = axes * given->moments.asDiagonal() * axes.transpose();
    const std::pair<const char*, double> entries[] = {{"ixx", tensor(0, 0)}, {"iyy", tensor(1, 1)}, {"izz", tensor(2, 2)},
                                                      {"ixy", tensor(0, 1)}, {"ixz", tensor(0, 2)}, {"iyz", tensor(1, 2)}};
    std::string moments;
    for (const auto& entry : entries) moments += tag(entry.first, numberText(entry.second));
    return "        <inertia>" + tag("mass", numberText(given->mass)) + tag("offset", positionText(given->principal)) +
           "<moment_of_inertia>" + moments + "</moment_of_inertia></inertia>\n";
  }

  std::string shapeText(const GeometryElement& element) const {
    const std::string geometry = element.fault.empty() ? geometryText(element) : "";
    if (geometry.empty()) return "";
    const std::string name = element.name.empty() ? "" : nameAttribute(element.name);
    return "        <collision_shape" + name + ">" + transformation(element.origin) + "<geometry>" + geometry +
           "</geometry></collision_shape>\n";
  }

  std::string geometryText(const GeometryElement& element) const {
    const auto inside = [](const std::string& name, const std::string& content) { return "<" + name + ">" + content + "</" + name + ">"; };
    switch (element.kind) {
      case Kind::kBox: return inside("box", tag("size", vectorText(element.size)));
      case Kind::kSphere: return inside("sphere", tag("radius", numberText(element.size.x())));
      case Kind::kCylinder:
        return inside("cylinder", tag("radius", numberText(element.size.x())) + tag("height", numberText(element.size.y())));
      case Kind::kNone: return "";
      case Kind::kMesh: break;
    }
    const std::string hull = model_.fileOf(element);
    return inside("mesh", tag("file_name", hull.empty() ? element.uri : "../" + hull) + tag("scale", vectorText(element.scale)));
  }

  /// As DART's URDF loader has it.
  std::string rootText(const std::string& link) const {
    return "      <joint type=\"free\" name=\"rootJoint\">" + tag("parent", kWorld) + tag("child", nameOf(link)) + "</joint>\n";
  }

  std::string jointText(const JointDescription& joint) const {
    return "      <joint type=\"" + std::string(typeOf(joint.kind)) + "\"" + nameAttribute(joint.name) + ">" +
           tag("parent", nameOf(joint.parent)) + tag("child", nameOf(joint.child)) + axisText(joint) + "</joint>\n";
  }

  std::string axisText(const JointDescription& joint) const {
    if (!turnsOrSlides(joint)) return "";
    const bool is_limited = joint.kind != JointKind::kContinuous;
    const JointDynamics dynamics = model_.dynamicsOf(joint.name);
    std::string text = "<axis>" + tag("xyz", vectorText(joint.axis));
    if (is_limited) text += "<limit>" + tag("lower", numberText(joint.lower)) + tag("upper", numberText(joint.upper)) + "</limit>";
    return text + "<dynamics>" + tag("damping", numberText(std::max(0.0, dynamics.damping))) +
           tag("friction", numberText(std::max(0.0, dynamics.friction))) + "</dynamics></axis>";
  }

  static const char* typeOf(JointKind kind) {
    switch (kind) {
      case JointKind::kRevolute:
      case JointKind::kContinuous: return "revolute";
      case JointKind::kPrismatic: return "prismatic";
      case JointKind::kFloating: return "free";
      default: return "weld";  // its planar joint has two axes of its own: fixed here, as in the robot at rest
    }
  }

  const WrittenModel& model_;
};

}  // namespace

ConsumerFiles dartFiles(const WrittenModel& model) {
  return {{"skel/" + robotFileName(model.robot().name) + ".skel", SkelWriter(model).text()}};
}

std::vector<std::string> dartNotes(const WrittenModel& model) {
  std::vector<std::string> notes = model.notes(), links;
  for (const LinkDescription& link : model.robot().links)
    if (link.name != kWorld && !model.inertialOf(link.name)) links.push_back(link.name);
  noteWithoutInertial(links, "dart", "DART", notes);
  const std::string planar = jointsThat(model, [](const auto& joint) { return joint.kind == JointKind::kPlanar; });
  if (!planar.empty()) notes.push_back("--for dart: planar joints (" + planar + ") are fixed: in a SKEL file they have other axes");
  noteFollowers(model, "dart", "a SKEL file", notes);
  return notes;
}

}  // namespace collision_hulls
