// Looks for each note's cause in the report of the fit, in the robot and in the scene.
#include "pipeline/scene/fit_notes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <variant>

#include "base/counted.h"
#include "base/decimal.h"
#include "base/uri_text.h"
#include "collision_hulls/geometry/triangle_bvh.h"
#include "pipeline/mesh_result.h"
#include "report/text_table.h"

namespace collision_hulls {
namespace {

constexpr double kOften = 0.01;  // of the samples: if a pair of links collides in more though its meshes do not, there is a note
constexpr double kMost = 0.5;    // of the samples: if the robot touches the scene in more, there is a note
constexpr double kSlower = 1.5, kLeastUs = 1;  // times as long, and by how much [us]: less may be chance
constexpr double kFew = 0.02;                  // of the samples: if the robot keeps the clearance in fewer, there is a note

using LeftOut = std::vector<const LeftOutPair*>;

LeftOut leftOut(const FitReport& fit, const std::function<bool(const LeftOutPair&)>& matches) {
  LeftOut pairs;
  for (const LeftOutPair& pair : fit.left_out)
    if (matches(pair)) pairs.push_back(&pair);
  return pairs;
}

/// "2 pairs of links are left out (a and b, for one): the original meshes touch there"; one pair at least. `of`: their kind.
std::string leftOutText(const LeftOut& pairs, const std::string& of, const std::string& between) {
  const bool is_one = pairs.size() == 1;
  return counted(pairs.size(), "pair") + " of " + of + (is_one ? " is" : " are") + " left out (" + pairs.front()->first + between +
         pairs.front()->second + (is_one ? "" : ", for one") + "): the original meshes touch there";
}

std::string pronoun(const LeftOut& pairs) {
  return pairs.size() == 1 ? "it" : "them";
}

/// On links and bodies of the scene that are not checked against each other; empty: there are none.
std::string noteOnScenePairs(const FitReport& fit) {
  const LeftOut pairs = leftOut(fit, [](const LeftOutPair& pair) { return !pair.links; });
  if (pairs.empty()) return "";
  return leftOutText(pairs, "a link and a body of the scene", " against ") +
         " always, or nearly, so the check in the scene says nothing about " + pronoun(pairs) +
         "; check the scene's pose unless the robot really stands like that";
}

/// On links that are left out because they touch in the given configurations, or with joints held, though not at rest; empty: there are
/// none.
std::string noteOnGivenContacts(const FitReport& fit) {
  if (!fit.given && fit.held.empty()) return "";
  const LeftOut pairs = leftOut(fit, [](const LeftOutPair& pair) { return pair.links && pair.reason == "Always" && !pair.at_rest; });
  if (pairs.empty()) return "";
  return leftOutText(pairs, "links", " and ") +
         (fit.given ? " in the given configurations" : " in nearly all configurations with the joints held") +
         ", though not at rest, so the check says nothing about " + pronoun(pairs) +
         (fit.given ? "; check the configurations" : "; hold them elsewhere") + " unless the robot really stands like that";
}

/// On links that are left out because they touch at rest, though often not elsewhere; empty: there are none.
std::string noteOnRestContacts(const FitReport& fit) {
  const LeftOut pairs = leftOut(fit, [](const LeftOutPair& pair) { return pair.reason == "Default"; });
  if (pairs.empty()) return "";
  return leftOutText(pairs, "links", " and ") + " at rest, though not in all configurations, so the check says nothing about " +
         pronoun(pairs) + ", and the SRDF disables " + pronoun(pairs) + "; delete there what has to be checked";
}

/// On pairs of links whose hulls meet in many configurations in which their meshes do not touch; empty: there are none. The fit allows that
/// wherever the robot does not keep the clearance, be it with this pair or another.
std::string noteOnNearPairs(const FitReport& fit) {
  const PairHits* worst = nullptr;
  std::size_t count = 0;
  for (const PairHits& pair : fit.self) {
    if (!pair.links || static_cast<double>(pair.after) < kOften * static_cast<double>(fit.samples)) continue;
    ++count;
    if (!worst || pair.after > worst->after) worst = &pair;
  }
  if (!worst) return "";
  return "hulls of links '" + worst->first + "' and '" + worst->second + "' collide in " + std::to_string(worst->after) + " of " +
         std::to_string(fit.samples) + " configurations in which the meshes do not" +
         (count > 1 ? ", and those of " + counted(count - 1, "more pair") + " in many" : "") +
         ", which a fit allows wherever any meshes, theirs or others, are nearer than the clearance; if the robot has to work there, "
         "use a smaller clearance";
}

/// On false collisions that nobody could find, since the meshes hardly ever keep the clearance; empty: they do.
std::string noteOnFewClear(const FitReport& fit) {
  if (static_cast<double>(fit.clear) >= kFew * static_cast<double>(fit.clear_of)) return "";
  return "the original meshes keep " + figureInMillimetres(fit.clearance) + " mm from the scene and from one another in " +
         (fit.clear == 0 ? "none" : "only " + std::to_string(fit.clear)) + " of " + counted(fit.clear_of, "configuration") + ", so " +
         (fit.clear == 0 ? "the fit had nothing to learn from and its check for false collisions says nothing"
                         : "the fit learned from few, and its check for false collisions says little") +
         "; use a smaller clearance, " + (fit.given || !fit.held.empty() ? "" : "let only the planned joints move (joints), ") +
         "or give " + (fit.given ? "other configurations" : "the configurations that matter");
}

/// "7.96 us for a collision query, 5.00 us with the meshes"; empty: the model is not slower.
std::string slowerText(const std::string& query, double model_us, double meshes_us) {
  if (meshes_us <= 0 || model_us < kSlower * meshes_us || model_us < meshes_us + kLeastUs) return "";
  return figure(model_us) + " us for a " + query + " query, " + figure(meshes_us) + " us with the meshes";
}

/// The body of a scene that is a mesh of most triangles; null: none is.
const SceneBody* largestMesh(const Scene& scene) {
  const SceneBody* largest = nullptr;
  std::size_t most = 0;
  for (const SceneBody& body : scene.bodies) {
    const TriangleMesh* const mesh = std::get_if<TriangleMesh>(&body.shape);
    if (!mesh || mesh->triangles.size() <= most) continue;
    most = mesh->triangles.size();
    largest = &body;
  }
  return largest;
}

/// [m] From the root's origin to a hull's bounding box, or to a mesh, in which a robot may stand.
double distanceTo(const SceneBody& body) {
  if (const auto* const hull = std::get_if<ConvexHull>(&body.shape)) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : hull->vertices) box.extend(body.pose * p);
    return box.exteriorDistance(Eigen::Vector3d::Zero());
  }
  const auto& mesh = std::get<TriangleMesh>(body.shape);
  const Eigen::Vector3d root = body.pose.inverse().translation();
  double least = std::numeric_limits<double>::infinity();
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    least = std::min(least, (closestPoint(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), root) - root).norm());
  return least;
}

}  // namespace

