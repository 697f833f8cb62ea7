// What each choice of shapes does:
// - a single one encloses the hull of the mesh, and has the bound that it has;
// - mixed: one primitive for the whole mesh if that keeps the tolerance; otherwise hulls as always, each of which gives way to a primitive
//   that encloses it and keeps the tolerance, too;
// - primitives: the same through the hull tree, from its root down: what no primitive can stand for is left to the children, and of a leaf
//   the surface in it is divided;
// - spheres: see spheres.h.
//
// Primitives enclose hulls that cover the mesh, so they cover it as well. The bound of a cylinder includes what the polyhedron about it
// adds, which stands for it in the collision queries of the validation.
#include "pipeline/shapes/shapes.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "base/millimetres.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/decompose/round_outward.h"
#include "collision_hulls/error.h"
#include "collision_hulls/primitives/spheres.h"
#include "fit/enclosing.h"
#include "pipeline/shapes/bodies.h"
#include "primitives/surface_patch.h"

namespace collision_hulls {
namespace {

constexpr double kLeaves = 0.25;  // of the tolerance: that of the leaves of trees that are built for primitives
// Of the tolerance: how deep at least primitives for parts of the surface reach below it, and what is taken for flat.
constexpr double kDepth = 0.5, kFlatness = 0.5;
constexpr std::size_t kMostPrimitives = 10'000;  // of a mesh

/// What the stages of one mesh work with.
struct Work {
  const ReadMesh& read;
  const LinkOptions& options;
  const HullTree* tree;
  const std::string& uri;
  std::uint64_t seed;
  const RunControl& control;
  MeshResult& result;

