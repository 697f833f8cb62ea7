// Collada's mesh is a chain of references: a primitive's VERTEX input names <vertices>, whose POSITION input names a <source>, whose
// <accessor> names a <float_array> and how to step through it. Each link must lead to one thing, in the same mesh.
#include "decode/collada/collada_shape.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "base/at.h"
#include "base/decimal.h"
#include "collision_hulls/error.h"
#include "mesh/formats/number.h"
#include "mesh/formats/scan.h"
#include "mesh/polygons.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kMostOffset = 1000;
constexpr std::size_t kNumbersBetweenChecks = 1 << 16;

/// Whether Assimp reads a number that we can read, but for the last bits: it takes whole digits for an integer of 64 bits, no more than 15
/// decimals, and computes the power of ten in single precision.
bool isPlain(std::string_view word) {
  constexpr std::size_t kLongest = 40, kMostDigits = 18, kMostDecimals = 15;
  constexpr std::int64_t kLargestPower = 30;
  const std::size_t e = std::min(word.find_first_of("eE"), word.size()), point = std::min(word.find('.'), e);
  if (word.size() > kLongest || point > kMostDigits) return false;
  std::string_view exponent = word.substr(std::min(e + 1, word.size()));
  const bool negative = exponent.substr(0, 1) == "-";
  exponent.remove_prefix(std::min(exponent.find_first_not_of("+-0"), exponent.size()));
  if (exponent.empty()) return true;
  std::int64_t power = 0;
  return parseInteger(exponent, &power) && power <= kLargestPower && (negative || e - point <= kMostDecimals);
}

class ShapeReader {
 public:
  ShapeReader(const ColladaElement& mesh, const std::string& path, std::size_t max_triangles, const RunControl& control)
      : mesh_(mesh), path_(path), max_triangles_(std::min(max_triangles, kMostTriangles)), control_(control) {}

  ColladaShape read() {
    for (const ColladaElement* child : childrenOf(mesh_)) {
      index(*child);
      if (isNamed(*child, "source"))
        for (const ColladaElement* array : childrenOf(*child, "float_array")) index(*array);
    }
    for (const ColladaElement* child : childrenOf(mesh_)) {
      const std::string_view name = child->Name();
      if (isPrimitive(name)) {
        readPrimitive(*child);
      } else if (name != "source" && name != "vertices" && name != "extra") {
        failElement(path_, *child, "is not known in a mesh; export it as triangles");
      }
    }
    return std::move(shape_);
  }

 private:
  static bool isPrimitive(std::string_view name) {
    constexpr std::string_view kNames[] = {"triangles", "polylist", "polygons", "trifans", "tristrips", "lines", "linestrips"};
    return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
  }

  /// Notes what the mesh's references may name.
  void index(const ColladaElement& child) {
    const auto [entry, is_new] = by_id_.emplace(std::make_pair(child.Name(), attributeOf(child, "id")), &child);
    if (!is_new) entry->second = nullptr;
  }

  /// The part of the mesh that a reference names.
  const ColladaElement& named(std::string_view kind, const ColladaElement& from) const {
    const std::string_view id = targetOf(path_, from, "source");
    const auto found = by_id_.find({kind, id});
    const std::string what = "<" + std::string(kind) + "> " + inQuotes(id);
    if (found == by_id_.end()) failElement(path_, from, "refers to " + what + ", which its mesh does not have");
    if (found->second == nullptr) failElement(path_, from, "refers to " + what + ", which its mesh has twice");
    return *found->second;
  }

  void readPrimitive(const ColladaElement& primitive) {
    const ColladaElement* vertex_input = nullptr;
    std::size_t width = 1;  // indices per corner
    for (const ColladaElement* child : childrenOf(primitive)) {
      if (isNamed(*child, "ph")) failElement(path_, *child, "is a polygon with holes, which is not supported; triangulate it");
      if (!isNamed(*child, "input")) continue;
      width = std::max(width, countOf(path_, *child, "offset", 0, kMostOffset) + 1);
      if (attributeOf(*child, "semantic") == "POSITION") failElement(path_, *child, "has POSITION outside <vertices>");
      if (attributeOf(*child, "semantic") != "VERTEX") continue;
      if (vertex_input != nullptr) failElement(path_, primitive, "has two VERTEX inputs");
      vertex_input = child;
    }
    const std::vector<const ColladaElement*> lists = childrenOf(primitive, "p");
    if (lists.empty() && countOf(path_, primitive, "count", 0, kMostTriangles) == 0) return;
    if (vertex_input == nullptr) failElement(path_, primitive, "lies without a VERTEX input");
    readPoints(named("vertices", *vertex_input));
    shape_.sizes.emplace_back();
    std::size_t primitives = 0;
    for (const ColladaElement* list : lists)
      primitives += addList(primitive, cornersIn(*list, width, countOf(path_, *vertex_input, "offset", 0, kMostOffset)));
    checkCount(primitive, primitives, lists.size());
    if (shape_.sizes.back().empty()) shape_.sizes.pop_back();
  }

