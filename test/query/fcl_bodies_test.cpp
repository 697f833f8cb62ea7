#include "query/fcl_bodies.h"

#include <fcl/math/bv/OBBRSS.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "solids.h"

namespace collision_hulls {
namespace {

using Eigen::Vector3d;

TEST(Enlarged, RoundsNothing) {
  int exponent = 0;
  EXPECT_EQ(std::frexp(kFclEnlarged, &exponent), 0.5) << "no power of two";
  const Vector3d p(0.1, -1e-7, 3e5);
  EXPECT_EQ(enlarged(std::vector<Vector3d>{p}).front() / kFclEnlarged, p);
}

TEST(Enlarged, MovesAPoseAndDoesNotTurnIt) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(0.3, Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() = Vector3d(1, 2, 3);
  EXPECT_EQ(enlarged(pose).linear(), pose.linear());
  EXPECT_EQ(enlarged(pose).translation(), 1024 * pose.translation());
}

TEST(FclConvex, HasTheHullsVerticesAndTriangles) {
  const ConvexHull box = test_shapes::boxHull({0, 0, 0}, {1, 2, 3});
  const auto convex = fclConvex(box, 2);
  ASSERT_EQ(convex->getVertices().size(), box.vertices.size());
  EXPECT_EQ(convex->getVertices()[3], 2 * box.vertices[3]);
  ASSERT_EQ(convex->getFaceCount(), static_cast<int>(box.triangles.size()));
  EXPECT_EQ((std::vector<int>(convex->getFaces().begin(), convex->getFaces().begin() + 4)),
            (std::vector<int>{3, box.triangles[0][0], box.triangles[0][1], box.triangles[0][2]}));
}

TEST(FclTree, RefusesWhatFclRefuses) {
  EXPECT_THROW(fclTree<fcl::OBBRSSd>({}, {}), Error);
}

TEST(Answered, TurnsAnExceptionIntoAnErrorThatSaysWhatToDo) {
  EXPECT_EQ(answered([] { return 7; }), 7);
  try {
    answered([]() -> double { throw std::logic_error("a degenerate simplex"); });
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kInternal);
    EXPECT_NE(std::string(error.what()).find("a degenerate simplex"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace collision_hulls
