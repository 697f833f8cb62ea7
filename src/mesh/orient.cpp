// Flood fill over manifold edges gives patches with consistent triangles; signed volumes, with fans over the openings, then tell which
// patches and components face inward. Linear, apart from sorting the boundary.
#include "mesh/orient.h"

#include <cmath>

#include "base/at.h"
#include "base/looks.h"
#include "mesh/boundary.h"

namespace collision_hulls {
namespace {

struct Patch {
  int component = 0;
  double area = 0;
  double turned_area = 0;  // of the triangles whose direction differs from the first one's
  double volume = 0;       // with the fans that close the patch
  bool closed = false;     // or nearly so, on its own
  bool turn = false;
};

class Orientation {
 public:
  Orientation(const TriangleMesh& mesh, const Edges& edges, const RunControl& control)
      : mesh_(mesh),
        edges_(edges),
        control_(control),
        look_(control),
        origin_(boundingBox(mesh).center()),
        turned_(mesh.triangles.size(), 0),
        patch_of_(mesh.triangles.size(), -1) {}

  OrientedPatches solve() {
    for (int t = 0; t < static_cast<int>(turned_.size()); ++t)
      if (patch_of_[at(t)] < 0) growPatch(t);
    turn([](const Patch& patch) { return 2 * patch.turned_area > patch.area; });
    measureVolumes();
    const std::vector<char> negative = negativeComponents();
    turn([&](const Patch& patch) { return negative[at(patch.component)] != 0; });
    turn([](const Patch& patch) { return patch.closed && isNegative(patch.volume, patch.area); });
    return {std::move(turned_), std::move(patch_of_), patches_.size()};
  }

 private:
  static bool isNegative(double volume, double area) { return volume < -kNilVolume * area * std::sqrt(area); }

  /// Numbers the triangles reachable from `seed` across manifold edges and flips those that disagree with it.
  void growPatch(int seed) {
    const int number = static_cast<int>(patches_.size());
    Patch patch;
    patch.component = edges_.component[at(seed)];
    std::vector<int> front{seed};
    patch_of_[at(seed)] = number;
    while (!front.empty()) {
      look_();
      const int t = front.back();
      front.pop_back();
      const double area = triangleArea(mesh_, t);
      patch.area += area;
      if (turned_[at(t)]) patch.turned_area += area;
      for (int h = 3 * t; h < 3 * t + 3; ++h) {
        const int twin = edges_.twin[at(h)];
        if (twin < 0 || patch_of_[at(twin / 3)] >= 0) continue;
        const bool agrees = startOf(mesh_.triangles, h) == endOf(mesh_.triangles, twin);
        turned_[at(twin / 3)] = agrees ? turned_[at(t)] : !turned_[at(t)];
        patch_of_[at(twin / 3)] = number;
        front.push_back(twin / 3);
      }
    }
    patches_.push_back(patch);
  }

  /// Flips the patches chosen.
  template <typename Choice>
  void turn(const Choice& choice) {
    for (Patch& patch : patches_) {
      patch.turn = choice(patch);
      if (patch.turn) patch.volume = -patch.volume;
    }
    for (std::size_t t = 0; t < turned_.size(); ++t) {
      look_();
      if (patches_[at(patch_of_[t])].turn) turned_[t] = !turned_[t];
    }
  }

  void measureVolumes() {
    for (int t = 0; t < static_cast<int>(turned_.size()); ++t) {
      look_();
      patches_[at(patch_of_[at(t)])].volume += (turned_[at(t)] ? -1 : 1) * volumeBehind(mesh_, t, origin_);
    }
    const std::vector<Closure> closing = closures(mesh_.vertices, patchBoundaries(), patches_.size(), origin_, control_);
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      patches_[i].volume += closing[i].volume;
      patches_[i].closed = closing[i].area < kSmallOpening * patches_[i].area;
    }
  }

  std::vector<BoundaryEdge> patchBoundaries() {
    std::vector<BoundaryEdge> boundary;
    for (int h = 0; h < static_cast<int>(edges_.twin.size()); ++h) {
      look_();
      if (edges_.twin[at(h)] < 0) boundary.push_back(boundaryEdge(mesh_, h, turned_, patch_of_));
    }
    return boundary;
  }

  std::vector<char> negativeComponents() const {
    std::vector<double> volume(edges_.components, 0), area(edges_.components, 0);
    for (const Patch& patch : patches_) {
      volume[at(patch.component)] += patch.volume;
      area[at(patch.component)] += patch.area;
    }
    std::vector<char> negative(edges_.components);
    for (std::size_t c = 0; c < negative.size(); ++c) negative[c] = isNegative(volume[c], area[c]);
    return negative;
  }

  const TriangleMesh& mesh_;
  const Edges& edges_;
  const RunControl& control_;
  Looks look_;
  Eigen::Vector3d origin_;
  std::vector<char> turned_;
  std::vector<int> patch_of_;
  std::vector<Patch> patches_;
};

}  // namespace

OrientedPatches orient(const TriangleMesh& mesh, const Edges& edges, const RunControl& control) {
  if (mesh.triangles.empty()) return {};
  return Orientation(mesh, edges, control).solve();
}

}  // namespace collision_hulls
