// urdfdom drops a whole link, or the whole robot, over one bad <visual> or <collision>. Such elements are taken out before urdfdom sees
// them, and a stand-in with the fault takes their place afterwards, so that one bad element costs only itself.
#include "decode/urdf/geometry_stand_ins.h"

#include <tinyxml2.h>

#include <iterator>
#include <optional>
#include <utility>

#include "base/uri_text.h"
#include "decode/urdf/urdf_elements.h"

namespace collision_hulls {
namespace {

using tinyxml2::XMLElement;

constexpr std::size_t kMostNotes = 20;

void deleteChildren(XMLElement& parent, const char* name) {
  while (XMLElement* child = parent.FirstChildElement(name)) parent.DeleteChild(child);
}

std::string attributeOf(const XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value ? value : "";
}

/// Why an element is left out. A scale is what most often goes wrong, and urdfdom says little of it.
std::string faultOf(const XMLElement& element, const XMLElement& shape, const std::string& link, const std::string& complaint) {
  const std::string what = std::string("this <") + element.Name() + "> of link '" + link + "'";
  if (complaint.find("Mesh scale") == std::string::npos) return "urdfdom cannot read " + what + " (" + complaint + "); correct it";
  return "the mesh of " + what + " has the scale '" + shown(attributeOf(shape, "scale")) +
         "'; give three finite numbers with spaces between them, such as '1 1 1', or '0.001 0.001 0.001' for millimetres";
}

}  // namespace

template <class Choice>
void GeometryStandIns::takeOut(const Choice& standInFor) {
  for (XMLElement* link = robot_.FirstChildElement("link"); link; link = link->NextSiblingElement("link")) {
    const std::string name = attributeOf(*link, "name");
    StandIns& stand_ins = stand_ins_[name];
    for (const bool visual : {true, false}) {
      const char* kind = visual ? "visual" : "collision";
      std::size_t index = 0;
      for (XMLElement* element = link->FirstChildElement(kind); element; ++index) {
        while (stand_ins.count({visual, index}) > 0) ++index;  // taken out before
        XMLElement* next = element->NextSiblingElement(kind);
        if (std::optional<GeometryElement> stand_in = standInFor(*element, name)) {
          stand_in->name = attributeOf(*element, "name");
          stand_ins.emplace(std::pair(visual, index), *std::move(stand_in));
          link->DeleteChild(element);
        }
        element = next;
      }
    }
  }
}

void GeometryStandIns::takeOutOtherThings() {
  for (XMLElement* link = robot_.FirstChildElement("link"); link; link = link->NextSiblingElement("link")) {
    deleteChildren(*link, "inertial");
    for (XMLElement* visual = link->FirstChildElement("visual"); visual; visual = visual->NextSiblingElement("visual"))
      deleteChildren(*visual, "material");
  }
  takeOut([&](const XMLElement& element, const std::string& link) -> std::optional<GeometryElement> {
    if (shapeOf(element)) return std::nullopt;
    if (++without_geometry_ <= kMostNotes)
      notes_.push_back(subject_.label + ", line " + std::to_string(subject_.lineFromRoot(element.GetLineNum())) + ": this <" +
                       element.Name() + "> of link '" + link +
                       "' has no geometry and is ignored here; urdfdom also drops the elements that follow it in its link");
    GeometryElement none;
    none.kind = GeometryElement::Kind::kNone;
    return none;
  });
  if (without_geometry_ > kMostNotes)
    notes_.push_back(subject_.label + ": " + std::to_string(without_geometry_ - kMostNotes) + " more elements have no geometry");
}

void GeometryStandIns::takeOutUnreadable() {
  takeOut([&](const XMLElement& element, const std::string& link) -> std::optional<GeometryElement> {
    const std::string complaint = complaintAbout(element, link);
    if (complaint.empty()) return std::nullopt;
    GeometryElement unreadable;
    const XMLElement& shape = *shapeOf(element);
    unreadable.uri = attributeOf(shape, "filename");
    if (unreadable.uri.empty()) unreadable.uri = "<" + shown(shape.Name()) + ">";
    unreadable.fault = subject_.label + ", line " + std::to_string(subject_.lineFromRoot(element.GetLineNum())) + ": " +
                       faultOf(element, shape, link, complaint);
    return unreadable;
  });
}

void GeometryStandIns::insertInto(LinkDescription& link) const {
  const auto found = stand_ins_.find(link.name);
  if (found == stand_ins_.end() || found->second.empty()) return;
  for (const bool visual : {true, false}) {
    std::vector<GeometryElement>& elements = visual ? link.visuals : link.collisions;
    std::vector<GeometryElement> all;
    auto next = elements.begin();
    for (auto stand_in = found->second.lower_bound({visual, 0}); stand_in != found->second.end(); ++stand_in) {
      const auto [of_visual, index] = stand_in->first;
      if (of_visual != visual) break;
      while (all.size() < index && next != elements.end()) all.push_back(std::move(*next++));
      all.push_back(stand_in->second);
    }
    all.insert(all.end(), std::make_move_iterator(next), std::make_move_iterator(elements.end()));
    elements = std::move(all);
  }
}

}  // namespace collision_hulls
