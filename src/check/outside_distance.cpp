#include "check/outside_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "check/level_bound.h"

namespace collision_hulls {

namespace {

const double kSqrt3 = std::sqrt(3.0);
constexpr double kBoxMargin = 1e-4;                 // the root's size beyond the box, as a share
constexpr double kOnFace = 1e-9;                    // a point this far beyond a face, in cells, still lies in the hull
constexpr std::size_t kMostVisits = 60000;          // of one query; then the largest bound left over is the answer's
constexpr std::size_t kMostCellsInAll = 8'000'000;  // then cells are not divided any more
constexpr int kDeepest = 40;                        // level that isWithin() descends to
constexpr std::size_t kMostCells = 40000;           // of one size that a search for intruders divides further

}  // namespace

/// A hull's faces, as cells are compared with them.
struct OutsideDistance::Faces {
  struct Face {
    Eigen::Vector3d normal;
    double offset, width;  // width: how far a cube of half side 1 about the origin reaches along the normal
  };
  struct List {
    std::size_t first = 0, count = 0;  // in `lists`
  };
  Eigen::Vector3d middle, half;  // of the hull's box
  std::vector<Face> faces;
  std::vector<int>& lists;  // one after the other
  List all;

  /// `memory`: for the lists, so that each query does not ask for its own.
  Faces(const ConvexHull& hull, std::vector<int>& memory) : lists(memory), all{0, hull.faces.size()} {
    const Eigen::AlignedBox3d box = boundingBox(hull);
    middle = box.center(), half = box.sizes() / 2;
    faces.reserve(hull.faces.size());
    for (const HalfSpace& f : hull.faces) faces.push_back({f.normal, f.offset, f.normal.lpNorm<1>()});
    lists.resize(all.count);
    std::iota(lists.begin(), lists.end(), 0);
  }
  double distance(int f, const Eigen::Vector3d& p) const {
    const Face& face = faces[static_cast<std::size_t>(f)];
    return face.normal.dot(p) - face.offset;
  }
};

/// The faces of a hull that cut a cell, and the point of the hull in the cell that is nearest to its centre, roughly.
struct OutsideDistance::View {
  Faces::List faces;
  double depth = std::numeric_limits<double>::infinity();  // no point of both lies deeper beneath the hull's surface
  bool outside = false;                                    // the cell and the hull have nothing in common
  double offset = 0;                                       // how far `point` lies from the centre
  bool has_point = false;
  Eigen::Vector3d point;

