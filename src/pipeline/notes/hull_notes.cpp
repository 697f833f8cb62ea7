// Each mesh counts for one reason at most, the first that holds in the order of `Cause`.
#include "pipeline/notes/hull_notes.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>

#include "base/counted.h"
#include "base/millimetres.h"
#include "report/largest_tolerance.h"
#include "verify/convex_parts.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kManyHulls = 40;   // of a mesh
constexpr std::size_t kManyInAll = 500;  // of a robot
constexpr std::size_t kHullsOfShell = 8;
constexpr double kHollow = 0.25;  // of the hulls' volume: shells have less inside
constexpr double kWide = 0.2;     // of the diagonal: with such openings a shell has hardly an inside, whatever volume it seems to have
constexpr std::size_t kManyParts = 20;         // of a mesh, with as many hulls
constexpr std::size_t kMostOfModel = 100'000;  // triangles: a collision mesh of convex parts has fewer
constexpr std::size_t kOthersOfModel = 10;     // one in so many triangles may belong to a part that is not convex
constexpr double kNearlyAll = 0.9;             // of the vertices that hulls may have
constexpr std::size_t kSeveral = 4;            // hulls of a mesh that might take one
constexpr std::size_t kLongestName = 60;       // of a link, in a note

/// Why a mesh took many hulls.
enum class Cause { kVertexLimit, kConvexParts, kLooseParts, kOpenShell, kDetail, kNone };

/// A round body that one hull would do for takes several where each may have few vertices.
bool isLimited(const ElementReport& row) {
  const double most = static_cast<double>(row.max_vertices) * static_cast<double>(row.hulls);
  return row.max_vertices > 0 && row.effort != Effort::kInstant && row.padding == 0 && row.untried.empty() && row.hulls >= kSeveral &&
         row.least_hulls == 1 && static_cast<double>(row.hull_vertices) >= kNearlyAll * most;
}

/// Parts that nothing can reach are solid inside a watertight housing. Inside an open one they have to be covered, each by hulls of its
/// own.
bool isLoose(const ElementReport& row) {
  return row.repair.components >= kManyParts && row.hulls >= kManyParts;
}

/// How many parts a mesh has that are convex, and others.
struct PartCounts {
  std::size_t convex = 0, others = 0;
};

/// Of a mesh such as the output of another program that decomposes meshes; nullopt: it is none.
std::optional<PartCounts> convexModel(const ElementReport& row, const TriangleMesh& mesh, const RunControl& control) {
  if (row.openings > 0 || mesh.triangles.size() > kMostOfModel) return std::nullopt;
  const ConvexParts parts = convexParts(mesh, control);
  if (parts.hulls.size() < kManyParts || kOthersOfModel * parts.rest.triangles.size() > mesh.triangles.size()) return std::nullopt;
  return PartCounts{parts.hulls.size(), parts.rest_parts};
}

/// A shell without thickness has no inside, so hulls have to follow its skin; a robot's covers stand for solids all the same. Closing a
/// body that has most of its inside already, as those with small openings do, changes little, and wider openings than the option takes stay
/// open.
bool isOpenShell(const ElementReport& row) {
  return row.openings > 0 && row.widest_opening <= kLargestTolerance && row.hulls >= kHullsOfShell &&
         (row.volume < kHollow * row.hull_volume || row.widest_opening > kWide * row.diagonal);
}

/// `parts`: those of a mesh of convex parts.
Cause causeOf(const ElementReport& row, const TriangleMesh& mesh, const RunControl& control, PartCounts& parts) {
  if (!followsTolerance(row)) return Cause::kNone;
  if (isLimited(row)) return Cause::kVertexLimit;
  if (isLoose(row)) {
    const std::optional<PartCounts> counts = convexModel(row, mesh, control);
    parts = counts.value_or(PartCounts());
    return counts ? Cause::kConvexParts : Cause::kLooseParts;
  }
  if (isOpenShell(row)) return Cause::kOpenShell;
  return row.hulls >= kManyHulls ? Cause::kDetail : Cause::kNone;
}

/// Meshes with the same cause: the first of those with most hulls, and how many others there are.
struct Alike {
  const ElementReport* most = nullptr;
  PartCounts parts;  // of that one
  std::size_t others = 0;
};

std::string took(const ElementReport& row) {
  return "took " + counted(row.hulls, "hull");
}

std::string likeIt(std::size_t others) {
  return others > 0 ? "; " + counted(others, "other mesh is", "other meshes are") + " like it" : "";
}

std::string vertexLimitText(const ElementReport& row, std::size_t others) {
  return took(row) + " with nearly as many vertices each as they may have (" + std::to_string(row.max_vertices) + ")" + likeIt(others) +
         ": with more, as in --max-vertices 256, or without a limit (0), far fewer may do";
}

std::string convexPartsText(const ElementReport& row, const PartCounts& parts, std::size_t others, bool single_mesh) {
  return "already consists of " + counted(parts.convex, "convex part") +
         (parts.others > 0 ? " and " + counted(parts.others, "other") : "") + ", and " + took(row) + likeIt(others) + ": use it as it is" +
         (single_mesh ? "" : " ('keep' in a configuration)") + ", or give a larger tolerance for fewer hulls";
}

