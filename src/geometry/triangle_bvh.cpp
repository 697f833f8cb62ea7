// Tree: nodes split where the area of the halves' boxes, times the leaves in them, is least (Goldsmith & Salmon 1987, in bins as Wald
// 2007), at a multiple of four triangles, so all leaves but the last hold four. That fixes the number of nodes below each node, and
// subtrees can be built in parallel. Siblings are stored side by side. Queries: depth first, nearer child first, O(log n) on surfaces;
// nearest() tests boxes in packs of four.
#include "collision_hulls/geometry/triangle_bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/looks.h"
#include "base/parallel.h"
#include "geometry/pi.h"

namespace collision_hulls {

namespace {

constexpr int kLeafSize = 4;
constexpr int kParallel = 4096;      // nodes with more triangles than this build both halves in parallel
constexpr int kBins = 16;            // places to split a node along an axis
constexpr float kThinnest = 1e-30F;  // extent of centres, in units of the tree, that is not divided: kBins over it must be finite
constexpr int kLeastShare = 4;       // a half gets at least 1 / this of a node's leaves

// For boxes in single precision: rounding error of a coordinate (at most 2 units large), and of the squared distance to a box, as a share.
constexpr float kBoxMargin = 4e-7F;
constexpr double kBoxRounding = 1e-6;

constexpr double kAnyDirection = kPi;
constexpr double kNarrow = 0.35;  // [rad] a cone narrower than this stands for all its triangles
constexpr std::size_t kMostCones = 64;
constexpr double kLevel = 1e-6;  // directions whose cosine is below this count as level: outside the half-space
// Rounding error of two sides' cross product, as a share of the product of their lengths; and an error of the unit normal [rad] from which
// on a sliver counts as degenerate: a tenth of what counts as level.
constexpr double kNormalRounding = 2e-15, kVague = 1e-7;
constexpr int kHalfSpaceRounds = 24;
constexpr double kLean = 0.3, kEnough = 1.01;  // step toward the worst cone; gain per round that justifies another round

std::size_t leavesFor(int triangles) {
  return (static_cast<std::size_t>(triangles) + kLeafSize - 1) / kLeafSize;
}

/// Eigen's squaredExteriorDistance(), without branches.
double squaredDistance(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& p) {
  return (box.min() - p).cwiseMax(p - box.max()).cwiseMax(0).squaredNorm();
}

/// Half the area of a box.
double halfArea(const Eigen::Vector3d& size) {
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

/// The triangles of a node whose centres lie in a slab across an axis.
struct Bin {
  Eigen::Array4f low = Eigen::Array4f::Constant(std::numeric_limits<float>::infinity()), high = -low;
  int count = 0;

  void add(const Bin& other) {
    low = low.min(other.low);
    high = high.max(other.high);
    count += other.count;
  }
  double cost(int leaves) const { return halfArea((high - low).head<3>().cast<double>()) * leaves; }
};

/// The directions within some angle of an axis.
struct Spread {
  Eigen::Vector3d axis;
  double sine;  // of the angle
};

/// Searches for a direction at an acute angle to all the cones: starts with the mean, then leans toward the worst. Returns the least cosine
/// of the best direction found; 0 if none was found.
double leastCosine(const Spread* cones, std::size_t count) {
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < count; ++i) u += cones[i].axis;
  double best = count == 0 ? 1 : 0;
  for (int round = 0; round < kHalfSpaceRounds && u.norm() > kLevel; ++round) {
    u.normalize();
    std::size_t worst = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
      const double cosine = u.dot(cones[i].axis) - cones[i].sine;
      if (cosine < least) least = cosine, worst = i;
    }
    if (least > kLevel && least < best * kEnough) break;
    best = std::max(best, least > kLevel ? least : 0);
    u += cones[worst].axis * (kLean - least);
  }
  return best;
}

}  // namespace

