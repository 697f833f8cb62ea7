// Reads static bodies from SDF, Gazebo's format: worlds contain models, models contain links and further models, links contain collisions.
// Elements that would change poses or shapes and are not supported are errors, so that no body ends up in the wrong place.
#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>

#include "base/decimal.h"
#include "base/finite_number.h"
#include "base/in_context.h"
#include "base/string_parts.h"
#include "collision_hulls/error.h"
#include "scene/model_uri.h"
#include "scene/reading.h"
#include "scene/sdf_frames.h"
#include "storage/text_file.h"
#include "xml/xml_tree.h"

namespace fs = std::filesystem;

namespace collision_hulls {
namespace {

constexpr int kDeepestInclude = 20, kMostIncludes = 10'000;
constexpr std::size_t kMostFollowed = 10'000;
constexpr double kLongestCapsule = 1e6;  // [m]

/// The hull of equal ellipsoids at several heights.
ConvexHull roundShape(const Eigen::Vector3d& radii, std::initializer_list<double> heights) {
  boxShape(radii);  // throws for invalid sizes
  const double largest = radii.maxCoeff();
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& p : sphereShape(largest).vertices) {
    for (const double z : heights) points.push_back(p.cwiseProduct(radii / largest) + z * Eigen::Vector3d::UnitZ());
  }
  return convexHull(points);
}

/// An element within <geometry>.
struct Shape {
  const std::string& file;
  const XmlNode& element;

  std::vector<double> numbers(const char* child, std::size_t count) const {
    const XmlNode* found = element.child(child);
    if (!found) failSdf(file, element, "<" + element.name + "> has no <" + child + ">");
    return sdfNumbers(file, *found, count);
  }
  double number(const char* child) const { return numbers(child, 1).front(); }
  Eigen::Vector3d vector(const char* child) const { return Eigen::Vector3d(numbers(child, 3).data()); }
};

void setConvexShape(const Shape& shape, SceneBody& body) {
  const std::string& kind = shape.element.name;
  if (kind == "box") return collision_hulls::setShape(body, kind, shape.numbers("size", 3));
  if (kind == "sphere") return collision_hulls::setShape(body, kind, {shape.number("radius")});
  if (kind == "cylinder" || kind == "cone") return collision_hulls::setShape(body, kind, {shape.number("radius"), shape.number("length")});
  if (kind == "plane") {
    const Eigen::Vector3d normal = shape.element.child("normal") ? shape.vector("normal") : Eigen::Vector3d::UnitZ();
    return collision_hulls::setShape(body, kind, {normal.x(), normal.y(), normal.z(), 0});
  }
  if (kind == "ellipsoid") {
    body.shape = roundShape(shape.vector("radii"), {0});
    return;
  }
  if (kind == "capsule") {
    const double radius = shape.number("radius"), length = shape.number("length");
    if (!(length >= 0 && length <= kLongestCapsule))
      failSdf(shape.file, shape.element, "a capsule of length " + decimal(length) + " m; it must be from 0 to 1e6 m");
    body.shape = roundShape(Eigen::Vector3d::Constant(radius), {-length / 2, length / 2});
    return;
  }
  failSdf(shape.file, shape.element,
          "<" + kind + "> is not supported; use box, sphere, cylinder, cone, capsule, ellipsoid, plane or mesh, or export it as a mesh");
}

class SdfReader {
 public:
  explicit SdfReader(const SceneReading& how) : find_package_(how.find_package), control_(how.control), meshes_(how) {}

  Scene read(const std::string& file) {
    const XmlNode& root = open(file);
    const std::vector<const XmlNode*> worlds = root.childrenNamed("world");
    if (worlds.size() > 1) failSdf(file, *worlds[1], "a second <world>; remove all but one");
    scene_.name = worlds.empty() ? fs::path(file).stem().string() : worlds.front()->attribute("name");
    const XmlNode& scope = worlds.empty() ? root : *worlds.front();
    readScope({&scope, file, "", nullptr, 0}, Eigen::Isometry3d::Identity(), "", stateOf(scope, file));
    scene_.files = meshes_.files();
    for (const auto& [included, document] : documents_) scene_.files.push_back(included);
    return std::move(scene_);
  }

 private:
  /// The root of an SDF file. It lives as long as the reader.
  const XmlNode& open(const std::string& file) {
    const auto known = documents_.find(file);
    if (known != documents_.end()) return known->second;
    const std::string text = readTextFile(file, ".sdf or .world file", control_);
    const XmlNode& root = documents_.emplace(file, parseXml(text, "'" + file + "'", control_)).first->second;
    if (root.name != "sdf") failSdf(file, root, "the root element is <" + root.name + ">; SDF needs <sdf>");
    return root;
  }

