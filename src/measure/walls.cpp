// Tells inside from outside by the winding number of the surface. The rim (edges whose triangles are unbalanced) falls into loops: narrow
// ones are cracks, closed by lids that count as surface; the others are openings (lids.h). The closed surface's winding number is a count
// of ray crossings; subtracting that of the openings' lids gives the generalized winding number at little more cost. Near openings, the
// number's gradient bounds how far the border of the solid can be (Biot-Savart).
#include "measure/walls.h"

#include <cmath>
#include <limits>

namespace collision_hulls {

namespace {

// With openings: points with a larger computed winding number surely are inside, where the true one exceeds 1/2; and what balls inside S
// leave in reserve.
constexpr double kSurelyInside = 0.55, kReserve = 0.02;
constexpr std::array<double, 2> kRoughErrors{0.3, 0.05};
static_assert(TriangleBvh::kWindingError < kSurelyInside - 0.5, "a point outside might count as inside");

}  // namespace

TriangleMesh closedSurface(const TriangleMesh& mesh, const Lids& lids) {
  TriangleMesh result = mesh;
  if (!lids.vertices.empty()) result.vertices = lids.vertices;
  for (const std::vector<Triangle>* triangles : {&lids.of_cracks, &lids.of_openings})
    result.triangles.insert(result.triangles.end(), triangles->begin(), triangles->end());
  return result;
}

Walls::Walls(const TriangleMesh& open, const Lids& all_lids, std::size_t triangles, const std::shared_ptr<const TriangleBvh>& surface,
             const RunControl& control)
    : closed(
          all_lids.vertices.empty() && open.triangles.size() == triangles
              ? surface
              : std::make_shared<TriangleBvh>(closedSurface(open, all_lids), std::vector<char>(), control, TriangleBvh::Keeps::kNothing)),
      lids({all_lids.vertices, all_lids.of_openings}, {}, control),
      rim(open.vertices, all_lids.rim_of_openings, control),
      crack_width(all_lids.crack_width),
      has_sheets(open.triangles.size() != triangles),
      blur(std::max(closed->blur(), surface->blur())),
      volume(signedVolume(open)) {}

bool Winding::isInside() {
  for (std::size_t i = 0; i < kRoughErrors.size(); ++i)
    if (margin(i) > 0) return rough(i).number > kSurelyInside;
  return exact() > kSurelyInside;
}

double Winding::wayToBorder(double enough) {
  double way = 0;
  for (std::size_t i = 0; i < kRoughErrors.size() && way <= enough; ++i) way = std::max(way, wayTo(margin(i) - kReserve));
  return way > 0 ? way : exactWayToBorder();
}

double Winding::exactWayToBorder() {
  return wayTo(std::abs(exact() - kSurelyInside) - kReserve);
}

bool Winding::isBorderBeyond(double length) {
  return wayTo(margin(0) - kReserve) > length;
}

double Winding::wayToHalf() {
  return wayTo(0.5 - exact() - (walls_.hasOpenings() ? TriangleBvh::kWindingError : 0));
}

bool Winding::isHalfBeyond(double length) {
  for (std::size_t i = 0; i < kRoughErrors.size() && walls_.hasOpenings(); ++i) {
    const double margin = 0.5 - rough(i).number, error = rough(i).error;
    if (wayTo(margin - error) > length) return true;
    if (wayTo(margin + error) <= length) return false;
  }
  return wayToHalf() > length;
}

/// Differs from the true number by no more than `error`.
const TriangleBvh::RoughWinding& Winding::rough(std::size_t i) {
  if (!rough_[i]) {
    rough_[i] = walls_.lids.roughWindingNumber(aside_, kRoughErrors[i]);
    rough_[i]->number = crossings_ - rough_[i]->number;
  }
  return *rough_[i];
}

/// Not more than what exact() is from the border.
double Winding::margin(std::size_t i) {
  return std::abs(rough(i).number - kSurelyInside) - rough(i).error - TriangleBvh::kWindingError;
}

double Winding::exact() {
  if (!exact_) exact_ = crossings_ - (walls_.hasOpenings() ? walls_.lids.windingNumber(aside_) : 0);
  return *exact_;
}

/// A lower bound on the length of any path from the point to where the winding number differs by `margin` that does not cross the surface.
double Winding::wayTo(double margin) {
  if (margin <= 0) return 0;
  if (!walls_.hasOpenings()) return std::numeric_limits<double>::infinity();
  if (!rim_) rim_ = walls_.rim.from(p_);
  return rim_->way(margin);
}

}  // namespace collision_hulls
