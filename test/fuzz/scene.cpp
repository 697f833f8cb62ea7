// Scene files. The first byte chooses the format.
#include "collision_hulls/scene/scene.h"

#include "fuzz/target.h"

namespace collision_hulls::fuzz {
namespace {

void takeScene(const std::string& input) {
  constexpr const char* kExtensions[] = {".yaml", ".sdf", ".scene", ".bt"};
  std::string bytes = input;
  const std::string extension = kExtensions[firstOf(bytes) % 4];
  const Scene scene = readScene(fileOf(bytes, extension), {});
  for (const SceneBody& body : scene.bodies) expect(!body.name.empty() && body.pose.matrix().allFinite(), "bodies are sound");
}

const Registered kScene("scene", takeScene);

}  // namespace
}  // namespace collision_hulls::fuzz
