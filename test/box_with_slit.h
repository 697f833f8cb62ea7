// A solid whose crack is as wide as one likes.
#pragma once

#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {
namespace test_shapes {

/// A box [-1, 2] x [-1, 1] x [-1, 0] with a slit along the x axis in its top, a crack if it is narrow.
inline TriangleMesh boxWithSlit(double half_width) {
  enum { kStart, kFirst, kSecond, kEnd, kThird, kFourth, kA, kB, kC, kD, kE, kF, kG, kH };
  return {{{0, 0, 0},
           {0.02, -half_width, 0},
           {0.97, -half_width, 0},
           {1, 0, 0},
           {0.98, half_width, 0},
           {0.01, half_width, 0},
           {-1, -1, 0},
           {2, -1, 0},
           {2, 1, 0},
           {-1, 1, 0},
           {-1, -1, -1},
           {2, -1, -1},
           {2, 1, -1},
           {-1, 1, -1}},
          {{kA, kB, kSecond},     {kA, kSecond, kFirst}, {kA, kFirst, kStart},  {kB, kEnd, kSecond}, {kC, kD, kFourth},
           {kC, kFourth, kThird}, {kC, kThird, kEnd},    {kD, kStart, kFourth}, {kD, kA, kStart},    {kB, kC, kEnd},
           {kE, kF, kB},          {kE, kB, kA},          {kF, kG, kC},          {kF, kC, kB},        {kG, kH, kD},
           {kG, kD, kC},          {kH, kE, kA},          {kH, kA, kD},          {kE, kG, kF},        {kE, kH, kG}}};
}

}  // namespace test_shapes
}  // namespace collision_hulls
