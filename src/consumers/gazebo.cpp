// SDF 1.9 in a model folder of its own: model.config and model.sdf stand at the output's root, so that the output is the model. Meshes are
// model:// URIs, found when the folder above is in GZ_SIM_RESOURCE_PATH. Links stand relative to their joints, joints relative to the
// parent's link. Gazebo's engines take each <collision> by itself, so one a hull keeps the shape. An SDF link without <inertial> weighs
// 1 kg: a URDF link with neither that nor a shape, such as base_footprint or tool0, is a <frame> of the link that it is fixed to.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/string_parts.h"
#include "consumers/written_model.h"
#include "robot/number_text.h"
#include "storage/names.h"

namespace collision_hulls {
namespace {

using Kind = GeometryElement::Kind;

std::string tagLine(const std::string& indent, const std::string& name, const std::string& text, const std::string& attributes = "") {
  return indent + tag(name, text, attributes) + "\n";
}

std::string pose(const std::string& indent, const Eigen::Isometry3d& pose, const std::string& frame = "") {
  const std::string relative = frame.empty() ? "" : " relative_to=\"" + xmlEscaped(frame) + "\"";
  if (relative.empty() && pose.matrix() == Eigen::Matrix4d::Identity()) return "";
  return tagLine(indent, "pose", positionText(pose) + " " + rpyText(pose), relative);
}

class SdfWriter {
 public:
  explicit SdfWriter(const WrittenModel& model) : model_(model) {
    // Links and joints share a name space in SDF, but not in URDF.
    std::set<std::string> links{kWorld}, taken;
    for (const LinkDescription& link : model_.robot().links) links.insert(nameOf(link.name));
    taken = links;
    for (const JointDescription& joint : model_.robot().joints) taken.insert(joint.name);
    for (const JointDescription& joint : model_.robot().joints) {
      std::string& name = joints_[joint.name] = joint.name;
      if (links.count(name) > 0) {
        do name += "_joint";
        while (!taken.insert(name).second);
      }
    }
    for (const JointDescription& joint : model_.robot().joints) above_[joint.child] = &joint;
    findCarriers();
  }

  /// In SDF, a link without a joint floats.
  bool floatsInWorld(const JointDescription& joint) const {
    return joint.kind == JointDescription::Kind::kFloating && carrierOf(joint.parent).empty();
  }

  /// Where a joint has another name here: "'name' is 'other'".
  std::vector<std::string> renamedJoints() const {
    std::vector<std::string> renamed;
    for (const JointDescription& joint : model_.robot().joints)
      if (const std::string& here = joints_.at(joint.name); isWritten(joint) && here != joint.name)
        renamed.push_back("'" + joint.name + "' is '" + here + "'");
    return renamed;
  }

  std::vector<std::string> linksWithoutInertial() const {
    std::vector<std::string> links;
    for (const LinkDescription& link : model_.robot().links)
      if (carrierOf(link.name) == link.name && !model_.inertialOf(link.name)) links.push_back(link.name);
    return links;
  }

  std::string text() {
    std::string text = "<?xml version=\"1.0\"?>\n<sdf version=\"1.9\">\n  <model" + nameAttribute(model_.robot().name) + ">\n";
    for (const LinkDescription& link : model_.robot().links) {
      const std::string& carrier = carrierOf(link.name);
      if (!carrier.empty()) text += carrier == link.name ? linkText(link) : frameText(link.name, carrier);
    }
    for (const JointDescription& joint : model_.robot().joints)
      if (isWritten(joint)) text += jointText(joint);
    return text + "  </model>\n</sdf>\n";
  }

 private:
  /// The link that a link is part of here: itself, or the one that it is a frame of. Empty for the world.
  const std::string& carrierOf(const std::string& link) const { return carriers_.at(link); }
  /// A joint between frames of one link is none.
  bool isWritten(const JointDescription& joint) const { return carrierOf(joint.parent) != carrierOf(joint.child) && !floatsInWorld(joint); }

