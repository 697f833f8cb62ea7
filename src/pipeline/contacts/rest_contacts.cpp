// Each mesh with its hulls is a part. Boxes around the parts are swept along x; where two meet, hulls are compared, box against box before
// FCL; where hulls touch, so are the meshes. Of these only the triangles near the other part count, so that FCL builds small trees:
// where hulls touch, the solids are no further apart than both protrude, and so are the meshes, unless one is inside the other.
//
// Samples of other configurations would find more, and say less: joints at rest are what users see first, in rviz and in MoveIt.
#include "pipeline/contacts/rest_contacts.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/counted.h"
#include "base/looks.h"
#include "base/millimetres.h"
#include "base/parallel.h"
#include "collision_hulls/error.h"
#include "collision_hulls/query/query_body.h"
#include "collision_hulls/robot/kinematics.h"
#include "fit/detail_tree.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostPairs = 1'000;  // of parts; where large meshes touch, each takes FCL up to a tenth of a second
constexpr std::size_t kMostNamed = 5;      // pairs of links in a note, beside the first
constexpr double kFlush = 1e-5;            // [m] meshes that are no further apart touch: their files are rounded
constexpr double kBeyond = 1e-3;           // [m] more than hulls protrude: meshes that are no nearer are inside one another

struct Part {
  std::size_t link = 0;
  const MeshResult* mesh = nullptr;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // in the root link's frame
  Eigen::AlignedBox3d box, at_rest;                        // around the hulls, in the part's frame and in the root link's
};

std::vector<Part> partsAtRest(const RobotDescription& robot, const Kinematics& kinematics, const std::vector<MeshUse>& uses,
                              const MeshResults& results, std::size_t model, const RunControl& control) {
  std::map<std::string, std::size_t> links;
  for (std::size_t i = 0; i < robot.links.size(); ++i) links[robot.links[i].name] = i;
  std::set<std::string> failed;  // they keep what they have
  for (std::size_t i = 0; i < uses.size(); ++i)
    if (uses[i].model == model && results[i]->status == Status::kFailed) failed.insert(uses[i].link);
  const std::vector<Eigen::Isometry3d> poses = kinematics.poses(kinematics.rest());
  std::vector<Part> parts;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    control.check();
    if (uses[i].model != model || results[i]->hulls.empty() || failed.count(uses[i].link)) continue;
    Part part;
    part.link = links.at(uses[i].link);
    part.mesh = results[i].get();
    part.pose = poses[part.link] * uses[i].source.origin;
    for (const ConvexHull& hull : results[i]->hulls) part.box.extend(boundingBox(hull));
    part.at_rest = placed(part.box, part.pose);
    parts.push_back(part);
  }
  return parts;
}

using PartPairs = std::vector<std::pair<const Part*, const Part*>>;

/// Those of links that no joint joins whose boxes meet.
PartPairs nearPairs(std::vector<Part>& parts, const Kinematics& kinematics, const RunControl& control) {
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.at_rest.min().x() < b.at_rest.min().x(); });
  Looks look(control);
  PartPairs pairs;
  for (auto a = parts.begin(); a != parts.end(); ++a) {
    for (auto b = a + 1; b != parts.end() && b->at_rest.min().x() <= a->at_rest.max().x(); ++b) {
      look();
      if (!a->at_rest.intersects(b->at_rest) || kinematics.adjacent(a->link, b->link)) continue;
      pairs.emplace_back(&*a, &*b);
      if (pairs.size() == kMostPairs) return pairs;
    }
  }
  return pairs;
}

/// What stands for a part near a box. `pose`: of the box in the part's frame.
std::vector<QueryBody> bodiesNear(const Part& part, const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& pose,
                                  const RunControl& control) {
  const std::vector<ConvexHull>& hulls = part.mesh->hulls;
  const std::size_t written = hulls.size() - part.mesh->primitives.size();  // the others enclose the primitives
  Looks look(control, kLargeItemsBetweenLooks);
  std::vector<QueryBody> bodies;
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    look();
    if (apart(boundingBox(hulls[i]), box, pose)) continue;
    bodies.push_back(i < written ? QueryBody(hulls[i]) : queryBody(part.mesh->primitives[i - written]));
  }
  return bodies;
}

