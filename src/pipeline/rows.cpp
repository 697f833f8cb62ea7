// A row is what the description says of a mesh (its use), what the stages found out (its result), and the names of the files that its hulls
// will have. Nothing else writes rows, but for the time that writing the files takes (output.cpp).
#include "pipeline/rows.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/counted.h"
#include "base/decimal.h"
#include "base/millimetres.h"
#include "collision_hulls/report/totals.h"
#include "geometry/bytes.h"
#include "pipeline/notes/hull_notes.h"
#include "pipeline/run.h"
#include "storage/names.h"

namespace collision_hulls {
namespace {

constexpr double kSmallestLink = 1e-3;  // [m] across
constexpr double kFarRegion = 0.1;      // of a mesh's diagonal: a region may well stand beside the mesh, as a table does

/// Names the files of hulls. Where there are several models, equal hulls of an element share a file.
class HullFiles {
 public:
  explicit HullFiles(const RobotResult& result) : result_(result), suffix_(extension(result.report.options.format)) {}

  std::vector<std::string> of(const MeshUse& use, const MeshResult& mesh) {
    std::vector<std::string> files;
    if (result_.single_mesh && !mesh.hulls.empty()) files.push_back(fileName(result_.robot_name) + "_hulls.obj");
    const std::string stem =
        result_.single_mesh ? "hull_" : "meshes/" + folderOf(use.link) + "/" + prefixOf(use) + std::to_string(use.element) + "_";
    for (std::size_t m = 0; m + mesh.primitives.size() < mesh.hulls.size(); ++m) {
      const std::string file = stem + std::to_string(m) + suffix_;
      files.push_back(result_.models.empty() ? file : shared(use, mesh.hulls[m], file));
    }
    return files;
  }

 private:
  const std::string& folderOf(const std::string& link) {
    std::string& folder = folders_[link];
    if (folder.empty()) folder = names_.take(fileName(link));
    return folder;
  }

  std::string prefixOf(const MeshUse& use) const { return use.model == 0 ? "" : result_.report.options.models[use.model].name + "_"; }

  /// The file of an equal hull, or else this one.
  const std::string& shared(const MeshUse& use, const ConvexHull& hull, const std::string& file) {
    return known_[{use.link, use.element}].emplace(toBytes(hull), file).first->second;
  }

