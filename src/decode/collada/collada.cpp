// Reads a Collada document's scene: from <scene> down its nodes, whose instances are followed in place. The work is bounded by counting
// every node, transform and instance as it is met, so circles and towers of instances end at the limit. What has been read is written as a
// document again, in the one form that leaves an XML parser and a reader of Collada nothing to choose.
#include "decode/collada/collada.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "base/decimal.h"
#include "collision_hulls/error.h"
#include "decode/collada/collada_shape.h"
#include "decode/collada/collada_xml.h"
#include "geometry/pi.h"
#include "mesh/formats/number.h"
#include "mesh/formats/scan.h"

namespace collision_hulls {
namespace {

constexpr int kDeepestNode = 200;
constexpr int kLongestChain = 10;  // of controllers
constexpr std::size_t kMostNodes = 200'000;

/// By id; null if several have it.
using Library = std::map<std::string_view, const ColladaElement*>;

void add(const ColladaElement& element, std::string_view key, Library* library) {
  const auto [entry, is_new] = library->emplace(key, &element);
  if (!is_new) entry->second = nullptr;
}

/// The transforms of a node, and how many numbers each takes.
struct TransformKind {
  std::string_view name;
  std::size_t numbers;
};
constexpr TransformKind kTransforms[] = {{"translate", 3}, {"rotate", 4}, {"scale", 3}, {"matrix", 16}, {"lookat", 9}, {"skew", 7}};

const TransformKind* transformNamed(std::string_view name) {
  for (const TransformKind& kind : kTransforms)
    if (kind.name == name) return &kind;
  return nullptr;
}

Eigen::Affine3d transformOf(std::string_view name, const std::array<double, 16>& n) {
  Eigen::Affine3d m = Eigen::Affine3d::Identity();
  if (name == "translate") {
    m.translate(Eigen::Vector3d(n[0], n[1], n[2]));
  } else if (name == "scale") {
    m.scale(Eigen::Vector3d(n[0], n[1], n[2]));
  } else if (name == "rotate") {
    const Eigen::Vector3d axis(n[0], n[1], n[2]);
    m.rotate(Eigen::AngleAxisd(n[3] * kPi / 180, axis));
  } else {
    m.matrix() = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(n.data());
  }
  return m;
}

class SceneReader {
 public:
  SceneReader(const ColladaElement& root, const std::string& path, std::size_t max_triangles, const RunControl& control)
      : root_(root), path_(path), max_triangles_(max_triangles), control_(control) {}

  ColladaScene read() {
    for (const ColladaElement* child : childrenOf(root_)) readLibrary(*child);
    Placement placement(Eigen::Affine3d(Eigen::Scaling(readUnit())));
    readNode(sceneElement(), placement, 0);
    scene_.canonical = document();
    return std::move(scene_);
  }

 private:
  void readLibrary(const ColladaElement& library) {
    const std::string_view name = library.Name();
    for (const ColladaElement* child : childrenOf(library)) {
      if (name == "library_geometries" && isNamed(*child, "geometry")) add(*child, attributeOf(*child, "id"), &geometries_);
      if (name == "library_controllers" && isNamed(*child, "controller")) add(*child, attributeOf(*child, "id"), &controllers_);
      if (name == "library_visual_scenes" && isNamed(*child, "visual_scene")) {
        add(*child, attributeOf(*child, "id"), &scenes_);
        indexNode(*child);
      }
      if (name == "library_nodes" && isNamed(*child, "node")) indexNode(*child);
    }
  }

  void indexNode(const ColladaElement& node) {
    add(node, attributeOf(node, "id"), &nodes_);
    add(node, attributeOf(node, "name"), &nodes_by_name_);
    for (const ColladaElement* child : childrenOf(node, "node")) indexNode(*child);
  }

  /// What a reference names; null if there is no such thing.
  const ColladaElement* find(const Library& library, const ColladaElement& from, const char* attribute) const {
    const auto found = library.find(targetOf(path_, from, attribute));
    if (found == library.end()) return nullptr;
    if (found->second == nullptr) failElement(path_, from, "refers to " + inQuotes(found->first) + ", of which there are several");
    return found->second;
  }

  const ColladaElement& findIn(const Library& library, const ColladaElement& from, const char* attribute) const {
    const ColladaElement* found = find(library, from, attribute);
    if (found == nullptr) failElement(path_, from, "refers to " + inQuotes(attributeOf(from, attribute)) + ", which is not there");
    return *found;
  }

  /// [m] Assimp takes anything but a positive number for 1.
  double readUnit() {
    const ColladaElement* asset = onlyChild(path_, root_, "asset");
    const ColladaElement* unit = asset == nullptr ? nullptr : onlyChild(path_, *asset, "unit");
    if (unit == nullptr || unit->Attribute("meter") == nullptr) return 1;
    const std::string_view word = attributeOf(*unit, "meter");
    double metres = 0;
    if (!parseNumber(word, &metres) || !(toSingle(metres) > 0) || !std::isfinite(toSingle(metres)))
      failElement(path_, *unit, "has meter = " + inQuotes(word) + "; it must be a positive number");
    appendColladaNumber(word, metres, &unit_);
    return metres;
  }