TriangleBvh::TriangleBvh(const TriangleMesh& mesh, const std::vector<char>& two_sided, const RunControl& control, Keeps keeps) {
  const std::size_t n = mesh.triangles.size();
  if (n == 0) return;
  Looks look(control);
  for (const Triangle& t : mesh.triangles) {
    look();
    for (int v : t) box_.extend(mesh.vertices[static_cast<std::size_t>(v)]);
  }
  centre_ = box_.center();
  const double size = box_.sizes().maxCoeff();
  unit_ = size > 0 ? std::exp2(std::ilogb(size)) : 1;  // a power of two, by which numbers are divided exactly
  std::vector<Item> items;
  enlarge(items, n, control);
  for (std::size_t t = 0; t < n; ++t) {
    look();
    const int i = static_cast<int>(t);
    const Eigen::Vector3f a = inUnits(mesh.corner(i, 0)), b = inUnits(mesh.corner(i, 1)), c = inUnits(mesh.corner(i, 2));
    items[t].triangle = i;
    for (int axis = 0; axis < 3; ++axis) {
      items[t].low[axis] = std::min({a[axis], b[axis], c[axis]});
      items[t].high[axis] = std::max({a[axis], b[axis], c[axis]});
    }
  }
  enlarge(corners_, n, control);
  enlarge(index_, n, control);
  enlarge(position_, n, control);
  two_sided_ = two_sided;
  enlarge(nodes_, 2 * leavesFor(static_cast<int>(n)) - 1, control);
  if (keeps == Keeps::kFarView) enlarge(clusters_, nodes_.size(), control);
  build(mesh, items, 0, 0, static_cast<int>(n), 1, control);
  items = std::vector<Item>();
  fours_.reserve(nodes_.size() * 5 / 6 + 1);  // one for each leaf, and for about two in three inner nodes
  gather(0, control);
  if (keeps == Keeps::kNothing) nodes_ = std::vector<Node>();
}

/// Packs the boxes of a leaf's triangles, or those of four nodes below a node: of the largest, its children. Returns their place.
int TriangleBvh::gather(int id, const RunControl& control) {
  if (fours_.size() % kItemsBetweenLooks == 0) control.check();
  const auto at = static_cast<int>(fours_.size());
  fours_.emplace_back();
  FourBoxes four;
  const auto add = [&](const Eigen::AlignedBox3d& box, int child) {
    const Eigen::Vector3f low = inUnits(box.min()), high = inUnits(box.max());
    for (int axis = 0; axis < 3; ++axis) {
      four.low[static_cast<std::size_t>(axis)][four.count] = low[axis] - kBoxMargin;
      four.high[static_cast<std::size_t>(axis)][four.count] = high[axis] + kBoxMargin;
    }
    four.child[static_cast<std::size_t>(four.count++)] = child;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) four.low[axis] = 1, four.high[axis] = -1;
  const Node& node = nodes_[static_cast<std::size_t>(id)];
  for (int k = node.first; k < node.first + node.count; ++k) {
    const auto& [a, b, c] = corners_[static_cast<std::size_t>(k)];
    add({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)}, ~k);
  }
  std::array<int, 4> below{node.first, node.first + 1};
  std::size_t count = node.count > 0 ? 0 : 2;
  while (count > 0 && count < below.size()) {
    int* largest = nullptr;
    double most = -1;
    for (std::size_t i = 0; i < count; ++i) {
      const Node& candidate = nodes_[static_cast<std::size_t>(below[i])];
      const double area = halfArea(candidate.box.sizes());
      if (candidate.count == 0 && area > most) most = area, largest = &below[i];
    }
    if (!largest) break;
    const int child = nodes_[static_cast<std::size_t>(*largest)].first;
    *largest = child;
    below[count++] = child + 1;
  }
  for (std::size_t i = 0; i < count; ++i) add(nodes_[static_cast<std::size_t>(below[i])].box, gather(below[i], control));
  fours_[static_cast<std::size_t>(at)] = four;
  return at;
}

