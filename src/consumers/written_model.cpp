// The rewritten text is parsed again, as a consumer would, so that the writers see what it sees. A hull is known by the end of its URI,
// which is its path in the output, whatever stands before that.
#include "consumers/written_model.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <sstream>

#include "base/counted.h"
#include "base/decimal.h"
#include "base/string_parts.h"
#include "geometry/roll_pitch_yaw.h"
#include "robot/number_text.h"

namespace collision_hulls {
namespace {

constexpr double kLeastMoment = 1e-9;  // [kg m^2], as the note says
constexpr double kFlat = 1e-6;         // relative
constexpr std::size_t kMostNamed = 3;  // links or joints of a message

double numberOf(const XmlNode* node, const std::string& attribute, double otherwise) {
  if (!node) return otherwise;
  std::istringstream in(node->attribute(attribute));
  in.imbue(std::locale::classic());
  double value = otherwise;
  return in >> value ? value : otherwise;
}

Eigen::Vector3d vectorOf(const XmlNode* node, const std::string& attribute) {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  if (!node) return v;
  std::istringstream in(node->attribute(attribute));
  in.imbue(std::locale::classic());
  in >> v.x() >> v.y() >> v.z();
  return in ? v : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

Eigen::Isometry3d originOf(const XmlNode* node) {
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
  origin.linear() = fromRollPitchYaw(vectorOf(node, "rpy")).toRotationMatrix();
  origin.translation() = vectorOf(node, "xyz");
  return origin;
}

/// Moments that a body may have: all positive, and none larger than the sum of the others. A flat plate's largest is as large as that, or
/// larger by rounding, so all of its moments grow a little. Where moments are impossible, their mean stands for all three, as MuJoCo's
/// balanceinertia has it; simulators refuse other tensors.
Eigen::Vector3d balanced(const Eigen::Vector3d& moments) {
  const double most = moments.maxCoeff(), others = moments.sum() - most;
  if (moments.minCoeff() > 0 && most < others) return moments;
  if (moments.minCoeff() > 0 && most <= (1 + kFlat) * others) return moments + Eigen::Vector3d::Constant(2 * kFlat * most);
  return Eigen::Vector3d::Constant(std::max(kLeastMoment, moments.sum() / 3));
}

/// "'a', 'b', 'c' and 4 more", for messages.
std::string fewOf(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i) text += (i == 0 ? "'" : ", '") + shortened(names[i]) + "'";
  return text + (names.size() > kMostNamed ? " and " + std::to_string(names.size() - kMostNamed) + " more" : "");
}

/// "1.234e-07 0.5 2", for messages.
std::string figures(const Eigen::Vector3d& v) {
  return decimal(v.x(), 4) + " " + decimal(v.y(), 4) + " " + decimal(v.z(), 4);
}

/// `given` [kg m^2]: the moments as the description has them.
Inertial inertialOf(const XmlNode& element, Eigen::Vector3d& given) {
  const XmlNode* const entries = element.child("inertia");
  const double xy = numberOf(entries, "ixy", 0), xz = numberOf(entries, "ixz", 0), yz = numberOf(entries, "iyz", 0);
  Eigen::Matrix3d tensor;
  tensor << numberOf(entries, "ixx", 0), xy, xz, xy, numberOf(entries, "iyy", 0), yz, xz, yz, numberOf(entries, "izz", 0);
  Inertial inertial;
  inertial.principal = originOf(element.child("origin"));
  inertial.mass = numberOf(element.child("mass"), "value", 0);
  given = inertial.moments = tensor.diagonal();
  if (!tensor.isDiagonal(0)) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor);
    Eigen::Matrix3d axes = solver.eigenvectors();
    if (axes.determinant() < 0) axes.col(0) *= -1;
    inertial.principal.linear() *= axes;
    given = inertial.moments = solver.eigenvalues();
  }
  inertial.moments = balanced(inertial.moments);
  return inertial;
}

}  // namespace

WrittenModel::WrittenModel(const RobotResult& result, const std::string& package, const RunControl& control)
    : result_(result), package_(package), robot_(parseRobotDescription(result.urdf, "", control)) {
  for (std::size_t i = 0; i < result.elements.size(); ++i) {
    const std::vector<std::string>& files = result.report.links[i].files;
    for (std::size_t m = 0; m < files.size(); ++m) hulls_[files[m]] = &result.elements[i].hulls[m];
  }
  for (const JointDescription& joint : robot_.joints) below_[joint.parent].push_back(&joint);
  readDynamics(parseXml(result.urdf, "the rewritten description", control));
}

void WrittenModel::readDynamics(const XmlNode& robot) {
  std::size_t changed = 0;
  for (const XmlNode* link : robot.childrenNamed("link")) {
    const XmlNode* const given = link->child("inertial");
    if (!given) continue;
    Eigen::Vector3d moments;
    const Inertial inertial = collision_hulls::inertialOf(*given, moments);
    if (!(inertial.mass > 0)) continue;
    const std::string name = link->attribute("name");
    inertials_[name] = inertial;
    if (!moments.isApprox(inertial.moments, 4 * kFlat) && ++changed == 1)
      notes_.push_back("link '" + name + "': moments of inertia of " + figures(moments) +
                       " are impossible (one is not positive, or larger than the sum of the others); the files of --for use their mean "
                       "instead, but at least 1e-9");
  }
  if (changed > 1) notes_.front() += "; " + counted(changed - 1, "more link") + (changed == 2 ? " is" : " are") + " like it";
  for (const XmlNode* joint : robot.childrenNamed("joint")) {
    const XmlNode *const limit = joint->child("limit"), *const dynamics = joint->child("dynamics");
    dynamics_[joint->attribute("name")] = {numberOf(limit, "effort", -1), numberOf(limit, "velocity", -1),
                                           numberOf(dynamics, "damping", -1), numberOf(dynamics, "friction", -1)};
  }
}