  /// `candidates`: the faces that cut a cell around this one.
  View(const Cell& cell, Faces& hull, const Faces::List& candidates) : faces{hull.lists.size(), 0}, point(cell.centre) {
    outside = ((cell.centre - hull.middle).cwiseAbs() - hull.half).maxCoeff() > cell.half;
    if (outside) return;
    int worst = -1;
    for (std::size_t i = candidates.first; i < candidates.first + candidates.count; ++i) {
      const int f = hull.lists[i];
      const double d = hull.distance(f, cell.centre), reach = cell.half * hull.faces[static_cast<std::size_t>(f)].width;
      if (d > reach) {
        outside = true;
        hull.lists.resize(faces.first);
        return;
      }
      if (d > -reach) hull.lists.push_back(f);
      depth = std::min(depth, reach - d);
      if (d > offset) {
        offset = d, worst = f;
        std::swap(hull.lists[faces.first], hull.lists.back());  // it is the likeliest to part cells within from the hull
      }
    }
    faces.count = hull.lists.size() - faces.first;
    has_point = worst < 0;
    if (has_point) return;
    point -= offset * hull.faces[static_cast<std::size_t>(worst)].normal;
    const auto first = hull.lists.cbegin() + static_cast<std::ptrdiff_t>(faces.first);
    has_point = std::all_of(first, hull.lists.cend(), [&](int f) { return hull.distance(f, point) <= kOnFace * cell.half; });
  }
};

OutsideDistance::OutsideDistance(const Solid& solid, const Eigen::AlignedBox3d& box) : solid_(solid) {
  Cell root;
  root.centre = box.center();
  root.half = box.sizes().maxCoeff() / 2 * (1 + kBoxMargin);
  measure(root, nullptr);
  cells_.push_back(root);
}

double OutsideDistance::radius(const Cell& cell) const {
  return cell.half * kSqrt3;
}

/// Where the parent's distance exceeds the way between the centres, no surface lies between them and the sign is the same, unless
/// there are openings.
void OutsideDistance::measure(Cell& cell, const Cell* parent) const {
  const TriangleBvh::Nearest n =
      solid_.surface().nearest(cell.centre, std::numeric_limits<double>::infinity(), parent ? parent->triangle : -1);
  cell.triangle = n.triangle;
  cell.to_surface = n.distance;
  if (parent && !solid_.hasOpenings() && parent->to_surface > (parent->centre - cell.centre).norm())
    cell.distance = parent->distance < 0 ? -n.distance : n.distance;
  else
    cell.distance = solid_.signedDistance(cell.centre, n.distance);
}

/// Over a cell, of the distance to S as a set; infinite if it was not measured yet.
double OutsideDistance::knownBound(int id) const {
  const Cell& cell = cells_[static_cast<std::size_t>(id)];
  return cell.triangle < 0 ? std::numeric_limits<double>::infinity() : cell.distance + radius(cell);
}

/// Whether a view from a cell whose centre is outside has a point that is outside, too.
bool OutsideDistance::isOutside(const View& view) const {
  return view.has_point && !(view.offset > 0 && solid_.hasOpenings() && solid_.contains(view.point));
}

bool OutsideDistance::canDivide(int id) const {
  return cells_.size() < kMostCellsInAll || cells_[static_cast<std::size_t>(id)].children >= 0;
}

/// Not measured yet: the hull that asks may lie in few of them.
int OutsideDistance::children(int id) {
  if (cells_[static_cast<std::size_t>(id)].children >= 0) return cells_[static_cast<std::size_t>(id)].children;
  const Cell parent = cells_[static_cast<std::size_t>(id)];
  const int first = static_cast<int>(cells_.size());
  for (int k = 0; k < 8; ++k) {
    Cell cell;
    cell.half = parent.half / 2;
    cell.centre = parent.centre + cell.half * Eigen::Vector3d(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    if (parent.summit == 0) cell.summit = 0;
    cells_.push_back(cell);
  }
  return cells_[static_cast<std::size_t>(id)].children = first;
}

const OutsideDistance::Cell& OutsideDistance::measuredChild(int id, int parent) {
  Cell& cell = cells_[static_cast<std::size_t>(id)];
  if (cell.triangle < 0) measure(cell, &cells_[static_cast<std::size_t>(parent)]);
  return cell;
}

bool OutsideDistance::mayHoldSummit(int id) {
  Cell& cell = cells_[static_cast<std::size_t>(id)];
  if (cell.summit < 0) cell.summit = !solid_.surface().facesOneWay(cell.centre, cell.to_surface + 2 * radius(cell));
  return cell.summit != 0;
}

/// Bound over a divided cell by the distances to the triangles nearest to its own and its children's centres.
double OutsideDistance::levelBound(int id) {
  for (int k = 0; k < 8; ++k) measuredChild(cells_[static_cast<std::size_t>(id)].children + k, id);
  const Cell& cell = cells_[static_cast<std::size_t>(id)];
  LevelBound<8, 9> bound;
  bound.add(cell.triangle);
  std::array<Eigen::Vector3d, 8> corners;
  for (int k = 0; k < 8; ++k) {
    const Cell& child = cells_[static_cast<std::size_t>(cell.children + k)];
    bound.add(child.triangle);
    corners[static_cast<std::size_t>(k)] = cell.centre + 2 * (child.centre - cell.centre);
  }
  return bound.over(corners, solid_.surface());
}

OutsideDistance::Largest OutsideDistance::largest(const ConvexHull& hull, const Query& query) {
  struct Open {
    double bound;
    int cell;
    std::size_t view;
    bool operator<(const Open& other) const { return bound < other.bound; }
  };
  Largest result;
  result.bound = query.floor;
  Faces faces(hull, face_lists_);
  std::vector<View> views;
  std::priority_queue<Open> queue;
  const auto enough = [&] { return std::max(result.found, query.floor); };
  const auto look = [&](int cell, int parent, const Faces::List& candidates) {
    if (knownBound(cell) <= enough()) return;
    View view(cells_[static_cast<std::size_t>(cell)], faces, candidates);
    if (view.outside) return;
    measuredChild(cell, parent);
    if (knownBound(cell) <= enough()) return;
    queue.push({knownBound(cell), cell, views.size()});
    views.push_back(std::move(view));
  };
  look(0, -1, faces.all);
  for (std::size_t visits = 0; !queue.empty() && queue.top().bound > enough(); ++visits) {
    const Open open = queue.top();
    if (visits == kMostVisits) {
      result.bound = std::max(result.bound, open.bound);
      break;
    }
    queue.pop();
    const Cell cell = cells_[static_cast<std::size_t>(open.cell)];
    const View view = views[open.view];
    if (cell.distance - view.offset > result.found && isOutside(view)) {
      result.found = cell.distance - view.offset;
      result.where = view.point;
      if (result.found > query.ceiling) {
        result.bound = std::numeric_limits<double>::infinity();
        return result;
      }
    }
    const double bound = std::min(open.bound, query.surface_bound + std::min(view.depth, query.depth));
    if (bound <= enough() || (query.summits_only && !mayHoldSummit(open.cell))) continue;
    if (radius(cell) < query.resolution || !canDivide(open.cell)) {
      result.bound = std::max(result.bound, bound);
      continue;
    }
    const int first = children(open.cell);
    if (query.summits_only && levelBound(open.cell) <= enough()) continue;
    for (int k = first; k < first + 8; ++k) look(k, open.cell, view.faces);
  }
  result.bound = std::max(result.bound, result.found);
  return result;
}

bool OutsideDistance::isWithin(const std::array<Eigen::Vector3d, 3>& triangle, double distance) const {
  const Eigen::Vector3d low = triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]);
  const Eigen::Vector3d high = triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
  const Eigen::Vector3d middle = (low + high) / 2, half = (high - low) / 2;
  const Eigen::Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double offset = normal.dot(triangle[0]), width = normal.lpNorm<1>();
  int stack[8 * kDeepest];
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const int id = stack[--top];
    const Cell& cell = cells_[static_cast<std::size_t>(id)];
    if (((cell.centre - middle).cwiseAbs() - half).maxCoeff() > cell.half) continue;
    if (std::abs(normal.dot(cell.centre) - offset) > cell.half * width) continue;
    if (cell.triangle >= 0 && solid_.distanceWithin(radius(cell), cell.distance, cell.to_surface) <= distance) continue;
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
  Faces faces(hull, face_lists_);
  std::vector<Open> level, divided;
  const auto look = [&](int cell, int parent, const Faces::List& candidates) {
    if (knownBound(cell) <= tolerance) return;
    View view(cells_[static_cast<std::size_t>(cell)], faces, candidates);
    if (view.outside) return;
    measuredChild(cell, parent);
    if (knownBound(cell) > tolerance) level.push_back({cell, std::move(view)});
  };
  look(0, -1, faces.all);
  std::vector<Intruder> found;
  while (!level.empty()) {
    found.clear();
    divided.clear();
    for (Open& open : level) {
      const Cell& cell = cells_[static_cast<std::size_t>(open.cell)];
      if (cell.distance - open.view.offset > tolerance && isOutside(open.view))
        found.push_back({open.view.point, cell.distance - open.view.offset, 8 * cell.half * cell.half * cell.half});
      if (radius(cell) >= resolution && canDivide(open.cell)) divided.push_back(std::move(open));
    }
    if (found.size() >= wanted || divided.size() > kMostCells / 8) break;
    level.clear();
    for (const Open& open : divided) {
      const int first = children(open.cell);
      for (int k = first; k < first + 8; ++k) look(k, open.cell, open.view.faces);
    }
  }
  return found;
}

}  // namespace collision_hulls
