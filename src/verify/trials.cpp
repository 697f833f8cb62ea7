// Each configuration is drawn from a stream of random numbers of its own, so that the counts do not depend on the number of threads.
//
// Boxes are placed where misses and phantoms are likely: near a random point of a random link's surface, at distances over three decades.
// If FCL finds no contact of surfaces, a body may still lie inside another; a point of each component then decides.
//
// A collision of the results alone is allowed if the originals are near enough. Most often a few points near the collision prove that;
// FCL's distance of two meshes, which takes much longer, decides the rest.
#include "verify/trials.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "base/looks.h"
#include "base/parallel.h"
#include "collision_hulls/query/query_body.h"
#include "fit/enclosing.h"
#include "geometry/box_hull.h"
#include "geometry/random_stream.h"
#include "verify/round_shapes.h"

namespace collision_hulls {
namespace {

constexpr double kNearest = 1e-3, kFarthest = 0.3;   // offset of a box, in diagonals of the link
constexpr double kThinnest = 0.02, kThickest = 0.5;  // its sides, in diagonals of the link
constexpr double kLeastContradiction = 1e-6;         // [m] by which a contradiction must exceed its bound
constexpr double kSliver = 1e-9;                     // [m] width that lines are given: far less than that
constexpr std::size_t kMostRemarks = 10;
constexpr std::size_t kBatch = 1000;      // configurations whose counts are kept one by one: they are added up in their order
constexpr std::size_t kMostLinks = 2000;  // whose pairs are counted: two million take 200 MB
constexpr int kTurns = 8;                 // of nearness()

/// One link of one side, or a box.
struct Model {
  struct Part {
    QueryBody body;
    Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
    double error = 0;  // [m] of a polyhedron that stands in for it in `exact`
    QueryBody exact;   // for distances, which FCL gets wrong for its own shapes
  };
  std::vector<Part> parts;
  std::vector<const Solid*> solids;  // whose insides count
  std::vector<const ConvexHull*> hulls;
  std::vector<Eigen::Vector3d> points;  // one of each component
  Eigen::AlignedBox3d box;
  std::shared_ptr<const TriangleBvh> surface;  // of an original or a box
};

QueryShape shapeOf(const GeometryElement& primitive) {
  QueryShape shape;
  shape.kind = primitive.kind == GeometryElement::Kind::kSphere ? QueryShape::Kind::kSphere : QueryShape::Kind::kCylinder;
  shape.size = primitive.size;
  return shape;
}

void addHull(Model& model, const ConvexHull& hull) {
  const QueryBody body(hull);
  model.parts.push_back({body, Eigen::Isometry3d::Identity(), 0, body});
  model.hulls.push_back(&hull);
  model.points.push_back(hull.vertices.front());
}

void addRound(Model& model, const GeometryElement& round) {
  const Approximation around = circumscribed(round);
  model.parts.push_back({QueryBody(shapeOf(round), round.origin), Eigen::Isometry3d::Identity(), around.error, QueryBody(around.hull)});
  model.points.push_back(round.origin.translation());
}

/// From one corner of a triangle to the next, along its longest side.
Segment longestSide(const TriangleMesh& mesh, int triangle) {
  Segment longest{mesh.corner(triangle, 2), mesh.corner(triangle, 0)};
  for (int k = 0; k < 2; ++k) {
    const Segment side{mesh.corner(triangle, k), mesh.corner(triangle, k + 1)};
    if ((side[1] - side[0]).squaredNorm() > (longest[1] - longest[0]).squaredNorm()) longest = side;
  }
  return longest;
}

/// The triangles without area, as slivers of the lines and points that they are: FCL leaves them out, but the bounds count them.
TriangleMesh slivers(const TriangleMesh& mesh, const RunControl& control) {
  Looks look(control);
  TriangleMesh result;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    look();
    const Eigen::Vector3d& corner = mesh.corner(t, 0);
    if (!(mesh.corner(t, 1) - corner).cross(mesh.corner(t, 2) - corner).isZero(0)) continue;
    const auto [from, to] = longestSide(mesh, t);
    Eigen::Vector3d way = to - from;
    if (way.norm() < kSliver) way = kSliver * Eigen::Vector3d::UnitX();
    const auto first = static_cast<int>(result.vertices.size());
    result.vertices.insert(result.vertices.end(), {from, from + way, from + kSliver * way.unitOrthogonal()});
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

void addMesh(Model& model, const TriangleMesh& mesh, const Solid* solid, const RunControl& control) {
  const QueryBody body(mesh, control);
  if (!body.empty()) model.parts.push_back({body, Eigen::Isometry3d::Identity(), 0, body});
  const TriangleMesh lines = slivers(mesh, control);
  if (!lines.triangles.empty())
    model.parts.push_back({QueryBody(TriangleMesh(), control), Eigen::Isometry3d::Identity(), 0, QueryBody(lines, control)});
  if (solid) model.solids.push_back(solid);
}

void finish(Model& model) {
  for (const Model::Part& part : model.parts) model.box.extend(part.body.box());
}

Model modelOfResult(const LinkPair& pair, const RunControl& control) {
  Model model;
  for (const ConvexHull& hull : pair.bodies().hulls()) addHull(model, hull);
  for (const GeometryElement& round : pair.bodies().rounds()) addRound(model, round);
  if (const Solid* const rest = pair.bodies().rest()) {
    addMesh(model, pair.result().rest(), rest, control);
    model.points.insert(model.points.end(), rest->componentPoints().begin(), rest->componentPoints().end());
  }
  finish(model);
  return model;
}

/// All of the original's insides count by its solid, in which round primitives are polyhedra.
Model modelOfOriginal(const LinkPair& pair, const RunControl& control) {
  Model model;
  for (const MeshBody& body : pair.original().meshes) addMesh(model, body.mesh, nullptr, control);
  for (const GeometryElement& primitive : pair.original().primitives) {
    if (isRound(primitive))
      addRound(model, primitive);
    else
      addMesh(model, surface(hullAbout(primitive)), nullptr, control);
  }
  model.solids.push_back(&pair.solid());
  model.points = pair.solid().componentPoints();
  model.surface = std::make_shared<TriangleBvh>(pair.surface(), std::vector<char>(), control);
  finish(model);
  return model;
}

/// One of the points that the model holds.
std::optional<Eigen::Vector3d> heldPoint(const Model& outer, const std::vector<Eigen::Vector3d>& points, const Eigen::Isometry3d& pose) {
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d p = pose * point;
    if (outer.box.contains(p) &&
        (std::any_of(outer.hulls.begin(), outer.hulls.end(), [&](const ConvexHull* hull) { return planeDistance(*hull, p) <= 0; }) ||
         std::any_of(outer.solids.begin(), outer.solids.end(), [&](const Solid* solid) { return solid->contains(p); })))
      return p;
  }
  return std::nullopt;
}

/// A collision: a place near it, in the frame of the first, and whether a part of one lies inside the other while no surfaces touch.
struct Meeting {
  Eigen::Vector3d place;
  bool is_inside = false;
};

/// `pose`: of the second in the frame of the first. There may be thousands of spheres on either side, few of them near the other.
std::optional<Meeting> collision(const Model& first, const Model& second, const Eigen::Isometry3d& pose) {
  if (apart(first.box, second.box, pose)) return std::nullopt;
  std::vector<const Model::Part*> near;
  for (const Model::Part& b : second.parts)
    if (!apart(first.box, b.body.box(), pose)) near.push_back(&b);
  for (const Model::Part& a : first.parts) {
    if (near.empty() || apart(a.body.box(), second.box, pose)) continue;
    for (const Model::Part* const b : near)
      if (!apart(a.body.box(), b->body.box(), pose) && touch(a.body, b->body, pose))
        return Meeting{a.body.box().intersection(placed(b->body.box(), pose)).center()};
  }
  if (const auto held = heldPoint(first, second.points, pose)) return Meeting{*held, true};
  const auto held = heldPoint(second, first.points, pose.inverse());
  return held ? std::optional<Meeting>({pose * *held, true}) : std::nullopt;
}

/// [m] An upper bound on the distance of two surfaces: that of points near `place` which are nearest to each other in turns. Ends when it
/// is no more than `enough`.
double nearness(const Model& first, const Model& second, const Eigen::Isometry3d& pose, Eigen::Vector3d place, double enough) {
  const Eigen::Isometry3d back = pose.inverse();
  double least = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < kTurns && least > enough; ++turn) {
    const TriangleBvh::Nearest one = first.surface->nearest(place);
    if (one.triangle < 0) break;  // no surface
    const TriangleBvh::Nearest other = second.surface->nearest(back * one.point);
    least = std::min(least, other.distance);
    place = pose * other.point;
  }
  return least;
}

/// [m] A lower bound on the distance of two models that do not collide, up to `limit`.
double distanceOf(const Model& first, const Model& second, const Eigen::Isometry3d& pose, double limit) {
  double least = limit;
  for (const Model::Part& a : first.parts) {
    for (const Model::Part& b : second.parts) {
      if (a.exact.box().exteriorDistance(placed(b.exact.box(), pose)) >= least) continue;
      least = std::min(least, distanceBelow(least, a.exact, b.exact, pose));
    }
  }
  return least;
}

/// Whether what is inside may be far from all surface and yet be reached without touching any: through an opening.
bool isOpen(const Model& model) {
  return std::any_of(model.solids.begin(), model.solids.end(), [](const Solid* solid) { return solid->hasOpenings(); });
}

/// Both sides of a link, or twice the same box.
struct Sides {
  const Model *original, *result;
  double uncovered, protrusion;  // [m] bounds
};

enum class Outcome { kFree, kHit, kMissed, kPhantom, kContradiction };

/// A collision on one side alone is within the bounds if the other side is no further apart than they add up to. What lies inside an
/// original and touches no surface is none that a result has to see: it covers surfaces.
Outcome outcomeOf(const Sides& a, const Sides& b, const Eigen::Isometry3d& pose) {
  const auto hit = collision(*a.original, *b.original, pose), seen = collision(*a.result, *b.result, pose);
  if (hit.has_value() == seen.has_value()) return hit ? Outcome::kHit : Outcome::kFree;
  if (hit && hit->is_inside) return Outcome::kFree;
  const double allowed = (hit ? a.uncovered + b.uncovered : a.protrusion + b.protrusion) + kLeastContradiction;
  if (seen && nearness(*a.original, *b.original, pose, seen->place, allowed) <= allowed) return Outcome::kPhantom;
  if (seen && (isOpen(*a.original) || isOpen(*b.original))) return Outcome::kPhantom;
  const double away = hit ? distanceOf(*a.result, *b.result, pose, 2 * allowed) : distanceOf(*a.original, *b.original, pose, 2 * allowed);
  if (away > allowed) return Outcome::kContradiction;
  return hit ? Outcome::kMissed : Outcome::kPhantom;
}

void count(Outcome outcome, TrialCounts& counts) {
  ++counts.queries;
  counts.hits += outcome == Outcome::kHit || outcome == Outcome::kMissed;
  counts.missed += outcome == Outcome::kMissed;
  counts.phantom += outcome == Outcome::kPhantom;
}

void add(TrialCounts& sum, const TrialCounts& more) {
  sum.queries += more.queries;
  sum.hits += more.hits;
  sum.missed += more.missed;
  sum.phantom += more.phantom;
}

void add(Trials& sum, const Trials& one) {
  add(sum.all, one.all);
  for (std::size_t i = 0; i < sum.of_link.size(); ++i) add(sum.of_link[i], one.of_link[i]);
  sum.contradictions += one.contradictions;
  for (const std::string& remark : one.remarks)
    if (sum.remarks.size() < kMostRemarks) sum.remarks.push_back(remark);
}

/// The pairs of links that collide on either side, in any configuration. Thread safe; the sums do not depend on the order.
class PairCounts {
 public:
  void add(std::size_t first, std::size_t second, Outcome outcome) {
    if (outcome == Outcome::kFree) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    count(outcome, counts_[{first, second}]);
  }