  const RobotResult& result_;
  const std::string suffix_;
  UniqueNames names_;
  std::map<std::string, std::string> folders_;                                       // by link
  std::map<std::pair<std::string, int>, std::map<std::string, std::string>> known_;  // by link and element: files by the hull's bytes
};

ElementReport rowOf(const MeshUse& use, const MeshResult& mesh) {
  ElementReport row;
  static_cast<MeshFacts&>(row) = mesh.mesh;
  static_cast<HullFacts&>(row) = mesh.model;
  row.link = use.link;
  row.element = use.element;
  row.visual = use.visual;
  row.uri = use.source.uri;
  row.scale = use.source.scale;
  row.method = use.options.method;
  row.regions_given = use.options.regions;
  row.padding = use.options.padding;
  row.close_openings = use.options.close_openings;
  row.shapes = use.options.shapes;
  row.effort = use.options.effort;
  row.max_vertices = use.options.max_vertices;
  row.status = mesh.status;
  row.reason = mesh.reason;
  row.error = mesh.error;
  row.untried = mesh.untried;
  row.seconds = mesh.seconds;
  row.cached = mesh.cached;
  return row;
}

/// segments/<link>/<n>.ply and .csv, with the folders that the hulls of a link have in meshes/; for a single mesh segments.ply and
/// hierarchy.csv.
void addSegmentFiles(RobotResult& result) {
  for (std::size_t i = 0; i < result.elements.size(); ++i) {
    const ElementReport& row = result.report.links[i];
    if (!result.elements[i].segments || row.files.empty()) continue;
    const Segments& segments = *result.elements[i].segments;
    const std::string folder = std::filesystem::path(row.files.front()).parent_path().filename().string();
    const std::string stem = "segments/" + folder + "/" + std::to_string(row.element);
    result.extra_files[result.single_mesh ? "segments.ply" : stem + ".ply"] = segmentsPly(segments);
    result.extra_files[result.single_mesh ? "hierarchy.csv" : stem + ".csv"] = hierarchyCsv(segments);
  }
}

/// The first row of which something is true, and how many others it is true of; null if there is none.
template <typename Predicate>
std::pair<const ElementReport*, std::size_t> firstAndOthers(const Report& report, const Predicate& is_true) {
  const auto first = std::find_if(report.links.begin(), report.links.end(), is_true);
  if (first == report.links.end()) return {nullptr, 0};
  return {&*first, static_cast<std::size_t>(std::count_if(first + 1, report.links.end(), is_true))};
}

/// Whether a row has hulls; of other meshes nothing is known.
bool isDone(const ElementReport& row) {
  return row.status == Status::kOk || row.status == Status::kDegraded;
}

/// URDF and most mesh formats mean metres; a mesh that is larger than any robot link was probably drawn in millimetres.
void noteHugeMeshes(Report& report) {
  const auto is_huge = [](const ElementReport& row) { return isDone(row) && row.diagonal > kLargestLink; };
  const auto [first, others] = firstAndOthers(report, is_huge);
  if (!first) return;
  report.notes.push_back("'" + first->uri + "' is " + decimal(first->diagonal, 3) + " m across" +
                         (others > 0 ? ", and " + counted(others, "other mesh", "other meshes") + " over 20 m" : "") +
                         ": if its numbers are millimetres, scale it by 0.001 " +
                         (report.urdf.empty() ? "(--scale 0.001)" : "(scale=\"0.001 0.001 0.001\" in the description's <mesh>)"));
}

/// A scale of 0.001 is for meshes in millimetres; one in metres becomes smaller by it than any robot link.
void noteTinyMeshes(Report& report) {
  const auto is_tiny = [](const ElementReport& row) {
    return isDone(row) && row.diagonal < kSmallestLink && row.scale.cwiseAbs().maxCoeff() < 1;
  };
  const auto [first, others] = firstAndOthers(report, is_tiny);
  if (!first) return;
  report.notes.push_back("'" + first->uri + "' is " + millimetres(first->diagonal) + " across with its scale" +
                         (others > 0 ? ", and " + counted(others, "other mesh", "other meshes") + " below 1 mm" : "") +
                         ": if its numbers are metres, leave the scale out");
}

/// A length alone, though finer than the default's, makes small meshes coarser than the default, which has a share as well. Links whose
/// rules say otherwise do not count.
void noteCoarserThanDefault(Report& report) {
  const Length& tolerance = report.options.models.empty() ? report.options.tolerance : report.options.models.front().tolerance;
  const Length usual = Options().tolerance;
  if (tolerance.share != Length::kUnset || tolerance.limit >= usual.limit) return;
  const auto by_default = [&](const ElementReport& row) { return usual.metres(row.diagonal); };
  const ElementReport* finest = nullptr;
  std::size_t coarser = 0;
  for (const ElementReport& row : report.links) {
    if (!followsTolerance(row) || row.tolerance != tolerance.limit || by_default(row) >= tolerance.limit) continue;
    ++coarser;
    if (!finest || by_default(row) < by_default(*finest)) finest = &row;
  }
  if (!finest) return;
  report.notes.push_back("a tolerance of " + toString(tolerance) + " is coarser than the default for " +
                         counted(coarser, "small mesh", "small meshes") + ", such as '" + finest->uri + "' (" +
                         millimetres(by_default(*finest)) + " by default): '" + toString({tolerance.limit, usual.share}) +
                         "' is at least as fine for all");
}

/// One hull is enough for a mesh that is smaller than the tolerance.
void noteSmallMeshes(Report& report) {
  const auto is_small = [](const ElementReport& row) { return row.status != Status::kFailed && row.tolerance > row.diagonal; };
  const auto [first, others] = firstAndOthers(report, is_small);
  if (!first) return;
  report.notes.push_back("the tolerance of " + millimetres(first->tolerance) + " is larger than '" + first->uri + "', which is " +
                         millimetres(first->diagonal) + " across" +
                         (others > 0 ? ", and than " + counted(others, "other mesh", "other meshes") : "") +
                         ": one hull covers each; for more detail give a smaller tolerance, or one with a percentage, as in 1cm,5%");
}

void noteClosedOpenings(Report& report) {
  std::size_t openings = 0, meshes = 0;
  for (const ElementReport& row : report.links) openings += row.closed_openings, meshes += row.closed_openings > 0;
  if (openings == 0) return;
  report.notes.push_back(counted(openings, "opening") + " of " + counted(meshes, "mesh", "meshes") + (openings == 1 ? " was" : " were") +
                         " closed: the hulls cover the lids, too, and protrusion is measured from the closed meshes");
}

/// Of the meshes that a width to close holds for.
struct Closing {
  std::size_t closed = 0, meshes = 0;
  const ElementReport* widest = nullptr;  // has the widest opening that is left, if any is
};

void noteIdleClosing(Report& report) {
  std::map<double, Closing> closings;  // by width
  for (const ElementReport& row : report.links) {
    if (!isDone(row) || row.close_openings == 0) continue;
    Closing& closing = closings[row.close_openings];
    closing.closed += row.closed_openings;
    ++closing.meshes;
    if (!closing.widest || row.widest_opening > closing.widest->widest_opening) closing.widest = &row;
  }
  for (const auto& [width, closing] : closings) {
    if (closing.closed > 0) continue;
    const ElementReport& mesh = *closing.widest;
    const std::string why = mesh.openings > 0 ? "'" + mesh.uri + "' has " + counted(mesh.openings, "opening") + ", up to " +
                                                    millimetres(std::ceil(1000 * mesh.widest_opening) / 1000) +
                                                    " wide, which is the least that closes all of them"
                            : closing.meshes > 1 ? "none of " + std::to_string(closing.meshes) + " meshes has any"
                                                 : "'" + mesh.uri + "' has none";
    report.notes.push_back("close-openings " + toString(lengthOf(width)) + " closed nothing: " + why);
  }
}

/// What is certified of padded hulls is measured from the mesh, as of all others.
void notePadding(Report& report) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const ElementReport& row : report.links) {
    if (!isDone(row)) continue;
    least = std::min(least, row.padding);
    most = std::max(most, row.padding);
  }
  if (most > 0)
    report.notes.push_back("the protrusion includes the padding of " + std::string(least < most ? "up to " : "") + millimetres(most));
}

