// Loads a robot as a user of DART would, from the text of the description, with its packages resolved by our finder.
#include "physics/robot.h"

#include <dart/utils/urdf/DartLoader.hpp>

#include "collision_hulls/error.h"
#include "xml/xml_spans.h"

namespace collision_hulls {
namespace {

std::string withoutVisuals(const std::string& urdf, const std::string& path) try {
  const XmlOutline outline = scanXml(urdf);
  std::string text;
  std::size_t done = 0;  // up to where the text is copied or left out
  for (const XmlElement& element : outline.elements) {
    if (element.name != "visual" || element.begin < done) continue;  // the latter lies in another
    text.append(urdf, done, element.begin - done);
    done = element.end;
  }
  return text.append(urdf, done, std::string::npos);
} catch (const XmlSyntaxError& error) {
  throw Error(ErrorCode::kNotARobot, "'" + path + "', line " + std::to_string(lineOf(urdf, error.offset())) + ": " + error.what());
}

void addPackages(const std::string& urdf, const PackageFinder& find_package, dart::utils::DartLoader& loader) {
  const std::string scheme = "package://";
  for (std::size_t at = 0; (at = urdf.find(scheme, at)) != std::string::npos;) {
    at += scheme.size();
    const std::string package = urdf.substr(at, urdf.find('/', at) - at);
    if (const auto folder = find_package(package)) loader.addPackageDirectory(package, *folder);
  }
}

}  // namespace

dart::dynamics::SkeletonPtr loadRobot(const std::string& urdf, const std::string& path, const PackageFinder& find_package) {
  const std::string text = withoutVisuals(urdf, path);
  dart::utils::DartLoader loader;
  addPackages(text, find_package, loader);
  dart::dynamics::SkeletonPtr robot = loader.parseSkeletonString(text, dart::common::Uri::createFromPath(path));
  if (!robot) throw Error(ErrorCode::kNotARobot, "'" + path + "': DART cannot load this robot; see DART's messages for the reason");
  return robot;
}

}  // namespace collision_hulls
