#include "base/positive_length.h"

#include <gtest/gtest.h>

#include <limits>

namespace collision_hulls {
namespace {

TEST(PositiveLength, RefusesAllOthersByName) {
  EXPECT_NO_THROW(expectPositiveLength("gap", 1e-300));
  for (const double value : {0.0, -1.0, -1e-9, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    try {
      expectPositiveLength("gap", value);
      ADD_FAILURE() << value;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadOption);
      EXPECT_EQ(std::string(error.what()), "gap is " + decimal(value) + " m; it must be a positive length");
    }
  }
}

}  // namespace
}  // namespace collision_hulls
