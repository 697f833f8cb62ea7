// Reads both descriptions' bodies, measures the links they share, and asks for collisions. What only one side has becomes a row, too.
#include "collision_hulls/verify/verify.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <optional>

#include "base/counted.h"
#include "base/decimal.h"
#include "base/millimetres.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "collision_hulls/error.h"
#include "collision_hulls/report/options.h"
#include "collision_hulls/robot/kinematics.h"
#include "report/link_pattern.h"
#include "robot/link_names.h"
#include "verify/compare_link.h"
#include "verify/joint_differences.h"
#include "verify/trials.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostPairs = 1000;  // of links, in a report
constexpr double kOtherUnit = 10;         // by which all links of one description are larger if it is in another unit
constexpr double kElsewhere = 1e-6;       // [m, and of rotation matrices] by which a link's place may differ between the descriptions

/// What is seen of a link; primitives of no size are nothing, as for decompose().
std::vector<GeometryElement> visualsOf(const LinkDescription& link) {
  std::vector<GeometryElement> elements;
  std::copy_if(link.visuals.begin(), link.visuals.end(), std::back_inserter(elements),
               [](const GeometryElement& element) { return element.kind == GeometryElement::Kind::kMesh || isSolidPrimitive(element); });
  return elements;
}

std::vector<GeometryElement> elementsOf(const LinkDescription& link, const VerifyOptions& options) {
  const std::vector<GeometryElement> visuals = visualsOf(link);
  if (options.made_from) {
    const auto known = options.made_from->of_link.find(link.name);
    const Source source = known != options.made_from->of_link.end() ? known->second : options.made_from->source;
    const SourceElements made_from = sourceElements(link, source);
    const std::vector<GeometryElement>& elements = made_from.visual ? visuals : made_from.elements;
    return elements.empty() ? link.collisions : elements;  // which a link without visual elements keeps
  }
  return options.source == Source::kCollision || (options.source == Source::kAuto && visuals.empty()) ? link.collisions : visuals;
}

/// A link of either side, and what became of it.
struct Work {
  std::size_t link = 0;  // index in ORIGINAL, if it is there
  LinkBodies original, result;
  std::unique_ptr<const LinkPair> pair;  // once it is measured
  double result_diagonal = 0;            // [m] of RESULT's bounding box, likewise
};

/// [m] Of the bounding box.
double diagonalOf(const LinkPair& pair) {
  Eigen::AlignedBox3d all = boundingBox(pair.result().rest());
  for (const Eigen::AlignedBox3d& box : pair.bodies().boxes()) all.extend(box);
  return all.diagonal().norm();
}

/// Whether there is a gate and the bound is beyond it; adds why.
bool exceeds(const std::optional<double>& gate, const Largest& largest, const std::string& what, std::string& reason) {
  if (!gate || largest.bound <= *gate) return false;
  reason += (reason.empty() ? "" : "; ") + what + " by up to " + millimetresBeyond(largest.bound, *gate) + " (found " +
            millimetres(largest.found) + "), more than the allowed " + millimetres(*gate);
  return true;
}

/// Those that differ in most configurations come first; leaves out those beyond the most.
void rank(std::vector<PairVerification>& pairs) {
  const auto differs_more = [](const PairVerification& a, const PairVerification& b) {
    return a.missed + a.phantom > b.missed + b.phantom;
  };
  std::stable_sort(pairs.begin(), pairs.end(), differs_more);
  if (pairs.size() > kMostPairs) pairs.resize(kMostPairs);
}

class Verifier {
 public:
  Verifier(const Description& original, const Description& result, const VerifyOptions& options, const RunControl& control)
      : original_(original), result_(result), options_(options), control_(control) {}

  Verification run() {
    Stopwatch watch;
    list();
    forEachInTurn(rows_.size(), [&](std::size_t i) { measure(i); });
    Verification done;
    done.configurations = options_.configurations;
    query(done);
    addNotes(done);
    done.links = std::move(rows_);
    done.seconds = watch.lap();
    return done;
  }