  /// Those with a missed or a phantom query, each of which was asked in every configuration.
  std::vector<TrialPair> differing(std::size_t configurations) const {
    std::vector<TrialPair> pairs;
    for (const auto& [links, counts] : counts_) {
      if (counts.missed + counts.phantom == 0) continue;
      pairs.push_back({links.first, links.second, counts});
      pairs.back().counts.queries = configurations;
    }
    return pairs;
  }

 private:
  std::mutex mutex_;
  std::map<std::pair<std::size_t, std::size_t>, TrialCounts> counts_;
};

/// The links of a robot, and the queries of one configuration.
class Trial {
 public:
  Trial(const Kinematics& kinematics, const std::vector<TrialLink>& links, const RunControl& control)
      : kinematics_(kinematics), links_(links) {
    for (const TrialLink& link : links) {
      originals_.push_back(modelOfOriginal(*link.pair, control));
      results_.push_back(modelOfResult(*link.pair, control));
    }
  }

  Trials run(std::uint64_t seed, std::size_t configuration, PairCounts& pairs) const {
    Random random(seed, 0, configuration);
    const std::vector<Eigen::Isometry3d> poses = kinematics_.poses(kinematics_.sample([&] { return random.uniform(0, 1); }));
    Trials trials;
    trials.of_link.resize(links_.size());
    for (std::size_t i = 0; i < links_.size(); ++i) {
      for (std::size_t j = i + 1; j < links_.size(); ++j) {
        if (kinematics_.adjacent(links_[i].link, links_[j].link)) continue;
        const Eigen::Isometry3d pose = poses[links_[i].link].inverse() * poses[links_[j].link];
        const Outcome outcome = outcomeOf(sides(i), sides(j), pose);
        record(outcome, {i, j}, configuration, links_[j].bounds->link, trials);
        if (links_.size() <= kMostLinks) pairs.add(i, j, outcome);
      }
    }
    queryBox(random, poses, configuration, trials);
    return trials;
  }

