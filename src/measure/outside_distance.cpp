// An octree of signed distances with two searches: largest() is branch and bound, largest bound first; intruders() goes level by level. A
// hull's faces are compared with a cell four at a time in single precision, and a cell hands down to its children only the faces that may
// cut it.
#include "measure/outside_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>

#include "measure/level_bound.h"

namespace collision_hulls {

namespace {

const double kSqrt3 = std::sqrt(3.0);
constexpr double kBoxMargin = 1e-4;                 // how far the root extends beyond the box, as a share of its size
constexpr float kSingleRounding = 4e-6F;            // rounding error of sums of a few products in single precision
constexpr double kOnFace = 1e-9;                    // a point this far beyond a face, in cells, still counts as in the hull
constexpr std::size_t kMostCellsInAll = 8'000'000;  // with more cells than this none are divided
constexpr int kDeepest = 40;                        // level down to which isWithin() descends
constexpr std::size_t kVisitsBetweenChecks = 1024;
constexpr std::size_t kMostCells = 40000;  // cells of one size that a search for intruders may divide

}  // namespace

/// A hull's faces, prepared for comparison with cells: four at a time, in single precision, relative to the middle of the hull's box and in
/// units of its half size.
struct OutsideDistance::Faces {
  /// A list of fours.
  struct List {
    std::size_t first = 0, count = 0;  // range in `lists`
  };
  const ConvexHull& hull;
  const Eigen::Matrix3d& axes;
  Eigen::Vector3d middle, half;  // of the hull's box
  double unit = 1;               // [m]
  std::vector<Four>& fours;
  std::vector<int>& lists;  // one after another
  List all;

  /// `memory` is reused so that each query need not allocate its own.
  Faces(const ConvexHull& the_hull, const Eigen::Matrix3d& the_axes, Memory& memory)
      : hull(the_hull), axes(the_axes), fours(memory.fours), lists(memory.lists) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& v : hull.vertices) box.extend(Eigen::Vector3d(axes * v));
    middle = box.center(), half = box.sizes() / 2;
    if (half.maxCoeff() > 0) unit = half.maxCoeff();
    fours.assign((hull.faces.size() + 3) / 4, {});
    for (std::size_t f = 0; f < hull.faces.size(); ++f) {
      const HalfSpace face = this->face(f);
      Four& four = fours[f / 4];
      const auto k = static_cast<Eigen::Index>(f % 4);
      for (int axis = 0; axis < 3; ++axis) four.normal[static_cast<std::size_t>(axis)][k] = static_cast<float>(face.normal[axis]);
      four.offset[k] = static_cast<float>(face.distance(middle) / unit);
      four.width[k] = static_cast<float>(face.normal.lpNorm<1>());
    }
    lists.resize(all.count = fours.size());
    std::iota(lists.begin(), lists.end(), 0);
  }

  /// In the frame of the cells.
  HalfSpace face(std::size_t f) const { return {axes * hull.faces[f].normal, hull.faces[f].offset}; }
};

/// A cell in relation to a hull's faces.
struct OutsideDistance::View {
  Faces::List faces;                                       // those that may cut the cell, and some others
  double depth = std::numeric_limits<double>::infinity();  // upper bound on how deep below the hull's surface any common point lies
  bool outside = false;                                    // the cell and the hull are disjoint
  double offset = 0;                                       // upper bound on how far the centre lies beyond a face

  /// `candidates`: the faces that may cut a cell around this one.
  View(const Cube& cell, Faces& hull, const Faces::List& candidates) : faces{hull.lists.size(), 0} {
    outside = ((cell.centre - hull.middle).cwiseAbs() - hull.half).maxCoeff() > cell.half;
    if (outside) return;
    const Eigen::Vector3f centre = ((cell.centre - hull.middle) / hull.unit).cast<float>();
    const float size = static_cast<float>(cell.half / hull.unit), rounding = kSingleRounding * (1 + size);
    hull.lists.resize(faces.first + candidates.count);
    const int* candidate = hull.lists.data() + candidates.first;
    int* const cutting = hull.lists.data() + faces.first;
    float highest = -rounding, beyond = std::numeric_limits<float>::lowest();
    for (std::size_t i = 0; i < candidates.count && beyond <= rounding; ++i) {
      const Four& four = hull.fours[static_cast<std::size_t>(candidate[i])];
      const Eigen::Array4f distance = four.distance(centre), reach = size * four.width;
      const float above = distance.maxCoeff();
      beyond = std::max(beyond, (distance - reach).maxCoeff());
      cutting[faces.count] = candidate[i];
      faces.count += static_cast<std::size_t>((distance + reach).maxCoeff() > -rounding);  // no branch: it would be unpredictable
      if (above > highest) {
        highest = above;
        std::swap(cutting[0], cutting[faces.count - 1]);  // in front: the likeliest to separate sub-cells from the hull
      }
    }
    outside = beyond > rounding;
    hull.lists.resize(faces.first + (outside ? 0 : faces.count));
    if (candidates.count > 0) depth = hull.unit * (rounding - beyond);
    offset = hull.unit * (highest + rounding);
  }