  const ColladaElement& sceneElement() const {
    const ColladaElement* scene = onlyChild(path_, root_, "scene");
    const ColladaElement* instance = scene == nullptr ? nullptr : onlyChild(path_, *scene, "instance_visual_scene");
    if (instance == nullptr) failNotAMesh(path_, "instances no scene, so nothing of it is shown");
    return findIn(scenes_, *instance, "url");
  }

  void countNode() {
    control_.check();
    if (++counted_ > kMostNodes)
      throw Error(ErrorCode::kTooLarge, path_ + ": more than " + std::to_string(kMostNodes) +
                                            " nodes and instances once instances are expanded; simplify the file");
  }

  /// A <node> or <visual_scene>: its transforms, its shapes, its children, and the nodes that it instances, in this order. A node without
  /// shapes below, such as a light's, leaves nothing behind, and may have faulty transforms.
  void readNode(const ColladaElement& node, const Placement& parent, int depth) {
    countNode();
    if (depth > kDeepestNode)
      failElement(path_, node, "instances itself in a circle, or nodes nest deeper than " + std::to_string(kDeepestNode));
    const std::size_t text_before = tree_.size(), instances_before = scene_.instances.size();
    tree_ += depth == 0 ? "<visual_scene id=\"scene\">" : "<node>";
    Placement placement = parent;
    std::optional<Error> fault;
    for (const ColladaElement* child : childrenOf(node)) {
      const TransformKind* const kind = transformNamed(child->Name());
      if (kind != nullptr && !fault) fault = faultOf([&] { readTransform(*kind, *child, depth, &placement); });
    }
    for (const ColladaElement* child : childrenOf(node)) readInstance(*child, placement);
    for (const ColladaElement* child : childrenOf(node, "node")) readNode(*child, placement, depth + 1);
    for (const ColladaElement* child : childrenOf(node, "instance_node")) readNode(instancedNode(*child), placement, depth + 1);
    tree_ += depth == 0 ? "</visual_scene>" : "</node>";
    const bool is_empty = scene_.instances.size() == instances_before;
    if (fault && !is_empty) throw Error(*fault);
    if (is_empty && depth > 0) tree_.resize(text_before);
  }

  /// By id, or else by name, as programs write both. A scene can be instanced as a node.
  const ColladaElement& instancedNode(const ColladaElement& instance) const {
    const ColladaElement* node = find(nodes_, instance, "url");
    return node != nullptr ? *node : findIn(nodes_by_name_, instance, "url");
  }

  /// The kNotAMesh that `work` throws.
  template <typename Work>
  static std::optional<Error> faultOf(const Work& work) try {
    work();
    return std::nullopt;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kNotAMesh) throw;
    return error;
  }

  void readTransform(const TransformKind& kind, const ColladaElement& element, int depth, Placement* placement) {
    countNode();
    if (kind.name == "lookat" || kind.name == "skew" || depth == 0)
      failElement(path_, element, "is not supported here; write a <matrix> or move the vertices");
    std::array<double, 16> numbers{};
    std::string_view text = textOf(path_, element);
    std::string spelt;
    std::size_t count = 0;
    for (std::string_view word = nextWord(&text); !word.empty(); word = nextWord(&text), ++count) {
      if (count == kind.numbers) failElement(path_, element, "holds more than " + std::to_string(count) + " numbers");
      if (!parseNumber(word, &numbers[count]) || !std::isfinite(toSingle(numbers[count])))
        failElement(path_, element, "holds " + inQuotes(word) + ", which is not a finite number");
      appendColladaNumber(word, numbers[count], &spelt);
    }
    if (count != kind.numbers) failElement(path_, element, "holds fewer than " + std::to_string(kind.numbers) + " numbers");
    if (kind.name == "rotate") checkAxis(element, numbers);
    if (kind.name == "matrix" && (numbers[12] != 0 || numbers[13] != 0 || numbers[14] != 0 || numbers[15] != 1))
      failElement(path_, element, "does not end with the row 0 0 0 1");
    tree_ += "<" + std::string(kind.name) + ">" + spelt + "</" + std::string(kind.name) + ">";
    *placement = Placement(*placement, transformOf(kind.name, numbers));
  }