  /// A saved world's <state>, which tells where its models and links were; null: none.
  const XmlNode* stateOf(const XmlNode& world, const std::string& file) {
    const std::vector<const XmlNode*> states = world.childrenNamed("state");
    if (states.empty()) return nullptr;
    if (states.size() > 1) failSdf(file, *states[1], "a second <state>; remove all but one");
    for (const char* change : {"insertions", "deletions"})
      if (const XmlNode* found = states.front()->child(change))
        failSdf(file, *found, "<" + found->name + "> is not supported; save the world again, with its models in place");
    return states.front();
  }

  /// The pose in the world that a state gives the model or link of this name; `state` becomes that element, or null.
  std::optional<Eigen::Isometry3d> placeIn(const XmlNode*& state, const char* kind, const std::string& name, const std::string& file) {
    if (!state) return std::nullopt;
    const std::vector<const XmlNode*> all = state->childrenNamed(kind);
    const auto found = std::find_if(all.begin(), all.end(), [&](const XmlNode* one) { return one->attribute("name") == name; });
    state = found == all.end() ? nullptr : *found;
    if (!state) return std::nullopt;
    const XmlNode* scale = state->child("scale");
    if (scale && Eigen::Vector3d(sdfNumbers(file, *scale, 3).data()) != Eigen::Vector3d::Ones())
      failSdf(file, *scale, "a <scale> other than 1 1 1 is not supported; scale the shapes of '" + name + "' themselves");
    return state->child("pose") ? std::optional<Eigen::Isometry3d>(sdfPose(file, *state->child("pose"))) : std::nullopt;
  }

  /// Reads a world, a model, or the root element of a file without a world, at `pose`.
  void readScope(const SdfModel& scope, const Eigen::Isometry3d& pose, const std::string& prefix, const XmlNode* state) {
    if (const XmlNode* population = scope.element->child("population"))
      failSdf(scope.file, *population, "<population> is not supported; save the world from Gazebo, with its models one by one");
    const std::vector<SdfModel> models = modelsWithin(scope);
    includes_ += std::count_if(models.begin(), models.end(), [&](const SdfModel& model) { return model.depth > scope.depth; });
    if (includes_ > kMostIncludes) failSdf(scope.file, *scope.element, "more than 10,000 includes; split the world");
    const ModelsWithin within = [this](const SdfModel& model) { return modelsForFrames(model); };
    const SdfFrames frames(*scope.element, scope.file, models, within);
    for (const XmlNode* link : scope.element->childrenNamed("link")) {
      const Eigen::Isometry3d in_scope = frames.poseOf(*link, "");
      const XmlNode* of_link = state;
      const std::optional<Eigen::Isometry3d> place = placeIn(of_link, "link", link->attribute("name"), scope.file);
      readLink(*link, scope.file, frames, place ? *place * in_scope.inverse() : pose, prefix);
    }
    for (const SdfModel& model : models) {
      control_.check();
      if (!model.element->attribute("placement_frame").empty()) {
        failSdf(model.file, *model.element, "placement_frame is not supported; give the pose of the model itself");
      }
      const XmlNode* of_model = state;
      const std::optional<Eigen::Isometry3d> place = placeIn(of_model, "model", model.name, scope.file);
      readScope(model, place ? *place : pose * frames.poseOf(*model.posed, ""), prefix + model.name + "::", of_model);
    }
  }

  void readLink(const XmlNode& link, const std::string& file, const SdfFrames& frames, const Eigen::Isometry3d& pose,
                const std::string& prefix) {
    control_.check();
    const std::string link_name = link.attribute("name");
    for (const XmlNode* collision : link.childrenNamed("collision")) {
      const std::string name = prefix + link_name + "::" + collision->attribute("name");
      SceneBody body{name, {}, pose * frames.poseOf(*collision, link_name)};
      inContext("collision '" + name + "'", [&] {
        if (setShape(*collision, file, body)) builder_.add(std::move(body));
      });
    }
  }

  /// For frames of models that are included, which are followed before these models are read.
  std::vector<SdfModel> modelsForFrames(const SdfModel& scope) {
    control_.check();
    std::vector<SdfModel> models = modelsWithin(scope);
    followed_ += models.size();
    if (followed_ > kMostFollowed)
      failSdf(scope.file, *scope.element, "more than 10,000 models that frames of others are relative to; split the world");
    return models;
  }

  std::vector<SdfModel> modelsWithin(const SdfModel& scope) {
    std::vector<SdfModel> models;
    for (const XmlNode& element : scope.element->children) {
      if (element.name == "model") models.push_back({&element, scope.file, element.attribute("name"), &element, scope.depth});
      if (element.name != "include") continue;
      if (const std::optional<SdfModel> model = included(element, scope)) models.push_back(*model);
    }
    return models;
  }

