// MuJoCo collides a mesh as its convex hull, and welds nothing of a body's geoms together: one <mesh> and one <geom> a hull keep the shape.
// Bodies nest as the links do, each with the frame of its joint. Links without mass get next to none from their geoms, as MuJoCo wants
// every moving body to have some. Pairs that need no check are excluded: MuJoCo itself leaves out a body and its parent, but not where the
// parent stands still. What floats is a body of the world, as MuJoCo lets no other be free. Visual meshes are left out: MuJoCo reads
// neither Collada nor package:// URIs. So are collision meshes that were kept, with a note: their
// convex hulls may protrude by any length.
#include <algorithm>

#include "collision_hulls/robot/kinematics.h"
#include "consumers/written_model.h"
#include "robot/number_text.h"
#include "storage/names.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

constexpr int kMostIndented = 20;  // levels: with more, the text would grow with the square of the depth

constexpr double kDensity = 1;  // [kg/m^3] of links without mass

std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + xmlEscaped(value) + "\"";
}

std::string poseText(const Eigen::Isometry3d& pose) {
  if (pose.matrix() == Eigen::Matrix4d::Identity()) return "";
  return attribute("pos", positionText(pose)) + attribute("quat", quaternionText(pose));
}

/// MuJoCo refuses a range of nothing: such a joint is fixed.
bool isLocked(const JointDescription& joint) {
  return turnsOrSlides(joint) && joint.kind != JointDescription::Kind::kContinuous && !(joint.lower < joint.upper);
}

bool moves(const JointDescription& joint) {
  return turnsOrSlides(joint) && !isLocked(joint);
}

class MjcfWriter {
 public:
  MjcfWriter(const WrittenModel& model, const std::vector<DisabledPair>& pairs, const RunControl& control)
      : model_(model), pairs_(pairs), control_(control) {
    const Kinematics kinematics(model.robot());
    const std::vector<Eigen::Isometry3d> places = kinematics.poses(kinematics.rest());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const LinkDescription& link = model.robot().links[i];
      links_[link.name] = &link;
      places_[link.name] = places[i];
    }
  }

  std::string text() {
    for (const std::string& root : model_.roots()) addBody(root, nullptr, 2);
    for (std::size_t i = 0; i < floating_.size(); ++i) addBody(floating_[i]->child, floating_[i], 2);  // and maybe adds others
    return "<mujoco" + attribute("model", model_.robot().name) + ">\n" +
           "  <compiler angle=\"radian\" meshdir=\"..\" boundmass=\"1e-6\" boundinertia=\"1e-9\"/>\n" + "  <asset>\n" + assets_ +
           "  </asset>\n  <worldbody>\n" + bodies_ + "  </worldbody>\n" + exclusions() + equalities() + "</mujoco>\n";
  }

 private:
  void addBody(const std::string& link, const JointDescription* joint, int depth) {
    control_.check();
    const std::string indent(static_cast<std::size_t>(2 * std::min(depth, kMostIndented)), ' ');
    if (!joint && link == kWorld) return addContents(link, indent, depth - 1);
    bodies_ += indent + "<body" + attribute("name", link) + (joint ? poseText(placeAt(*joint)) : "") + ">\n";
    bodies_ += inertialText(link, indent + "  ");
    if (joint) bodies_ += jointText(*joint, indent + "  ");
    addContents(link, indent + "  ", depth);
    bodies_ += indent + "</body>\n";
  }

  /// Of the body below a joint, in the one above it.
  Eigen::Isometry3d placeAt(const JointDescription& joint) const {
    if (joint.kind == JointDescription::Kind::kFloating) return places_.at(joint.child);
    return isLocked(joint) ? places_.at(joint.parent).inverse() * places_.at(joint.child) : joint.origin;
  }

  /// The geoms of a link, and the bodies below it.
  void addContents(const std::string& link, const std::string& indent, int depth) {
    bodies_ += geoms(*links_.at(link), indent);
    for (const JointDescription* below : model_.jointsBelow(link))
      if (below->kind == JointDescription::Kind::kFloating)
        floating_.push_back(below);
      else
        addBody(below->child, below, depth + 1);
  }

  std::string inertialText(const std::string& link, const std::string& indent) const {
    const Inertial* const given = model_.inertialOf(link);
    if (!given) return "";
    return indent + "<inertial" + attribute("pos", positionText(given->principal)) + attribute("quat", quaternionText(given->principal)) +
           attribute("mass", numberText(given->mass)) + attribute("diaginertia", vectorText(given->moments)) + "/>\n";
  }

  std::string jointText(const JointDescription& joint, const std::string& indent) const {
    const JointDynamics dynamics = model_.dynamicsOf(joint.name);
    const bool slides = joint.kind == JointDescription::Kind::kPrismatic, turns = joint.kind == JointDescription::Kind::kRevolute;
    if (joint.kind == JointDescription::Kind::kFloating) return indent + "<freejoint" + attribute("name", joint.name) + "/>\n";
    if (!moves(joint)) return "";
    std::string text = indent + "<joint" + attribute("name", joint.name) + attribute("type", slides ? "slide" : "hinge") +
                       attribute("axis", vectorText(joint.axis));
    if (slides || turns) text += attribute("limited", "true") + attribute("range", numberText(joint.lower) + " " + numberText(joint.upper));
    if (dynamics.damping > 0) text += attribute("damping", numberText(dynamics.damping));
    if (dynamics.friction > 0) text += attribute("frictionloss", numberText(dynamics.friction));
    return text + "/>\n";
  }

  std::string geoms(const LinkDescription& link, const std::string& indent) {
    std::string text;
    const bool has_mass = model_.inertialOf(link.name) != nullptr;
    for (const GeometryElement& element : link.collisions) {
      const std::string shape = shapeText(element);
      if (shape.empty()) continue;
      const std::string name = element.name.empty() ? "" : attribute("name", names_.take(element.name));
      text += indent + "<geom" + name + shape + poseText(element.origin) + (has_mass ? "" : attribute("density", numberText(kDensity))) +
              "/>\n";
    }
    return text;
  }

  /// Empty for what is no body, and for a mesh that is not of this output.
  std::string shapeText(const GeometryElement& element) {
    const Eigen::Vector3d& size = element.size;
    switch (element.kind) {
      case Kind::kBox: return attribute("type", "box") + attribute("size", vectorText(size / 2));
      case Kind::kSphere: return attribute("type", "sphere") + attribute("size", numberText(size.x()));
      case Kind::kCylinder: return attribute("type", "cylinder") + attribute("size", numberText(size.x()) + " " + numberText(size.y() / 2));
      case Kind::kNone: return "";
      case Kind::kMesh: break;
    }
    const std::string file = model_.fileOf(element);
    if (file.empty()) return "";
    const auto known = meshes_.find(file);
    const std::string name = known != meshes_.end() ? known->second : mesh_names_.take(file.substr(0, file.find_last_of('.')));
    if (known == meshes_.end()) {
      meshes_[file] = name;
      assets_ += "    <mesh" + attribute("name", name) + attribute("file", file) + "/>\n";
    }
    return attribute("type", "mesh") + attribute("mesh", name);
  }

  std::string exclusions() const {
    std::string text;
    for (const DisabledPair& pair : pairs_)
      text += "    <exclude" + attribute("body1", pair.link1) + attribute("body2", pair.link2) + "/>\n";
    return text.empty() ? "" : "  <contact>\n" + text + "  </contact>\n";
  }

  /// Joints that mimic others: offset and multiplier of the master's position, or the one position that a locked master leaves them.
  std::string equalities() const {
    std::map<std::string, double> locked;
    for (const JointDescription& joint : model_.robot().joints)
      if (isLocked(joint)) locked[joint.name] = joint.lower;
    std::string text;
    for (const JointDescription& joint : model_.robot().joints) {
      if (joint.mimic.empty() || !moves(joint)) continue;
      const auto at = locked.find(joint.mimic);
      const bool is_free = at == locked.end();
      const double offset = joint.mimic_offset + (is_free ? 0 : joint.mimic_multiplier * at->second);
      text += "    <joint" + attribute("joint1", joint.name) + (is_free ? attribute("joint2", joint.mimic) : "") +
              attribute("polycoef", numberText(offset) + " " + numberText(is_free ? joint.mimic_multiplier : 0) + " 0 0 0") + "/>\n";
    }
    return text.empty() ? "" : "  <equality>\n" + text + "  </equality>\n";
  }

  const WrittenModel& model_;
  const std::vector<DisabledPair>& pairs_;
  const RunControl& control_;
  std::map<std::string, const LinkDescription*> links_;
  std::map<std::string, Eigen::Isometry3d> places_;  // of links, in the world, with the robot at rest
  std::vector<const JointDescription*> floating_;
  std::string bodies_;
  UniqueNames names_, mesh_names_;
  std::map<std::string, std::string> meshes_;  // by file: the asset's name
  std::string assets_;
};

}  // namespace