  /// Roughly the point of the hull in the cell that is nearest to the cell's centre; nullopt if it is hard to find.
  std::optional<Eigen::Vector3d> point(const Cube& cell, const Faces& hull) const {
    if (offset <= 0) return cell.centre;
    std::vector<HalfSpace> mine;
    for (std::size_t i = 0; i < faces.count; ++i) {
      const auto first = 4 * static_cast<std::size_t>(hull.lists[faces.first + i]);
      for (std::size_t f = first; f < std::min(first + 4, hull.hull.faces.size()); ++f) mine.push_back(hull.face(f));
    }
    const auto worst = std::max_element(mine.begin(), mine.end(), [&](const HalfSpace& a, const HalfSpace& b) {
      return a.distance(cell.centre) < b.distance(cell.centre);
    });
    const Eigen::Vector3d p = cell.centre - std::max(0.0, worst->distance(cell.centre)) * worst->normal;
    const auto holds = [&](const HalfSpace& f) { return f.distance(p) <= kOnFace * cell.half; };
    if (!std::all_of(mine.begin(), mine.end(), holds)) return std::nullopt;
    return p;
  }
};

Eigen::AlignedBox3d OutsideDistance::turned(const Eigen::AlignedBox3d& box, const Eigen::Matrix3d& axes) {
  const Eigen::Vector3d middle = axes * box.center(), half = axes.cwiseAbs() * box.sizes() / 2;
  return {middle - half, middle + half};
}

OutsideDistance::OutsideDistance(const Solid& solid, const Eigen::AlignedBox3d& world_box) : solid_(solid) {
  const Eigen::AlignedBox3d box = turned(world_box, solid.axes());
  Family& root = families_.emplace_back();
  root.half = box.sizes().maxCoeff() / 2 * (1 + kBoxMargin);
  root.middle = box.center() + Eigen::Vector3d::Constant(root.half);
  measure(0, -1);
  tellSide(0, -1);
}

OutsideDistance::Cube OutsideDistance::cube(int id) const {
  const Family& all = family(id);
  return {all.middle + all.half * Eigen::Vector3d(id & 1 ? 1 : -1, id & 2 ? 1 : -1, id & 4 ? 1 : -1), all.half};
}

double OutsideDistance::radius(int id) const {
  return family(id).half * kSqrt3;
}

bool OutsideDistance::reaches(const ConvexHull& hull) const {
  const Cube root = cube(0);
  return std::all_of(hull.vertices.begin(), hull.vertices.end(),
                     [&](const Eigen::Vector3d& v) { return (solid_.axes() * v - root.centre).cwiseAbs().maxCoeff() <= root.half; });
}

/// -1: no parent. Which side of the surface the centre is on takes as long to tell, and many cells are done with without.
void OutsideDistance::measure(int id, int parent_id) {
  const int hint = parent_id < 0 ? -1 : at(parent_id).triangle;
  const TriangleBvh::Nearest n = solid_.surface().nearest(inWorld(cube(id).centre), std::numeric_limits<double>::infinity(), hint);
  Cell& cell = at(id);
  cell.triangle = n.triangle;
  cell.to_surface = n.distance;
}

