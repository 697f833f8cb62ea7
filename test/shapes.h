// Closed-form shapes for the tests of all rooms. Closed shapes are watertight, welded and outward; lengths in metres.
//
// Each shape takes `n`, the number of pieces that every edge of the coarse shape is divided into (one triangle becomes n * n), or, if it is
// round, its numbers of segments.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "collision_hulls/geometry/triangle_mesh.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {
namespace test_shapes {

constexpr double kPi = 3.14159265358979323846;

/// Collects triangles by position; equal positions (to 1e-9 m) become one vertex.
class MeshBuilder {
 public:
  int vertex(const Eigen::Vector3d& p) {
    const std::array<long long, 3> key{std::llround(p.x() * 1e9), std::llround(p.y() * 1e9), std::llround(p.z() * 1e9)};
    const auto found = index_.emplace(key, static_cast<int>(mesh_.vertices.size()));
    if (found.second) mesh_.vertices.push_back(p);
    return found.first->second;
  }
  void triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const Triangle t{vertex(a), vertex(b), vertex(c)};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh_.triangles.push_back(t);
  }
  void quad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }
  const TriangleMesh& mesh() const { return mesh_; }

 private:
  TriangleMesh mesh_;
  std::map<std::array<long long, 3>, int> index_;
};

/// Points, represented as repair() leaves triangles that shrink to a point.
inline std::vector<Segment> loosePoints(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Segment> result;
  for (const Eigen::Vector3d& p : points) result.push_back({p, p});
  return result;
}

/// Every triangle divided into n * n equal ones.
inline TriangleMesh subdivided(const TriangleMesh& mesh, int n) {
  if (n <= 1) return mesh;
  MeshBuilder builder;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d origin = mesh.corner(static_cast<int>(t), 0);
    const Eigen::Vector3d u = (mesh.corner(static_cast<int>(t), 1) - origin) / n;
    const Eigen::Vector3d v = (mesh.corner(static_cast<int>(t), 2) - origin) / n;
    const auto at = [&](int i, int j) -> Eigen::Vector3d { return origin + i * u + j * v; };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        builder.triangle(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < n) builder.triangle(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  return builder.mesh();
}

/// Several meshes as one, not welded to each other.
inline TriangleMesh merged(const std::vector<TriangleMesh>& parts) {
  TriangleMesh all;
  for (const TriangleMesh& part : parts) append(all, part);
  return all;
}

inline TriangleMesh moved(TriangleMesh mesh, const Eigen::Vector3d& offset) {
  for (Eigen::Vector3d& v : mesh.vertices) v += offset;
  return mesh;
}

/// An outline (counter-clockwise, in x and y) with its triangulation, extruded along z from 0 to `height`.
inline TriangleMesh prism(const std::vector<Eigen::Vector2d>& outline, const std::vector<Triangle>& cap, double height) {
  const auto at = [&](std::size_t i, double z) { return Eigen::Vector3d(outline[i].x(), outline[i].y(), z); };
  MeshBuilder builder;
  for (const Triangle& t : cap) {
    const auto a = static_cast<std::size_t>(t[0]), b = static_cast<std::size_t>(t[1]), c = static_cast<std::size_t>(t[2]);
    builder.triangle(at(a, height), at(b, height), at(c, height));
    builder.triangle(at(a, 0), at(c, 0), at(b, 0));
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t j = (i + 1) % outline.size();
    builder.quad(at(i, 0), at(j, 0), at(j, height), at(i, height));
  }
  return builder.mesh();
}

/// [0, x] x [0, y] x [0, z]; 12 n^2 triangles.
inline TriangleMesh box(double x, double y, double z, int n = 1) {
  return subdivided(prism({{0, 0}, {x, 0}, {x, y}, {0, y}}, {{0, 1, 2}, {0, 2, 3}}, z), n);
}

/// Two walls of thickness t along the x and y axes, each `leg` long and `height` high in z; 20 n^2 triangles. Volume (2 leg t - t^2)
/// height; its hull protrudes by (leg - t) / 2.
inline TriangleMesh lBracket(double leg = 1, double t = 0.1, double height = 1, int n = 1) {
  const std::vector<Eigen::Vector2d> outline{{0, 0}, {leg, 0}, {leg, t}, {t, t}, {t, leg}, {0, leg}};
  return subdivided(prism(outline, {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}}, height), n);
}

/// A floor along x and two walls along y, all of thickness t; `height` in z; 28 n^2 triangles. Its hull protrudes by min(width / 2 - t,
/// depth - t).
inline TriangleMesh uChannel(double width = 1, double depth = 1, double t = 0.1, double height = 2, int n = 1) {
  const std::vector<Eigen::Vector2d> outline{{0, 0},         {width, 0}, {width, depth}, {width - t, depth},
                                             {width - t, t}, {t, t},     {t, depth},     {0, depth}};
  return subdivided(prism(outline, {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}, {0, 5, 6}, {0, 6, 7}}, height), n);
}

/// A cube-like box of outer size x, y, z and wall thickness t, open at the top; 28 n^2 triangles.
/// Volume x y z - (x - 2 t) (y - 2 t) (z - t).
inline TriangleMesh openBox(double x = 1, double y = 1, double z = 1, double t = 0.05, int n = 1) {
  const auto corner = [&](double inset, std::size_t k, double height) {
    const bool right = k == 1 || k == 2, back = k >= 2;
    return Eigen::Vector3d(right ? x - inset : inset, back ? y - inset : inset, height);
  };
  MeshBuilder builder;
  builder.quad(corner(0, 0, 0), corner(0, 3, 0), corner(0, 2, 0), corner(0, 1, 0));
  builder.quad(corner(t, 0, t), corner(t, 1, t), corner(t, 2, t), corner(t, 3, t));
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t l = (k + 1) % 4;
    builder.quad(corner(0, k, 0), corner(0, l, 0), corner(0, l, z), corner(0, k, z));
    builder.quad(corner(t, l, t), corner(t, k, t), corner(t, k, z), corner(t, l, z));
    builder.quad(corner(0, k, z), corner(0, l, z), corner(t, l, z), corner(t, k, z));
  }
  return subdivided(builder.mesh(), n);
}

