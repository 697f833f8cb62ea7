// Resolves <pose relative_to> by following frames recursively; a chain longer than the number of frames is a cycle. Frames inside nested
// models are resolved on demand by building that model's SdfFrames.
#include "scene/sdf_frames.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "base/finite_number.h"
#include "base/in_context.h"
#include "collision_hulls/error.h"
#include "geometry/pi.h"
#include "geometry/roll_pitch_yaw.h"
#include "scene/reading.h"

namespace collision_hulls {
namespace {

const std::string kWithin = "::";
constexpr std::size_t kMostFrames = 1000;  // in a chain, which takes a level of recursion for each
constexpr double kRadiansPerDegree = kPi / 180;

std::string textOfChild(const XmlNode& element, const std::string& name) {
  const XmlNode* child = element.child(name);
  return child ? child->text : "";
}

}  // namespace

void failSdf(const std::string& file, const XmlNode& element, const std::string& reason) {
  throw Error(ErrorCode::kBadScene, "'" + file + "', line " + std::to_string(element.line) + ": " + reason);
}

std::vector<double> sdfNumbers(const std::string& file, const XmlNode& element, std::size_t count) {
  std::istringstream words(element.text);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    if (!parseFinite(word, numbers.emplace_back()))
      failSdf(file, element, "'" + word + "' in <" + element.name + "> is not a finite number");
  }
  if (numbers.size() != count) {
    failSdf(file, element, "<" + element.name + "> has " + std::to_string(numbers.size()) + " numbers; it needs " + std::to_string(count));
  }
  return numbers;
}

Eigen::Isometry3d sdfPose(const std::string& file, const XmlNode& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (pose.text.empty()) return result;
  const bool quaternion = pose.attribute("rotation_format") == "quat_xyzw";
  const std::vector<double> n = sdfNumbers(file, pose, quaternion ? 7 : 6);
  result.translation() = Eigen::Vector3d(n[0], n[1], n[2]);
  std::string degrees = pose.attribute("degrees");
  for (char& c : degrees) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const double unit = degrees == "true" || degrees == "1" ? kRadiansPerDegree : 1;
  inContext("'" + file + "', line " + std::to_string(pose.line), [&] {
    result.linear() = (quaternion ? checkedQuaternion(n[3], n[4], n[5], n[6]) : fromRollPitchYaw(unit * Eigen::Vector3d(n[3], n[4], n[5])))
                          .toRotationMatrix();
  });
  return result;
}

struct SdfFrames::Nested {
  std::vector<SdfModel> models;
  SdfFrames frames;

  Nested(const SdfModel& model, const ModelsWithin& models_within)
      : models(models_within(model)), frames(*model.element, model.file, models, models_within) {}
};

SdfFrames::SdfFrames(const XmlNode& scope, const std::string& file, const std::vector<SdfModel>& models, const ModelsWithin& models_within)
    : file_(file), models_(models), models_within_(models_within) {
  for (const XmlNode& element : scope.children) {
    if (element.name == "link") add(element.attribute("name"), element, "");
    if (element.name == "frame") add(element.attribute("name"), element, element.attribute("attached_to"));
  }
  for (const SdfModel& model : models) add(model.name, *model.posed, "");
  // Before SDF 1.7 a joint could share its name with a link; the name then means the link.
  for (const XmlNode* joint : scope.childrenNamed("joint"))
    if (frames_.count(joint->attribute("name")) == 0) add(joint->attribute("name"), *joint, textOfChild(*joint, "child"));
}

void SdfFrames::add(const std::string& name, const XmlNode& element, const std::string& relative_to) {
  if (name.empty()) failSdf(file_, element, "a <" + element.name + "> has no name; give it one");
  if (!frames_.emplace(name, Frame{&element, relative_to}).second) {
    failSdf(file_, element, "'" + name + "' appears twice in its model or world; rename one of them");
  }
}

Eigen::Isometry3d SdfFrames::poseOf(const XmlNode& element, const std::string& frame) const {
  return poseOf(element, frame, Steps());
}

Eigen::Isometry3d SdfFrames::poseOf(const XmlNode& element, const std::string& frame, const Steps& steps) const {
  const XmlNode* pose = element.child("pose");
  if (!pose) return frameNamed(frame, element, steps);
  const std::string relative_to = pose->attribute("relative_to");
  // Before SDF 1.7 the attribute was called `frame`.
  const std::string given = relative_to.empty() ? pose->attribute("frame") : relative_to;
  return frameNamed(given.empty() ? frame : given, *pose, steps) * sdfPose(file_, *pose);
}

Eigen::Isometry3d SdfFrames::frameNamed(const std::string& name, const XmlNode& asked_by, const Steps& steps) const {
  if (name.empty() || name == "__model__" || name == "world") return Eigen::Isometry3d::Identity();
  if (steps.here > frames_.size())
    failSdf(file_, asked_by, "frame '" + name + "' is relative to itself, by way of other frames; break the cycle");
  if (steps.all > kMostFrames)
    failSdf(file_, asked_by, "frame '" + name + "' ends a chain of more than " + std::to_string(kMostFrames) + " frames; shorten it");
  const auto known = found_.find(name);
  if (known != found_.end()) return known->second;
  const auto frame = frames_.find(name);
  const std::size_t end = name.find(kWithin);
  Eigen::Isometry3d place;
  if (frame != frames_.end()) {
    place = poseOf(*frame->second.element, frame->second.relative_to, steps.next());
  } else if (end != std::string::npos) {
    const std::string model = name.substr(0, end), within = name.substr(end + kWithin.size());
    const SdfFrames& frames = framesIn(model, within, asked_by);
    place = frameNamed(model, asked_by, steps) * frames.frameNamed(within, asked_by, {0, steps.all + 1});
  } else {
    failSdf(file_, asked_by, "this model or world has no frame '" + name + "'");
  }
  return found_[name] = place;
}

SdfFrames::~SdfFrames() = default;

const SdfFrames& SdfFrames::framesIn(const std::string& model, const std::string& name, const XmlNode& asked_by) const {
  std::unique_ptr<Nested>& nested = nested_[model];
  if (nested) return nested->frames;
  const auto found = std::find_if(models_.begin(), models_.end(), [&](const SdfModel& m) { return m.name == model; });
  if (found == models_.end()) failSdf(file_, asked_by, "this model or world has no model '" + model + "', in which to find '" + name + "'");
  nested = std::make_unique<Nested>(*found, models_within_);
  return nested->frames;
}

}  // namespace collision_hulls