  void findCarriers() {
    using Joint = JointDescription::Kind;
    std::set<std::string> bare;  // links
    for (const LinkDescription& link : model_.robot().links) {
      carriers_[link.name] = link.name != kWorld || hasShape(link) ? link.name : "";
      if (link.name != kWorld && !hasShape(link) && !model_.inertialOf(link.name)) bare.insert(link.name);
    }
    for (const std::string& root : model_.roots()) {
      if (bare.count(root) == 0) continue;
      std::set<std::string> fixed{root};  // to it, by bare links alone
      for (const JointDescription& joint : model_.robot().joints) {
        if (joint.kind != Joint::kFixed || fixed.count(joint.parent) == 0) continue;
        if (bare.count(joint.child) == 0) {
          carriers_[root] = joint.child;
          break;
        }
        fixed.insert(joint.child);
      }
    }
    for (const JointDescription& joint : model_.robot().joints)
      if (joint.kind == Joint::kFixed && bare.count(joint.child) > 0 && !carrierOf(joint.parent).empty())
        carriers_[joint.child] = carrierOf(joint.parent);
  }

  static bool hasShape(const LinkDescription& link) { return !link.visuals.empty() || !link.collisions.empty(); }

  /// SDF reserves the name "world": a link of that name is left out, or takes another name if it has geometry.
  std::string nameOf(const std::string& link) const { return model_.nameBesideWorld(link, hasShape); }

  /// What a pose is relative to: the model itself for the world, which has no frame in it.
  std::string frameOf(const std::string& link) const { return nameOf(link) == kWorld ? "__model__" : nameOf(link); }

  /// A link's or frame's pose: at the joint above, or where that one stands.
  std::string placeText(const std::string& link) const {
    const auto found = above_.find(link);
    if (found == above_.end()) return "";
    const JointDescription& joint = *found->second;
    return isWritten(joint) ? pose("      ", Eigen::Isometry3d::Identity(), joints_.at(joint.name))
                            : pose("      ", joint.origin, frameOf(joint.parent));
  }

  std::string frameText(const std::string& name, const std::string& carrier) const {
    const std::string place = placeText(name);
    return "    <frame" + nameAttribute(name) + " attached_to=\"" + xmlEscaped(nameOf(carrier)) + "\">\n" +
           (place.empty() ? pose("      ", Eigen::Isometry3d::Identity(), "__model__") : place) + "    </frame>\n";
  }

  std::string linkText(const LinkDescription& link) const {
    std::string text = "    <link" + nameAttribute(nameOf(link.name)) + ">\n" + placeText(link.name);
    text += inertialText(link.name);
    UniqueNames names;
    for (std::size_t i = 0; i < link.visuals.size(); ++i)
      text += elementText("visual", names.take(link.name + "_visual_" + std::to_string(i)), link.visuals[i]);
    for (std::size_t i = 0; i < link.collisions.size(); ++i) {
      const GeometryElement& element = link.collisions[i];
      text += elementText("collision", names.take(element.name.empty() ? link.name + "_" + std::to_string(i) : element.name), element);
    }
    return text + "    </link>\n";
  }

  std::string inertialText(const std::string& link) const {
    const Inertial* const given = model_.inertialOf(link);
    if (!given) return "";
    std::string text = "      <inertial>\n" + pose("        ", given->principal) + tagLine("        ", "mass", numberText(given->mass)) +
                       "        <inertia>\n";
    const std::pair<const char*, double> entries[] = {
        {"ixx", given->moments.x()}, {"iyy", given->moments.y()}, {"izz", given->moments.z()}, {"ixy", 0.0}, {"ixz", 0.0}, {"iyz", 0.0}};
    for (const auto& entry : entries) text += tagLine("          ", entry.first, numberText(entry.second));
    return text + "        </inertia>\n      </inertial>\n";
  }

  std::string elementText(const std::string& kind, const std::string& name, const GeometryElement& element) const {
    const std::string geometry = element.fault.empty() ? shapeText(element) : "";
    if (geometry.empty()) return "";
    return "      <" + kind + nameAttribute(name) + ">\n" + pose("        ", element.origin) + "        <geometry>\n" + geometry +
           "        </geometry>\n      </" + kind + ">\n";
  }

  std::string shapeText(const GeometryElement& element) const {
    const std::string in = "            ";
    const auto shape = [](const std::string& name, const std::string& content) {
      return "          <" + name + ">\n" + content + "          </" + name + ">\n";
    };
    switch (element.kind) {
      case Kind::kBox: return shape("box", tagLine(in, "size", vectorText(element.size)));
      case Kind::kSphere: return shape("sphere", tagLine(in, "radius", numberText(element.size.x())));
      case Kind::kCylinder:
        return shape("cylinder", tagLine(in, "radius", numberText(element.size.x())) + tagLine(in, "length", numberText(element.size.y())));
      case Kind::kNone: return "";
      case Kind::kMesh: break;
    }
    const bool is_scaled = element.scale != Eigen::Vector3d::Ones();
    return shape("mesh", tagLine(in, "uri", uriOf(element)) + (is_scaled ? tagLine(in, "scale", vectorText(element.scale)) : ""));
  }

