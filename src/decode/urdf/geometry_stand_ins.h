// Elements of a description that urdfdom had better not see: it drops the rest of a link after one that it cannot read.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "collision_hulls/robot/robot_description.h"
#include "decode/xml_source.h"

namespace tinyxml2 {
class XMLElement;
}

namespace collision_hulls {

/// What stands for elements that were taken out of a description.
class GeometryStandIns {
 public:
  GeometryStandIns(const XmlSource& subject, tinyxml2::XMLElement& robot) : subject_(subject), robot_(robot) {}

  /// Takes out what says nothing about geometry: inertia, materials, and elements without geometry, which a note is made of.
  void takeOutOtherThings();
  /// Takes out the <visual> and <collision> elements that urdfdom cannot read by themselves.
  void takeOutUnreadable();
  /// Puts the stand-ins of a link in among its elements.
  void insertInto(LinkDescription& link) const;

  const std::vector<std::string>& notes() const { return notes_; }

 private:
  // Of one link: by visual or not, and by index among the link's elements as they stand in the text.
  using StandIns = std::map<std::pair<bool, std::size_t>, GeometryElement>;
  template <class Choice>
  void takeOut(const Choice& standInFor);

  const XmlSource& subject_;
  tinyxml2::XMLElement& robot_;
  std::map<std::string, StandIns> stand_ins_;  // by link
  std::vector<std::string> notes_;
  std::size_t without_geometry_ = 0;  // elements
};

}  // namespace collision_hulls