/// Around the z axis; 2 * around * across triangles, corners on the torus.
inline TriangleMesh torus(double ring = 1, double tube = 0.3, int around = 32, int across = 16) {
  const auto at = [&](int i, int j) {
    const double a = 2 * kPi * (i % around) / around, b = 2 * kPi * (j % across) / across;
    const double r = ring + tube * std::cos(b);
    return Eigen::Vector3d(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
  };
  MeshBuilder builder;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) builder.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  return builder.mesh();
}

/// A subdivided icosahedron, corners on the sphere about the origin; 20 n^2 triangles, 10 n^2 + 2 vertices.
inline TriangleMesh sphere(double radius = 1, int n = 4) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2}, {3, 2, 6}, {3, 6, 8},  {3, 8, 9},   {4, 9, 5}, {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  mesh = subdivided(mesh, n);
  for (Eigen::Vector3d& v : mesh.vertices) v = radius * v.normalized();
  return mesh;
}

/// Four unit spheres at the corners of a square, not touching.
inline TriangleMesh fourSpheres(int n = 3) {
  const TriangleMesh one = sphere(1, n);
  return merged({moved(one, {-2, -2, 0}), moved(one, {2, -2, 0}), moved(one, {2, 2, 0}), moved(one, {-2, 2, 0})});
}

/// A disc in x and y with a bore and `holes` round holes on a circle between bore and rim, from z = 0 to thickness. Each hole has 4 *
/// quarter segments; `rings` counts the rings between a hole and its sector's border. Genus holes + 1.
inline TriangleMesh flange(int holes = 6, double bore = 0.4, double rim = 1, double hole_radius = 0.12, double thickness = 0.15,
                           int quarter = 4, int rings = 2) {
  const double middle = (bore + rim) / 2, half = kPi / holes;
  const auto border = [&](int k) {  // k-th point of a sector's border in (angle, radius), counter-clockwise from the bore
    const int side = k / quarter % 4;
    const double s = 2.0 * (k % quarter) / quarter - 1;
    const double a = side == 0 ? -s : side == 1 ? -1 : side == 2 ? s : 1;
    const double r = side == 0 ? -1 : side == 1 ? s : side == 2 ? 1 : -s;
    return Eigen::Vector2d(a * half, middle + r * (rim - bore) / 2);
  };
  MeshBuilder builder;
  for (int h = 0; h < holes; ++h) {
    const double turn = 2 * half * h;
    const auto at = [&](int k, int ring, double z) {
      const Eigen::Vector2d polar = border(k), centre(middle, 0);
      const Eigen::Vector2d out(polar.y() * std::cos(polar.x()), polar.y() * std::sin(polar.x()));
      const Eigen::Vector2d in = centre + hole_radius * (out - centre).normalized();
      const Eigen::Vector2d p = Eigen::Rotation2Dd(turn) * (in + (out - in) * ring / rings);
      return Eigen::Vector3d(p.x(), p.y(), z);
    };
    for (int k = 0; k < 4 * quarter; ++k) {
      for (int ring = 0; ring < rings; ++ring) {
        builder.quad(at(k, ring, thickness), at(k, ring + 1, thickness), at(k + 1, ring + 1, thickness), at(k + 1, ring, thickness));
        builder.quad(at(k, ring, 0), at(k + 1, ring, 0), at(k + 1, ring + 1, 0), at(k, ring + 1, 0));
      }
      builder.quad(at(k + 1, 0, 0), at(k, 0, 0), at(k, 0, thickness), at(k + 1, 0, thickness));
      const bool on_bore = k / quarter == 0, on_rim = k / quarter == 2;
      if (on_bore || on_rim) {
        builder.quad(at(k, rings, 0), at(k + 1, rings, 0), at(k + 1, rings, thickness), at(k, rings, thickness));
      }
    }
  }
  return builder.mesh();
}

/// A flat open sheet [0, x] x [0, y] at z = 0, facing +z; 2 n^2 triangles.
inline TriangleMesh sheet(double x = 1, double y = 1, int n = 1) {
  MeshBuilder builder;
  builder.quad({0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0});
  return subdivided(builder.mesh(), n);
}

/// A pipe without thickness along z: the side of a cylinder, without its ends.
inline TriangleMesh pipe(double radius, double length, int segments) {
  MeshBuilder builder;
  const auto at = [&](int i, double z) {
    const double angle = 2 * kPi * (i % segments) / segments;
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  for (int i = 0; i < segments; ++i) builder.quad(at(i, 0), at(i + 1, 0), at(i + 1, length), at(i, length));
  return builder.mesh();
}

/// One triangle in the plane z = 0, facing +z, of area 1/2.
inline TriangleMesh singleTriangle() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
}

/// The solid angles of all triangles (Van Oosterom & Strackee), divided by 4 pi.
inline double winding(const TriangleMesh& mesh, const Eigen::Vector3d& p) {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Eigen::Vector3d a = mesh.corner(t, 0) - p, b = mesh.corner(t, 1) - p, c = mesh.corner(t, 2) - p;
    sum +=
        2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() + b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return sum / (4 * kPi);
}

}  // namespace test_shapes
}  // namespace collision_hulls
