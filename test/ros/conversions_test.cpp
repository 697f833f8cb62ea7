#include "ros/conversions.h"

#include <gtest/gtest.h>

namespace collision_hulls {
namespace {

TEST(Summary, NamesEachFailure) {
  Report report;
  EXPECT_EQ("0 meshes, 0 hulls", summary(report));
  report.links.resize(2);
  report.links[0].hulls = 3;
  report.links[1].link = "hand";
  report.links[1].status = Status::kFailed;
  report.links[1].reason = "no such file";
  EXPECT_EQ("2 meshes, 3 hulls, 1 meshes failed:\nhand (element 0): no such file", summary(report));
  report.notes = {"mind the gap"};
  EXPECT_EQ("2 meshes, 3 hulls, 1 meshes failed:\nhand (element 0): no such file\nnote: mind the gap", summary(report));
}

TEST(ToMessage, LinkReport) {
  ElementReport report;
  report.link = "arm";
  report.element = 2;
  report.status = Status::kDegraded;
  report.reason = "capped";
  report.triangles = 12;
  report.protrusion = 0.002;
  report.seconds = {1, 2, 3, 4, 5};
  const LinkReport message = toMessage(report);
  EXPECT_EQ("arm", message.link);
  EXPECT_EQ(2, message.element);
  EXPECT_EQ("degraded", message.status);
  EXPECT_EQ("capped", message.reason);
  EXPECT_EQ(12u, message.triangles);
  EXPECT_EQ(0.002, message.protrusion);
  EXPECT_EQ(15, message.seconds);
}

}  // namespace
}  // namespace collision_hulls