 private:
  Sides sides(std::size_t i) const {
    return {&originals_[i], &results_[i], links_[i].bounds->uncovered.bound, links_[i].bounds->protrusion.bound};
  }

  void queryBox(Random& random, const std::vector<Eigen::Isometry3d>& poses, std::size_t configuration, Trials& trials) const {
    const std::size_t chosen = random.below(links_.size());
    const TriangleMesh& surface = links_[chosen].pair->surface();
    const double size = links_[chosen].bounds->diagonal;
    if (surface.triangles.empty() || !(size > 0)) return;
    Eigen::Vector3d sides_of_box;
    for (int axis = 0; axis < 3; ++axis) sides_of_box[axis] = random.logUniform(kThinnest, kThickest) * size;
    const ConvexHull hull = hullOfBox(sides_of_box);
    Model box;
    addHull(box, hull);
    box.surface = std::make_shared<TriangleBvh>(collision_hulls::surface(hull));
    finish(box);
    const Eigen::Vector3d& corner = hull.vertices[random.below(hull.vertices.size())];
    const Eigen::Vector3d near =
        surface.corner(static_cast<int>(random.below(surface.triangles.size())), static_cast<int>(random.below(3)));
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    place.linear() = random.rotation().toRotationMatrix();
    place.translation() = near - place.linear() * corner + random.direction() * random.logUniform(kNearest, kFarthest) * size;
    const Sides same{&box, &box, 0, 0};
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const Outcome outcome = outcomeOf(sides(i), same, poses[links_[i].link].inverse() * poses[links_[chosen].link] * place);
      record(outcome, {i}, configuration, "a box", trials);
    }
  }