 private:
  /// A row for each link with geometry on either side.
  void list() {
    const LinkPattern pattern(options_.links.empty() ? ".*" : options_.links, "--links");
    std::map<std::string, const LinkDescription*> of_result;
    for (const LinkDescription& link : result_.robot.links) of_result[link.name] = &link;
    MeshFiles originals(original_, options_.mesh_limits, false, control_, options_.close_openings),
        results(result_, options_.mesh_limits, true, control_);
    for (std::size_t i = 0; i < original_.robot.links.size(); ++i) {
      control_.check();
      const LinkDescription& link = original_.robot.links[i];
      const auto other = of_result.find(link.name);
      const LinkDescription* const result = other == of_result.end() ? nullptr : other->second;
      if (result) noteElsewhere(link, *result);
      if (pattern.matches(link.name))
        add(i, link.name, originals.bodiesOf(elementsOf(link, options_)), result ? results.bodiesOf(result->collisions) : LinkBodies(),
            !result);
      if (result) of_result.erase(other);
    }
    for (const LinkDescription& link : result_.robot.links) {
      control_.check();
      if (of_result.count(link.name) && pattern.matches(link.name))
        add(0, link.name, LinkBodies(), results.bodiesOf(link.collisions), true);
    }
  }

  /// `alone`: the other description has no such link.
  void add(std::size_t index, const std::string& name, LinkBodies original, LinkBodies result, bool alone) {
    LinkVerification row;
    row.link = name;
    if (original.empty() && result.empty() && original.fault.empty() && result.fault.empty()) return;
    if (!original.fault.empty() || !result.fault.empty()) {
      row.status = LinkStatus::kFailed;
      row.reason = original.fault.empty() ? "RESULT: " + result.fault : "ORIGINAL: " + original.fault;
      row.uri = original.fault.empty() ? result.fault_uri : original.fault_uri;
    } else if (result.empty()) {
      row.status = LinkStatus::kMissing;
      row.reason = alone ? "RESULT has no such link" : "RESULT has no collision geometry here";
      if (alone) of_original_alone_.push_back(name);
      row.uncovered.bound = row.uncovered.found = std::numeric_limits<double>::infinity();
      row.uncovered_share = 1;
    } else if (original.empty()) {
      row.status = LinkStatus::kAdded;
      row.reason = alone ? "ORIGINAL has no such link" : "ORIGINAL has no geometry here to compare with";
      if (alone) of_result_alone_.push_back(name);
      row.protrusion.bound = row.protrusion.found = std::numeric_limits<double>::infinity();
    }
    rows_.push_back(std::move(row));
    works_.push_back({index, std::move(original), std::move(result), nullptr, 0});
  }

  void measure(std::size_t i) {
    LinkVerification& row = rows_[i];
    Work& work = works_[i];
    row.hulls = work.result.hulls().size();
    row.meshes = work.result.restParts();
    row.primitives = work.result.primitives.size();
    if (row.status != LinkStatus::kOk) return;
    Stopwatch watch;
    try {
      work.pair = std::make_unique<LinkPair>(work.original, work.result, control_);
      row.triangles = work.pair->surface().triangles.size();
      row.diagonal = diagonal(work.pair->surface());
      work.result_diagonal = diagonalOf(*work.pair);
      work.pair->measure(row, options_.max_protrusion.value_or(0), control_);
    } catch (const Error& e) {
      if (e.code() == ErrorCode::kCancelled) throw;
      work.pair.reset();
      row.status = LinkStatus::kFailed;
      row.reason = e.what();
    }
    row.seconds = watch.lap();
    if (row.status != LinkStatus::kOk) return;
    const bool bare = exceeds(options_.max_uncovered, row.uncovered, "uncovered", row.reason);
    if (exceeds(options_.max_protrusion, row.protrusion, "protrudes", row.reason) || bare) row.status = LinkStatus::kOver;
  }