  double tolerance() const { return result.mesh.tolerance; }
  PrimitiveOptions primitives() const {
    return {tolerance(), read.margin, {PrimitiveKind::kSphere, PrimitiveKind::kBox, PrimitiveKind::kCylinder}, kAroundRound};
  }
};

std::optional<Body> primitiveFor(const ConvexHull& hull, const Work& work) {
  RunControl part;
  part.whole = &work.control;
  const std::optional<CertifiedPrimitive> found = coveringPrimitive(hull, *work.result.solid, work.primitives(), part);
  if (!found) return std::nullopt;
  return Body{found->primitive, {}, found->bound, found->found, found->where, found->nearest};
}

ConvexHull hullOfMesh(const Work& work) {
  return roundOutward({convexHull(work.result.original.vertices, work.control)}, work.result.original, work.read.margin, 0, work.control)
      .hulls.front();
}

/// The one that is asked for by name.
Body single(const Work& work) {
  const PrimitiveKind kind = primitiveKindNamed(name(work.options.shapes)).value();
  return bodyOf(primitiveOfKind(kind, hullOfMesh(work), *work.result.solid, work.primitives(), work.control));
}

/// Of each hull a primitive that keeps the tolerance, or nothing.
std::vector<std::optional<Body>> primitivesFor(const std::vector<ConvexHull>& hulls, const Work& work) {
  std::vector<std::optional<Body>> bodies(hulls.size());
  forEach(hulls.size(), [&](std::size_t i) { bodies[i] = primitiveFor(hulls[i], work); });
  return bodies;
}

/// The hulls of decomposeAndCertify(), with what it proved of all of them.
std::vector<Body> mixed(const Work& work) {
  decomposeHulls(work.read, work.options, work.tree, work.uri, work.seed, work.control, work.result);
  const HullFacts& all = work.result.model;
  const std::vector<std::optional<Body>> primitives = primitivesFor(work.result.hulls, work);
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < primitives.size(); ++i)
    bodies.push_back(primitives[i].value_or(
        Body{std::nullopt, work.result.hulls[i], all.protrusion, all.protrusion_found, all.worst, all.worst_nearest}));
  return bodies;
}

/// The primitive about a hull that reaches least far, though no further than it has to.
Body leastPrimitive(const ConvexHull& hull, const Work& work) {
  std::optional<Body> best;
  for (const PrimitiveKind kind : work.primitives().kinds) {
    Body body = bodyOf(primitiveOfKind(kind, hull, *work.result.solid, work.primitives(), work.control));
    if (!best || body.bound < best->bound) best = std::move(body);
  }
  return *std::move(best);
}

/// The coarsest cut through the tree whose hulls have primitives, but for leaves that have none.
std::vector<ConvexHull> hullsWithPrimitives(const Work& work) {
  const std::vector<HullNode>& nodes = work.tree->nodes;
  std::vector<ConvexHull> chosen;
  std::vector<int> level{static_cast<int>(nodes.size()) - 1}, below;
  for (; !level.empty(); level = std::exchange(below, {})) {
    std::vector<ConvexHull> hulls;
    for (const int node : level) hulls.push_back(nodes[static_cast<std::size_t>(node)].hull);
    const std::vector<std::optional<Body>> found = primitivesFor(hulls, work);
    for (std::size_t i = 0; i < level.size(); ++i) {
      const HullNode& node = nodes[static_cast<std::size_t>(level[i])];
      if (found[i] || node.left < 0)
        chosen.push_back(hulls[i]);
      else
        below.insert(below.end(), {node.left, node.right});
    }
  }
  return chosen;
}

/// A primitive about a patch, as deep as the tolerance allows: what stays empty below it, a body could lie in unseen.
std::optional<Body> primitiveFor(const SurfacePatch& patch, double depth, const Work& work) {
  std::optional<Body> deepest = primitiveFor(patch.hull(depth), work);
  const double most = diagonal(work.result.original);
  for (std::optional<Body> deeper = deepest; deeper && depth < most; deeper = primitiveFor(patch.hull(depth *= 2), work)) deepest = deeper;
  return deepest;
}

/// Bodies for the surface in hulls that no primitive stands for: it is divided until primitives about the parts keep the tolerance, or are
/// too many.
void addPrimitives(const std::vector<ConvexHull>& hulls, const Work& work, std::vector<Body>& bodies) {
  const double depth = kDepth * work.tolerance(), flatness = kFlatness * work.tolerance();
  std::vector<SurfacePatch> patches, next;
  for (const ConvexHull& hull : hulls) patches.emplace_back(work.result.original, hull);
  std::size_t seen = 0;  // bodies that no patch holds anything of
  for (; !patches.empty(); patches = std::exchange(next, {})) {
    std::vector<std::optional<Body>> found(patches.size());
    std::vector<std::array<SurfacePatch, 2>> parts(patches.size());
    const bool too_many = bodies.size() + patches.size() > kMostPrimitives;
    forEach(patches.size(), [&](std::size_t i) {
      work.control.check();
      for (std::size_t body = seen; body < bodies.size(); ++body) patches[i].dropWithin(*bodies[body].primitive);
      if (patches[i].empty()) return;
      found[i] = primitiveFor(patches[i], depth, work);
      if (!found[i] && too_many) found[i] = leastPrimitive(patches[i].hull(depth), work);
      if (found[i]) return;
      parts[i] = patches[i].parts(flatness, depth);
      if (parts[i][0].empty() || parts[i][1].empty()) found[i] = leastPrimitive(patches[i].hull(depth), work), parts[i] = {};
    });
    seen = bodies.size();
    for (std::size_t i = 0; i < patches.size(); ++i) {
      if (found[i]) bodies.push_back(*std::move(found[i]));
      for (SurfacePatch& part : parts[i])
        if (!part.empty()) next.push_back(std::move(part));
    }
  }
}

/// Primitives about hulls that cover the mesh as it was read.
std::vector<Body> primitives(const Work& work) {
  const std::vector<ConvexHull> hulls =
      roundOutward(hullsWithPrimitives(work), work.result.original, work.read.margin, 0, work.control).hulls;
  expectCovered(work.result.original, hulls, work.uri, work.control);
  std::vector<Body> bodies;
  std::vector<ConvexHull> others;
  const std::vector<std::optional<Body>> found = primitivesFor(hulls, work);
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    if (found[i])
      bodies.push_back(*found[i]);
    else
      others.push_back(hulls[i]);
  }
  addPrimitives(others, work, bodies);
  return bodies;
}

std::vector<Body> spheres(const Work& work) {
  SphereOptions options;
  options.tolerance = work.tolerance();
  options.effort = work.options.effort;
  if (work.options.max_hulls > 0) options.max_spheres = static_cast<std::size_t>(work.options.max_hulls);
  const MeshResult& result = work.result;
  const CertifiedSpheres made =
      certifiedSpheres({result.original, work.read.repaired, *result.solid, work.read.margin, nullptr, work.uri}, options, work.control);
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < made.spheres.size(); ++i) {
    const Sphere& sphere = made.spheres[i];
    Primitive primitive{PrimitiveKind::kSphere, {sphere.radius, 0, 0}, Eigen::Isometry3d(Eigen::Translation3d(sphere.centre))};
    bodies.push_back({primitive, {}, made.bounds[i], 0, sphere.centre, sphere.centre});
  }
  work.result.reason = made.reason;
  return bodies;
}

std::vector<Body> bodiesFor(const Work& work) {
  const Shapes shapes = work.options.shapes;
  if (isSingle(shapes)) return {single(work)};
  if (shapes == Shapes::kSpheres) return spheres(work);
  if (const std::optional<Body> one = primitiveFor(hullOfMesh(work), work)) return {*one};
  return shapes == Shapes::kMixed ? mixed(work) : primitives(work);
}