  void record(Outcome outcome, const std::vector<std::size_t>& links, std::size_t configuration, const std::string& other,
              Trials& trials) const {
    count(outcome, trials.all);
    for (const std::size_t i : links) count(outcome, trials.of_link[i]);
    if (outcome != Outcome::kContradiction) return;
    ++trials.contradictions;
    trials.remarks.push_back("configuration " + std::to_string(configuration) + ": '" + links_[links.front()].bounds->link + "' and " +
                             other + " collide on one side, and on the other they are further apart than the bounds allow");
  }

  const Kinematics& kinematics_;
  const std::vector<TrialLink>& links_;
  std::vector<Model> originals_, results_;
};

}  // namespace

Trials tryConfigurations(const Kinematics& kinematics, const std::vector<TrialLink>& links, std::size_t configurations, std::uint64_t seed,
                         const RunControl& control) {
  Trials sum;
  sum.of_link.resize(links.size());
  if (links.empty()) return sum;
  const Trial trial(kinematics, links, control);
  PairCounts pairs;
  for (std::size_t first = 0; first < configurations; first += kBatch) {
    std::vector<Trials> each(std::min(kBatch, configurations - first));
    forEach(each.size(), [&](std::size_t i) {
      control.check();
      each[i] = trial.run(seed, first + i, pairs);
    });
    for (const Trials& one : each) add(sum, one);
  }
  sum.pairs = pairs.differing(configurations);
  return sum;
}

}  // namespace collision_hulls
