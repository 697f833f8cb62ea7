// Lossless conversion of values to bytes and back, for the library's own files.
//
// A type takes part through a function `fields(archive, value)` that lists its members once, for both directions:
//
//   template <typename Archive>
//   void fields(Archive& archive, HalfSpace& face) { archive(face.normal, face.offset); }
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "collision_hulls/geometry/convex_hull.h"
#include "collision_hulls/geometry/triangle_mesh.h"

namespace collision_hulls {

// Files are little-endian, like the machines this runs on.
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "numbers are copied byte for byte from memory");

/// What is wrong with some bytes, worded to end a sentence that names the file.
class ByteFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Numbers and enumerators: copied as they are.
template <typename Value>
constexpr bool kIsPlain = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;

/// Appends values to a byte string.
class ByteWriter {
 public:
  template <typename... Values>
  void operator()(const Values&... values) {
    (put(values), ...);
  }
  std::string take() { return std::move(bytes_); }

 private:
  template <typename Value>
  void put(const Value& value) {
    if constexpr (kIsPlain<Value>) {
      char raw[sizeof value];
      std::memcpy(raw, &value, sizeof value);
      bytes_.append(raw, sizeof value);
    } else {
      fields(*this, const_cast<Value&>(value));  // changes nothing: this archive takes const references
    }
  }
  void put(const std::string& text) {
    put(std::uint64_t{text.size()});
    bytes_ += text;
  }
  void put(const Eigen::Vector3d& v) { (*this)(v.x(), v.y(), v.z()); }
  template <typename Value, std::size_t n>
  void put(const std::array<Value, n>& values) {
    for (const Value& value : values) put(value);
  }
  template <typename Value>
  void put(const std::vector<Value>& values) {
    put(std::uint64_t{values.size()});
    bytes_.reserve(bytes_.size() + values.size() * sizeof(Value));
    for (const Value& value : values) put(value);
  }

  std::string bytes_;
};

/// Reads the values back in the same order. Never reads past the end, nor reserves more memory than the bytes can fill. Throws ByteFault.
class ByteReader {
 public:
  explicit ByteReader(const std::string& bytes) : bytes_(bytes) {}

  template <typename... Values>
  void operator()(Values&... values) {
    (get(values), ...);
  }
  /// Throws ByteFault if any bytes are left.
  void expectEnd() const {
    if (left() > 0) throw ByteFault(std::to_string(left()) + " bytes follow its end");
  }

 private:
  template <typename Value>
  void get(Value& value) {
    if constexpr (kIsPlain<Value>) {
      std::memcpy(&value, take(sizeof value), sizeof value);
    } else {
      fields(*this, value);
    }
  }
  void get(std::string& text) {
    const std::uint64_t size = count();
    text.assign(take(size), size);
  }
  void get(Eigen::Vector3d& v) { (*this)(v.x(), v.y(), v.z()); }
  template <typename Value, std::size_t n>
  void get(std::array<Value, n>& values) {
    for (Value& value : values) get(value);
  }
  template <typename Value>
  void get(std::vector<Value>& values) {
    const std::uint64_t size = count();
    values.clear();
    values.reserve(std::min<std::uint64_t>(size, left() / sizeof(Value) + 1));
    for (std::uint64_t i = 0; i < size; ++i) get(values.emplace_back());
  }

  std::uint64_t count() {
    std::uint64_t count = 0;
    get(count);
    return count;
  }
  const char* take(std::uint64_t size) {
    if (size > left())
      throw ByteFault("it ends inside a value: only " + std::to_string(left()) + " of its " + std::to_string(size) + " bytes are there");
    at_ += size;
    return bytes_.data() + (at_ - size);
  }
  std::uint64_t left() const { return bytes_.size() - at_; }

  const std::string& bytes_;
  std::uint64_t at_ = 0;
};

/// Some values as bytes, and back; fromBytes also throws if bytes are left over.
template <typename... Values>
std::string toBytes(const Values&... values) {
  ByteWriter out;
  out(values...);
  return out.take();
}
template <typename... Values>
void fromBytes(const std::string& bytes, Values&... values) {
  ByteReader in(bytes);
  in(values...);
  in.expectEnd();
}

/// FNV-1a (Fowler, Noll, Vo). Each step is a bijection of the state, so changing a single byte always changes the sum.
std::uint64_t checksum(std::string_view bytes);

/// A file's kind and format version, as stored at its start.
struct FileKind {
  std::array<char, 8> magic;
  std::uint32_t version;
};

/// A file's bytes: magic, version, size of the payload, payload, and a 64-bit checksum of all these. Any change to a single byte is
/// detected.
std::string sealed(const FileKind& kind, const std::string& payload);

/// The payload of a file. Throws ByteFault if the kind, version, size or checksum does not match.
std::string opened(const FileKind& kind, const std::string& bytes);

template <typename Archive>
void fields(Archive& archive, TriangleMesh& mesh) {
  archive(mesh.vertices, mesh.triangles);
}

template <typename Archive>
void fields(Archive& archive, HalfSpace& face) {
  archive(face.normal, face.offset);
}

template <typename Archive>
void fields(Archive& archive, ConvexHull& hull) {
  archive(hull.vertices, hull.triangles, hull.faces, hull.thickness, hull.slack);
}

}  // namespace collision_hulls