/// A child near its parent's centre is on the same side of the surface, which saves telling the side anew. The parent's is known. -1: no
/// parent.
void OutsideDistance::tellSide(int id, int parent) {
  Cell& cell = at(id);
  if (!std::isnan(cell.distance)) return;
  const Eigen::Vector3d p = inWorld(cube(id).centre);
  const bool inside = parent >= 0 && std::signbit(at(parent).distance);
  // With openings, a ball about a point inside may be smaller than its distance from the surface.
  if (parent >= 0 && !(inside && solid_.hasOpenings()) && isOneSide(parent))
    cell.distance = solid_.signedDistance(p, cell.to_surface, inside);
  else
    cell.distance = solid_.signedDistance(p, cell.to_surface);
}

/// Whether the centres of a cell's children are known to be on the same side of the surface as its own.
bool OutsideDistance::isOneSide(int id) {
  signed char& known = family(id).one_side[static_cast<std::size_t>(id) % 8];
  if (known < 0) known = solid_.isOneSide(inWorld(cube(id).centre), at(id).to_surface, radius(id) / 2) ? 1 : 0;
  return known != 0;
}

/// An upper bound over a cell on the distance to S as a set (lemma 1 of doc/certified.md); infinite if the cell was not measured yet. A
/// cell without a side counts as outside.
double OutsideDistance::knownBound(int id) const {
  const Cell& cell = at(id);
  if (cell.triangle < 0) return std::numeric_limits<double>::infinity();
  return std::min((std::isnan(cell.distance) ? cell.to_surface : cell.distance) + radius(id), cell.level);
}

/// The same of a measured cell, whose side is told if the bound is more than `enough` without.
double OutsideDistance::boundBelow(double enough, int id, int parent) {
  if (knownBound(id) > enough) tellSide(id, parent);
  return knownBound(id);
}

/// A point of the hull in a cell whose centre is outside the solid; nullopt if that point may not be outside, too.
std::optional<Eigen::Vector3d> OutsideDistance::outsidePoint(int cell, const Faces& hull, const View& view) const {
  const std::optional<Eigen::Vector3d> p = view.point(cube(cell), hull);
  return p && view.offset > 0 && solid_.hasOpenings() && solid_.contains(inWorld(*p)) ? std::nullopt : p;
}

bool OutsideDistance::canDivide(int id) const {
  return 8 * families_.size() < kMostCellsInAll || at(id).children >= 0;
}

/// Does not measure them yet: the hull in question may meet only few of them.
int OutsideDistance::children(int id) {
  Cell& parent = at(id);
  if (parent.children >= 0) return parent.children;
  parent.children = static_cast<int>(8 * families_.size());
  const Cube whole = cube(id);
  Family& all = families_.emplace_back();
  all.middle = whole.centre;
  all.half = whole.half / 2;
  if (summit(id) == 0) {
    all.summit.fill(0);
    for (Cell& cell : all.cells) cell.summits = 0;
  }
  return parent.children;
}

const OutsideDistance::Cell& OutsideDistance::measuredChild(int id, int parent) {
  if (at(id).triangle < 0) measure(id, parent);
  return at(id);
}

void OutsideDistance::learn(int id, const OutsideDistance& other, int known_id, const Eigen::AlignedBox3d& part) {
  const Cell& known = other.at(known_id);
  Cell& cell = at(id);
  if (cell.triangle < 0) cell.to_surface = known.to_surface, cell.triangle = known.triangle;
  if (std::isnan(cell.distance)) cell.distance = known.distance;
  const auto at_known = static_cast<std::size_t>(known_id) % 8;
  if (summit(id) < 0) summit(id) = other.family(known_id).summit[at_known];
  cell.level = std::min(cell.level, known.level);
  cell.summits = std::min(cell.summits, known.summits);
  levelled(id) = levelled(id) || other.family(known_id).levelled[at_known];
  if (known.children < 0 || !canDivide(id)) return;
  const Cube place = cube(id);
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(place.half);
  if (!part.intersects({place.centre - reach, place.centre + reach})) return;
  const int first = children(id);
  for (int k = 0; k < 8; ++k) learn(first + k, other, known.children + k, part);
}

bool OutsideDistance::mayHoldSummit(int id) {
  Cell& cell = at(id);
  if (summit(id) < 0) {
    const Eigen::Vector3d centre = inWorld(cube(id).centre);
    summit(id) = solid_.mayHoldSummit(centre, cell.to_surface, radius(id));
    if (summit(id) != 0 && !isAmongWalls(id))
      cell.summits = std::min(cell.summits, solid_.summitAmongWalls(centre, cell.to_surface, radius(id)));
  }
  if (summit(id) == 0) cell.summits = 0;
  return summit(id) != 0;
}