  /// Assimp takes an axis for a unit vector.
  void checkAxis(const ColladaElement& element, const std::array<double, 16>& numbers) const {
    constexpr double kMostError = 1e-3;
    const double length = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]).norm();
    if (numbers[3] != 0 && std::abs(length - 1) > kMostError)
      failElement(path_, element, "has an axis of length " + fixedDecimal(length) + "; it must be 1");
  }

  void readInstance(const ColladaElement& element, const Placement& placement) {
    const std::string_view name = element.Name();
    if (name == "instance_geometry") return addInstance(findIn(geometries_, element, "url"), placement);
    if (name == "instance_controller") return addInstance(controlledBy(findIn(controllers_, element, "url")), placement);
    const bool known = name == "instance_node" || name == "instance_camera" || name == "instance_light";
    if (name.substr(0, 9) == "instance_" && !known) failElement(path_, element, "is not supported; instance the geometry itself");
  }

  /// The geometry that a controller, or a chain of them, deforms: a skin in its bind pose, a morph's base, as in rviz.
  const ColladaElement& controlledBy(const ColladaElement& first) const {
    const ColladaElement* controller = &first;
    for (int i = 0; i < kLongestChain; ++i) {
      const ColladaElement* skin = onlyChild(path_, *controller, "skin");
      const ColladaElement* source = skin != nullptr ? skin : onlyChild(path_, *controller, "morph");
      if (source == nullptr) failElement(path_, *controller, "has neither <skin> nor <morph>");
      if (const ColladaElement* geometry = find(geometries_, *source, "source")) return *geometry;
      controller = &findIn(controllers_, *source, "source");
    }
    failElement(path_, first, "begins a circle of controllers, or more than " + std::to_string(kLongestChain));
  }

  void addInstance(const ColladaElement& geometry, const Placement& placement) {
    countNode();
    const auto [entry, is_new] = shape_of_.emplace(&geometry, scene_.shapes.size());
    if (is_new) scene_.shapes.push_back(readColladaShape(geometry, path_, max_triangles_, control_));
    const ColladaShape& shape = scene_.shapes[entry->second];
    triangles_ += shape.triangles;
    checkTriangleCount(path_, triangles_, max_triangles_);
    scene_.instances.push_back({entry->second, placement});
    if (shape.triangles > 0) tree_ += "<instance_geometry url=\"#g" + std::to_string(entry->second) + "\"/>";
  }

  std::string document() const {
    std::string text = "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\">";
    if (!unit_.empty()) text += "<asset><unit meter=\"" + unit_.substr(0, unit_.size() - 1) + "\"/></asset>";
    text += "<library_geometries>";
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i) appendGeometry(scene_.shapes[i], std::to_string(i), &text);
    return text + "</library_geometries><library_visual_scenes>" + tree_ +
           "</library_visual_scenes><scene><instance_visual_scene url=\"#scene\"/></scene></COLLADA>\n";
  }

  static void appendIntegers(const std::string& name, const int* begin, const int* end, std::string* text) {
    *text += "<" + name + ">";
    std::array<char, 16> digits;
    for (; begin != end; ++begin) {
      char* const last = std::to_chars(digits.data(), digits.data() + digits.size(), *begin).ptr;
      *last = ' ';
      text->append(digits.data(), last + 1);
    }
    *text += "</" + name + ">";
  }

  static void appendGeometry(const ColladaShape& shape, const std::string& i, std::string* text) {
    if (shape.triangles == 0) return;
    const std::string points = std::to_string(shape.points.size()), numbers = std::to_string(3 * shape.points.size());
    *text += "<geometry id=\"g" + i + "\"><mesh><source id=\"s" + i + "\"><float_array id=\"a" + i + "\" count=\"" + numbers + "\">";
    *text += shape.numbers;
    *text += "</float_array><technique_common><accessor source=\"#a" + i + "\" count=\"" + points +
             "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/>"
             "</accessor></technique_common></source><vertices id=\"v" +
             i + "\"><input semantic=\"POSITION\" source=\"#s" + i + "\"/></vertices>";
    const int* corner = shape.corners.data();
    for (const std::vector<int>& sizes : shape.sizes) {
      const bool triangles = std::all_of(sizes.begin(), sizes.end(), [](int size) { return size == 3; });
      const std::string name = triangles ? "triangles" : "polylist";
      *text +=
          "<" + name + " count=\"" + std::to_string(sizes.size()) + "\"><input semantic=\"VERTEX\" source=\"#v" + i + "\" offset=\"0\"/>";
      if (!triangles) appendIntegers("vcount", sizes.data(), sizes.data() + sizes.size(), text);
      const int* const end = corner + std::accumulate(sizes.begin(), sizes.end(), std::ptrdiff_t{0});
      appendIntegers("p", corner, end, text);
      corner = end;
      *text += "</" + name + ">";
    }
    *text += "</mesh></geometry>";
  }

  const ColladaElement& root_;
  const std::string& path_;
  std::size_t max_triangles_;
  const RunControl& control_;
  Library geometries_, controllers_, scenes_, nodes_, nodes_by_name_;
  std::map<const ColladaElement*, std::size_t> shape_of_;  // of each geometry instanced so far
  ColladaScene scene_;
  std::string unit_;  // as written, with a blank; empty if there is none
  std::string tree_;  // of nodes, as written
  std::size_t counted_ = 0;
  std::size_t triangles_ = 0;
};

}  // namespace

ColladaScene readCollada(const std::string& bytes, const std::string& path, std::size_t max_triangles, const RunControl& control) {
  tinyxml2::XMLDocument document;
  return SceneReader(parseCollada(bytes, path, &document), path, max_triangles, control).read();
}

}  // namespace collision_hulls
