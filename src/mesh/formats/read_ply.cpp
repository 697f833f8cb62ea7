// PLY, text or binary of either byte order. The header says what each row holds; all rows are walked, and of them x, y and z of "vertex"
// and the index list of "face" are kept. The data must end where the header says.
#include <array>
#include <cstring>
#include <limits>

#include "mesh/formats/number.h"
#include "mesh/formats/ply_header.h"
#include "mesh/formats/readers.h"
#include "mesh/formats/scan.h"
#include "mesh/polygons.h"

namespace collision_hulls {
namespace {

/// The range of an integer type.
struct Range {
  std::int64_t least, most;
};

template <typename T>
constexpr Range kRangeOf{std::numeric_limits<T>::min(), std::numeric_limits<T>::max()};

Range rangeOf(PlyType type) {
  switch (type) {
    case PlyType::kInt8: return kRangeOf<std::int8_t>;
    case PlyType::kUint8: return kRangeOf<std::uint8_t>;
    case PlyType::kInt16: return kRangeOf<std::int16_t>;
    case PlyType::kUint16: return kRangeOf<std::uint16_t>;
    case PlyType::kInt32: return kRangeOf<std::int32_t>;
    default: return kRangeOf<std::uint32_t>;
  }
}

/// The values of a text, a line per row.
class TextValues {
 public:
  TextValues(const PlyHeader& header, const std::string& path, const RunControl& control)
      : lines_(header.data, control, header.lines + 1), path_(path) {}

  void beginRow(const PlyElement& element) {
    element_ = &element;
    if (!lines_.next(&line_))
      failNotAMesh(path_, "ends within the " + std::to_string(element.rows) + " rows announced for element '" + element.name + "'");
  }
  void endRow() {
    if (!nextWord(&line_).empty()) fail("too many values for element '" + element_->name + "'");
  }
  void end() {
    if (lines_.next(&line_)) fail("more rows than the header announces");
  }

  std::int64_t integer(PlyType type) {
    const std::string_view word = value();
    std::int64_t value = 0;
    const Range range = rangeOf(type);
    if (!parseInteger(word, &value) || value < range.least || value > range.most)
      fail(inQuotes(word) + " is not an integer from " + std::to_string(range.least) + " to " + std::to_string(range.most));
    return value;
  }
  double number(PlyType type) { return isInteger(type) ? static_cast<double>(integer(type)) : numberIn(value(), path_, lines_.number()); }
  void skip(PlyType type, std::uint64_t count) {
    for (; count > 0; --count) number(type);
  }
  [[noreturn]] void fail(const std::string& reason) const { failNotAMesh(path_, lines_.number(), reason); }

 private:
  std::string_view value() {
    const std::string_view word = nextWord(&line_);
    if (word.empty()) fail("too few values for element '" + element_->name + "'");
    return word;
  }

  LineScanner lines_;
  const std::string& path_;
  const PlyElement* element_ = nullptr;
  std::string_view line_;  // what is left of the current row
};

/// The values of binary data, one right behind the other.
class BinaryValues {
 public:
  BinaryValues(const PlyHeader& header, const std::string& path)
      : data_(header.data), path_(path), reversed_(header.format == PlyHeader::Format::kBigEndian) {}

  void beginRow(const PlyElement& element) { element_ = &element; }
  void endRow() {}
  void end() {
    std::string_view rest = data_;
    if (!nextWord(&rest).empty()) failNotAMesh(path_, "has " + std::to_string(data_.size()) + " bytes more than its header announces");
  }

  std::int64_t integer(PlyType type) {
    switch (type) {
      case PlyType::kInt8: return take<std::int8_t>();
      case PlyType::kUint8: return take<std::uint8_t>();
      case PlyType::kInt16: return take<std::int16_t>();
      case PlyType::kUint16: return take<std::uint16_t>();
      case PlyType::kInt32: return take<std::int32_t>();
      default: return take<std::uint32_t>();
    }
  }
  double number(PlyType type) {
    if (type == PlyType::kFloat) return static_cast<double>(take<float>());
    return type == PlyType::kDouble ? take<double>() : static_cast<double>(integer(type));
  }
  void skip(PlyType type, std::uint64_t count) {
    if (count > data_.size() / bytesOf(type)) failShort();
    data_.remove_prefix(count * bytesOf(type));
  }
  [[noreturn]] void fail(const std::string& reason) const { failNotAMesh(path_, "element '" + element_->name + "': " + reason); }

 private:
  template <typename T>
  T take() {
    if (data_.size() < sizeof(T)) failShort();
    std::array<char, sizeof(T)> bytes;
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes[reversed_ ? sizeof(T) - 1 - i : i] = data_[i];
    data_.remove_prefix(sizeof(T));
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }

  [[noreturn]] void failShort() const {
    failNotAMesh(path_, "ends within the " + std::to_string(element_->rows) + " rows announced for element '" + element_->name + "'");
  }