std::string noteOnUnknownPairs(const std::vector<DisabledPair>& disabled, const RobotDescription& robot) {
  std::set<std::string> links;
  for (const LinkDescription& link : robot.links) links.insert(link.name);
  const auto is_unknown = [&](const DisabledPair& pair) { return links.count(pair.link1) == 0 || links.count(pair.link2) == 0; };
  const auto first = std::find_if(disabled.begin(), disabled.end(), is_unknown);
  if (first == disabled.end()) return "";
  const auto count = static_cast<std::size_t>(std::count_if(first, disabled.end(), is_unknown));
  return counted(count, "pair") + " of links that " + (count == 1 ? "is" : "are") + " not to be checked " +
         (count == 1 ? "names" : "name") + " links that the robot does not have (" + shown(first->link1) + " and " + shown(first->link2) +
         (count == 1 ? "" : ", for one") + "); " + (count == 1 ? "it is" : "they are") + " left out: correct the names";
}

std::string noteOnSpeed(const FitReport& fit, const Scene& scene) {
  const std::string collision = slowerText("collision", fit.query_us, fit.original_query_us),
                    distance = slowerText("distance", fit.distance_us, fit.original_distance_us);
  if (collision.empty() && distance.empty()) return "";
  const SceneBody* const mesh = fit.far_bodies == 0 ? largestMesh(scene) : nullptr;  // what is far is not in these times
  return "the fitted model is slower than the meshes: it takes " + collision + (collision.empty() || distance.empty() ? "" : "; ") +
         distance +
         (mesh ? ". Body '" + mesh->name +
                     "' of the scene is a mesh, and hulls take long against a mesh: give it as boxes, cylinders or "
                     "spheres, which 'decompose --shapes primitives' makes"
               : ". Hulls gain little where meshes have few triangles: keep the meshes, or give a larger clearance, which takes fewer "
                 "hulls");
}

