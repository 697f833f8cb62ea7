// Reads and repairs a mesh, builds its tree, measures its hulls, validates all uses of meshes.
//
// A mesh's size is checked as soon as it is read: in the wrong unit it would keep the later stages busy for minutes, for nothing.
#include "pipeline/stages.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/decimal.h"
#include "base/large_pages.h"
#include "base/stopwatch.h"
#include "collision_hulls/check/validate.h"
#include "collision_hulls/decompose/certified.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/error.h"
#include "collision_hulls/measure/measures.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/mesh/openings.h"
#include "collision_hulls/pipeline/fit_scene.h"
#include "decompose/certified/unproved_tree.h"
#include "decompose/finest_tolerance.h"
#include "pipeline/shapes/shapes.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kManyTriangles = 100'000;  // some 100 MB at work

/// What the method has: a node's parameter holds for requests of any.
Effort effortOf(const LinkOptions& options) {
  return options.method == Method::kCertified ? options.effort : Effort::kQuick;
}

/// Whether an opening is the gap between an edge and others along it, such as at a T-junction: nothing passes through.
bool isSlit(const Opening& opening) {
  constexpr double kSlit = 1e-3;  // of the width squared: the area of a lid
  double area = 0;
  for (std::size_t i = 0; i < opening.rim.size(); ++i) {
    const Eigen::Vector3d &a = opening.rim[i], &b = opening.rim[(i + 1) % opening.rim.size()];
    area += (a - opening.center).cross(b - opening.center).norm() / 2;
  }
  return area <= kSlit * opening.width * opening.width;
}

/// Closes openings of a mesh up to a width [m] and tells what it finds. Whether it closed any.
bool closeAsAsked(const RepairedMesh& repaired, double width, const RunControl& control, MeshResult& result) {
  MeshFacts& facts = result.mesh;
  for (const Opening& opening : openingsOf(repaired, control)) {
    if (opening.width <= width) {
      ++facts.closed_openings;
      addLid(opening, result.original);
    } else if (!isSlit(opening)) {
      ++facts.openings;
      facts.widest_opening = std::max(facts.widest_opening, opening.width);
    }
  }
  return facts.closed_openings > 0;
}

/// Short, for messages: a hostile scale has 300 digits.
std::string scaleText(const Eigen::Vector3d& scale) {
  return decimal(scale.x()) + " " + decimal(scale.y()) + " " + decimal(scale.z());
}

}  // namespace

/// A percentage of the diagonal takes the same work in every unit, so it stays allowed: for the link that really is that large.
void checkSize(const std::string& mesh, double diagonal, const Length& tolerance, const std::string& remedy) {
  if (diagonal <= kLargestLink || tolerance.limit == Length::kUnset) return;
  throw Error(ErrorCode::kTooLarge, mesh + " is " + (diagonal < 1000 ? decimal(diagonal, 3) : fixedDecimal(diagonal, 0)) +
                                        " m across, larger than any robot link: if its numbers are millimetres, " + remedy +
                                        "; if it really is that large, give the tolerance only as a percentage, such as 1%");
}

double toleranceFor(const TriangleMesh& mesh, const Length& tolerance) {
  const double metres = tolerance.metres(diagonal(mesh));
  if (metres > 0) return metres;
  throw Error(ErrorCode::kEmptyMesh, "all " + std::to_string(mesh.triangles.size()) +
                                         " triangles lie in one point, so a percentage of the mesh's size is a tolerance of 0; give "
                                         "only a length, such as 1mm, or repair the mesh");
}

void setTolerance(const MeshTask& task, const LinkOptions& options, MeshResult& result) {
  const std::string name = "'" + task.uri + "'", scale = scaleText(task.scale);
  if (!std::isfinite(result.mesh.diagonal))
    throw Error(ErrorCode::kTooLarge, name + " is so large that its size overflows, with the scale '" + scale +
                                          "'; correct the scale, or the file's coordinates");
  constexpr double kMillimetre = 0.001;
  const std::string instead = task.scale == Eigen::Vector3d::Ones() ? "" : " in place of '" + scale + "'";
  checkSize(
      name, result.mesh.diagonal, options.tolerance,
      task.scale.cwiseAbs().maxCoeff() <= kMillimetre
          ? "they are too large for the scale '" + scale + "': give a smaller one"
          : "scale it by 0.001" + instead + " (--scale 0.001 for a mesh file, scale=\"0.001 0.001 0.001\" in a description's <mesh>)");
  result.mesh.tolerance = toleranceFor(result.original, options.tolerance);
  expectResolvable(result.mesh.tolerance, result.mesh.diagonal, task.uri);
}