  std::string_view data_;  // from the current value on
  const std::string& path_;
  bool reversed_;
  const PlyElement* element_ = nullptr;
};

/// What a property is for us.
enum class Role { kX, kY, kZ, kCorners, kNone };

Role roleOf(const PlyElement& element, const PlyProperty& property) {
  if (element.name == "vertex" && !property.count) {
    if (property.name == "x") return Role::kX;
    if (property.name == "y") return Role::kY;
    if (property.name == "z") return Role::kZ;
  }
  const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
  return element.name == "face" && property.count && corners ? Role::kCorners : Role::kNone;
}

/// Walks through all rows.
template <typename Values>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Values values, Polygons* polygons, const std::string& path, const RunControl& control)
      : header_(header), values_(std::move(values)), polygons_(*polygons), path_(path), control_(control) {}

  void read() {
    for (const PlyElement& element : header_.elements)
      if (element.name == "vertex") points_ = element.rows;
    for (const PlyElement& element : header_.elements) readElement(element);
    values_.end();
  }

 private:
  static constexpr std::size_t kRowsBetweenChecks = 1 << 16;

  void readElement(const PlyElement& element) {
    std::vector<Role> roles;
    for (const PlyProperty& property : element.properties) roles.push_back(roleOf(element, property));
    for (face_ = 0; face_ < element.rows; ++face_) {
      if (face_ % kRowsBetweenChecks == 0) control_.check();
      values_.beginRow(element);
      std::array<double, 3> p{};
      for (std::size_t k = 0; k < roles.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (roles[k] == Role::kCorners) {
          readCorners(property);
        } else if (roles[k] == Role::kNone) {
          values_.skip(property.type, property.count ? countOf(property) : 1);
        } else {
          p[static_cast<std::size_t>(roles[k])] = values_.number(property.type);
        }
      }
      values_.endRow();
      if (element.name == "vertex") polygons_.addPoint(p[0], p[1], p[2]);
    }
  }

  std::uint64_t countOf(const PlyProperty& list) {
    const std::int64_t count = values_.integer(*list.count);
    if (count < 0) values_.fail("a list of " + std::to_string(count) + " values");
    return static_cast<std::uint64_t>(count);
  }

  void readCorners(const PlyProperty& list) {
    for (std::uint64_t count = countOf(list); count > 0; --count) {
      const std::int64_t index = values_.integer(list.type);
      if (index < 0 || static_cast<std::uint64_t>(index) >= points_ || index > std::numeric_limits<int>::max())
        throw Error(ErrorCode::kIndexOutOfRange, path_ + ": face " + std::to_string(face_) + " names vertex " + std::to_string(index) +
                                                     ", but there are " + std::to_string(points_) + ", counted from 0; export it again");
      polygons_.addCorner(static_cast<int>(index));
    }
    polygons_.endPolygon();
  }

  const PlyHeader& header_;
  Values values_;
  Polygons& polygons_;
  const std::string& path_;
  const RunControl& control_;
  std::size_t points_ = 0;
  std::size_t face_ = 0;  // the current row
};

/// Vertices need coordinates, and faces one list of corners.
void checkProperties(const PlyElement& element, const std::string& path) {
  std::array<int, 5> times{};
  for (const PlyProperty& property : element.properties) {
    const Role role = roleOf(element, property);
    ++times[static_cast<std::size_t>(role)];
    if (role == Role::kCorners && !isInteger(property.type)) failNotAMesh(path, "the corners of its faces are not integers");
  }
  if (element.name == "vertex" && (times[0] == 0 || times[1] == 0 || times[2] == 0)) failNotAMesh(path, "its vertices lack x, y or z");
  if (element.name == "face" && times[3] != 1)
    failNotAMesh(path, times[3] == 0 ? "its faces have no list vertex_indices" : "its faces have both vertex_indices and vertex_index");
}

}  // namespace

LoadedMesh readPly(const std::string& bytes, const std::string& path, const MeshLimits& limits, const RunControl& control) {
  const PlyHeader header = readPlyHeader(bytes, path);
  Polygons polygons(path, limits.max_triangles, control);
  std::size_t vertices = 0, faces = 0;
  for (const PlyElement& element : header.elements) {
    checkProperties(element, path);
    if (element.name == "vertex") vertices = element.rows;
    if (element.name == "face") faces = element.rows;
  }
  checkTriangleCount(path, faces, limits.max_triangles);
  polygons.reserve(vertices, faces);
  if (header.format == PlyHeader::Format::kText) {
    checkedText(header.data, path);
    PlyReader<TextValues>(header, TextValues(header, path, control), &polygons, path, control).read();
  } else {
    PlyReader<BinaryValues>(header, BinaryValues(header, path), &polygons, path, control).read();
  }
  return polygons.triangles(Polygons::Vertices::kShared);
}

}  // namespace collision_hulls
