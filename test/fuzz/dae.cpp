// Collada up to the point where Assimp gets a document of our own: the check of its tree.
#include <algorithm>
#include <cstddef>

#include "decode/collada/collada.h"
#include "fuzz/target.h"

namespace collision_hulls::fuzz {
namespace {

/// Of the whole scene.
std::size_t trianglesOf(const ColladaScene& scene) {
  std::size_t sum = 0;
  for (const ColladaInstance& instance : scene.instances) sum += scene.shapes[instance.shape].triangles;
  return sum;
}

void takeDae(const std::string& bytes) {
  const ColladaScene scene = readCollada(bytes, "input.dae", 100'000, {});
  for (const ColladaInstance& instance : scene.instances) expect(instance.shape < scene.shapes.size(), "instances are of shapes");
  for (const ColladaShape& shape : scene.shapes) {
    const auto count = static_cast<int>(shape.points.size());
    for (const int corner : shape.corners) expect(corner >= 0 && corner < count, "corners are points");
  }
  const ColladaScene again = readCollada(scene.canonical, "canonical.dae", 100'000, {});
  const auto has_surface = [&](const ColladaInstance& instance) { return scene.shapes[instance.shape].triangles > 0; };
  const auto instances = std::count_if(scene.instances.begin(), scene.instances.end(), has_surface);
  expect(static_cast<std::ptrdiff_t>(again.instances.size()) == instances, "the canonical document has the same instances");
  expect(trianglesOf(again) == trianglesOf(scene), "the canonical document has the same triangles");
}

const Registered kDae("dae", takeDae);

}  // namespace
}  // namespace collision_hulls::fuzz
