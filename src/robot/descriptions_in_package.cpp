// The robot descriptions that a package offers, without the xacro files that hold nothing but macros for others.
#include <algorithm>
#include <iterator>
#include <set>

#include "collision_hulls/error.h"
#include "collision_hulls/robot/robot_description.h"
#include "robot/package_crawl.h"
#include "storage/text_file.h"
#include "xml/xml_tree.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

constexpr const char* kXacro = "xacro:";

/// Whether an element of a xacro file adds a part to a robot: a link, or a macro call.
bool makesParts(const XmlNode& element) {
  static const std::set<std::string> others{"xacro:include", "xacro:macro", "xacro:property", "xacro:arg", "xacro:insert_block"};
  if (element.name == "xacro:if" || element.name == "xacro:unless")
    return std::any_of(element.children.begin(), element.children.end(), makesParts);
  return element.name == "link" || (element.name.rfind(kXacro, 0) == 0 && others.count(element.name) == 0);
}

/// False for a xacro file of macros and properties only. True for an unreadable file, so that its reader can say what is wrong.
bool isDescription(const std::string& file) {
  if (fs::path(file).extension() != ".xacro") return true;
  try {
    const XmlNode root = parseXml(readTextFile(file, ".xacro file"), "'" + file + "'");
    return std::any_of(root.children.begin(), root.children.end(), makesParts);
  } catch (const Error&) {
    return true;
  }
}

}  // namespace

std::vector<std::string> robotDescriptionsIn(const std::string& package_folder) {
  std::vector<std::string> found;
  for (const char* extension : {".urdf", ".xacro"}) {
    for (const char* folder : {"robots", "urdf"}) {
      for (const fs::path& entry : sortedEntries(fs::path(package_folder) / folder)) {
        if (entry.extension() == extension && isFile(entry)) found.push_back(entry.string());
      }
    }
  }
  std::vector<std::string> descriptions;
  std::copy_if(found.begin(), found.end(), std::back_inserter(descriptions), isDescription);
  return descriptions.empty() ? found : descriptions;
}

}  // namespace collision_hulls