MeshLimits meshLimits(const Options& options) {
  MeshLimits limits;
  limits.reader_memory = static_cast<std::uintmax_t>(options.reader_memory) << 20;
  limits.reader_seconds = options.reader_time;
  return limits;
}

void checkForRobot(const Options& options) {
  if (options.scale == 1) return;
  const std::string s = decimal(options.scale);
  throw Error(ErrorCode::kBadOption, "scale '" + s +
                                         "' is for a single mesh; a robot's description scales its meshes itself: write scale=\"" + s +
                                         " " + s + " " + s + "\" in its <mesh> elements");
}

void checkForMesh(const std::string& path, const Options& options) {
  const auto refuse = [&](const std::string& item, const std::string& place) {
    throw Error(ErrorCode::kBadOption, (place.empty() ? "" : place + ": ") + item + ": '" + path +
                                           "' is a single mesh, which has no links and one model; give a robot description");
  };
  if (!options.links.empty()) refuse("links '" + options.links + "'", options.links_place);
  if (!options.rules.empty()) refuse("links '" + options.rules.front().pattern + "'", options.rules.front().place);
  for (const RegionRule& rule : options.region_rules)
    if (!rule.pattern.empty()) refuse("link '" + rule.pattern + "' of region '" + rule.name + "'", rule.place);
  if (options.shapes != Shapes::kHulls)
    throw Error(ErrorCode::kBadOption, std::string("shapes '") + name(options.shapes) + "': '" + path +
                                           "' is a mesh, and mesh files hold no primitives; give a robot description that names it");
  if (!options.models.empty()) refuse("model '" + options.models.front().name + "'", "");
}

const ReadMesh& SharedMesh::read(const LinkOptions& options, const RunControl& control, MeshResult& result) {
  if (read_) {
    result = known_;
    setTolerance(task_, options, result);
    return *read_;
  }
  MeshFacts& facts = result.mesh;
  Stopwatch stage;

  // 1. Read, and scale as the description says.
  facts.sha256 = task_.sha256;
  const MeshLimits limits = meshLimits(options_);
  LoadedMesh loaded = parseMesh(contentOf(task_, limits, control), task_.file, limits, control);
  facts.triangles = loaded.mesh.triangles.size();
  facts.skipped_primitives = loaded.skipped_primitives;
  result.original = scaled(std::move(loaded.mesh), task_.scale);
  facts.diagonal = diagonal(result.original);
  setTolerance(task_, options, result);
  result.seconds.read = stage.lap();

  // 2. Repair: a mesh with topology, closed if that is asked for, and the solid that it stands for.
  ReadMesh read{repair(result.original, {}, control)};
  if (closeAsAsked(read.repaired, task_.close_openings, control, result)) read.repaired = repair(result.original, {}, control);
  facts.repair = read.repaired.counts;
  read.margin = readingError(loaded.resolution) * task_.scale.cwiseAbs().maxCoeff() + read.repaired.counts.weld_distance;
  result.solid = std::make_shared<const Solid>(read.repaired, control);
  facts.interior = name(result.solid->interior());
  facts.volume = result.solid->volume();
  result.seconds.repair = stage.lap();
  if (task_.variants.size() > 1) known_ = result;
  known_.seconds = {};
  return read_.emplace(std::move(read));
}

/// The tree is built without a cap on hulls: caps choose a cut, so one tree serves them all.
std::shared_ptr<const HullTree> SharedMesh::tree(const LinkOptions& options, double tolerance, const RunControl& control) {
  const std::string key = treeKey(task_, options, options_.seed, tolerance);
  std::shared_ptr<const HullTree>& tree = trees_[key];
  if (tree) return tree;
  if (std::optional<HullTree> known = cache_.findTree(key)) return tree = std::make_shared<const HullTree>(std::move(*known));
  built_tree_ = true;
  const auto make = takesTreeWithoutProof(options) ? hullTreeWithoutProof : hullTree;
  HullTree built =
      make(read_->repaired, {options.method, tolerance, 0, options.max_vertices, options_.seed, effortOf(options), options.fill, {}, 0},
           control);
  cache_.storeTree(key, built);
  return tree = std::make_shared<const HullTree>(std::move(built));
}