/// Builds a node of `count` triangles. `below`: where its descendants go.
void TriangleBvh::build(const TriangleMesh& mesh, std::vector<Item>& items, int id, int first, int count, int below,
                        const RunControl& control) {
  Node& node = nodes_[static_cast<std::size_t>(id)];
  node.first = first;
  node.count = count;
  if (count <= kLeafSize) {
    fillLeaf(mesh, items, node);
  } else {
    Looks look(control);
    const auto begin = items.begin() + first;
    const Split at = split(&*begin, count);
    const int left = kLeafSize * at.left;
    std::nth_element(begin, begin + left, begin + count, [axis = at.axis, &look](const Item& a, const Item& b) {
      look();
      const float one = a.low[axis] + a.high[axis], other = b.low[axis] + b.high[axis];
      return one < other || (one == other && a.triangle < b.triangle);
    });
    node.first = below;
    node.count = 0;
    const auto build_left = [&] { build(mesh, items, below, first, left, below + 2, control); };
    const auto build_right = [&] { build(mesh, items, below + 1, first + left, count - left, below + 2 * at.left, control); };
    if (count > kParallel) {
      control.check();
      atOnce(build_left, build_right);
    } else {
      build_left();
      build_right();
    }
  }
  fit(id);
}

TriangleBvh::Split TriangleBvh::split(const Item* items, int count) {
  Bin centres;
  for (int i = 0; i < count; ++i) centres.add({items[i].twiceCentre(), items[i].twiceCentre(), 1});
  const Eigen::Array4f size = centres.high - centres.low, perUnit = (size > kThinnest).select(kBins / size, 0);
  std::array<std::array<Bin, kBins>, 3> bins;
  for (int i = 0; i < count; ++i) {
    const Eigen::Array4f place = (items[i].twiceCentre() - centres.low) * perUnit;
    for (std::size_t axis = 0; axis < 3; ++axis)
      bins[axis][static_cast<std::size_t>(std::min(static_cast<int>(place[axis]), kBins - 1))].add({items[i].low, items[i].high, 1});
  }
  const int leaves = static_cast<int>(leavesFor(count)), least = (leaves + kLeastShare - 1) / kLeastShare;
  Split best{0, leaves / 2};
  double least_cost = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<Bin, kBins> after = bins[axis];  // each with all after it
    for (std::size_t i = kBins - 1; i-- > 0;) after[i].add(after[i + 1]);
    Bin before;
    for (std::size_t i = 0; i + 1 < kBins && after[i + 1].count > 0; ++i) {
      before.add(bins[axis][i]);
      if (bins[axis][i].count == 0) continue;
      const int left = std::clamp((before.count + kLeafSize / 2) / kLeafSize, least, leaves - least);
      const double cost = before.cost(left) + after[i + 1].cost(leaves - left);
      if (cost < least_cost) least_cost = cost, best = {static_cast<int>(axis), left};
    }
  }
  return best;
}