/// A bound on all of the bodies, closer than it took to accept each of them.
double closeBound(const std::vector<Body>& bodies, const CertifiedPrimitive& of_primitives) {
  double hulls = 0, each = 0;
  for (const Body& body : bodies) (body.primitive ? each : hulls) = std::max(body.primitive ? each : hulls, body.bound);
  return std::max(hulls, std::min(each, of_primitives.bound));
}

/// Of all bodies. Of spheres only the bounds are known so far; the one that reaches furthest has its place searched.
Protrusion proofOf(const std::vector<Body>& bodies, const Work& work) {
  const auto further = [](const Body& a, const Body& b) { return a.bound < b.bound; };
  const Body& worst = *std::max_element(bodies.begin(), bodies.end(), further);
  Protrusion proof{worst.bound, worst.found, worst.where, worst.nearest};
  const auto see = [&](const auto& seen) {
    if (seen.found > proof.found) proof.found = seen.found, proof.where = seen.where, proof.nearest = seen.nearest;
  };
  for (const Body& body : bodies) see(body);
  std::vector<Primitive> primitives;
  for (const Body& body : bodies)
    if (body.primitive) primitives.push_back(*body.primitive);
  if (work.options.shapes == Shapes::kSpheres) {
    see(certificate(*worst.primitive, *work.result.solid, work.read.margin, work.tolerance(), work.control));
  } else if (!isSingle(work.options.shapes) && !primitives.empty()) {
    const CertifiedPrimitive closer = certificate(primitives, *work.result.solid, work.primitives(), work.control);
    proof.bound = closeBound(bodies, closer);
    see(closer);
  }
  return proof;
}

std::string subject(Shapes shapes) {
  if (isSingle(shapes)) return "the " + std::string(name(shapes)) + " protrudes";
  return shapes == Shapes::kMixed ? "the hulls and primitives protrude" : "the " + std::string(name(shapes)) + " protrude";
}

std::string excuse(const Work& work) {
  if (isSingle(work.options.shapes))
    return "a single " + std::string(name(work.options.shapes)) + " does not fit better; take other shapes";
  if (work.options.shapes == Shapes::kPrimitives) return "no primitive fits better there; take shapes 'mixed', or a larger tolerance";
  return "take a larger tolerance";
}

}  // namespace

double treeLeaves(const LinkOptions& options, double diagonal) {
  const double tolerance = options.tolerance.metres(diagonal);
  return std::min(tolerance, options.tree ? options.tree->metres(diagonal) : kLeaves * tolerance);
}

void shapeAndCertify(const ReadMesh& read, const LinkOptions& options, const HullTree* tree, const std::string& uri, std::uint64_t seed,
                     const RunControl& control, MeshResult& result) {
  Stopwatch stage;
  const Work work{read, options, tree, uri, seed, control, result};
  std::vector<Body> bodies = bodiesFor(work);
  const auto hulls_end = std::stable_partition(bodies.begin(), bodies.end(), [](const Body& body) { return !body.primitive; });
  result.seconds.decompose += stage.lap();
  const Protrusion proof = proofOf(bodies, work);
  result.hulls.clear();
  for (auto body = bodies.begin(); body != hulls_end; ++body) result.hulls.push_back(body->hull);
  std::vector<Primitive> parts;
  for (auto body = hulls_end; body != bodies.end(); ++body)
    for (const Primitive& part : partsOf(*body->primitive)) parts.push_back(part);
  std::stable_partition(parts.begin(), parts.end(), [](const Primitive& part) { return part.kind != PrimitiveKind::kSphere; });
  for (const Primitive& part : parts) {
    result.primitives.push_back(elementOf(part));
    result.hulls.push_back(polyhedronAbout(part));
  }
  result.model = factsOf(result.hulls, parts.size(), *result.solid, proof, control);
  if (options.shapes == Shapes::kPrimitives && options.max_hulls > 0 && parts.size() > static_cast<std::size_t>(options.max_hulls))
    result.reason = "it takes " + std::to_string(parts.size()) + " primitives, more than max-hulls " + std::to_string(options.max_hulls) +
                    ", which limits hulls and spheres alone; raise it, or the tolerance, or take shapes 'mixed'";
  if (result.reason.empty() && proof.bound > result.mesh.tolerance)
    result.reason = subject(options.shapes) + " by up to " + millimetres(proof.bound) + ", more than the tolerance of " +
                    millimetres(result.mesh.tolerance) + ": " + excuse(work);
  result.status = result.reason.empty() ? Status::kOk : Status::kDegraded;
  result.seconds.certify += stage.lap();
}

}  // namespace collision_hulls
