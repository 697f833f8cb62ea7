// How a consumer loads its file: a line for each, printed below that of ROS, whose description is for some of them the wrong one.
#include <filesystem>

#include "collision_hulls/consumers/consumers.h"
#include "pipeline/collision_model.h"
#include "storage/names.h"
#include "storage/replace_folder.h"

namespace collision_hulls {

namespace fs = std::filesystem;

namespace {

/// The file, and what is done with it.
std::string wayOf(Consumer consumer, const RobotResult& result, const fs::path& place) {
  const Options& options = result.report.options;
  const std::string package = outputPackage(options, place.string()), folder = place.string() + "/",
                    robot = robotFileName(result.robot_name);
  const std::string instead = " in place of " + urdfFile(result.robot_name);
  switch (consumer) {
    case Consumer::kMoveit: return folder + "config/" + robot + ".srdf, whose elements go into your SRDF";
    case Consumer::kGazebo:
      return folder + "model.sdf, as model://" + package + " with " + place.parent_path().string() + " in GZ_SIM_RESOURCE_PATH";
    case Consumer::kMujoco: return folder + "mjcf/" + robot + ".xml, by mujoco.MjModel.from_xml_path()";
    case Consumer::kDrake:
      return folder + "urdf/" + robot + "_drake.urdf" + instead + ", by Parser::AddModels()" +
             (options.uri == UriStyle::kPackage ? " after package_map().AddPackageXml(\"" + folder + "package.xml\")" : "");
    case Consumer::kIsaac: return folder + "usd/" + robot + ".usda, each prim referenced under that of its link";
    case Consumer::kTesseract: return folder + "urdf/" + robot + "_tesseract.urdf" + instead;
    case Consumer::kCurobo:
      return folder + "config/" + robot + "_spheres.yml, which goes into the kinematics section of your configuration";
    case Consumer::kDart: return folder + "skel/" + robot + ".skel, by dart::utils::SkelParser::readWorld()";
    case Consumer::kBullet: return folder + urdfFile(result.robot_name) + ", by loadURDF()";
  }
  return "";
}

}  // namespace

std::string howToLoad(const std::vector<Consumer>& consumers, const RobotResult& result, const std::string& output) {
  const fs::path place = replacedFolder(output);
  std::string lines;
  for (const Consumer consumer : consumers) lines += "For " + std::string(name(consumer)) + ": " + wayOf(consumer, result, place) + "\n";
  return lines;
}

}  // namespace collision_hulls