/// [m] At most the distance of the mesh's convex hull from the region; below 0 where no side of the region has the whole mesh behind it.
double gapTo(const Region& region, const TriangleMesh& mesh) {
  double gap = -std::numeric_limits<double>::infinity();
  for (const HalfSpace& side : region.sides) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& v : mesh.vertices) nearest = std::min(nearest, side.distance(v));
    gap = std::max(gap, nearest);
  }
  return gap;
}

/// Regions that no hull can reach were probably given in millimetres, or in another frame.
void noteFarRegions(RobotResult& result) {
  std::map<std::string, std::pair<double, std::string>> gaps;  // by the region's name: the least, and the link of that mesh
  for (std::size_t i = 0; i < result.elements.size(); ++i) {
    const ElementReport& row = result.report.links[i];
    for (const Region& region : row.regions_given) {
      const double gap = gapTo(region, result.elements[i].original);
      const double far = gap > kFarRegion * row.diagonal ? gap : 0;  // infinite for a failed mesh, which has no hulls
      const auto [known, is_new] = gaps.emplace(region.name, std::make_pair(far, row.link));
      if (!is_new && far < known->second.first) known->second = {far, row.link};
    }
  }
  for (const auto& [name, nearest] : gaps) {
    const auto& [gap, link] = nearest;
    if (gap > 0 && std::isfinite(gap))
      result.report.notes.push_back("region '" + name + "' changes nothing: it is at least " + decimal(gap, 3) + " m from " +
                                    (result.single_mesh ? "the mesh" : "link '" + link + "'") +
                                    ". Regions are in metres, in the frame of " + (result.single_mesh ? "the mesh" : "their link"));
  }
}

/// Where the link's own tolerance is as fine, a region changes nothing.
void noteCoarseRegions(Report& report) {
  std::map<std::string, const ElementReport*> rows;  // by the region's name: one of its meshes; null: the region is finer than some other's
  std::map<std::string, double> tolerances;
  for (const ElementReport& row : report.links) {
    for (const Region& region : row.regions_given) {
      if (row.status == Status::kFailed) continue;
      const ElementReport*& known = rows.emplace(region.name, &row).first->second;
      if (region.tolerance < row.tolerance) known = nullptr;
      tolerances[region.name] = region.tolerance;
    }
  }
  for (const auto& [name, row] : rows) {
    if (row)
      report.notes.push_back("region '" + name + "' changes nothing: its tolerance of " + millimetres(tolerances[name]) +
                             " is no finer than that of '" + row->uri + "', " + millimetres(row->tolerance));
  }
}

/// The hulls are what could be found in time.
void noteTimeLimit(Report& report) {
  const auto is_cut = [](const ElementReport& row) { return !row.untried.empty(); };
  const auto [first, others] = firstAndOthers(report, is_cut);
  if (!first) return;
  report.notes.push_back("the time limit ended the search for " + std::to_string(others + 1) + " of " +
                         std::to_string(totals(report).meshes) +
                         " meshes early, so they may have more hulls, or protrude further, than they need. They cover their meshes and "
                         "keep the bounds in the report; "
                         "what '" +
                         first->uri + "' had no time for: " + first->untried);
}

}  // namespace

void putTogether(const std::vector<MeshUse>& uses, const MeshResults& results, RobotResult& result, const RunControl& control) {
  HullFiles files(result);
  std::set<const MeshResult*> timed;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    control.check();
    const MeshUse& use = uses[i];
    const MeshResult& mesh = *results[i];
    ElementReport row = rowOf(use, mesh);
    if (!timed.insert(&mesh).second) row.seconds = {};  // its time counts once
    row.files = files.of(use, mesh);
    reportOf(use.model, result.report).links.push_back(std::move(row));
    modelOf(use.model, result)
        .elements.push_back(
            {use.link, use.source, use.pose, mesh.original, mesh.hulls, mesh.primitives, mesh.unneeded, mesh.segments, mesh.coarser});
  }
  addSegmentFiles(result);
  noteHugeMeshes(result.report);
  noteTinyMeshes(result.report);
  if (!result.report.scene) {  // a fit chooses how fine each link has to be
    noteCoarserThanDefault(result.report);
    for (std::string& note : notesOnHulls(result, control)) result.report.notes.push_back(std::move(note));
  }
  noteClosedOpenings(result.report);
  noteIdleClosing(result.report);
  notePadding(result.report);
  noteFarRegions(result);
  noteCoarseRegions(result.report);
  noteSmallMeshes(result.report);
  noteTimeLimit(result.report);
}

}  // namespace collision_hulls
