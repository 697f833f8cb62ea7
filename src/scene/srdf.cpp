// Reads and writes the <disable_collisions> of an SRDF; its other elements are ignored. MoveIt evaluates the elements by kind rather than
// in document order: links disabled by default, then pairs enabled again, then pairs disabled. So does this reader.
#include "collision_hulls/scene/srdf.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/counted.h"
#include "base/looks.h"
#include "base/nearest_name.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "robot/number_text.h"
#include "storage/text_file.h"
#include "xml/xml_tree.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostPairs = 1'000'000;

using LinkPair = std::pair<std::string, std::string>;

LinkPair inOrder(const std::string& a, const std::string& b) {
  return std::minmax(a, b);
}

class SrdfReader {
 public:
  SrdfReader(const RobotDescription& robot, std::string label, const RunControl& control)
      : label_(std::move(label)), robot_(robot.name), look_(control, kLargeItemsBetweenLooks) {
    for (const LinkDescription& link : robot.links) links_.push_back(link.name);
    known_.insert(links_.begin(), links_.end());
  }

  DisabledPairs read(const XmlNode& root) {
    if (root.name != "robot") fail(root, "the root element is <" + root.name + ">; an SRDF needs <robot>");
    if (const XmlNode* const link = root.child("link"); link && !root.child("disable_collisions"))
      fail(*link, "a <link>: this is the robot's description; give its SRDF");
    for (const XmlNode* element : root.childrenNamed("disable_default_collisions")) {
      disableAllOf(*element);
      if (result_.pairs.size() > kMostPairs)
        fail(*element, "more than " + std::to_string(kMostPairs) + " pairs are disabled by default; name those that touch instead");
    }
    for (const XmlNode* element : root.childrenNamed("enable_collisions")) enable(pairOf(*element));
    dropEnabled();
    for (const XmlNode* element : root.childrenNamed("disable_collisions")) disable(pairOf(*element), element->attribute("reason"));
    if (left_out_ > 0 && !names_a_pair_)
      fail(root, "no pair names two links of the robot '" + robot_ + "', which has no '" + shortened(first_unknown_) +
                     "'; give the SRDF of this robot");
    if (const std::string name = root.attribute("name"); !name.empty() && name != robot_)
      result_.notes.push_back(label_ + " is for the robot '" + shortened(name) + "', and the description is of '" + robot_ +
                              "'; its pairs count where the links have the same names");
    if (left_out_ > 0) {
      const std::string nearest = nearestName(first_unknown_, links_);
      result_.notes.push_back(label_ + ": " + counted(left_out_, "pair names", "pairs name") +
                              " links that the robot does not have, first '" + shortened(first_unknown_) + "'" +
                              (nearest.empty() ? "" : " (did you mean '" + shortened(nearest) + "'?)") + "; " +
                              (left_out_ == 1 ? "it is" : "they are") + " left out");
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const XmlNode& element, const std::string& reason) const {
    throw Error(ErrorCode::kNotAnSrdf, label_ + ", line " + std::to_string(element.line) + ": " + reason);
  }

  std::string linkOf(const XmlNode& element, const std::string& attribute) const {
    const std::string link = element.attribute(attribute);
    if (link.empty()) fail(element, "<" + element.name + "> has no " + attribute + "; give it a link's name");
    return link;
  }

  LinkPair pairOf(const XmlNode& element) const { return {linkOf(element, "link1"), linkOf(element, "link2")}; }

  bool isKnown(const LinkPair& pair) {
    look_();
    for (const std::string& link : {pair.first, pair.second}) {
      if (known_.count(link)) continue;
      leaveOut(link, 1);
      return false;
    }
    names_a_pair_ = true;
    return true;
  }

  void leaveOut(const std::string& unknown, std::size_t pairs) {
    if (left_out_ == 0) first_unknown_ = unknown;
    left_out_ += pairs;
  }

  void disable(const LinkPair& pair, const std::string& reason) {
    if (!isKnown(pair) || !disabled_.insert(inOrder(pair.first, pair.second)).second) return;
    result_.pairs.push_back({pair.first, pair.second, reason, ""});
  }

  void enable(const LinkPair& pair) {
    if (isKnown(pair)) disabled_.erase(inOrder(pair.first, pair.second));
  }

  void dropEnabled() {
    const auto is_enabled = [this](const DisabledPair& p) { return look_(), disabled_.count(inOrder(p.link1, p.link2)) == 0; };
    result_.pairs.erase(std::remove_if(result_.pairs.begin(), result_.pairs.end(), is_enabled), result_.pairs.end());
  }

  void disableAllOf(const XmlNode& element) {
    const std::string link = linkOf(element, "link");
    look_();
    if (!by_default_.insert(link).second) return;  // all pairs of it are disabled already
    if (known_.count(link) == 0) return leaveOut(link, links_.size());
    names_a_pair_ = true;
    for (const std::string& other : links_) {
      if (other != link) disable({link, other}, "Default");
    }
  }

  std::string label_, robot_;
  Looks look_;
  std::vector<std::string> links_;
  std::set<std::string> known_;
  std::set<std::string> by_default_;
  std::set<LinkPair> disabled_;
  bool names_a_pair_ = false;
  std::size_t left_out_ = 0;
  std::string first_unknown_;
  DisabledPairs result_;
};

/// Without "--", which XML forbids in comments.
std::string commentText(std::string text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at)) text.replace(at, 2, "- ");
  return text;
}

}  // namespace

DisabledPairs parseDisabledPairs(const std::string& srdf_text, const RobotDescription& robot, const std::string& path,
                                 const RunControl& control) {
  const std::string label = path.empty() ? "SRDF" : "'" + path + "'";
  return SrdfReader(robot, label, control).read(parseXml(srdf_text, label, control));
}

DisabledPairs readDisabledPairs(const std::string& srdf_file, const RobotDescription& robot, const RunControl& control) {
  return parseDisabledPairs(readTextFile(srdf_file, ".srdf file", control), robot, srdf_file, control);
}

std::string srdfFragment(const std::string& robot_name, const std::vector<DisabledPair>& pairs,
                         const std::vector<SphereApproximation>& spheres) {
  std::string text = "<?xml version=\"1.0\"?>\n<robot name=\"" + xmlEscaped(robot_name) + "\">\n";
  for (const DisabledPair& pair : pairs) {
    text += "  <disable_collisions link1=\"" + xmlEscaped(pair.link1) + "\" link2=\"" + xmlEscaped(pair.link2) + "\" reason=\"" +
            xmlEscaped(pair.reason) + "\"/>";
    text += pair.known.empty() ? "\n" : "  <!-- " + commentText(pair.known) + " -->\n";
  }
  for (const SphereApproximation& of_link : spheres) {
    text += "  <link_sphere_approximation link=\"" + xmlEscaped(of_link.link) + "\">\n";
    for (const Sphere& sphere : of_link.spheres)
      text += "    <sphere center=\"" + vectorText(sphere.centre) + "\" radius=\"" + numberText(sphere.radius) + "\"/>\n";
    text += "  </link_sphere_approximation>\n";
  }
  return text + "</robot>\n";
}

}  // namespace collision_hulls
