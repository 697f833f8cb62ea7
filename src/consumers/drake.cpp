// Drake's URDF parser makes a geometry::Convex of a <mesh> with <drake:declare_convex/> (multibody/parsing/detail_urdf_geometry.cc). The
// description is otherwise the same, byte for byte.
#include "consumers/written_model.h"
#include "storage/names.h"

namespace collision_hulls {

ConsumerFiles drakeFiles(const WrittenModel& model) {
  return {{"urdf/" + robotFileName(model.robot().name) + "_drake.urdf",
           withMarkedHulls(model, "", "<drake:declare_convex/>", " xmlns:drake=\"http://drake.mit.edu\"")}};
}

}  // namespace collision_hulls