std::string WrittenModel::fileOf(const GeometryElement& element) const {
  if (element.kind != GeometryElement::Kind::kMesh) return "";
  for (std::size_t at = element.uri.find("meshes/"); at != std::string::npos; at = element.uri.find("meshes/", at + 1)) {
    const std::string file = element.uri.substr(at);
    if (at > 0 && element.uri[at - 1] == '/' && hulls_.count(file)) return file;
  }
  return "";
}

const ConvexHull* WrittenModel::hullOf(const GeometryElement& element) const {
  const std::string file = fileOf(element);
  return file.empty() ? nullptr : hulls_.at(file);
}

const Inertial* WrittenModel::inertialOf(const std::string& link) const {
  const auto found = inertials_.find(link);
  return found == inertials_.end() ? nullptr : &found->second;
}

JointDynamics WrittenModel::dynamicsOf(const std::string& joint) const {
  const auto found = dynamics_.find(joint);
  return found == dynamics_.end() ? JointDynamics() : found->second;
}

const std::vector<const JointDescription*>& WrittenModel::jointsBelow(const std::string& link) const {
  static const std::vector<const JointDescription*> none;
  const auto found = below_.find(link);
  return found == below_.end() ? none : found->second;
}

std::vector<std::string> WrittenModel::roots() const {
  std::vector<std::string> roots;
  for (const LinkDescription& link : robot_.links)
    if (link.parent.empty()) roots.push_back(link.name);
  return roots;
}

std::string WrittenModel::nameBesideWorld(const std::string& link, const std::function<bool(const LinkDescription&)>& is_body) const {
  const auto is_it = [&](const LinkDescription& other) { return other.name == link && is_body(other); };
  return link == kWorld && std::any_of(robot_.links.begin(), robot_.links.end(), is_it) ? "world_link" : link;
}

std::vector<std::string> WrittenModel::linksWithOtherMeshes() const {
  std::vector<std::string> links;
  const auto is_other = [&](const GeometryElement& element) {
    return element.kind == GeometryElement::Kind::kMesh && fileOf(element).empty();
  };
  for (const LinkDescription& link : robot_.links)
    if (std::any_of(link.collisions.begin(), link.collisions.end(), is_other)) links.push_back(link.name);
  return links;
}

bool turnsOrSlides(const JointDescription& joint) {
  using Joint = JointDescription::Kind;
  return joint.kind == Joint::kRevolute || joint.kind == Joint::kContinuous || joint.kind == Joint::kPrismatic;
}

std::string jointsThat(const WrittenModel& model, const std::function<bool(const JointDescription&)>& is_so) {
  std::vector<std::string> names;
  for (const JointDescription& joint : model.robot().joints)
    if (is_so(joint)) names.push_back(joint.name);
  return fewOf(names);
}

void noteLeftOut(const WrittenModel& model, const std::string& consumer, const std::string& otherwise, std::vector<std::string>& notes) {
  const std::vector<std::string> links = model.linksWithOtherMeshes();
  if (links.empty()) return;
  notes.push_back("--for " + consumer + ": " + someHave(links) + " a mesh that is not a hull of this output; the file leaves it out, as " +
                  otherwise +
                  "; collisions with it are missed. Decompose it as well (its action is decompose, and --links, if given, matches it)");
}

void noteFollowers(const WrittenModel& model, const std::string& consumer, const std::string& format, std::vector<std::string>& notes) {
  const std::string joints = jointsThat(model, [](const auto& joint) { return !joint.mimic.empty() && turnsOrSlides(joint); });
  if (joints.empty()) return;
  notes.push_back("--for " + consumer + ": joints that mimic others (" + joints + ") move by themselves, as " + format +
                  " cannot say that they follow");
}

void noteWithoutInertial(const std::vector<std::string>& links, const std::string& consumer, const std::string& who,
                         std::vector<std::string>& notes) {
  if (!links.empty())
    notes.push_back("--for " + consumer + ": " + someHave(links) + " no <inertial>: " + who +
                    " assumes a mass of 1 kg and moments of inertia of 1 kg m^2; add <inertial>");
}

std::string someHave(const std::vector<std::string>& links) {
  if (links.size() == 1) return "link '" + shortened(links.front()) + "' has";
  return "links " + fewOf(links) + " have";
}

std::string positionText(const Eigen::Isometry3d& pose) {
  return vectorText(pose.translation());
}

std::string rpyText(const Eigen::Isometry3d& pose) {
  return vectorText(rollPitchYaw(pose.linear()));
}

std::string nameAttribute(const std::string& name) {
  return " name=\"" + xmlEscaped(name) + "\"";
}

std::string tag(const std::string& name, const std::string& text, const std::string& attributes) {
  return "<" + name + attributes + ">" + xmlEscaped(text) + "</" + name + ">";
}

std::string quaternionText(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  return numberText(q.w()) + " " + vectorText(q.vec());
}

}  // namespace collision_hulls