/// Bounds the distance over a divided cell by the triangles nearest to its own and its children's centres. Where one of these is further
/// away than `distance` no such bound can be within it.
bool OutsideDistance::isLevelWithin(double distance, int id) {
  Cell& cell = at(id);
  if (levelled(id)) return cell.level <= distance;
  if (cell.to_surface > distance) return false;
  const Eigen::Vector3d centre = cube(id).centre;
  std::array<Eigen::Vector3d, 8> corners;
  for (int k = 0; k < 8; ++k) corners[static_cast<std::size_t>(k)] = inWorld(centre + 2 * (cube(cell.children + k).centre - centre));
  LevelBound<8, 9> bound(corners, solid_.surface());
  bound.add(cell.triangle);
  for (int k = 0; k < 8 && !bound.reaches(distance); ++k) {
    const Cell& child = measuredChild(cell.children + k, id);
    if (child.to_surface > distance) return false;
    bound.add(child.triangle);
  }
  levelled(id) = !bound.reaches(distance);
  cell.level = std::min(cell.level, levelled(id) ? bound.value() : distance);
  return cell.level <= distance;
}

/// Whether the walls in a cell are known to have the inside on both sides; its bound then is.
bool OutsideDistance::isAmongWalls(int id) {
  signed char& known = family(id).among_walls[static_cast<std::size_t>(id) % 8];
  if (known < 0) {
    const double bound = solid_.distanceAmongWalls(inWorld(cube(id).centre), at(id).to_surface, radius(id));
    known = std::isinf(bound) ? 0 : 1;
    at(id).level = std::min(at(id).level, bound);
  }
  return known != 0;
}

/// What is known about its children may bound a cell more tightly; later queries then need not divide it. Children without a side come
/// last: theirs is told only where it makes a difference.
void OutsideDistance::boundByChildren(int id) {
  double most = 0, summits = 0;
  const int first = at(id).children;
  Cell& cell = at(id);
  const auto add = [&](int child) {
    most = std::max(most, knownBound(child));
    summits = std::max(summits, summitBound(child));
  };
  const auto lacks_side = [&](int child) { return at(child).triangle >= 0 && std::isnan(at(child).distance); };
  for (int k = first; k < first + 8; ++k)
    if (!lacks_side(k)) add(k);
  for (int k = first; k < first + 8; ++k) {
    if (!lacks_side(k)) continue;
    const bool matters = (most < cell.level && knownBound(k) > most) || (summits < cell.summits && summitBound(k) > summits);
    if (matters) tellSide(k, id);
    add(k);
  }
  cell.level = std::min(cell.level, most);
  cell.summits = std::min(cell.summits, summits);
}

OutsideDistance::Largest OutsideDistance::largest(const ConvexHull& hull, const Query& query, const RunControl& control) {
  struct Open {
    double bound;
    int cell;
    std::size_t view;
    bool operator<(const Open& other) const { return bound < other.bound; }
  };
  Largest result;
  result.bound = query.floor;
  Faces faces(hull, solid_.axes(), memory_);
  std::vector<View> views;
  std::priority_queue<Open> queue;
  const auto enough = [&] { return std::max(result.found, query.floor); };
  std::vector<int> divided;
  const auto look = [&](int cell, int parent, const Faces::List& candidates) {
    if ((query.summits_only ? summitBound(cell) : knownBound(cell)) <= enough()) return;
    View view(cube(cell), faces, candidates);
    if (view.outside) return;
    measuredChild(cell, parent);
    const double bound = std::min(boundBelow(enough(), cell, parent), query.surface_bound + std::min(view.depth, query.depth));
    if (bound <= enough()) return;
    queue.push({bound, cell, views.size()});
    views.push_back(std::move(view));
  };
  look(0, -1, faces.all);
  for (; !queue.empty() && queue.top().bound > enough(); ++result.visits) {
    const Open open = queue.top();
    const bool looks_up = result.visits % kVisitsBetweenChecks == 0;
    if (looks_up) control.check();
    if (result.visits == query.most_visits || (looks_up && control.late())) {
      result.bound = std::max(result.bound, open.bound);
      break;
    }
    queue.pop();
    const Cell& cell = at(open.cell);
    const View view = views[open.view];
    const auto outside = cell.distance - view.offset > result.found ? outsidePoint(open.cell, faces, view) : std::nullopt;
    if (outside) {
      result.found = cell.distance - view.offset;
      result.where = inWorld(*outside);
      if (result.found > query.ceiling) {
        result.bound = std::numeric_limits<double>::infinity();
        return result;
      }
    }
    if (open.bound <= enough() || (query.summits_only && !mayHoldSummit(open.cell))) continue;
    if (query.summits_only && summitBound(open.cell) <= enough()) continue;
    if (radius(open.cell) < query.resolution || !canDivide(open.cell)) {
      result.bound = std::max(result.bound, open.bound);
      continue;
    }
    if (isAmongWalls(open.cell) && knownBound(open.cell) <= enough()) continue;
    const int first = children(open.cell);
    divided.push_back(open.cell);
    if (query.summits_only && isLevelWithin(enough(), open.cell)) continue;
    for (int k = first; k < first + 8; ++k) look(k, open.cell, view.faces);
  }
  std::for_each(divided.rbegin(), divided.rend(), [this](int cell) { boundByChildren(cell); });
  result.bound = std::max(result.bound, result.found);
  return result;
}

