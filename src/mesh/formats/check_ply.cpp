// Checks a PLY file before Assimp reads it: walks through the data as the header describes it, and so makes sure that data backs every
// count.
#include <algorithm>
#include <cstring>
#include <vector>

#include "mesh/formats/scan.h"
#include "mesh/formats/source_checks.h"

namespace collision_hulls {
namespace {

struct Property {
  std::string name;
  std::size_t bytes = 0;        // of one value
  std::size_t count_bytes = 0;  // of a list's count; 0: not a list
};

struct Element {
  std::string name;
  std::int64_t rows = 0;
  std::vector<Property> properties;

  bool has(const char* property, bool list) const {
    return std::any_of(properties.begin(), properties.end(),
                       [&](const Property& p) { return p.name == property && (p.count_bytes > 0) == list; });
  }
};

/// The size in bytes of a PLY type; 0 if there is no such type.
std::size_t typeBytes(std::string_view type) {
  struct Type {
    std::string_view name;
    std::size_t bytes;
  };
  constexpr Type kTypes[] = {{"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
                             {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
                             {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto* const found = std::find_if(std::begin(kTypes), std::end(kTypes), [&](const Type& t) { return t.name == type; });
  return found == std::end(kTypes) ? 0 : found->bytes;
}

class PlyCheck {
 public:
  PlyCheck(std::string_view bytes, const std::string& path) : lines_(bytes), path_(path) {}

  Announced run(std::size_t max_triangles) {
    readHeader();
    checkElements(max_triangles);
    for (const Element& element : elements_)
      for (std::int64_t row = 0; row < element.rows; ++row) binary_ ? walkBinaryRow(element) : walkTextRow(element);
    return {rowsOf("vertex"), rowsOf("face") - empty_faces_};
  }

 private:
  void readHeader() {
    std::string_view line;
    if (!lines_.next(&line) || nextWord(&line) != "ply") failNotAMesh(path_, "does not begin with 'ply'");
    while (true) {
      if (!lines_.next(&line)) failNotAMesh(path_, "its header has no end_header");
      const std::string_view keyword = nextWord(&line);
      if (keyword == "end_header") break;
      if (keyword == "format") readFormat(nextWord(&line));
      if (keyword == "element") readElement(line);
      if (keyword == "property") readProperty(line);
    }
    data_ = lines_.rest();
  }

  void readFormat(std::string_view format) {
    if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
      failNotAMesh(path_, lines_.number(), "unknown format '" + std::string(format.substr(0, 40)) + "'");
    binary_ = format != "ascii";
    big_endian_ = format == "binary_big_endian";
  }

  void readElement(std::string_view line) {
    Element element;
    element.name = nextWord(&line);
    if (!parseInteger(nextWord(&line), &element.rows) || element.rows < 0)
      failNotAMesh(path_, lines_.number(), "an element needs a name and a number of rows");
    elements_.push_back(element);
  }

  void readProperty(std::string_view line) {
    Property property;
    std::string_view type = nextWord(&line);
    const bool list = type == "list";
    if (list) {
      property.count_bytes = typeBytes(nextWord(&line));
      type = nextWord(&line);
    }
    property.bytes = typeBytes(type);
    property.name = nextWord(&line);
    if (elements_.empty() || property.bytes == 0 || (list && property.count_bytes == 0) || property.name.empty())
      failNotAMesh(path_, lines_.number(), "a property needs an element before it, a known type and a name");
    elements_.back().properties.push_back(property);
  }

  /// Assimp takes missing coordinates for 0 and faces without an index list for empty, and keeps only one triangle of each strip.
  void checkElements(std::size_t max_triangles) const {
    for (const Element& e : elements_) {
      if (e.rows > 0 && e.properties.empty()) failNotAMesh(path_, "element '" + e.name + "' has no property");
      if (e.name == "vertex" && !(e.has("x", false) && e.has("y", false) && e.has("z", false)))
        failNotAMesh(path_, "its vertices lack x, y or z");
      if (e.name == "face" && !e.has("vertex_indices", true) && !e.has("vertex_index", true))
        failNotAMesh(path_, "its faces have no list vertex_indices");
      if (e.name == "tristrips") failNotAMesh(path_, "triangle strips are not supported; write faces instead");
      if (e.name == "face") checkTriangleCount(path_, static_cast<std::uint64_t>(e.rows), max_triangles);
    }
  }

  void walkTextRow(const Element& element) {
    std::string_view line;
    if (!lines_.next(&line)) failShort(element);
    if (lines_.passedBlanks())
      failNotAMesh(path_, lines_.number(), "a whitespace-only line before it would count as a row; remove that line");
    for (const Property& property : element.properties) {
      std::int64_t values = 1;
      if (property.count_bytes > 0 && (!parseInteger(nextWord(&line), &values) || values < 0))
        failNotAMesh(path_, lines_.number(), "a list must begin with its number of values");
      countEmpty(element, property, values == 0);
      for (; values > 0; --values)
        if (nextWord(&line).empty()) failNotAMesh(path_, lines_.number(), "too few values for element '" + element.name + "'");
    }
  }

  void walkBinaryRow(const Element& element) {
    for (const Property& property : element.properties) {
      std::uint64_t values = 1;
      if (property.count_bytes > 0) values = takeCount(element, property.count_bytes);
      countEmpty(element, property, values == 0);
      if (values > data_.size() / property.bytes) failShort(element);
      data_.remove_prefix(values * property.bytes);
    }
  }

  void countEmpty(const Element& element, const Property& list, bool is_empty) {
    if (is_empty && element.name == "face" && (list.name == "vertex_indices" || list.name == "vertex_index")) ++empty_faces_;
  }

  /// The unsigned integer at the front of the data; a negative count is too large for any file.
  std::uint64_t takeCount(const Element& element, std::size_t bytes) {
    if (bytes > data_.size()) failShort(element);
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < bytes; ++i) count = count << 8 | static_cast<unsigned char>(data_[big_endian_ ? i : bytes - 1 - i]);
    data_.remove_prefix(bytes);
    return count;
  }

  std::size_t rowsOf(const char* name) const {
    std::size_t rows = 0;
    for (const Element& element : elements_)
      if (element.name == name) rows += static_cast<std::size_t>(element.rows);
    return rows;
  }

  [[noreturn]] void failShort(const Element& element) const {
    failNotAMesh(path_, "ends within the " + std::to_string(element.rows) + " rows announced for element '" + element.name + "'");
  }

  LineScanner lines_;
  const std::string& path_;
  bool binary_ = false;
  bool big_endian_ = false;
  std::vector<Element> elements_;
  std::size_t empty_faces_ = 0;
  std::string_view data_;  // a binary file's data from the current value on
};

}  // namespace

Announced checkPly(std::string_view bytes, const std::string& path, std::size_t max_triangles) {
  return PlyCheck(bytes, path).run(max_triangles);
}

}  // namespace collision_hulls
