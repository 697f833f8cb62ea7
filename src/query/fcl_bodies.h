// How this room puts bodies and questions to FCL: what fcl_queries, query_body and query_model have in common. For them and for benchmarks.
#pragma once

#include <fcl/config.h>
// FCL 0.6 and 0.7 agree in everything used here; 0.5 has a different Convex (plane arrays instead of a face array) and no scalar type.
#if FCL_MAJOR_VERSION == 0 && FCL_MINOR_VERSION < 6
#error "collision_hulls needs FCL 0.6 or newer; on Ubuntu 20.04 that is the package ros-noetic-fcl or a build from source"
#endif
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/distance_request.h>

#include <Eigen/Geometry>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "base/left_behind.h"
#include "collision_hulls/control.h"
#include "collision_hulls/error.h"
#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/query/query_body.h"

namespace collision_hulls {

/// Lengths are multiplied by this for FCL, whose thresholds are absolute; a power of two, so that nothing is rounded.
constexpr double kFclEnlarged = 1024;

/// Of enlarged distances. libccd's default, 1e-6, is off by up to 5e-4 near contact.
constexpr double kFclDistanceTolerance = 1e-9;

std::vector<Eigen::Vector3d> enlarged(std::vector<Eigen::Vector3d> points, double factor = kFclEnlarged);
Eigen::Isometry3d enlarged(Eigen::Isometry3d pose);

/// A hull as FCL's Convex.
std::shared_ptr<fcl::Convexd> fclConvex(const ConvexHull& hull, double factor = kFclEnlarged);

std::vector<fcl::Triangle> fclTriangles(const std::vector<Triangle>& triangles);

/// FCL's own boxes. FCL asks for each node's, so that what a look throws ends its building.
template <typename Box>
class OwnBoxes : public fcl::detail::BVFitter<Box> {
 public:
  OwnBoxes(const std::vector<Eigen::Vector3d>&, const std::vector<fcl::Triangle>&, const RunControl& control) : control_(control) {}
  Box fit(unsigned int* indices, int count) override {
    control_.check();
    return fcl::detail::BVFitter<Box>::fit(indices, count);
  }

 private:
  const RunControl& control_;
};

/// FCL's tree over triangles, with the boxes of a Fitter made from (vertices, triangles, control). Throws kInternal if FCL refuses them,
/// std::bad_alloc, and kCancelled: of a large mesh even while FCL makes room for the tree, which it does in one go.
template <typename Box, typename Fitter = OwnBoxes<Box>>
std::shared_ptr<fcl::BVHModel<Box>> fclTree(const std::vector<Eigen::Vector3d>& vertices, std::vector<fcl::Triangle> triangles,
                                            double factor = kFclEnlarged, const RunControl& control = {}) {
  constexpr std::size_t kMany = 100'000;  // triangles for which FCL takes a tenth of a second or more
  const std::size_t count = triangles.size();
  auto work = [points = enlarged(vertices, factor), triangles = std::move(triangles)](const RunControl& control) mutable {
    auto model = std::make_shared<fcl::BVHModel<Box>>();
    model->bv_fitter = std::make_shared<Fitter>(points, triangles, control);
    const auto expectOk = [count = triangles.size()](int answer) {
      if (answer == fcl::BVH_ERR_MODEL_OUT_OF_MEMORY) throw std::bad_alloc();
      if (answer != fcl::BVH_OK) throw Error(ErrorCode::kInternal, "FCL rejected a mesh of " + std::to_string(count) + " triangles");
    };
    expectOk(model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size())));
    expectOk(model->addSubModel(points, triangles));
    // FCL has its own copies, and the tree is large. (An empty list, = {}, would keep the memory.)
    points = std::vector<Eigen::Vector3d>();
    triangles = std::vector<fcl::Triangle>();
    control.check();
    expectOk(model->endModel());
    model->bv_fitter.reset();  // which refers to the control
    return model;
  };
  return count < kMany ? work(control) : orLeftBehind(std::move(work), control);
}

fcl::DistanceRequestd distanceRequest(bool nearest_points);
fcl::CollisionRequestd contactRequest();

/// Returns what `query` does; turns what FCL throws into an Error.
template <typename Query>
auto answered(const Query& query) -> decltype(query()) {
  try {
    return query();
  } catch (const std::exception& error) {
    throw Error(ErrorCode::kInternal, std::string("FCL could not compare two bodies (") + error.what() +
                                          "); move one of them a little, or count them as touching");
  }
}

struct QueryBody::Impl {
  std::shared_ptr<fcl::CollisionGeometryd> geometry;
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  // [m] the geometry's pose in the body's frame
};

}  // namespace collision_hulls