  /// A package is a folder, as a model is. What is relative counts from model.sdf here, and from urdf/ in the description.
  std::string uriOf(const GeometryElement& element) const {
    const std::string file = model_.fileOf(element), scheme = "package://";
    if (!file.empty()) return "model://" + model_.package() + "/" + file;
    if (isRelativeUri(element.uri) && element.uri.find("://") == std::string::npos)
      return (std::filesystem::path("urdf") / element.uri).lexically_normal().string();
    return element.uri.compare(0, scheme.size(), scheme) == 0 ? "model://" + element.uri.substr(scheme.size()) : element.uri;
  }

  std::string parentOf(const JointDescription& joint) const {
    const std::string& carrier = carrierOf(joint.parent);
    return nameOf(carrier.empty() ? joint.parent : carrier);
  }

  std::string jointText(const JointDescription& joint) const {
    std::string text = "    <joint" + nameAttribute(joints_.at(joint.name)) + " type=\"" + typeOf(joint.kind) + "\">\n" +
                       pose("      ", joint.origin, frameOf(joint.parent)) + tagLine("      ", "parent", parentOf(joint)) +
                       tagLine("      ", "child", nameOf(joint.child));
    if (!turnsOrSlides(joint)) return text + "    </joint>\n";
    const bool is_limited = joint.kind != JointDescription::Kind::kContinuous;
    const JointDynamics dynamics = model_.dynamicsOf(joint.name);
    text += "      <axis>\n" + tagLine("        ", "xyz", vectorText(joint.axis)) + "        <limit>\n";
    if (is_limited)
      text += tagLine("          ", "lower", numberText(joint.lower)) + tagLine("          ", "upper", numberText(joint.upper));
    if (dynamics.effort >= 0) text += tagLine("          ", "effort", numberText(dynamics.effort));
    if (dynamics.velocity >= 0) text += tagLine("          ", "velocity", numberText(dynamics.velocity));
    text += "        </limit>\n        <dynamics>\n" + tagLine("          ", "damping", numberText(std::max(0.0, dynamics.damping))) +
            tagLine("          ", "friction", numberText(std::max(0.0, dynamics.friction))) + "        </dynamics>\n";
    return text + "      </axis>\n    </joint>\n";
  }

  /// SDF has no planar joint, and no floating one between links: those are fixed here, as they are in the robot at rest.
  static std::string typeOf(JointDescription::Kind kind) {
    switch (kind) {
      case JointDescription::Kind::kRevolute: return "revolute";
      case JointDescription::Kind::kContinuous: return "continuous";
      case JointDescription::Kind::kPrismatic: return "prismatic";
      default: return "fixed";
    }
  }

  const WrittenModel& model_;
  std::map<std::string, std::string> joints_;             // names here, by those in the description
  std::map<std::string, const JointDescription*> above_;  // by child
  std::map<std::string, std::string> carriers_;           // by links
};

}  // namespace

std::vector<std::string> gazeboNotes(const WrittenModel& model) {
  std::vector<std::string> notes = model.notes();
  const SdfWriter writer(model);
  noteWithoutInertial(writer.linksWithoutInertial(), "gazebo", "SDF", notes);
  const std::vector<std::string> renamed = writer.renamedJoints();
  if (!renamed.empty())
    notes.push_back("--for gazebo: SDF lets no joint have the name of a link or of the world, so in model.sdf the joint " +
                    listed(renamed));
  const std::string fixed = jointsThat(model, [&](const auto& joint) {
    return (joint.kind == JointDescription::Kind::kFloating && !writer.floatsInWorld(joint)) ||
           joint.kind == JointDescription::Kind::kPlanar;
  });
  if (!fixed.empty()) notes.push_back("--for gazebo: floating and planar joints (" + fixed + ") are fixed, as SDF has none");
  noteFollowers(model, "gazebo", "SDF 1.9", notes);
  return notes;
}

ConsumerFiles gazeboFiles(const WrittenModel& model) {
  const std::string config = "<?xml version=\"1.0\"?>\n<model>\n" + tagLine("  ", "name", model.robot().name) +
                             tagLine("  ", "version", "1.0") + tagLine("  ", "sdf", "model.sdf", " version=\"1.9\"") + "</model>\n";
  return {{"model.config", config}, {"model.sdf", SdfWriter(model).text()}};
}

}  // namespace collision_hulls
