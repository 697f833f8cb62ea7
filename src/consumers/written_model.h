// What was decomposed, as the writers need it: the rewritten description, and which of its meshes are hulls of this output.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "collision_hulls/pipeline/result.h"
#include "collision_hulls/scene/srdf.h"
#include "xml/xml_tree.h"

namespace collision_hulls {

/// What a description says of a link's mass. Units: kg, m, kg m^2.
struct Inertial {
  Eigen::Isometry3d principal = Eigen::Isometry3d::Identity();  ///< of the centre of mass, with the principal axes, in the link's frame
  double mass = 0;
  Eigen::Vector3d moments = Eigen::Vector3d::Zero();  ///< of inertia about these axes: as a body may have them
};

/// What it says of a joint beside its place and range: N or N m, m/s or rad/s; damping and friction in SI units. Negative: not given.
struct JointDynamics {
  double effort = -1, velocity = -1, damping = -1, friction = -1;
};

class WrittenModel {
 public:
  /// Keeps a reference. `package`: the output package's name.
  WrittenModel(const RobotResult& result, const std::string& package, const RunControl& control);

  const RobotResult& result() const { return result_; }
  const std::string& package() const { return package_; }
  const RobotDescription& robot() const { return robot_; }  ///< with the new `<collision>` elements

  /// The path in the output of a hull that a URI means; empty if it means another file.
  std::string fileOf(const GeometryElement& element) const;
  /// Null for an element that is no hull of this output.
  const ConvexHull* hullOf(const GeometryElement& element) const;

  const Inertial* inertialOf(const std::string& link) const;  ///< null: none is given
  JointDynamics dynamicsOf(const std::string& joint) const;
  const std::vector<const JointDescription*>& jointsBelow(const std::string& link) const;  ///< in document order
  const std::vector<std::string>& notes() const { return notes_; }                         ///< on what had to be changed
  std::vector<std::string> roots() const;                                                  ///< links without a parent
  /// A link's name where a format reserves that of the world: its own, or "world_link" for a link called "world" of which `is_body` is
  /// true.
  std::string nameBesideWorld(const std::string& link, const std::function<bool(const LinkDescription&)>& is_body) const;
  std::vector<std::string> linksWithOtherMeshes() const;  ///< than hulls of this output, such as those that were kept or failed

 private:
  void readDynamics(const XmlNode& robot);

  const RobotResult& result_;
  const std::string package_;
  RobotDescription robot_;
  std::map<std::string, const ConvexHull*> hulls_;  // by path in the output
  std::map<std::string, Inertial> inertials_;
  std::map<std::string, JointDynamics> dynamics_;
  std::map<std::string, std::vector<const JointDescription*>> below_;  // by parent
  std::vector<std::string> notes_;
};

/// A root link of this name stands for the surroundings in ROS; MuJoCo and SDF have such a body of their own.
constexpr const char* kWorld = "world";

/// Numbers and poses as text: "x y z" and "r p y" [rad], "w x y z".
std::string positionText(const Eigen::Isometry3d& pose);
std::string rpyText(const Eigen::Isometry3d& pose);
std::string quaternionText(const Eigen::Isometry3d& pose);
std::string nameAttribute(const std::string& name);  ///< of an XML element: ` name="..."`, escaped
/// An XML element that holds text, which is escaped; each of `attributes` has a space before it.
std::string tag(const std::string& name, const std::string& text, const std::string& attributes = "");

/// The pairs of links that need no check: neighbours; those that touch at rest, as their original meshes do; and those of which it is
/// proved that they never meet, whatever the joints do.
std::vector<DisabledPair> pairsWithoutCheck(const WrittenModel& model, const RunControl& control);
std::vector<std::string> notesOn(const std::vector<DisabledPair>& pairs);  ///< on those that touch at rest

/// The rewritten description with a change to the <mesh> of each hull: `attributes` in it (each with a space before it), `content` between
/// its tags; and `of_root` among the attributes of <robot>, unless it has one that begins like it up to the '='.
std::string withMarkedHulls(const WrittenModel& model, const std::string& attributes, const std::string& content,
                            const std::string& of_root);

/// Whether a joint has a position of its own, or one that it takes from another: revolute, continuous and prismatic ones.
bool turnsOrSlides(const JointDescription& joint);

/// For messages: "link 'a' has", "links 'a', 'b', 'c' and 4 more have".
std::string someHave(const std::vector<std::string>& links);

/// For messages: the joints of which something is true, as "'a', 'b', 'c' and 4 more"; empty if there are none.
std::string jointsThat(const WrittenModel& model, const std::function<bool(const JointDescription&)>& is_so);

// Notes, if there is something to say. `consumer`: its name in --for; `format`: "a SKEL file"; `otherwise`: what becomes of a mesh there.
void noteLeftOut(const WrittenModel& model, const std::string& consumer, const std::string& otherwise, std::vector<std::string>& notes);
void noteFollowers(const WrittenModel& model, const std::string& consumer, const std::string& format, std::vector<std::string>& notes);
/// For consumers that give links without <inertial> 1 kg. `links`: these; `who`: "DART".
void noteWithoutInertial(const std::vector<std::string>& links, const std::string& consumer, const std::string& who,
                         std::vector<std::string>& notes);

/// Throws kBadOption if elements that stay as they are would be missed by cuRobo.
void checkForCurobo(const RobotDescription& robot, const Options& options, const RunControl& control);

// The writers: path in the output, content. `pairs`: pairsWithoutCheck().
using ConsumerFiles = std::map<std::string, std::string>;
ConsumerFiles curoboFiles(const WrittenModel& model, const std::vector<DisabledPair>& pairs);
ConsumerFiles tesseractFiles(const WrittenModel& model);
ConsumerFiles moveitFiles(const WrittenModel& model, const std::vector<DisabledPair>& pairs);
ConsumerFiles drakeFiles(const WrittenModel& model);
ConsumerFiles isaacFiles(const WrittenModel& model);
ConsumerFiles mujocoFiles(const WrittenModel& model, const std::vector<DisabledPair>& pairs, const RunControl& control);
ConsumerFiles gazeboFiles(const WrittenModel& model);
ConsumerFiles dartFiles(const WrittenModel& model);

// On what their formats cannot say; for those with masses, WrittenModel::notes() as well.
std::vector<std::string> isaacNotes(const WrittenModel& model);
std::vector<std::string> mujocoNotes(const WrittenModel& model);
std::vector<std::string> gazeboNotes(const WrittenModel& model);
std::vector<std::string> dartNotes(const WrittenModel& model);
std::vector<std::string> bulletNotes(const WrittenModel& model, const std::string& output);  ///< `output`: the folder that will be written

}  // namespace collision_hulls