  /// SketchUp writes wrong counts for lines, which have no surface.
  void checkCount(const ColladaElement& primitive, std::size_t primitives, std::size_t lists) const {
    const std::string_view kind = primitive.Name();
    if (kind == "lines" || kind == "linestrips") return;
    const std::size_t held = kind == "triangles" || kind == "polylist" ? primitives : lists;
    const std::size_t announced = countOf(path_, primitive, "count", 0, std::numeric_limits<std::uint32_t>::max());
    if (announced != held)
      failElement(path_, primitive, "announces " + std::to_string(announced) + " of them but holds " + std::to_string(held));
  }

  void readPoints(const ColladaElement& vertices) {
    if (vertices_ == &vertices) return;
    if (vertices_ != nullptr) failElement(path_, vertices, "is the second that this mesh uses");
    vertices_ = &vertices;
    const ColladaElement* position = nullptr;
    for (const ColladaElement* input : childrenOf(vertices, "input")) {
      if (attributeOf(*input, "semantic") != "POSITION") continue;
      if (position != nullptr) failElement(path_, vertices, "has two POSITION inputs");
      position = input;
    }
    if (position == nullptr) failElement(path_, vertices, "has no POSITION input");
    const ColladaElement& source = named("source", *position);
    const ColladaElement* technique = onlyChild(path_, source, "technique_common");
    const ColladaElement* accessor = technique == nullptr ? nullptr : onlyChild(path_, *technique, "accessor");
    if (accessor == nullptr) failElement(path_, source, "has no <accessor>");
    readAccessor(*accessor);
  }

  /// Which of an item's values are x, y and z.
  std::array<std::size_t, 3> coordinatesOf(const ColladaElement& accessor) const {
    constexpr std::string_view kNames[] = {"X", "Y", "Z"};
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::array<std::size_t, 3> places{kNone, kNone, kNone};
    const std::vector<const ColladaElement*> params = childrenOf(accessor, "param");
    for (std::size_t i = 0; i < params.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (attributeOf(*params[i], "name") == kNames[k]) {
          if (places[k] != kNone) failElement(path_, accessor, "has " + std::string(kNames[k]) + " twice");
          places[k] = i;
        }
    if (std::count(places.begin(), places.end(), kNone) > 0) failElement(path_, accessor, "lacks a <param> named X, Y or Z");
    return places;
  }

  void readAccessor(const ColladaElement& accessor) {
    const ColladaElement& array = named("float_array", accessor);
    const std::vector<std::string_view> words = wordsOf(array);
    const std::size_t most = words.size();
    const std::size_t count = countOf(path_, accessor, "count", 0, most);
    if (count == 0) return;  // an empty geometry, whatever its stride
    const std::size_t stride = countOf(path_, accessor, "stride", 1, most);
    const std::size_t offset = countOf(path_, accessor, "offset", 0, most);
    const std::array<std::size_t, 3> places = coordinatesOf(accessor);
    const std::size_t last = *std::max_element(places.begin(), places.end());
    const std::size_t needed = offset + (count - 1) * stride + last + 1;
    if (needed > words.size())
      throw Error(ErrorCode::kIndexOutOfRange, path_ + ": line " + std::to_string(accessor.GetLineNum()) + ": <accessor> reads value " +
                                                   std::to_string(needed) + " of the array " + inQuotes(attributeOf(array, "id")) +
                                                   ", which has only " + std::to_string(words.size()) + "; export it again");
    shape_.points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (i % kNumbersBetweenChecks == 0) control_.check();
      for (std::size_t k = 0; k < 3; ++k) words_[k] = words[offset + i * stride + places[k]];
      addPoint(array);
    }
  }

