// The whole description is read by urdfdom as it is, and the elements of its links are counted. Where some are missing, each element of the
// link is read in a link of its own, in urdfdom's order, to find the one at which it stopped.
#include "decode/urdf/urdfdom_losses.h"

#include <tinyxml2.h>

#include <new>
#include <optional>
#include <stdexcept>
#include <unordered_map>

#include "base/counted.h"
#include "decode/urdf/urdf_elements.h"
#include "decode/xml_source.h"

namespace collision_hulls {
namespace {

using tinyxml2::XMLElement;

constexpr std::size_t kMostNamed = 5;  // links of a note

/// An element at which urdfdom stops reading its link, and why.
struct Stop {
  const XMLElement* element = nullptr;
  std::string reason;
};

/// Elements of which one note names the first, and the links of some others.
class Losses {
 public:
  void add(const std::string& link, const std::string& first) {
    if (note_.empty()) {
      note_ = first;
    } else if (++more_ <= kMostNamed) {
      others_ += (others_.empty() ? "'" : ", '") + link + "'";
    }
  }

  void addTo(std::vector<std::string>& notes) const {
    if (note_.empty()) return;
    const std::string rest = ". The same holds for " + counted(more_, "more link") + ": " + others_ + (more_ > kMostNamed ? ", ..." : "");
    notes.push_back(note_ + (more_ > 0 ? rest : ""));
  }

 private:
  std::string note_, others_;
  std::size_t more_ = 0;
};

/// A shape that urdfdom does not look at: it takes the first of the first <geometry>.
const XMLElement* secondShapeOf(const XMLElement& element) {
  const XMLElement* geometry = element.FirstChildElement("geometry");
  for (const XMLElement* const first = shapeOf(element); geometry; geometry = geometry->NextSiblingElement("geometry"))
    for (const XMLElement* shape = geometry->FirstChildElement(); shape; shape = shape->NextSiblingElement())
      for (const char* kind : {"box", "cylinder", "sphere", "mesh"})
        if (shape != first && shape->Name() == std::string(kind)) return shape;
  return nullptr;
}

/// The first such shape in a link.
const XMLElement* secondShapeIn(const XMLElement& link) {
  for (const char* kind : {"visual", "collision"})
    for (const XMLElement* element = link.FirstChildElement(kind); element; element = element->NextSiblingElement(kind))
      if (const XMLElement* const second = secondShapeOf(*element)) return second;
  return nullptr;
}

std::optional<Stop> stopIn(const XMLElement& link, const std::string& name) {
  for (const char* kind : {"inertial", "visual", "collision"})
    for (const XMLElement* element = link.FirstChildElement(kind); element; element = element->NextSiblingElement(kind))
      if (std::string reason = complaintAbout(*element, name); !reason.empty()) return Stop{element, std::move(reason)};
  return std::nullopt;
}

}  // namespace

std::vector<std::string> notesOnLosses(const XmlSource& subject, const XMLElement& root) {
  std::unordered_map<std::string, const LinkDescription*> by_name;
  UrdfModel model;
  try {
    model = readUrdfModel(root);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return {subject.label + ": urdfdom, and so rviz and MoveIt, refuses it as it is: " + error.what()};
  }
  for (const LinkDescription& link : model.links) by_name[link.name] = &link;
  Losses unread, second_shapes;
  for (const XMLElement* link = root.FirstChildElement("link"); link; link = link->NextSiblingElement("link")) {
    const std::string name = link->Attribute("name");
    if (const XMLElement* const second = secondShapeIn(*link))
      second_shapes.add(name, subject.label + ", line " + std::to_string(subject.lineFromRoot(second->GetLineNum())) + ": this <" +
                                  second->Name() + "> of link '" + name + "' is a second shape, which urdfdom, and so rviz and MoveIt, " +
                                  "does not see; give it a <visual> or <collision> of its own");
    const auto seen = by_name.find(name);
    const std::size_t visuals = countChildren(*link, "visual"), collisions = countChildren(*link, "collision");
    if (seen == by_name.end() || (seen->second->visuals.size() == visuals && seen->second->collisions.size() == collisions)) continue;
    const std::optional<Stop> stop = stopIn(*link, name);
    if (!stop || (stop->element->Name() != std::string("inertial") && !shapeOf(*stop->element))) continue;
    const auto share = [](std::size_t taken, std::size_t there, const char* kind) {
      return std::to_string(taken) + " of its " + std::to_string(there) + " <" + kind + ">";
    };
    unread.add(name, subject.label + ", line " + std::to_string(subject.lineFromRoot(stop->element->GetLineNum())) +
                         ": urdfdom cannot read this <" + stop->element->Name() + "> of link '" + name + "' (" + stop->reason +
                         ") or anything after it there: rviz, MoveIt and others see " +
                         share(seen->second->visuals.size(), visuals, "visual") + " and " +
                         share(seen->second->collisions.size(), collisions, "collision") +
                         " elements, as they will in the output; correct it");
  }
  std::vector<std::string> notes;
  for (const Losses* const losses : {&unread, &second_shapes}) losses->addTo(notes);
  return notes;
}

}  // namespace collision_hulls
