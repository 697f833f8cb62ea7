// Writing hulls. The same hull gives the same bytes: no date, no version, no locale.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <locale>
#include <sstream>

#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kStlHeaderBytes = 80;
// Must not begin with "solid", the mark of a text STL.
constexpr char kStlHeader[] = "binary STL, convex hull, metres, written by collision_hulls";
constexpr char kObjHeader[] = "# convex hulls, metres, written by collision_hulls\n";

/// Little-endian, as the format wants it and the machines that this runs on store it.
template <typename Number>
void append(std::string* bytes, Number number) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes->append(raw, sizeof number);
}

void append(std::string* bytes, const Eigen::Vector3d& v) {
  for (const double x : {v.x(), v.y(), v.z()}) append(bytes, static_cast<float>(x));
}

std::string stl(const ConvexHull& hull) {
  std::string bytes = kStlHeader;
  bytes.resize(kStlHeaderBytes, ' ');
  append(&bytes, static_cast<std::uint32_t>(hull.triangles.size()));
  for (const Triangle& t : hull.triangles) {
    const auto corner = [&](int k) { return hull.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])]; };
    append(&bytes, (corner(1) - corner(0)).cross(corner(2) - corner(0)).stableNormalized());
    for (int k = 0; k < 3; ++k) append(&bytes, corner(k));
    append(&bytes, std::uint16_t{0});
  }
  return bytes;
}

/// Writes numbers as single precision with the nine digits that bring each back. Assimp rounds a power of ten several times, so
/// small numbers are written without one as far as it reads digits.
class Decimals {
 public:
  Decimals() { text_.imbue(std::locale::classic()); }

  std::string text() const { return text_.str(); }
  Decimals& operator<<(const std::string& text) {
    text_ << text;
    return *this;
  }
  Decimals& operator<<(double number) {
    const auto x = static_cast<float>(number);
    const bool small = std::abs(x) >= 1e-6f && std::abs(x) < 1e-4f;
    text_ << (small ? std::fixed : std::defaultfloat) << std::setprecision(small ? 15 : 9) << x;
    return *this;
  }

 private:
  std::ostringstream text_;
};

/// A name of one word.
std::string oneWord(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
  return name;
}

/// `first`: the number of the hull's first vertex in the file, from 1.
std::string objObject(const ConvexHull& hull, const std::string& name, std::size_t first) {
  Decimals text;
  text << "o " + oneWord(name) + "\n";
  for (const Eigen::Vector3d& v : hull.vertices) text << "v " << v.x() << " " << v.y() << " " << v.z() << "\n";
  for (const Triangle& t : hull.triangles) {
    text << "f";
    for (const int v : t) text << " " + std::to_string(first + static_cast<std::size_t>(v));
    text << "\n";
  }
  return text.text();
}

}  // namespace

const char* extension(MeshFormat format) {
  return format == MeshFormat::kStl ? ".stl" : ".obj";
}

std::string encodeHull(const ConvexHull& hull, MeshFormat format, const std::string& object_name) {
  return format == MeshFormat::kStl ? stl(hull) : kObjHeader + objObject(hull, object_name, 1);
}

std::string encodeHullsObj(const std::vector<ConvexHull>& hulls, const std::string& name) {
  std::string text = kObjHeader;
  std::size_t first = 1;
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    text += objObject(hulls[i], name + "_" + std::to_string(i), first);
    first += hulls[i].vertices.size();
  }
  return text;
}

}  // namespace collision_hulls