bool hullsTouch(const Part& a, const Part& b, const RunControl& control) {
  const Eigen::Isometry3d pose = a.pose.inverse() * b.pose;
  if (apart(a.box, b.box, pose)) return false;
  const std::vector<QueryBody> of_a = bodiesNear(a, b.box, pose, control), of_b = bodiesNear(b, a.box, pose.inverse(), control);
  Looks look(control, kLargeItemsBetweenLooks);
  for (const QueryBody& one : of_a) {
    for (const QueryBody& other : of_b) {
      look();
      if (!apart(one.box(), other.box(), pose) && touch(one, other, pose)) return true;
    }
  }
  return false;
}

QueryBody meshNear(const TriangleMesh& mesh, const Eigen::AlignedBox3d& box, const RunControl& control) {
  Looks look(control);
  TriangleMesh near;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    look();
    Eigen::AlignedBox3d of_triangle;
    for (int corner = 0; corner < 3; ++corner) of_triangle.extend(mesh.corner(t, corner));
    if (!of_triangle.intersects(box)) continue;
    const auto first = static_cast<int>(near.vertices.size());
    for (int corner = 0; corner < 3; ++corner) near.vertices.push_back(mesh.corner(t, corner));
    near.triangles.push_back({first, first + 1, first + 2});
  }
  return QueryBody(near, control);
}

/// Of two meshes whose hulls touch.
RestContact contact(const Part& a, const Part& b, const RunControl& control) {
  const double most = a.mesh->model.protrusion + b.mesh->model.protrusion + kBeyond;
  const Eigen::Isometry3d pose = a.pose.inverse() * b.pose;
  const auto around = [&](const Eigen::AlignedBox3d& box) {
    return Eigen::AlignedBox3d(box.min().array() - most, box.max().array() + most);
  };
  const QueryBody of_a = meshNear(a.mesh->original, around(placed(b.box, pose)), control);
  if (of_a.empty()) return {std::min(a.link, b.link), std::max(a.link, b.link), most, true};
  const QueryBody of_b = meshNear(b.mesh->original, around(placed(of_a.box(), pose.inverse())), control);
  const double apart = touch(of_a, of_b, pose) ? 0 : distanceBelow(most, of_a, of_b, pose);
  return {std::min(a.link, b.link), std::max(a.link, b.link), apart, apart >= most};
}

std::set<std::string> linksOf(const RobotDescription& robot, const std::vector<RestContact>& pairs) {
  std::set<std::string> links;
  for (const RestContact& pair : pairs) links.insert({robot.links[pair.first].name, robot.links[pair.second].name});
  return links;
}

/// What the links of these pairs are made of: "hulls", "spheres", "primitives" of other kinds, or "bodies" if primitives stand beside
/// hulls.
std::string kindThatTouches(const RobotDescription& robot, const std::vector<RestContact>& pairs, const std::vector<MeshUse>& uses,
                            const MeshResults& results, std::size_t model) {
  const std::set<std::string> links = linksOf(robot, pairs);
  bool hulls = false, spheres = false, others = false;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (uses[i].model != model || links.count(uses[i].link) == 0) continue;
    const MeshResult& mesh = *results[i];
    hulls = hulls || mesh.hulls.size() > mesh.primitives.size();
    for (const GeometryElement& primitive : mesh.primitives) (primitive.kind == GeometryElement::Kind::kSphere ? spheres : others) = true;
  }
  if (hulls) return spheres || others ? "bodies" : "hulls";
  return others ? "primitives" : "spheres";
}

