// Perturbations, which move vertices but keep the shape, are here; defects are in defects.cpp. Each kind draws from its own random stream.
#include "bench/stability/trouble.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "bench/stability/defects.h"
#include "collision_hulls/error.h"
#include "geometry/pi.h"

namespace collision_hulls {

namespace {

using Kind = TroubleKind;

/// The kinds with their names, in order.
const std::vector<std::pair<Kind, const char*>>& kinds() {
  static const std::vector<std::pair<Kind, const char*>> all{{Kind::kNone, "none"},
                                                             {Kind::kRotation, "rotation"},
                                                             {Kind::kJitter, "jitter"},
                                                             {Kind::kScale, "scale"},
                                                             {Kind::kFar, "far"},
                                                             {Kind::kRetessellation, "retessellation"},
                                                             {Kind::kShuffle, "shuffle"},
                                                             {Kind::kUnwelded, "unwelded"},
                                                             {Kind::kDuplicate, "duplicate"},
                                                             {Kind::kFlipped, "flipped"},
                                                             {Kind::kZeroArea, "zero_area"},
                                                             {Kind::kSliver, "sliver"},
                                                             {Kind::kDecimation, "decimation"},
                                                             {Kind::kHole, "hole"},
                                                             {Kind::kFin, "fin"},
                                                             {Kind::kSelfCrossing, "self_crossing"},
                                                             {Kind::kNested, "nested"},
                                                             {Kind::kManyComponents, "many_components"},
                                                             {Kind::kOneTriangle, "one_triangle"},
                                                             {Kind::kNan, "nan"}};
  return all;
}

TriangleMesh rotated(TriangleMesh mesh, double degrees, Random& random) {
  const Eigen::Vector3d middle = boundingBox(mesh).center();
  const Eigen::AngleAxisd turn(degrees * kPi / 180, random.direction());
  for (Eigen::Vector3d& v : mesh.vertices) v = middle + turn * (v - middle);
  return mesh;
}

TriangleMesh jittered(TriangleMesh mesh, double reach, Random& random) {
  for (Eigen::Vector3d& v : mesh.vertices)
    for (int axis = 0; axis < 3; ++axis) v[axis] += random.uniform(-reach, reach);
  return mesh;
}

TriangleMesh movedFar(TriangleMesh mesh, double distance, Random& random) {
  const Eigen::Vector3d offset = distance * random.direction();
  for (Eigen::Vector3d& v : mesh.vertices) v += offset;
  return mesh;
}

/// Splits each triangle into four; neighbours share the midpoints of their edges.
TriangleMesh retessellated(const TriangleMesh& mesh) {
  TriangleMesh result{mesh.vertices, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(result.vertices.size()));
    if (fresh) result.vertices.push_back((mesh.vertices[static_cast<std::size_t>(a)] + mesh.vertices[static_cast<std::size_t>(b)]) / 2);
    return place->second;
  };
  for (const Triangle& t : mesh.triangles) {
    const int a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
    for (const Triangle& part : {Triangle{t[0], a, c}, Triangle{a, t[1], b}, Triangle{c, b, t[2]}, Triangle{a, b, c}})
      result.triangles.push_back(part);
  }
  return result;
}

template <typename T>
void shuffle(std::vector<T>& items, Random& random) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random.below(i)]);
}

TriangleMesh shuffled(const TriangleMesh& mesh, Random& random) {
  std::vector<int> order(mesh.vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  shuffle(order, random);
  TriangleMesh result = mesh;
  for (std::size_t i = 0; i < order.size(); ++i) result.vertices[static_cast<std::size_t>(order[i])] = mesh.vertices[i];
  for (Triangle& t : result.triangles) {
    for (int& corner : t) corner = order[static_cast<std::size_t>(corner)];
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.below(3)), t.end());
  }
  shuffle(result.triangles, random);
  return result;
}

}  // namespace

