// Checks a Collada file before Assimp reads it: Assimp recurses as deep as elements nest and nodes instance each other, trusts the indices
// of accessors, and adds indices without end at text that is not a number. One pass over the tags collects nodes, arrays and accessors;
// then every node is expanded once.
#include <algorithm>
#include <cmath>
#include <locale>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "mesh/formats/number.h"
#include "mesh/formats/scan.h"
#include "mesh/formats/source_checks.h"
#include "mesh/formats/xml_tags.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kDeepestNesting = 200;
constexpr std::size_t kMostNodes = 1'000'000;
constexpr std::int64_t kNoItem = -1;

/// The id that a reference "#id" points to.
std::string target(std::string_view url) {
  return std::string(url.substr(url.substr(0, 1) == "#" ? 1 : 0));
}

/// A <node>, or a <visual_scene>, which can be instanced in the same way.
struct Node {
  std::vector<std::size_t> children;
  std::vector<std::string> instances;  // ids of nodes
  std::size_t expanded = 0;            // number of nodes in it with all instances expanded; 0: not known yet
  std::size_t height = 0;              // longest chain of nested nodes
  bool open = false;                   // is being expanded
};

struct Accessor {
  std::string source;
  std::int64_t last = 0;  // index in the array of the first value of the last item
  std::int64_t params = 0;
};