void TriangleBvh::fillLeaf(const TriangleMesh& mesh, const std::vector<Item>& items, Node& leaf) {
  for (int k = leaf.first; k < leaf.first + leaf.count; ++k) {
    const int t = items[static_cast<std::size_t>(k)].triangle;
    corners_[static_cast<std::size_t>(k)] = {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
    index_[static_cast<std::size_t>(k)] = t;
    position_[static_cast<std::size_t>(t)] = k;
  }
}

/// Computes a node's box and cluster from its triangles or its (finished) children.
void TriangleBvh::fit(int id) {
  Node& node = nodes_[static_cast<std::size_t>(id)];
  for (int k = node.first; k < node.first + node.count; ++k) {
    const auto& [a, b, c] = corners_[static_cast<std::size_t>(k)];
    node.box.extend(a).extend(b).extend(c);
  }
  for (int k = node.first; node.count == 0 && k < node.first + 2; ++k) node.box.extend(nodes_[static_cast<std::size_t>(k)].box);
  if (clusters_.empty()) return;
  fitCluster(id);
  fitCone(id);
}

void TriangleBvh::fitCluster(int id) {
  const Node& node = nodes_[static_cast<std::size_t>(id)];
  Cluster& cluster = clusters_[static_cast<std::size_t>(id)];
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
  if (node.count > 0) {
    for (int k = node.first; k < node.first + node.count; ++k) {
      const auto& [a, b, c] = corners_[static_cast<std::size_t>(k)];
      const Eigen::Vector3d vector = (b - a).cross(c - a) / 2;
      cluster.dipole += vector;
      cluster.area += vector.norm();
      weighted += vector.norm() * (a + b + c) / 3;
    }
  } else {
    const auto left = static_cast<std::size_t>(node.first), right = left + 1;
    const Cluster &l = clusters_[left], &r = clusters_[right];
    cluster.dipole = l.dipole + r.dipole;
    cluster.area = l.area + r.area;
    weighted = l.area * l.dipole_centre + r.area * r.dipole_centre;
  }
  cluster.dipole_centre = cluster.area > 0 ? Eigen::Vector3d(weighted / cluster.area) : Eigen::Vector3d(node.box.center());
  const Eigen::Vector3d reach = (node.box.max() - cluster.dipole_centre).cwiseMax(cluster.dipole_centre - node.box.min());
  cluster.radius = reach.norm();
}

/// The cone about the mean normal of a leaf's triangles, or about the children's cones.
void TriangleBvh::fitCone(int id) {
  const Node& node = nodes_[static_cast<std::size_t>(id)];
  Cluster& cluster = clusters_[static_cast<std::size_t>(id)];
  std::array<Cone, kLeafSize> parts;
  std::size_t count = 0;
  if (node.count > 0) {
    for (int k = node.first; k < node.first + node.count; ++k) parts[count++] = cone(k);
  } else {
    for (int k = node.first; k < node.first + 2; ++k)
      parts[count++] = {clusters_[static_cast<std::size_t>(k)].cone_axis, clusters_[static_cast<std::size_t>(k)].cone_angle};
  }
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < count; ++i) axis += parts[i].axis;
  cluster.cone_angle = kAnyDirection;
  if (!(axis.norm() > kLevel)) return;
  cluster.cone_axis = axis.normalized();
  double angle = 0;
  for (std::size_t i = 0; i < count; ++i)
    angle = std::max(angle, parts[i].angle + std::acos(std::clamp(cluster.cone_axis.dot(parts[i].axis), -1.0, 1.0)));
  cluster.cone_angle = std::min(angle, kAnyDirection);
}

TriangleBvh::Cone TriangleBvh::cone(int k) const {
  const auto& [a, b, c] = corners_[static_cast<std::size_t>(k)];
  const Eigen::Vector3d vector = (b - a).cross(c - a);
  const double length = vector.norm(), error = kNormalRounding * (b - a).norm() * (c - a).norm() / length;
  if (!(error < kVague) || (!two_sided_.empty() && two_sided_[static_cast<std::size_t>(index_[static_cast<std::size_t>(k)])]))
    return {Eigen::Vector3d::Zero(), kAnyDirection};
  return {vector / length, error};
}