const char* name(TroubleKind kind) {
  const auto found = std::find_if(kinds().begin(), kinds().end(), [&](const auto& known) { return known.first == kind; });
  return found == kinds().end() ? "unknown" : found->second;
}

std::optional<TroubleKind> troubleNamed(const std::string& text) {
  for (const auto& [kind, known] : kinds())
    if (text == known) return kind;
  return std::nullopt;
}

const std::vector<Trouble>& usualTroubles() {
  static const std::vector<Trouble> troubles{{Kind::kNone, 0},
                                             {Kind::kRotation, 10},
                                             {Kind::kRotation, 77},
                                             {Kind::kJitter, 1e-7},
                                             {Kind::kJitter, 1e-6},
                                             {Kind::kJitter, 1e-5},
                                             {Kind::kJitter, 1e-4},
                                             {Kind::kJitter, 1e-3},
                                             {Kind::kScale, 1e-3},
                                             {Kind::kScale, 1e3},
                                             {Kind::kFar, 10},
                                             {Kind::kFar, 1e3},
                                             {Kind::kShuffle, 1},
                                             {Kind::kRetessellation, 4},
                                             {Kind::kUnwelded, 1},
                                             {Kind::kDuplicate, 1.0 / 3},
                                             {Kind::kFlipped, 1.0 / 3},
                                             {Kind::kZeroArea, 0.1},
                                             {Kind::kSliver, 1e-6},
                                             {Kind::kSliver, 1e-9},
                                             {Kind::kDecimation, 0.5},
                                             {Kind::kHole, 0.02},
                                             {Kind::kHole, 0.2},
                                             {Kind::kFin, 0.02},
                                             {Kind::kSelfCrossing, 0.1},
                                             {Kind::kNested, 0.5},
                                             {Kind::kManyComponents, 200},
                                             {Kind::kOneTriangle, 1},
                                             {Kind::kNan, 1}};
  return troubles;
}

const std::vector<Trouble>& fewTroubles() {
  static const std::vector<Trouble> troubles{{Kind::kNone, 0},        {Kind::kRotation, 77}, {Kind::kJitter, 1e-5}, {Kind::kScale, 1e-3},
                                             {Kind::kFar, 10},        {Kind::kUnwelded, 1},  {Kind::kSliver, 1e-6}, {Kind::kHole, 0.02},
                                             {Kind::kOneTriangle, 1}, {Kind::kNan, 1}};
  return troubles;
}

bool keepsShape(TroubleKind kind) {
  return kind < TroubleKind::kDecimation;
}

bool isRandom(TroubleKind kind) {
  switch (kind) {
    case TroubleKind::kNone:
    case TroubleKind::kScale:
    case TroubleKind::kRetessellation:
    case TroubleKind::kUnwelded:
    case TroubleKind::kDecimation:
    case TroubleKind::kNested:
    case TroubleKind::kOneTriangle: return false;
    default: return true;
  }
}

double lengthFactor(const Trouble& trouble) {
  return trouble.kind == TroubleKind::kScale ? trouble.amount : 1;
}

TriangleMesh troubled(const TriangleMesh& mesh, const Trouble& trouble, std::uint64_t seed) {
  Random random(seed, static_cast<std::uint64_t>(trouble.kind), 0);
  switch (trouble.kind) {
    case TroubleKind::kNone: return mesh;
    case TroubleKind::kRotation: return rotated(mesh, trouble.amount, random);
    case TroubleKind::kJitter: return jittered(mesh, trouble.amount * diagonal(mesh), random);
    case TroubleKind::kScale: return scaled(mesh, Eigen::Vector3d::Constant(trouble.amount));
    case TroubleKind::kFar: return movedFar(mesh, trouble.amount * diagonal(mesh), random);
    case TroubleKind::kRetessellation: return retessellated(mesh);
    case TroubleKind::kShuffle: return shuffled(mesh, random);
    default: return defective(mesh, trouble, random);
  }
}

}  // namespace collision_hulls