class DaeCheck {
 public:
  DaeCheck(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  void run() {
    XmlTag tag;
    bool collada = false;
    for (std::string_view rest = bytes_; nextTag(&rest, &tag);) {
      collada = collada || tag.name == "COLLADA";
      if (tag.opens) open(tag);
      if (tag.name == "p" && tag.opens && !tag.closes) checkIndices(rest);
      if (tag.closes) close(tag);
    }
    if (!collada) failNotAMesh(path_, "has no <COLLADA> element");
    for (const Accessor& accessor : accessors_) check(accessor);
    for (std::size_t i = 0; i < nodes_.size(); ++i) expand(i, 0);
  }

 private:
  void open(const XmlTag& tag) {
    stack_.emplace_back(tag.name);
    if (stack_.size() > kDeepestNesting) failNotAMesh(path_, "elements nest deeper than " + std::to_string(kDeepestNesting));
    if (tag.name == "node" || tag.name == "visual_scene") openNode(tag);
    if (tag.name == "instance_node" && !open_nodes_.empty()) nodes_[open_nodes_.back()].instances.push_back(target(tag.attribute("url")));
    if (tag.name == "float_array") arrays_[std::string(tag.attribute("id"))] = number(tag, "count", 0);
    if (tag.name == "Name_array" || tag.name == "IDREF_array") number(tag, "count", 0);
    if (tag.name == "accessor") openAccessor(tag);
    if (tag.name == "param" && inside("accessor")) ++accessors_.back().params;
    if (tag.name == "unit" && inside("asset")) checkUnit(tag.attribute("meter"));
    openPrimitivePart(tag);
  }

  /// Assimp replaces anything but a positive number by 1.
  void checkUnit(std::string_view metres) const {
    if (metres.empty()) return;
    std::istringstream in{std::string(metres)};
    in.imbue(std::locale::classic());
    double value = 0;
    if (!(in >> value) || !(in >> std::ws).eof() || !std::isfinite(value) || value <= 0)
      failNotAMesh(path_, "its <unit meter> is " + std::string(metres.substr(0, 40)) + "; it must be a positive number");
  }

  void close(const XmlTag& tag) {
    if ((tag.name == "node" || tag.name == "visual_scene") && !open_nodes_.empty()) open_nodes_.pop_back();
    if (!stack_.empty()) stack_.pop_back();
  }

  bool inside(const char* name) const { return stack_.size() > 1 && stack_[stack_.size() - 2] == name; }

  /// An attribute that counts things of which each takes at least one byte of the file.
  std::int64_t number(const XmlTag& tag, const char* key, std::int64_t otherwise) const {
    const std::string_view text = tag.attribute(key);
    if (text.empty()) return otherwise;
    std::int64_t value = 0;
    if (!parseInteger(text, &value) || value < 0 || value > static_cast<std::int64_t>(bytes_.size()))
      failNotAMesh(path_, "<" + std::string(tag.name) + " " + key + "=\"" + std::string(text.substr(0, 40)) +
                              "\">: expected an integer from 0 to " + std::to_string(bytes_.size()) + ", the file's size in bytes");
    return value;
  }

  void openNode(const XmlTag& tag) {
    if (!open_nodes_.empty()) nodes_[open_nodes_.back()].children.push_back(nodes_.size());
    by_id_.emplace(tag.attribute("id"), nodes_.size());
    by_name_.emplace(tag.attribute("name"), nodes_.size());
    open_nodes_.push_back(nodes_.size());
    nodes_.emplace_back();
  }

  void openAccessor(const XmlTag& tag) {
    const std::int64_t count = number(tag, "count", 0), stride = number(tag, "stride", 1), offset = number(tag, "offset", 0);
    accessors_.push_back({target(tag.attribute("source")), count > 0 ? offset + (count - 1) * stride : kNoItem, 0});
  }

  /// A primitive's <p> must follow its VERTEX input and, in a polylist, the <vcount>.
  void openPrimitivePart(const XmlTag& tag) {
    static const std::set<std::string_view> kPrimitives{"triangles", "lines", "linestrips", "polygons", "polylist", "trifans", "tristrips"};
    if (kPrimitives.count(tag.name) > 0) {
      has_vertex_input_ = false;
      has_vcount_ = number(tag, "count", 0) == 0 || tag.name != "polylist";
    }
    if (tag.name == "input" && tag.attribute("semantic") == "VERTEX") has_vertex_input_ = true;
    if (tag.name == "vcount") has_vcount_ = true;
    if (tag.name == "p" && !(has_vertex_input_ && has_vcount_)) failNotAMesh(path_, "a <p> without a VERTEX input or a <vcount> before it");
  }

  /// `rest` begins with the text of a <p>. At anything but a number Assimp would add indices until memory runs out.
  void checkIndices(std::string_view rest) const {
    const std::size_t end = std::min(rest.find_first_not_of("0123456789 \t\n\r"), rest.size());
    if (rest.substr(end, 1) == "-") throw Error(ErrorCode::kIndexOutOfRange, path_ + ": a <p> holds an index below 0; export it again");
    if (rest.substr(end, 2) != "</") failNotAMesh(path_, "a <p> holds something other than numbers");
  }

  void check(const Accessor& accessor) const {
    const auto array = arrays_.find(accessor.source);
    if (array == arrays_.end() || accessor.last == kNoItem) return;
    const std::int64_t needed = accessor.last + std::max<std::int64_t>(accessor.params, 1);
    if (needed > array->second)
      throw Error(ErrorCode::kIndexOutOfRange, path_ + ": an <accessor> reads value " + std::to_string(needed) + " of the array '" +
                                                   accessor.source + "', which has only " + std::to_string(array->second) +
                                                   "; export it again");
  }

  /// The target of an <instance_node>, by id or else by name; null if there is none.
  const std::size_t* findNode(const std::string& id) const {
    const auto by_id = by_id_.find(id);
    if (by_id != by_id_.end()) return &by_id->second;
    const auto by_name = by_name_.find(id);
    return by_name != by_name_.end() ? &by_name->second : nullptr;
  }

  /// Counts the nodes that a node becomes with all its instances, and how deep they nest.
  void expand(std::size_t i, std::size_t depth) {
    if (nodes_[i].open || depth > kDeepestNesting) failNesting();
    if (nodes_[i].expanded > 0) return;
    nodes_[i].open = true;
    nodes_[i].expanded = 1;
    std::vector<std::size_t> below = nodes_[i].children;
    for (const std::string& id : nodes_[i].instances)
      if (const std::size_t* node = findNode(id)) below.push_back(*node);
    for (const std::size_t node : below) {
      expand(node, depth + 1);
      nodes_[i].expanded += nodes_[node].expanded;
      nodes_[i].height = std::max(nodes_[i].height, nodes_[node].height + 1);
      if (nodes_[i].height > kDeepestNesting) failNesting();
      if (nodes_[i].expanded > kMostNodes)
        throw Error(ErrorCode::kTooLarge,
                    path_ + ": more than " + std::to_string(kMostNodes) + " nodes once its instances are expanded; simplify the file");
    }
    nodes_[i].open = false;
  }

  [[noreturn]] void failNesting() const {
    failNotAMesh(path_, "nodes instance each other in a circle, or deeper than " + std::to_string(kDeepestNesting));
  }

  std::string_view bytes_;
  const std::string& path_;
  std::vector<std::string> stack_;
  std::vector<Node> nodes_;
  std::vector<std::size_t> open_nodes_;
  std::map<std::string, std::size_t> by_id_, by_name_;
  std::map<std::string, std::int64_t> arrays_;  // number of values, by id
  std::vector<Accessor> accessors_;
  bool has_vertex_input_ = false;
  bool has_vcount_ = false;
};

}  // namespace

void checkDae(std::string_view bytes, const std::string& path) {
  DaeCheck(bytes, path).run();
}

}  // namespace collision_hulls