bool OutsideDistance::isWithin(const std::array<Eigen::Vector3d, 3>& in_world, double distance) const {
  std::array<Eigen::Vector3d, 3> triangle;
  for (std::size_t k = 0; k < 3; ++k) triangle[k] = solid_.axes() * in_world[k];
  const Eigen::Vector3d low = triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]);
  const Eigen::Vector3d high = triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
  const Eigen::Vector3d middle = (low + high) / 2, half = (high - low) / 2;
  const Cube root = cube(0);
  if (((root.centre - middle).cwiseAbs() + half).maxCoeff() > root.half) return false;
  const Eigen::Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double offset = normal.dot(triangle[0]), width = normal.lpNorm<1>();
  int stack[8 * kDeepest];
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const int id = stack[--top];
    const Cell& cell = at(id);
    const Cube place = cube(id);
    if (((place.centre - middle).cwiseAbs() - half).maxCoeff() > place.half) continue;
    if (std::abs(normal.dot(place.centre) - offset) > place.half * width) continue;
    const double signed_distance = std::isnan(cell.distance) ? cell.to_surface : cell.distance;
    if (cell.triangle >= 0 && solid_.distanceWithin(radius(id), signed_distance, cell.to_surface) <= distance) continue;
    if (cell.children < 0 || top + 8 > 8 * kDeepest) return false;
    for (int k = 0; k < 8; ++k) stack[top++] = cell.children + k;
  }
  return true;
}

std::vector<OutsideDistance::Intruder> OutsideDistance::intruders(const ConvexHull& hull, double tolerance, std::size_t wanted,
                                                                  double resolution) {
  struct Open {
    int cell;
    View view;
  };
  Faces faces(hull, solid_.axes(), memory_);
  std::vector<Open> level, divided;
  const auto look = [&](int cell, int parent, const Faces::List& candidates) {
    if (knownBound(cell) <= tolerance) return;
    View view(cube(cell), faces, candidates);
    if (view.outside) return;
    measuredChild(cell, parent);
    if (boundBelow(tolerance, cell, parent) > tolerance) level.push_back({cell, std::move(view)});
  };
  look(0, -1, faces.all);
  std::vector<Intruder> found;
  while (!level.empty()) {
    found.clear();
    divided.clear();
    for (Open& open : level) {
      const Cell& cell = at(open.cell);
      const auto outside = cell.distance - open.view.offset > tolerance ? outsidePoint(open.cell, faces, open.view) : std::nullopt;
      const double side = 2 * family(open.cell).half;
      if (outside) found.push_back({inWorld(*outside), cell.distance - open.view.offset, side * side * side});
      if (radius(open.cell) >= resolution && canDivide(open.cell)) divided.push_back(std::move(open));
    }
    if (found.size() >= wanted || divided.size() > kMostCells / 8) break;
    level.clear();
    for (const Open& open : divided) {
      if (isAmongWalls(open.cell) && knownBound(open.cell) <= tolerance) continue;
      const int first = children(open.cell);
      for (int k = first; k < first + 8; ++k) look(k, open.cell, open.view.faces);
    }
  }
  return found;
}

}  // namespace collision_hulls