double reachOf(const RobotDescription& robot) {
  std::map<std::string, double> reach;  // by link
  double largest = 0;
  for (const JointDescription& joint : robot.joints) {  // parents before children
    const bool slides = joint.kind == JointDescription::Kind::kPrismatic;
    const double way = slides ? std::max(std::abs(joint.lower), std::abs(joint.upper)) : 0;
    reach[joint.child] = reach[joint.parent] + joint.origin.translation().norm() + way;
    largest = std::max(largest, reach[joint.child]);
  }
  return largest;
}

std::string noteOnCap(const FitReport& fit, const std::set<std::string>& capped) {
  if (fit.phantom == 0 || fit.leaf_contacts > 0 || capped.empty()) return "";
  return std::to_string(fit.phantom) + " of " + counted(fit.samples, "configuration") + " still " + (fit.phantom == 1 ? "has" : "have") +
         " a false collision, since max-hulls keeps link '" + *capped.begin() + "'" +
         (capped.size() > 1 ? " and " + std::to_string(capped.size() - 1) + " more" : "") +
         " from finer hulls; raise max-hulls, or set it to 0, which lifts the limit";
}

std::vector<std::string> notesOnFit(const FitReport& fit, const Options& options) {
  std::vector<std::string> notes;
  if (const std::string note = noteOnFewClear(fit); !note.empty()) notes.push_back(note);
  if (fit.leaf_contacts > 0) {
    notes.push_back(counted(fit.leaf_contacts, "counterexample") + (fit.leaf_contacts == 1 ? " remains" : " remain") +
                    " even with the finest hulls: " + fit.leaf_contact +
                    "; give these links a smaller tolerance in the configuration, or all links by --tolerance");
  }
  notes.insert(notes.end(), fit.notes.begin(), fit.notes.end());
  if (!options.links.empty()) notes.push_back("links that '" + options.links + "' does not match stay as they are, also in the fit");
  if (const std::string note = noteOnScenePairs(fit); !note.empty()) notes.push_back(note);
  if (const std::string note = noteOnGivenContacts(fit); !note.empty()) notes.push_back(note);
  if (const std::string note = noteOnRestContacts(fit); !note.empty()) notes.push_back(note);
  if (const std::string note = noteOnNearPairs(fit); !note.empty()) notes.push_back(note);
  if (!fit.scene_contact.empty())
    notes.push_back("the original meshes are in contact with the scene at rest: " + fit.scene_contact +
                    "; check the scene's pose unless the robot really stands like that");
  const bool is_partial = !noteOnScenePairs(fit).empty();
  const std::string touched = "the original meshes touch the scene" + std::string(is_partial ? ", pairs that are left out aside," : "") +
                              " in " + std::to_string(fit.scene_hits) + " of " + std::to_string(fit.samples);
  if (fit.scene_hits > 0 && fit.given)
    notes.push_back(touched + " given configurations, the first of them " + fit.first_scene_hit +
                    "; check these unless the contact is meant");
  if (!fit.given && static_cast<double>(fit.scene_hits) > kMost * static_cast<double>(fit.samples))
    notes.push_back(touched + " sampled configurations, most often " + fit.most_scene_hits +
                    ", and a fit learns from the others alone; if the robot does not stand there, move the scene, or give the " +
                    "configurations that matter");
  return notes;
}

std::vector<std::string> notesOnFarScene(const Scene& scene, double clearance, const RobotDescription& robot) {
  if (scene.bodies.empty()) return {};
  std::vector<double> distances;
  for (const SceneBody& body : scene.bodies) distances.push_back(distanceTo(body));
  const auto nearest = std::min_element(distances.begin(), distances.end());
  if (*nearest <= reachOf(robot) + kLargestLink + clearance) return {};
  return {"no body of scene '" + scene.name + "' comes near the robot: the nearest, '" +
          scene.bodies[static_cast<std::size_t>(nearest - distances.begin())].name + "', is " + decimal(*nearest, 3) +
          " m from its root link; sizes and poses of a scene are in metres"};
}

}  // namespace collision_hulls