std::vector<std::string> mujocoNotes(const WrittenModel& model) {
  std::vector<std::string> notes = model.notes(), links;
  for (const LinkDescription& link : model.robot().links)
    if (!link.parent.empty() && !link.collisions.empty() && !model.inertialOf(link.name)) links.push_back(link.name);
  if (!links.empty())
    notes.push_back("--for mujoco: " + someHave(links) + " no <inertial>: the file gives such links a density of " + numberText(kDensity) +
                    " kg/m^3, so that they weigh next to nothing, and a simulation may diverge; add <inertial>, or change the density");
  const std::string planar = jointsThat(model, [](const auto& joint) { return joint.kind == JointDescription::Kind::kPlanar; });
  if (!planar.empty()) notes.push_back("--for mujoco: planar joints (" + planar + ") are fixed, as MJCF has none");
  const std::string locked = jointsThat(model, isLocked);
  if (!locked.empty()) notes.push_back("--for mujoco: joints whose range is nothing (" + locked + ") are fixed, as MuJoCo refuses them");
  const std::string out_of_range = jointsThat(model, [](const auto& joint) { return moves(joint) && restValue(joint) != 0; });
  if (!out_of_range.empty())
    notes.push_back("--for mujoco: out of range where MuJoCo starts, with all joints at 0: " + out_of_range +
                    "; set their qpos first. No keyframe is written, as MuJoCo rejects one once other bodies are added");
  noteLeftOut(model, "mujoco", "MuJoCo would take its convex hull, which fills what is hollow", notes);
  return notes;
}

ConsumerFiles mujocoFiles(const WrittenModel& model, const std::vector<DisabledPair>& pairs, const RunControl& control) {
  return {{"mjcf/" + robotFileName(model.robot().name) + ".xml", MjcfWriter(model, pairs, control).text()}};
}

}  // namespace collision_hulls
