// The frames of an SDF model or world.
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "xml/xml_tree.h"

namespace collision_hulls {

/// Throws kBadScene, naming file and line.
[[noreturn]] void failSdf(const std::string& file, const XmlNode& element, const std::string& reason);

/// The numbers in an element's text; throws unless there are `count` of them.
std::vector<double> sdfNumbers(const std::string& file, const XmlNode& element, std::size_t count);

/// The value of a <pose>, whatever it is relative to.
Eigen::Isometry3d sdfPose(const std::string& file, const XmlNode& pose);

/// A model within a scope. An <include> may override its name and pose.
struct SdfModel {
  const XmlNode* element = nullptr;
  std::string file;  ///< in which it is defined
  std::string name;
  const XmlNode* posed = nullptr;  ///< the element whose <pose> counts
  int depth = 0;                   ///< number of nested includes that led to it
};

/// The models nested in a model.
using ModelsWithin = std::function<std::vector<SdfModel>(const SdfModel&)>;

/// The frames of one model or world, in its own frame: links, joints, frames, nested models and their frames (`model::frame`), and
/// `__model__`. Keeps references.
class SdfFrames {
 public:
  SdfFrames(const XmlNode& scope, const std::string& file, const std::vector<SdfModel>& models, const ModelsWithin& models_within);
  ~SdfFrames();

  /// The <pose> of an element, relative to `frame` unless it names another; empty: the scope's own frame. Throws kBadScene for missing
  /// frames, cycles of frames, and an invalid pose.
  Eigen::Isometry3d poseOf(const XmlNode& element, const std::string& frame) const;

 private:
  struct Frame {
    const XmlNode* element;
    std::string relative_to;
  };
  /// Frames followed so far: in this scope, and in those around it as well.
  struct Steps {
    std::size_t here = 0, all = 0;
    Steps next() const { return {here + 1, all + 1}; }
  };
  struct Nested;
  void add(const std::string& name, const XmlNode& element, const std::string& relative_to);
  Eigen::Isometry3d poseOf(const XmlNode& element, const std::string& frame, const Steps& steps) const;
  Eigen::Isometry3d frameNamed(const std::string& name, const XmlNode& asked_by, const Steps& steps) const;
  const SdfFrames& framesIn(const std::string& model, const std::string& name, const XmlNode& asked_by) const;

  const std::string& file_;
  const std::vector<SdfModel>& models_;
  const ModelsWithin& models_within_;
  std::map<std::string, Frame> frames_;
  mutable std::map<std::string, Eigen::Isometry3d> found_;         // that were asked for
  mutable std::map<std::string, std::unique_ptr<Nested>> nested_;  // by model
};

}  // namespace collision_hulls
