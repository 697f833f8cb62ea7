// Clusters of triangles and their hierarchy, as files. They are computed apart from the hulls, since the cache may have those: hacd gives
// the same clusters for the same mesh.
#include "collision_hulls/decompose/segments.h"

#include <algorithm>
#include <cmath>

#include "base/decimal.h"
#include "collision_hulls/mesh/repair.h"

namespace collision_hulls {

namespace {

constexpr std::size_t kMostRows = 1000;  // of a hierarchy: nobody looks at the first merges of thousands of triangles
constexpr double kSame = 1e-8;           // concavities that differ by less than this share differ by rounding
constexpr double kGoldenRatio = 0.6180339887498949;

/// Hue in turns, saturation and value in [0, 1].
Rgb fromHsv(double hue, double saturation, double value) {
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + 6 * hue, 6.0);
    return static_cast<std::uint8_t>(std::lround(255 * (value - value * saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0))));
  };
  return {channel(5), channel(3), channel(1)};
}

}  // namespace

Segments segmentsOf(const TriangleMesh& original, double epsilon, const RunControl& control) {
  Segments result;
  result.mesh = repair(original, {}, control).mesh;
  result.segmentation = hacdSegmentation(result.mesh, epsilon, control);
  return result;
}

Rgb clusterColour(std::size_t k) {
  constexpr double kSaturation[] = {0.7, 0.5, 0.85}, kValue[] = {0.95, 0.8, 0.65};
  const double turns = kGoldenRatio * static_cast<double>(k);
  return fromHsv(turns - std::floor(turns), kSaturation[k % 3], kValue[k / 3 % 3]);
}

std::string segmentsPly(const Segments& segments) {
  const std::vector<std::vector<int>>& clusters = segments.segmentation.clusters;
  std::vector<Rgb> colours;
  for (std::size_t k = 0; k < clusters.size(); ++k) colours.push_back(clusterColour(k));
  return encodePly(segments.mesh, clusters, colours);
}

std::string hierarchyCsv(const Segments& segments) {
  const std::vector<double>& merges = segments.segmentation.merges;
  std::ostringstream text = decimalStream(9);
  text << "concavity,clusters\n";
  for (std::size_t i = 0; i < merges.size(); ++i) {
    const bool is_last_at_its_height = i + 1 == merges.size() || merges[i + 1] > merges[i] * (1 + kSame);
    const std::size_t clusters = segments.mesh.triangles.size() - i - 1;
    if (is_last_at_its_height && clusters <= kMostRows) text << merges[i] << "," << clusters << "\n";
  }
  return text.str();
}

}  // namespace collision_hulls
