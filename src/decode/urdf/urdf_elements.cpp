// urdfdom reads text alone, so elements are printed for it: the whole robot, or one element in a robot with no other.
#include "decode/urdf/urdf_elements.h"

#include <tinyxml2.h>

#include <cstring>
#include <new>
#include <stdexcept>

namespace collision_hulls {

using tinyxml2::XMLElement;

std::size_t countChildren(const XMLElement& element, const char* name) {
  std::size_t count = 0;
  for (const XMLElement* child = element.FirstChildElement(name); child; child = child->NextSiblingElement(name)) ++count;
  return count;
}

const XMLElement* shapeOf(const XMLElement& element) {
  const XMLElement* geometry = element.FirstChildElement("geometry");
  return geometry ? geometry->FirstChildElement() : nullptr;
}

UrdfModel readUrdfModel(const XMLElement& robot) {
  tinyxml2::XMLPrinter printer(nullptr, true);
  robot.Accept(&printer);
  return readUrdfModel(printer.CStr());
}

std::string complaintAbout(const XMLElement& element, const std::string& link) {
  tinyxml2::XMLDocument alone;
  XMLElement* const robot = alone.NewElement("robot");
  robot->SetAttribute("name", "r");
  alone.InsertEndChild(robot);
  XMLElement* const parent = alone.NewElement("link");
  parent->SetAttribute("name", link.c_str());
  robot->InsertEndChild(parent);
  parent->InsertEndChild(element.DeepClone(&alone));
  try {
    const UrdfModel model = readUrdfModel(*robot);
    const std::size_t taken = model.links.at(0).visuals.size() + model.links.at(0).collisions.size();
    const bool is_read = std::strcmp(element.Name(), "inertial") == 0 ? model.complaints.empty() : taken == 1;
    return is_read ? "" : model.complaints.empty() ? "it gives no reason" : model.complaints;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace collision_hulls