HullFacts factsOf(const std::vector<ConvexHull>& hulls, std::size_t primitives, const Solid& solid, const Protrusion& proof,
                  const RunControl& control) {
  HullFacts facts;
  facts.primitives = primitives;
  facts.least_hulls = 1;
  facts.hulls = hulls.size() - primitives;
  for (std::size_t i = 0; i < facts.hulls; ++i) facts.hull_vertices += hulls[i].vertices.size();
  facts.protrusion = proof.bound;
  facts.protrusion_found = proof.found;
  facts.worst = proof.where;
  facts.worst_nearest = proof.nearest;
  facts.hull_volume = unionVolume(hulls, control);
  facts.covered_share = coveredShare(hulls, solid, control);
  return facts;
}

void decomposeAndCertify(const ReadMesh& read, const LinkOptions& options, const HullTree* tree, const std::string& uri, std::uint64_t seed,
                         const RunControl& control, MeshResult& result) {
  const auto make = options.shapes == Shapes::kHulls ? decomposeHulls : shapeAndCertify;
  make(read, options, tree, uri, seed, control, result);
}

/// The solid is known only up to the margin, so the bound includes it.
void decomposeHulls(const ReadMesh& read, const LinkOptions& options, const HullTree* tree, const std::string& uri, std::uint64_t seed,
                    const RunControl& control, MeshResult& result) {
  const DecomposeOptions how{options.method,    result.mesh.tolerance, options.max_hulls, options.max_vertices, seed,
                             effortOf(options), options.fill,          options.regions,   options.padding};
  CertifiedHulls made = certifiedHulls({result.original, read.repaired, *result.solid, read.margin, tree, uri}, how, control);
  Stopwatch stage;
  result.hulls = std::move(made.hulls);
  result.model = factsOf(result.hulls, 0, *result.solid, {made.bound, made.found, made.where, made.nearest}, control);
  if (made.least_hulls) result.model.least_hulls = *made.least_hulls;
  result.model.nudge = made.nudge;
  result.model.thickness = made.thickness;
  result.model.regions = std::move(made.regions);
  result.status = made.within_tolerance ? Status::kOk : Status::kDegraded;
  result.reason = made.reason;
  result.untried = made.untried;
  result.seconds.decompose += made.seconds.decompose;
  result.seconds.certify = made.seconds.certify + stage.lap();
}

Validation validateUses(const std::vector<MeshUse>& uses, const MeshResults& results, std::size_t model, std::uint64_t seed,
                        const RunControl& control) {
  std::size_t triangles = 0;
  for (const auto& mesh : results) triangles += mesh->mesh.triangles;
  if (triangles >= kManyTriangles) giveBackFreedMemory();  // FCL's trees take more than decomposing leaves in one piece
  std::vector<ValidationPair> pairs;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const MeshUse& use = uses[i];
    const MeshResult& mesh = *results[i];
    if (use.model != model || mesh.hulls.empty()) continue;
    control.check();
    ValidationPair pair;
    pair.name = use.link + "/" + std::to_string(use.element);
    pair.original = transformed(mesh.original, use.pose);
    for (const ConvexHull& hull : mesh.hulls) pair.hulls.push_back(transformed(hull, use.pose));
    for (const GeometryElement& primitive : mesh.primitives) {
      if (primitive.kind == GeometryElement::Kind::kSphere)
        pair.spheres.push_back({use.pose * primitive.origin.translation(), primitive.size.x()});
      else
        pair.spheres.clear();  // only the last hulls may stand for spheres
    }
    pair.protrusion = mesh.model.protrusion;
    pair.solid = mesh.solid;
    pair.solid_pose = use.pose;
    pairs.push_back(std::move(pair));
  }
  ValidationOptions options;
  options.seed = seed;
  return validate(std::move(pairs), options, control);
}

}  // namespace collision_hulls
