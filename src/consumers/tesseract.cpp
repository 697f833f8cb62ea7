// Tesseract's URDF parser makes a ConvexMesh of a <mesh> with tesseract:make_convex="true", by computing its hull (tesseract_urdf,
// mesh.cpp); other meshes are collided as triangles. The description is otherwise the same, byte for byte.
#include "consumers/written_model.h"
#include "storage/names.h"

namespace collision_hulls {

ConsumerFiles tesseractFiles(const WrittenModel& model) {
  return {{"urdf/" + robotFileName(model.robot().name) + "_tesseract.urdf",
           withMarkedHulls(model, " tesseract:make_convex=\"true\"", "",
                           " xmlns:tesseract=\"https://github.com/tesseract-robotics/tesseract\"")}};
}

}  // namespace collision_hulls