  void addPoint(const ColladaElement& array) {
    Eigen::Vector3f& point = shape_.points.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      double value = 0;
      if (!parseNumber(words_[k], &value)) failElement(path_, array, "holds " + inQuotes(words_[k]) + ", which is not a number");
      point[static_cast<int>(k)] = toSingle(value);
      appendColladaNumber(words_[k], value, &shape_.numbers);
    }
  }

  std::vector<std::string_view> wordsOf(const ColladaElement& array) const {
    std::string_view text = textOf(path_, array);
    std::vector<std::string_view> words;
    for (std::string_view word = nextWord(&text); !word.empty(); word = nextWord(&text)) {
      if (words.size() % kNumbersBetweenChecks == 0) control_.check();
      words.push_back(word);
    }
    if (countOf(path_, array, "count", 0, std::numeric_limits<std::uint32_t>::max()) != words.size())
      failElement(
          path_, array,
          "announces " + std::string(attributeOf(array, "count")).substr(0, 40) + " values but holds " + std::to_string(words.size()));
    return words;
  }

  /// The points that a <p> names, one for each corner.
  std::vector<int> cornersIn(const ColladaElement& list, std::size_t width, std::size_t offset) const {
    std::vector<int> corners;
    std::string_view text = textOf(path_, list);
    std::size_t count = 0;
    for (std::string_view word = nextWord(&text); !word.empty(); word = nextWord(&text), ++count) {
      if (count % kNumbersBetweenChecks == 0) control_.check();
      std::int64_t index = 0;
      if (!parseInteger(word, &index)) failElement(path_, list, "holds " + inQuotes(word) + ", which is not an index");
      if (count % width != offset) continue;
      if (index < 0 || static_cast<std::size_t>(index) >= shape_.points.size())
        failIndex(path_, static_cast<std::size_t>(list.GetLineNum()), index, shape_.points.size(), 0);
      corners.push_back(static_cast<int>(index));
    }
    if (count % width != 0)
      failElement(path_, list, "holds " + std::to_string(count) + " indices, which is not a multiple of " + std::to_string(width));
    return corners;
  }

  /// Adds what a <p> holds; how many primitives.
  std::size_t addList(const ColladaElement& primitive, const std::vector<int>& corners) {
    const std::string_view kind = primitive.Name();
    const std::size_t n = corners.size();
    if (kind == "polylist") return addPolylist(primitive, corners);
    if (kind == "polygons") {
      addPolygon(corners.data(), n);
    } else if (kind == "triangles") {
      if (n % 3 != 0) failElement(path_, primitive, "has a <p> of " + std::to_string(n) + " corners, which is not a multiple of 3");
      for (std::size_t i = 0; i < n; i += 3) addPolygon(corners.data() + i, 3);
      return n / 3;
    } else if (kind == "trifans") {
      for (std::size_t i = 1; i + 1 < n; ++i) addTriangle(corners[0], corners[i], corners[i + 1]);
    } else if (kind == "tristrips") {  // every other triangle runs the other way round
      for (std::size_t i = 0; i + 2 < n; ++i) addTriangle(corners[i + i % 2], corners[i + 1 - i % 2], corners[i + 2]);
    } else {
      shape_.skipped += kind == "lines" ? n / 2 : std::max<std::size_t>(n, 1) - 1;
    }
    return 1;
  }

  std::size_t addPolylist(const ColladaElement& primitive, const std::vector<int>& corners) {
    const ColladaElement* vcount = onlyChild(path_, primitive, "vcount");
    if (vcount == nullptr) failElement(path_, primitive, "has no <vcount>");
    onlyChild(path_, primitive, "p");
    std::size_t begin = 0, polygons = 0;
    std::string_view text = textOf(path_, *vcount);
    for (std::string_view word = nextWord(&text); !word.empty(); word = nextWord(&text), ++polygons) {
      std::int64_t size = 0;
      if (!parseInteger(word, &size) || size < 0)
        failElement(path_, *vcount, "holds " + inQuotes(word) + ", which is not a number of corners");
      if (static_cast<std::size_t>(size) > corners.size() - begin)
        failElement(path_, *vcount, "counts more than the " + std::to_string(corners.size()) + " corners that there are");
      addPolygon(corners.data() + begin, static_cast<std::size_t>(size));
      begin += static_cast<std::size_t>(size);
    }
    if (begin != corners.size())
      failElement(path_, *vcount, "counts " + std::to_string(begin) + " corners, but there are " + std::to_string(corners.size()));
    return polygons;
  }

  void addTriangle(int a, int b, int c) {
    const std::array<int, 3> corners{a, b, c};
    addPolygon(corners.data(), corners.size());
  }

  void addPolygon(const int* corners, std::size_t size) {
    if (size < 3) {
      ++shape_.skipped;
      return;
    }
    shape_.triangles += size - 2;
    checkTriangleCount(path_, shape_.triangles, max_triangles_);
    shape_.sizes.back().push_back(static_cast<int>(size));
    shape_.corners.insert(shape_.corners.end(), corners, corners + size);
  }

  const ColladaElement& mesh_;
  const std::string& path_;
  std::size_t max_triangles_;
  const RunControl& control_;
  ColladaShape shape_;
  std::map<std::pair<std::string_view, std::string_view>, const ColladaElement*> by_id_;  // by name and id; null if there are several
  const ColladaElement* vertices_ = nullptr;                                              // of the points read
  std::array<std::string_view, 3> words_;                                                 // of the current point
};

}  // namespace

void appendColladaNumber(std::string_view word, double value, std::string* text) {
  if (isPlain(word)) {
    text->append(word);
  } else {
    text->append(decimal(static_cast<double>(toSingle(value)), 9));
  }
  text->push_back(' ');
}

ColladaShape readColladaShape(const ColladaElement& geometry, const std::string& path, std::size_t max_triangles,
                              const RunControl& control) {
  for (const char* other : {"convex_mesh", "brep"})
    if (const ColladaElement* child = geometry.FirstChildElement(other)) failElement(path, *child, "is not supported; export it as a mesh");
  const ColladaElement* mesh = onlyChild(path, geometry, "mesh");
  return mesh == nullptr ? ColladaShape() : ShapeReader(*mesh, path, max_triangles, control).read();
}

}  // namespace collision_hulls