  void query(Verification& done) {
    std::vector<TrialLink> links;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < works_.size(); ++i) {
      if (!works_[i].pair) continue;
      links.push_back({works_[i].link, works_[i].pair.get(), &rows_[i]});
      index.push_back(i);
    }
    std::optional<Kinematics> kinematics;
    try {
      kinematics.emplace(original_.robot);
    } catch (const Error& e) {
      if (options_.configurations > 0) done.notes.push_back(std::string("no configuration was tried: ") + e.what());
      done.configurations = 0;
      return;
    }
    const Trials trials = tryConfigurations(*kinematics, links, options_.configurations, options_.seed, control_);
    for (std::size_t i = 0; i < index.size(); ++i) {
      LinkVerification& row = rows_[index[i]];
      const TrialCounts& counts = trials.of_link[i];
      row.queries = counts.queries, row.hits = counts.hits, row.missed = counts.missed, row.phantom = counts.phantom;
    }
    done.queries = trials.all.queries, done.hits = trials.all.hits, done.missed = trials.all.missed, done.phantom = trials.all.phantom;
    for (const TrialPair& pair : trials.pairs)
      done.pairs.push_back({rows_[index[pair.first]].link, rows_[index[pair.second]].link, pair.counts.queries, pair.counts.hits,
                            pair.counts.missed, pair.counts.phantom});
    rank(done.pairs);
    done.contradictions = trials.contradictions;
    done.notes = trials.remarks;
  }

  void noteElsewhere(const LinkDescription& original, const LinkDescription& result) {
    if ((original.pose.matrix() - result.pose.matrix()).cwiseAbs().maxCoeff() > kElsewhere) elsewhere_.push_back(original.name);
  }

  /// Millimetres beside metres differ by 1,000 in every link; a model that is bad in one link does not.
  void noteUnits(std::vector<std::string>& notes) const {
    std::size_t measured = 0, larger = 0, smaller = 0, first = 0;
    for (std::size_t i = 0; i < works_.size(); ++i) {
      if (!works_[i].pair) continue;
      const double original = rows_[i].diagonal, result = works_[i].result_diagonal;
      if (measured++ == 0) first = i;
      larger += result > kOtherUnit * original;
      smaller += original > kOtherUnit * result;
    }
    if (measured == 0 || std::max(larger, smaller) < measured) return;
    notes.push_back("in every link that was compared, RESULT is " + std::string(larger ? "more than ten times" : "less than a tenth") +
                    " as large as ORIGINAL; '" + rows_[first].link + "' is " + decimal(works_[first].result_diagonal) +
                    " m across, and in ORIGINAL " + decimal(rows_[first].diagonal) + " m: give both the same unit");
  }

  void noteNames(std::vector<std::string>& notes) const {
    if (of_original_alone_.empty() || of_result_alone_.empty()) return;
    notes.push_back(counted(of_original_alone_.size(), "link is", "links are") + " in ORIGINAL alone, such as '" +
                    of_original_alone_.front() + "', and " + std::to_string(of_result_alone_.size()) + " in RESULT alone, such as '" +
                    of_result_alone_.front() + "': links are compared by name");
  }

  void noteJoints(std::vector<std::string>& notes) const {
    const std::vector<std::string> differences = jointDifferences(original_.robot, result_.robot);
    if (differences.empty()) return;
    notes.push_back(counted(differences.size(), "joint moves", "joints move") + " otherwise in RESULT" +
                    (differences.size() == 1 ? ": " : ", such as ") + differences.front() + "; links are moved by ORIGINAL's joints");
  }

  void addNotes(Verification& done) const {
    if (options_.made_from)
      done.notes.push_back("RESULT is compared with the elements of ORIGINAL that it was made from (--source " +
                           std::string(name(options_.made_from->source)) + " of " +
                           (options_.made_from->fitted ? "fit_scene" : "decompose") + "), as '" + options_.made_from->report +
                           "' says; --source chooses others");
    if (options_.made_from && options_.made_from->close_openings > options_.close_openings)
      done.notes.push_back("RESULT was made with --close-openings " + decimal(1000 * options_.made_from->close_openings, 12) +
                           "mm, as that report says: give it here as well, or what it closed counts as protrusion");
    noteUnits(done.notes);
    noteNames(done.notes);
    if (!elsewhere_.empty())
      done.notes.push_back(counted(elsewhere_.size(), "link stands", "links stand") +
                           " elsewhere in RESULT's zero configuration, such as '" + elsewhere_.front() +
                           "': links are compared in their own frames, and moved by ORIGINAL's joints");
    noteJoints(done.notes);
    if (done.missed > 0 && !options_.max_uncovered)
      done.notes.push_back(counted(done.missed, "collision") + (done.missed == 1 ? " was" : " were") +
                           " missed, and no gate limits how much of ORIGINAL is uncovered: set --max-uncovered, 0 for cover without a gap");
    for (const Description* side : {&original_, &result_})
      for (const std::string& note : side->find_package.notes())
        if (std::find(done.notes.begin(), done.notes.end(), note) == done.notes.end()) done.notes.push_back(note);
  }

  const Description &original_, &result_;
  const VerifyOptions& options_;
  const RunControl& control_;
  std::vector<LinkVerification> rows_;
  std::vector<Work> works_;
  std::vector<std::string> elsewhere_, of_original_alone_, of_result_alone_;  // names of links
};