/// For lemma 5 of doc/certified.md.
bool TriangleBvh::facesOneWay(const Eigen::Vector3d& p, double radius) const {
  if (clusters_.empty()) return empty();
  std::array<Spread, kMostCones> cones;
  std::size_t count = 0;
  const auto add = [&](const Cone& c) {
    if (c.angle >= kAnyDirection || count == kMostCones) return false;
    cones[count++] = {c.axis, c.angle > 0 ? std::sin(c.angle) : 0};
    return true;
  };
  int stack[kDeepest];
  int top = 0;
  if (!nodes_.empty()) stack[top++] = 0;
  while (top > 0) {
    const auto id = static_cast<std::size_t>(stack[--top]);
    const Node& node = nodes_[id];
    if (squaredDistance(node.box, p) > radius * radius) continue;
    if (clusters_[id].cone_angle < kNarrow) {
      if (!add({clusters_[id].cone_axis, clusters_[id].cone_angle})) return false;
    } else if (node.count > 0) {
      for (int k = node.first; k < node.first + node.count; ++k) {
        const auto& [a, b, c] = corners_[static_cast<std::size_t>(k)];
        if ((closestPoint(a, b, c, p) - p).squaredNorm() <= radius * radius && !add(cone(k))) return false;
      }
    } else {
      stack[top++] = node.first;
      stack[top++] = node.first + 1;
    }
  }
  return leastCosine(cones.data(), count) > 0;
}

TriangleBvh::Nearest TriangleBvh::nearest(const Eigen::Vector3d& p, double limit, int hint) const {
  Nearest best;
  double least = limit * limit;
  const auto visit = [&](int k) {
    const auto& [a, b, c] = corners_[static_cast<std::size_t>(k)];
    const Eigen::Vector3d q = closestPoint(a, b, c, p);
    const double d = (q - p).squaredNorm();
    if (d < least) least = d, best.point = q, best.triangle = index_[static_cast<std::size_t>(k)];
  };
  if (fours_.empty()) return best;
  if (hint >= 0) visit(position_[static_cast<std::size_t>(hint)]);
  const Eigen::Vector3f q = inUnits(p);
  const double scale = unit_ * unit_ * (1 - kBoxRounding);
  struct Open {
    double distance;
    int four;
  };
  Open stack[kDeepestFours];
  int top = 0;
  stack[top++] = {0, 0};
  while (top > 0) {
    const Open open = stack[--top];
    if (open.distance >= least) continue;
    const FourBoxes& four = fours_[static_cast<std::size_t>(open.four)];
    Eigen::Array4f squared = Eigen::Array4f::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      squared += (four.low[i] - q[axis]).max(q[axis] - four.high[i]).max(0).square();
    }
    squared = squared.min(std::numeric_limits<float>::max());
    const int others = top;
    for (int i = 0; i < four.count; ++i) {
      const double distance = scale * squared[i];
      const int child = four.child[static_cast<std::size_t>(i)];
      if (distance >= least) continue;
      if (child < 0) {
        visit(~child);
        continue;
      }
      int place = top++;  // keep the nearest on top
      for (; place > others && stack[place - 1].distance < distance; --place) stack[place] = stack[place - 1];
      stack[place] = {distance, child};
    }
  }
  if (best.triangle >= 0) best.distance = std::sqrt(least);
  return best;
}

std::vector<int> TriangleBvh::trianglesNear(const Eigen::AlignedBox3d& box, std::size_t most) const {
  std::vector<int> found;
  if (fours_.empty() || box.isEmpty()) return found;
  const Eigen::Vector3f low = inUnits(box.min()), high = inUnits(box.max());
  int stack[kDeepestFours];
  int top = 0;
  stack[top++] = 0;
  while (top > 0 && found.size() <= most) {
    const FourBoxes& four = fours_[static_cast<std::size_t>(stack[--top])];
    Eigen::Array4f away = Eigen::Array4f::Constant(-1);
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      away = away.max(four.low[i] - high[axis]).max(low[axis] - four.high[i]);
    }
    for (int i = 0; i < four.count; ++i) {
      if (away[i] > 0) continue;
      const int child = four.child[static_cast<std::size_t>(i)];
      if (child >= 0) {
        stack[top++] = child;
        continue;
      }
      const auto& [a, b, c] = corners_[static_cast<std::size_t>(~child)];
      const Eigen::AlignedBox3d own(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
      if (own.intersects(box)) found.push_back(index_[static_cast<std::size_t>(~child)]);
    }
  }
  if (found.size() > most) found.resize(most + 1);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace collision_hulls
