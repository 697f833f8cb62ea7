// A strict reader of PLY headers. Binary data begins right behind the last line, so the ends of lines must be known exactly: the first line
// shows which the file has.
#include "mesh/formats/ply_header.h"

#include <algorithm>

#include "mesh/formats/number.h"
#include "mesh/formats/scan.h"

namespace collision_hulls {
namespace {

struct NamedType {
  std::string_view name;
  PlyType type;
};
constexpr NamedType kTypes[] = {
    {"char", PlyType::kInt8},   {"int8", PlyType::kInt8},     {"uchar", PlyType::kUint8},   {"uint8", PlyType::kUint8},
    {"short", PlyType::kInt16}, {"int16", PlyType::kInt16},   {"ushort", PlyType::kUint16}, {"uint16", PlyType::kUint16},
    {"int", PlyType::kInt32},   {"int32", PlyType::kInt32},   {"uint", PlyType::kUint32},   {"uint32", PlyType::kUint32},
    {"float", PlyType::kFloat}, {"float32", PlyType::kFloat}, {"double", PlyType::kDouble}, {"float64", PlyType::kDouble}};

/// The most elements, and properties of one: names are compared with each other.
constexpr std::size_t kMostNames = 1000;

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& path) : path_(path) {
    header_.data = bytes;
    const std::size_t end = bytes.find_first_of("\r\n");
    line_end_ = end != std::string_view::npos && bytes[end] == '\r' && bytes.substr(end + 1, 1) != "\n" ? '\r' : '\n';
  }

  PlyHeader read() {
    nextLine();
    if (nextWord(&line_) != "ply" || !nextWord(&line_).empty()) failNotAMesh(path_, "does not begin with 'ply'");
    while (nextLine()) {
      const std::string_view keyword = nextWord(&line_);
      if (keyword == "end_header") {
        endOfLine();
        checkElements();
        return header_;
      }
      readLine(keyword);
    }
    failNotAMesh(path_, "its header has no end_header");
  }

 private:
  bool nextLine() {
    const std::size_t length = header_.data.find(line_end_);
    if (length == std::string_view::npos) return false;
    line_ = header_.data.substr(0, length);
    header_.data.remove_prefix(length + 1);
    ++header_.lines;
    return true;
  }

  void readLine(std::string_view keyword) {
    if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) return;
    if (keyword == "format") {
      readFormat();
    } else if (keyword == "element") {
      readElement();
    } else if (keyword == "property") {
      readProperty();
    } else {
      fail(inQuotes(keyword) + " begins no line of a PLY header");
    }
    endOfLine();
  }

  void readFormat() {
    if (has_format_) fail("a second format");
    has_format_ = true;
    const std::string_view format = nextWord(&line_);
    if (format == "binary_little_endian") {
      header_.format = PlyHeader::Format::kLittleEndian;
    } else if (format == "binary_big_endian") {
      header_.format = PlyHeader::Format::kBigEndian;
    } else if (format != "ascii") {
      fail("unknown format " + inQuotes(format));
    }
    if (nextWord(&line_) != "1.0") fail("a version other than 1.0");
  }

  void readElement() {
    PlyElement element;
    element.name = nextWord(&line_);
    std::int64_t rows = 0;
    if (!parseInteger(nextWord(&line_), &rows) || rows < 0) fail("an element needs a name and a number of rows");
    element.rows = static_cast<std::size_t>(rows);
    if (header_.elements.size() == kMostNames) fail("more than " + std::to_string(kMostNames) + " elements");
    header_.elements.push_back(element);
  }

  void readProperty() {
    PlyProperty property;
    std::string_view type = nextWord(&line_);
    if (type == "list") {
      property.count = typeNamed(nextWord(&line_));
      if (!isInteger(*property.count)) fail("the number of a list's values must be an integer");
      type = nextWord(&line_);
    }
    property.type = typeNamed(type);
    property.name = nextWord(&line_);
    if (header_.elements.empty() || property.name.empty()) fail("a property needs an element before it, a type and a name");
    std::vector<PlyProperty>& properties = header_.elements.back().properties;
    for (const PlyProperty& other : properties)
      if (other.name == property.name) fail("a second property " + inQuotes(property.name));
    if (properties.size() == kMostNames) fail("more than " + std::to_string(kMostNames) + " properties");
    properties.push_back(property);
  }

  PlyType typeNamed(std::string_view name) const {
    const auto* const found = std::find_if(std::begin(kTypes), std::end(kTypes), [&](const NamedType& t) { return t.name == name; });
    if (found == std::end(kTypes)) fail("unknown type " + inQuotes(name));
    return found->type;
  }

  void endOfLine() {
    const std::string_view word = nextWord(&line_);
    if (!word.empty()) fail(inQuotes(word) + " at the end of a header line");
  }

  void checkElements() const {
    if (!has_format_) failNotAMesh(path_, "its header has no format");
    for (const PlyElement& e : header_.elements) {
      if (e.rows > 0 && e.properties.empty()) failNotAMesh(path_, "element '" + e.name + "' has no property");
      if (e.rows > header_.data.size())  // each takes a byte at least
        failNotAMesh(path_, "announces " + std::to_string(e.rows) + " rows of element '" + e.name + "' but has only " +
                                std::to_string(header_.data.size()) + " bytes of data");
      if (e.rows > 0 && (e.name == "tristrips" || e.name == "range_grid"))
        failNotAMesh(path_, "its element '" + e.name + "' is not supported", "write faces instead");
      if (std::count_if(header_.elements.begin(), header_.elements.end(), [&](const PlyElement& other) { return other.name == e.name; }) >
          1)
        failNotAMesh(path_, "has two elements '" + e.name + "'");
    }
  }

  [[noreturn]] void fail(const std::string& reason) const { failNotAMesh(path_, header_.lines, reason); }

  const std::string& path_;
  char line_end_ = '\n';
  std::string_view line_;  // what is left of the current line
  bool has_format_ = false;
  PlyHeader header_;
};

}  // namespace

std::size_t bytesOf(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8: return 1;
    case PlyType::kInt16:
    case PlyType::kUint16: return 2;
    case PlyType::kDouble: return 8;
    default: return 4;
  }
}

bool isInteger(PlyType type) {
  return type != PlyType::kFloat && type != PlyType::kDouble;
}

PlyHeader readPlyHeader(std::string_view bytes, const std::string& path) {
  return HeaderReader(bytes, path).read();
}

}  // namespace collision_hulls
