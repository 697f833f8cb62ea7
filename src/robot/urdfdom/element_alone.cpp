#include "robot/urdfdom/element_alone.h"

#include <tinyxml2.h>

#include <cstring>
#include <new>
#include <stdexcept>

#include "robot/urdf_model.h"

namespace collision_hulls {

std::string complaintAbout(const tinyxml2::XMLElement& element, const std::string& link) {
  tinyxml2::XMLDocument alone;
  tinyxml2::XMLElement* const robot = alone.NewElement("robot");
  robot->SetAttribute("name", "r");
  alone.InsertEndChild(robot);
  tinyxml2::XMLElement* const parent = alone.NewElement("link");
  parent->SetAttribute("name", link.c_str());
  robot->InsertEndChild(parent);
  parent->InsertEndChild(element.DeepClone(&alone));
  tinyxml2::XMLPrinter printer(nullptr, true);
  alone.Print(&printer);
  try {
    const UrdfModel model = readUrdfModel(printer.CStr());
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
