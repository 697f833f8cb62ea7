// Collada up to the point where Assimp gets a document of our own: the check of its tree.
#include <cstdlib>

#include "fuzz/target.h"
#include "mesh/formats/collada.h"

namespace collision_hulls::fuzz {
namespace {

void takeDae(const std::string& bytes) {
  const ColladaScene scene = readCollada(bytes, "input.dae", 100'000, {});
  for (const ColladaInstance& instance : scene.instances) expect(instance.shape < scene.shapes.size(), "instances are of shapes");
  for (const ColladaShape& shape : scene.shapes) {
    const auto count = static_cast<int>(shape.points.size());
    for (const int corner : shape.corners) expect(corner >= 0 && corner < count, "corners are points");
  }
  const ColladaScene again = readCollada(scene.canonical, "canonical.dae", 100'000, {});
  expect(again.instances.size() == scene.instances.size(), "the canonical document has the same instances");
}

const Registered kDae("dae", takeDae);

}  // namespace
}  // namespace collision_hulls::fuzz