/// What would keep the bodies of two links apart.
std::string remedyFor(const std::set<std::string>& links, const std::vector<MeshUse>& uses, const MeshResults& results, std::size_t model) {
  bool padded = false, single = false, one_hull = false, limited = false;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (uses[i].model != model || links.count(uses[i].link) == 0) continue;
    const LinkOptions& options = uses[i].options;
    padded = padded || options.padding > 0;
    single = single || isSingle(options.shapes);
    one_hull = one_hull || options.method == Method::kSingleHull || options.method == Method::kBoundingBox;
    limited = limited || (options.max_hulls > 0 && results[i]->status == Status::kDegraded);
  }
  if (one_hull) return "choose another method for these links, ";
  if (single) return "take hulls for these links, ";
  if (limited) return "allow these links more hulls, ";
  return padded ? "lower the padding or the tolerance of these links, " : "lower the tolerance of these links, ";
}

/// "'a' and 'b'"
std::string names(const RobotDescription& robot, const RestContact& pair) {
  return "'" + robot.links[pair.first].name + "' and '" + robot.links[pair.second].name + "'";
}

/// The pairs but the first; empty if there are none.
std::string others(const RobotDescription& robot, const std::vector<RestContact>& pairs) {
  if (pairs.size() == 1) return "";
  const std::size_t named = std::min(pairs.size(), 1 + kMostNamed);
  std::string text = " (and those of " + names(robot, pairs[1]);
  for (std::size_t i = 2; i < named; ++i) text += ", of " + names(robot, pairs[i]);
  if (pairs.size() > named) text += ", and of " + counted(pairs.size() - named, "more pair");
  return text + ")";
}

}  // namespace

std::vector<RestContact> restContacts(const RobotDescription& robot, const std::vector<MeshUse>& uses, const MeshResults& results,
                                      std::size_t model, const RunControl& control) {
  const Kinematics kinematics(robot);
  std::vector<Part> parts = partsAtRest(robot, kinematics, uses, results, model, control);
  const PartPairs pairs = nearPairs(parts, kinematics, control);
  std::vector<std::optional<RestContact>> of_parts(pairs.size());
  forEach(pairs.size(), [&](std::size_t i) {
    control.check();
    const auto& [a, b] = pairs[i];
    if (hullsTouch(*a, *b, control)) of_parts[i] = contact(*a, *b, control);
  });
  std::map<std::pair<std::size_t, std::size_t>, RestContact> nearest;  // by links
  for (const std::optional<RestContact>& one : of_parts) {
    if (!one) continue;
    RestContact& known = nearest.emplace(std::make_pair(one->first, one->second), *one).first->second;
    if (one->apart < known.apart) known = *one;
  }
  std::vector<RestContact> contacts;
  for (const auto& [links, one] : nearest)
    if (one.apart > kFlush) contacts.push_back(one);
  std::stable_sort(contacts.begin(), contacts.end(), [](const RestContact& a, const RestContact& b) { return a.apart > b.apart; });
  return contacts;
}

std::vector<std::string> notesOnRestContacts(const RobotDescription& robot, const std::vector<MeshUse>& uses, const MeshResults& results,
                                             std::size_t model, const RunControl& control) {
  try {
    const std::vector<RestContact> contacts = restContacts(robot, uses, results, model, control);
    if (contacts.empty()) return {};
    const bool one = contacts.size() == 1, inside = contacts.front().at_least;
    return {kindThatTouches(robot, contacts, uses, results, model) + " of " + names(robot, contacts.front()) + others(robot, contacts) +
            " touch with all joints at rest, where " + (one ? "their meshes are " : "the meshes of the first are ") +
            (inside ? "at least " : "") + millimetres(contacts.front().apart) + " apart" + (inside ? ", one inside the other: " : ": ") +
            (one && inside ? "" : remedyFor(linksOf(robot, contacts), uses, results, model) + "or ") + "disable " +
            (one ? "the pair" : "the pairs")};
  } catch (const Error& error) {
    if (error.code() == ErrorCode::kCancelled) throw;
    return {std::string("links were not compared at rest: ") + error.what()};
  }
}

}  // namespace collision_hulls