  /// nullopt for a light or an actor, which has no collision.
  std::optional<SdfModel> included(const XmlNode& include, const SdfModel& scope) {
    const std::string& file = scope.file;
    if (scope.depth >= kDeepestInclude) failSdf(file, include, "includes nest deeper than 20; does one include itself?");
    if (include.child("placement_frame")) failSdf(file, include, "placement_frame is not supported; give the pose of the model itself");
    const XmlNode* uri = include.child("uri");
    if (!uri) failSdf(file, include, "an <include> has no <uri>; give it one");
    std::string path;
    inContext("'" + file + "', line " + std::to_string(uri->line), [&] { path = includedFile(uri->text, file); });
    const XmlNode& root = open(path);
    const XmlNode* model = root.child("model");
    if (!model && (root.child("light") || root.child("actor"))) return std::nullopt;
    if (!model) failSdf(path, root, "this included file has no <model>");
    const XmlNode* name = include.child("name");
    return SdfModel{model, path, name ? name->text : model->attribute("name"), include.child("pose") ? &include : model, scope.depth + 1};
  }

  /// Resolves the URI of a file, or of a model's folder: the file that its model.config names for the newest version, or model.sdf.
  std::string includedFile(const std::string& uri, const std::string& file) {
    const std::string extension = lowerExtension(uri);
    if (extension == ".sdf" || extension == ".world") return resolveModelUri(uri, file, find_package_);
    std::string config;
    try {
      config = resolveModelUri(uri + "/model.config", file, find_package_);
    } catch (const Error&) {
      return resolveModelUri(uri + "/model.sdf", file, find_package_);
    }
    const XmlNode root = parseXml(readTextFile(config, "model.config", control_), "'" + config + "'", control_);
    std::string newest;
    double newest_version = -1;
    for (const XmlNode* sdf : root.childrenNamed("sdf")) {
      double version = 0;
      parseFinite(sdf->attribute("version"), version);
      if (version > newest_version) newest_version = version, newest = sdf->text;
    }
    if (newest.empty()) failSdf(config, root, "this model.config names no <sdf> file");
    return (fs::path(config).parent_path() / newest).string();
  }

  /// The only shape of a collision. Simulators read the first of several, and the others would be missing from the scene.
  static const XmlNode& shapeOf(const XmlNode& collision, const std::string& file) {
    const std::vector<const XmlNode*> geometries = collision.childrenNamed("geometry");
    if (geometries.empty() || geometries.front()->children.empty())
      failSdf(file, collision, "this collision has no geometry; give it one, or <empty/>");
    if (geometries.size() > 1) failSdf(file, *geometries[1], "a second <geometry> of a collision; give it a <collision> of its own");
    const std::vector<XmlNode>& shapes = geometries.front()->children;
    if (shapes.size() > 1)
      failSdf(
          file, shapes[1],
          "<" + shapes[1].name + "> is the second shape of a collision, after <" + shapes[0].name + ">; give it a <collision> of its own");
    return shapes.front();
  }

  /// Returns false for <empty/>.
  bool setShape(const XmlNode& collision, const std::string& file, SceneBody& body) {
    const Shape shape{file, shapeOf(collision, file)};
    const std::string& kind = shape.element.name;
    if (kind == "empty") return false;
    if (kind == "mesh") {
      body.shape = mesh(shape.element, file);
    } else {
      setConvexShape(shape, body);
    }
    return true;
  }

  TriangleMesh mesh(const XmlNode& shape, const std::string& file) {
    const XmlNode *uri = shape.child("uri"), *scale = shape.child("scale");
    if (!uri) failSdf(file, shape, "<mesh> has no <uri>");
    if (shape.child("submesh")) failSdf(file, shape, "<submesh> is not supported; give the part of the mesh a file of its own");
    const Eigen::Vector3d factors = scale ? Eigen::Vector3d(sdfNumbers(file, *scale, 3).data()) : Eigen::Vector3d::Ones();
    return meshes_.read(resolveModelUri(uri->text, file, find_package_), factors, file);
  }

  const PackageFinder& find_package_;
  const RunControl& control_;
  MeshLibrary meshes_;
  std::map<std::string, XmlNode> documents_;  // by path; models point into them
  std::ptrdiff_t includes_ = 0;
  std::size_t followed_ = 0;
  Scene scene_;
  SceneBuilder builder_{scene_};
};

}  // namespace

Scene readSdfScene(const std::string& file, const SceneReading& how) {
  return SdfReader(how).read(file);
}

}  // namespace collision_hulls
