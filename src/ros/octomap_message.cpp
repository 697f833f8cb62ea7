// Octomaps as OctoMap publishes them. Built only where octomap_msgs is installed, which Debian does not package.
#include "octomap_message.h"

#include "collision_hulls/error.h"

namespace collision_hulls {

Octomap toOctomap(const octomap_msgs::Octomap& message) {
  const auto* bytes = reinterpret_cast<const char*>(message.data.data());
  return {message.binary != 0, message.id, message.resolution, {bytes, message.data.size()}};
}

Scene toScene(const octomap_msgs::Octomap& message, const std::string& root_link, const RunControl& control) {
  const std::string& frame = message.header.frame_id;
  if (!frame.empty() && frame != root_link && frame != "/" + root_link)
    throw Error(ErrorCode::kBadScene, "the octomap is in the frame '" + frame +
                                          "', and tf is not asked where that is: let its node publish it in the root link's, '" +
                                          root_link + "' (octomap_server: its parameter frame_id), or give a planning scene that holds it");
  Scene scene;
  addOctomap(scene, "octomap", toOctomap(message), Eigen::Isometry3d::Identity(), control);
  return scene;
}

}  // namespace collision_hulls