void check(const VerifyOptions& options) {
  const auto refuse = [](const std::string& option, double value) {
    throw Error(ErrorCode::kBadOption, option + " '" + fixedDecimal(value) + "' is invalid: use a length of 0 or more");
  };
  if (options.max_uncovered && !(*options.max_uncovered >= 0)) refuse("max-uncovered", *options.max_uncovered);
  if (options.max_protrusion && !(*options.max_protrusion >= 0)) refuse("max-protrusion", *options.max_protrusion);
  if (!(options.close_openings >= 0)) refuse("close-openings", options.close_openings);
  if (options.jobs < 0)
    throw Error(ErrorCode::kBadOption,
                "jobs '" + std::to_string(options.jobs) + "' is invalid: use a number of threads, or 0 for one per core");
}

[[noreturn]] void refuseNothing(const RobotDescription& robot, const VerifyOptions& options) {
  const std::string where = " in links that match --links '" + options.links + "'; ORIGINAL's links are " + linkNames(robot);
  throw Error(ErrorCode::kBadOption,
              "there is nothing to compare: neither description has geometry" + (options.links.empty() ? "" : where));
}

/// Two robots, given by mistake as one before and after.
void refuseTwoRobots(const std::vector<LinkVerification>& rows) {
  const auto first = [&](LinkStatus status) {
    return std::find_if(rows.begin(), rows.end(), [status](const LinkVerification& row) { return row.status == status; });
  };
  const auto missing = first(LinkStatus::kMissing), added = first(LinkStatus::kAdded);
  const auto is_compared = [](const LinkVerification& row) {
    return row.status != LinkStatus::kMissing && row.status != LinkStatus::kAdded;
  };
  if (missing == rows.end() || added == rows.end() || std::any_of(rows.begin(), rows.end(), is_compared)) return;
  throw Error(ErrorCode::kBadOption, "there is nothing to compare: ORIGINAL has geometry in links such as '" + missing->link +
                                         "', RESULT only in others, such as '" + added->link + "'; give two descriptions of one robot");
}

}  // namespace

const char* name(LinkStatus status) {
  switch (status) {
    case LinkStatus::kOk: return "ok";
    case LinkStatus::kOver: return "over";
    case LinkStatus::kMissing: return "missing";
    case LinkStatus::kAdded: return "added";
    case LinkStatus::kFailed: return "failed";
  }
  return "";
}

Description describeMesh(const std::string& file) {
  GeometryElement mesh;
  mesh.uri = std::filesystem::absolute(file).string();
  LinkDescription link;
  link.name = "mesh";
  link.visuals = link.collisions = {mesh};
  Description description;
  description.robot.name = "mesh";
  description.robot.path = mesh.uri;
  description.robot.links = {link};
  return description;
}

Verification verify(const Description& original, const Description& result, const VerifyOptions& options, const RunControl& control) {
  check(options);
  Verification done;
  withJobs(options.jobs, [&] { done = Verifier(original, result, options, control).run(); });
  if (done.links.empty()) refuseNothing(original.robot, options);
  refuseTwoRobots(done.links);
  return done;
}

bool passed(const Verification& verification, const VerifyOptions& options) {
  const auto passes = [&](const LinkVerification& row) {
    if (row.status == LinkStatus::kMissing) return !options.max_uncovered;
    if (row.status == LinkStatus::kAdded) return !options.max_protrusion;
    return row.status == LinkStatus::kOk;
  };
  return verification.contradictions == 0 && std::all_of(verification.links.begin(), verification.links.end(), passes);
}

}  // namespace collision_hulls
