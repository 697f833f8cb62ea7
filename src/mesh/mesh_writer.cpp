// Encodes hulls as mesh files. The same hull gives the same bytes: no date, no version, no locale.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <map>
#include <sstream>
#include <string_view>

#include "base/decimal.h"
#include "collision_hulls/mesh/mesh_io.h"

namespace collision_hulls {
namespace {

constexpr std::size_t kStlHeaderBytes = 80;
// Must not begin with "solid", the mark of a text STL.
constexpr char kStlHeader[] = "binary STL, convex hull, metres, written by collision_hulls";
constexpr char kObjHeader[] = "# convex hulls, metres, written by collision_hulls\n";

/// Appends a number in little-endian order, which both the format and the machines this runs on use.
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

/// Writes numbers as single precision with nine digits, enough to recover each one. Assimp rounds several times when it applies a power of
/// ten, so small numbers are written without an exponent as far as Assimp reads digits.
class Decimals {
 public:
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
  std::ostringstream text_ = decimalStream();
};

/// A name as one word that needs no escaping in XML.
std::string oneWord(std::string name) {
  const auto reserved = [](char c) { return static_cast<unsigned char>(c) <= ' ' || std::strchr("<>&\"'", c) != nullptr; };
  std::replace_if(name.begin(), name.end(), reserved, '_');
  return name;
}

/// `first`: the index in the file of the hull's first vertex, counted from 1.
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

// The schema requires both dates; today's would make the bytes of a hull change from day to day.
constexpr char kDae[] = R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset>
    <contributor><authoring_tool>collision_hulls</authoring_tool></contributor>
    <created>1970-01-01T00:00:00Z</created>
    <modified>1970-01-01T00:00:00Z</modified>
    <unit name="meter" meter="1"/>
    <up_axis>Z_UP</up_axis>
  </asset>
  <library_geometries>
    <geometry id="hull" name="@name@">
      <mesh>
        <source id="positions">
          <float_array id="coordinates" count="@numbers@">@coordinates@</float_array>
          <technique_common>
            <accessor source="#coordinates" count="@vertices@" stride="3">
              <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
            </accessor>
          </technique_common>
        </source>
        <vertices id="vertices"><input semantic="POSITION" source="#positions"/></vertices>
        <triangles count="@triangles@">
          <input semantic="VERTEX" source="#vertices" offset="0"/>
          <p>@corners@</p>
        </triangles>
      </mesh>
    </geometry>
  </library_geometries>
  <library_visual_scenes>
    <visual_scene id="scene">
      <node id="node"><instance_geometry url="#hull"/></node>
    </visual_scene>
  </library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
)";

/// The text with every @key@ replaced by its value.
std::string filled(std::string_view text, const std::map<std::string_view, std::string>& values) {
  std::string result;
  for (bool key = false;; key = !key) {
    const std::string_view part = text.substr(0, text.find('@'));
    result += key ? values.at(part) : part;
    if (part.size() == text.size()) return result;
    text.remove_prefix(part.size() + 1);
  }
}

std::string dae(const ConvexHull& hull, const std::string& name) {
  Decimals coordinates;
  for (const Eigen::Vector3d& v : hull.vertices) coordinates << v.x() << " " << v.y() << " " << v.z() << " ";
  std::string corners;
  for (const Triangle& t : hull.triangles)
    for (const int v : t) corners += std::to_string(v) + " ";
  return filled(kDae, {{"name", oneWord(name)},
                       {"numbers", std::to_string(3 * hull.vertices.size())},
                       {"coordinates", coordinates.text()},
                       {"vertices", std::to_string(hull.vertices.size())},
                       {"triangles", std::to_string(hull.triangles.size())},
                       {"corners", corners}});
}

}  // namespace

const char* extension(MeshFormat format) {
  switch (format) {
    case MeshFormat::kStl: return ".stl";
    case MeshFormat::kObj: return ".obj";
    case MeshFormat::kDae: return ".dae";
  }
  return "";
}

std::optional<MeshFormat> meshFormatNamed(const std::string& name) {
  for (const MeshFormat format : {MeshFormat::kStl, MeshFormat::kObj, MeshFormat::kDae})
    if (extension(format) == "." + name) return format;
  return std::nullopt;
}

std::string encodeHull(const ConvexHull& hull, MeshFormat format, const std::string& object_name) {
  switch (format) {
    case MeshFormat::kStl: return stl(hull);
    case MeshFormat::kObj: return kObjHeader + objObject(hull, object_name, 1);
    case MeshFormat::kDae: return dae(hull, object_name);
  }
  return "";
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