std::string loosePartsText(const ElementReport& row, std::size_t others) {
  const std::string closing =
      row.openings > 0 ? "if parts lie in a housing with openings, --close-openings makes it solid, and they take no hulls; or " : "";
  return "consists of " + std::to_string(row.repair.components) + " loose parts and " + took(row) + likeIt(others) + ": " + closing +
         "remove parts that nothing can touch";
}

std::string openShellText(const ElementReport& row, std::size_t others) {
  const double width = std::ceil(100 * row.widest_opening) / 100;
  return "has " + counted(row.openings, "opening") + " and " + took(row) + likeIt(others) +
         ": if it is the skin of a solid, --close-openings " + toString(lengthOf(width)) + " makes it that solid, which may take far fewer";
}

/// Null: the row has none.
const Region* finestRegion(const ElementReport& row) {
  const auto finer = [](const Region& a, const Region& b) { return a.tolerance < b.tolerance; };
  const auto finest = std::min_element(row.regions_given.begin(), row.regions_given.end(), finer);
  return finest == row.regions_given.end() ? nullptr : &*finest;
}

/// How a configuration gives the row's link alone a tolerance of about twice its own. Empty for a name that is no plain word, which would
/// have to be quoted there.
std::string largerToleranceText(const ElementReport& row) {
  const auto is_plain = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  if (row.link.size() > kLongestName || !std::all_of(row.link.begin(), row.link.end(), is_plain)) return "";
  const double tolerance = std::ceil(2000 * row.tolerance) / 1000;
  if (tolerance > kLargestTolerance) return "";
  return ", also for single links ('links: {" + row.link + ": {tolerance: " + toString(lengthOf(tolerance)) + "}}' in a configuration)";
}

std::string detailText(const ElementReport& row, std::size_t others, bool single_mesh) {
  const Region* const region = finestRegion(row);
  const bool is_finer = region && region->tolerance < row.tolerance;
  return took(row) + " at a tolerance of " + millimetres(row.tolerance) +
         (is_finer ? " and, in region '" + region->name + "', of " + millimetres(region->tolerance) : "") + likeIt(others) + ": " +
         (is_finer ? "a smaller region, or a larger tolerance in it, may make fewer" : "a larger tolerance makes fewer") +
         (is_finer || single_mesh ? "" : largerToleranceText(row)) + "; so does a limit, as in --max-hulls 16";
}

std::string noteOn(Cause cause, const Alike& alike, bool single_mesh) {
  const auto text = [&] {
    switch (cause) {
      case Cause::kVertexLimit: return vertexLimitText(*alike.most, alike.others);
      case Cause::kConvexParts: return convexPartsText(*alike.most, alike.parts, alike.others, single_mesh);
      case Cause::kLooseParts: return loosePartsText(*alike.most, alike.others);
      case Cause::kOpenShell: return openShellText(*alike.most, alike.others);
      case Cause::kDetail: return detailText(*alike.most, alike.others, single_mesh);
      case Cause::kNone: break;
    }
    return std::string();
  };
  return "'" + alike.most->uri + "' " + text();
}

/// More hulls than planners and simulators like for a whole robot; empty: it has fewer, or a single mesh, of which others tell.
std::string noteOnAll(const Report& report) {
  std::size_t hulls = 0, meshes = 0;
  for (const ElementReport& row : report.links)
    if (followsTolerance(row)) hulls += row.hulls, ++meshes;
  if (hulls <= kManyInAll || meshes == 1) return "";
  return std::to_string(meshes) + " meshes took " + std::to_string(hulls) +
         " hulls: for fewer, give a larger tolerance, and for small parts a larger percentage with it, as in 3cm,20%; or limit the "
         "hulls of each mesh, as in --max-hulls 4";
}

}  // namespace

bool followsTolerance(const ElementReport& row) {
  return (row.status == Status::kOk || row.status == Status::kDegraded) && row.method == Method::kCertified && row.shapes == Shapes::kHulls;
}

std::vector<std::string> notesOnHulls(const RobotResult& result, const RunControl& control) {
  std::map<Cause, Alike> causes;
  for (std::size_t i = 0; i < result.elements.size(); ++i) {
    const ElementReport& row = result.report.links[i];
    PartCounts parts;
    const Cause cause = causeOf(row, result.elements[i].original, control, parts);
    if (cause == Cause::kNone) continue;
    Alike& alike = causes[cause];
    if (alike.most) ++alike.others;
    if (!alike.most || row.hulls > alike.most->hulls) alike.most = &row, alike.parts = parts;
  }
  std::vector<std::string> notes;
  for (const auto& [cause, alike] : causes) notes.push_back(noteOn(cause, alike, result.single_mesh));
  if (std::string note = noteOnAll(result.report); !note.empty()) notes.push_back(std::move(note));
  return notes;
}

}  // namespace collision_hulls
