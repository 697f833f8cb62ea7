// Also tests src/mesh/formats/ply_header.cpp.
#include <gtest/gtest.h>

#include "../files.h"
#include "../reading.h"

namespace collision_hulls {
namespace {

using namespace test_files;

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kFace = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kHeader = "ply\nformat ascii 1.0\nelement vertex 3\n" + kXyz + kFace + "end_header\n";  // nine lines
const std::string kData = "0 0 0\n1 0 0\n1 2 0\n3 0 1 2\n";
const std::vector<Eigen::Vector3d> kFirst{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}};
const std::vector<Triangle> kOne{{0, 1, 2}};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
  return text;
}

/// One value in the bytes of a type.
template <typename T>
std::string binary(double value, bool big) {
  using Whole = std::conditional_t<std::is_integral_v<T>, std::int64_t, T>;  // -1 is no value of an unsigned type, but wraps to one
  const std::string bytes = raw(static_cast<T>(static_cast<Whole>(value)));
  return big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

std::string binary(const std::string& type, double value, bool big) {
  if (type == "char" || type == "int8") return binary<std::int8_t>(value, big);
  if (type == "uchar" || type == "uint8") return binary<std::uint8_t>(value, big);
  if (type == "short" || type == "int16") return binary<std::int16_t>(value, big);
  if (type == "ushort" || type == "uint16") return binary<std::uint16_t>(value, big);
  if (type == "int" || type == "int32") return binary<std::int32_t>(value, big);
  if (type == "uint" || type == "uint32") return binary<std::uint32_t>(value, big);
  return type == "float" || type == "float32" ? binary<float>(value, big) : binary<double>(value, big);
}

const std::vector<std::string> kIntegers{"char", "uchar", "short", "ushort", "int",   "uint",
                                         "int8", "uint8", "int16", "uint16", "int32", "uint32"};

TEST(ReadPly, EveryTypeInEveryFormat) {
  std::vector<std::string> types = kIntegers;
  types.insert(types.end(), {"float", "double", "float32", "float64"});
  for (const std::string& type : types) {
    SCOPED_TRACE(type);
    const std::string header = replaced(kHeader, "property float", "property " + type);
    expectMesh("a.ply", header + kData, kFirst, kOne);
    for (const bool big : {false, true}) {
      std::string bytes = replaced(header, "ascii", big ? "binary_big_endian" : "binary_little_endian");
      for (const Eigen::Vector3d& p : kFirst)
        for (const double x : p) bytes += binary(type, x, big);
      expectMesh("a.ply", bytes + '\3' + binary("int", 0, big) + binary("int", 1, big) + binary("int", 2, big), kFirst, kOne);
    }
  }
}

TEST(ReadPly, EveryTypeOfAListInEveryFormat) {
  for (const std::string& type : kIntegers) {
    SCOPED_TRACE(type);
    const std::string header = replaced(replaced(kHeader, "uchar int", type + " " + type), "vertex_indices", "vertex_index");
    expectMesh("a.ply", header + kData, kFirst, kOne);
    for (const bool big : {false, true}) {
      std::string bytes = replaced(header, "ascii", big ? "binary_big_endian" : "binary_little_endian");
      for (const Eigen::Vector3d& p : kFirst)
        for (const double x : p) bytes += binary("float", x, big);
      for (const double x : {3, 0, 1, 2}) bytes += binary(type, x, big);
      expectMesh("a.ply", bytes, kFirst, kOne);
      const std::string negative = bytes.substr(0, bytes.size() - 4 * binary(type, 0, big).size()) + binary(type, -1, big);
      expectRefused("a.ply", {{negative, type[0] == 'u' ? "ends within the 1 rows" : "a list of -1 values"}});
    }
  }
}

TEST(ReadPly, OtherElementsAndPropertiesAreSkipped) {
  const std::string header =
      "ply\ncomment element junk\nformat ascii 1.0\nobj_info made up\nelement camera 2\nproperty float a\nproperty list int "
      "float b\nelement vertex 3\nproperty uchar red\n" +
      kXyz + "property list uchar float uv\n" + replaced(kFace, "vertex_indices\n", "vertex_indices\nproperty int part\n") +
      "element edge 1\nproperty int v1\nproperty int v2\nend_header\n";
  expectMesh("a.ply", header + "1 2 0.5 0.5\n1 0\n7 0 0 0 0\n7 1 0 0 1 1.5\n7 1 2 0 2 1 1\n3 0 1 2 9\n0 1\n", kFirst, kOne);
}

TEST(ReadPly, FacesMayComeBeforeTheirVertices) {
  expectMesh("a.ply", "ply\nformat ascii 1.0\n" + kFace + "element vertex 3\n" + kXyz + "end_header\n3 0 1 2\n0 0 0\n1 0 0\n1 2 0\n",
             kFirst, kOne);
}

TEST(ReadPly, EndsOfLines) {
  expectMesh("a.ply", replaced(kHeader + kData, "\n", "\r\n"), kFirst, kOne);
  expectMesh("a.ply", replaced(kHeader + kData, "\n", "\r"), kFirst, kOne);
  expectMesh("a.ply", kHeader + "\n0 0 0\n \n1 0 0\n1 2 0\n\t\n3 0 1 2\n \n", kFirst, kOne);
  // Binary data that begins with the character that would end a line.
  const std::string header = replaced(replaced(kHeader, "ascii", "binary_little_endian"), "float x", "char x");
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string bytes = replaced(header, "\n", end);
    for (const char x : {'\n', '\r', '\0'}) bytes += x + raw(0.f) + raw(x == '\0' ? 1.f : 0.f);
    expectMesh("a.ply", bytes + '\3' + raw(0) + raw(1) + raw(2), {{10, 0, 0}, {13, 0, 0}, {0, 0, 1}}, kOne);
  }
}

TEST(ReadPly, RefusesNumbersThatOthersGuess) {
  for (const std::string& word : misspeltNumbers()) {
    const std::string part = "line 11: '" + word + "' is not a number";
    expectRefused("a.ply", {{kHeader + "0 0 0\n1 " + word + " 0\n1 2 0\n3 0 1 2\n", part}});
  }
  const std::string coloured = replaced(kHeader, "float z\n", "float z\nproperty uchar red\n");
  expectRefused("a.ply", {{coloured + "0 0 0 7\n1 0 0 7,5\n1 2 0 7\n3 0 1 2\n", "line 12: '7,5' is not an integer from 0 to 255"},
                          {coloured + "0 0 0 7\n1 0 0 7.5\n1 2 0 7\n3 0 1 2\n", "line 12: '7.5' is not an integer"},
                          {coloured + "0 0 0 7\n1 0 0 256\n1 2 0 7\n3 0 1 2\n", "line 12: '256' is not an integer"}});
  const std::string whole = replaced(kHeader, "float x", "uchar x");
  for (const char* word : {"0.5", "256", "-1"})
    expectRefused("a.ply", {{whole + "0 0 0\n" + word + " 0 0\n1 2 0\n3 0 1 2\n",
                             "line 11: '" + std::string(word) + "' is not an integer from 0 to 255"}});
  expectRefused("a.ply", {{kHeader + "0 0 0\n1 0 0\n1 nan 0\n3 0 1 2\n", "vertex 2 (of face 0", ErrorCode::kNonFiniteCoordinate}});
}

TEST(ReadPly, RefusesHeadersThatOthersSkip) {
  struct Case {
    std::string from, to, part;
  };
  for (const Case& c :
       {Case{"property float z\n", "3 7 8 11\nproperty float z\n", "line 6: '3' begins no line of a PLY header"},
        {"property float z\n", "", "its vertices lack x, y or z"},
        {"float z", "list uchar float z", "its vertices lack x, y or z"},
        {"float z", "float y", "line 6: a second property 'y'"},
        {"float z", "half z", "line 6: unknown type 'half'"},
        {"float z", "float", "a property needs an element before it, a type and a name"},
        {"float z", "float z w", "line 6: 'w' at the end of a header line"},
        {"uchar int", "float int", "the number of a list's values must be an integer"},
        {"uchar int", "uchar float", "the corners of its faces are not integers"},
        {"vertex_indices", "indices", "its faces have no list vertex_indices"},
        {"vertex_indices\n", "vertex_indices\nproperty list uchar int vertex_index\n", "both vertex_indices and vertex_index"},
        {"element vertex 3", "element vertex three", "line 3: an element needs a name and a number of rows"},
        {"element vertex 3", "element vertex -3", "an element needs a name and a number of rows"},
        {"element vertex 3", "element vertex 3 3", "'3' at the end"},
        {"element vertex 3", "element vertex 3000", "announces 3000 rows of element 'vertex' but has only"},
        {"element face 1\n", "element face 1\nproperty list uchar int vertex_index\nelement face 1\n", "has two elements 'face'"},
        {"element face", "element tristrips 1\nproperty list int int vertex_indices\nelement face",
         "'tristrips' is not supported; write faces"},
        {"element face", "element edge 1\nelement face", "element 'edge' has no property"},
        {"format ascii 1.0\n", "", "its header has no format"},
        {"format ascii 1.0\n", "format ascii 1.0\nformat binary_big_endian 1.0\n", "line 3: a second format"},
        {"ascii", "text", "line 2: unknown format 'text'"},
        {"ascii 1.0", "ascii 2.0", "line 2: a version other than 1.0"},
        {"end_header", "end_header now", "'now' at the end"},
        {"end_header\n", "", "line 9: '0' begins no line of a PLY header"},
        {"ply\n", "plyx\n", "does not begin with 'ply'"}})
    expectRefused("a.ply", {{replaced(kHeader + kData, c.from, c.to), c.part}});
  expectRefused("a.ply", {{"ply\nformat ascii 1.0\nelement vertex 0\n", "no end_header"},
                          {"ply\nformat ascii 1.0\nend_header\n", "no triangle", ErrorCode::kEmptyMesh}});
}

TEST(ReadPly, RefusesNamesWithoutEnd) {
  std::string properties, elements;
  for (int i = 0; i < 2000; ++i) {
    properties += "property int p" + std::to_string(i) + "\n";
    elements += "element e" + std::to_string(i) + " 0\n";
  }
  expectRefused("a.ply", {{replaced(kHeader, "element face", properties + "element face") + kData, "more than 1000 properties"},
                          {replaced(kHeader, "element face", elements + "element face") + kData, "more than 1000 elements"}});
}

TEST(ReadPly, RefusesRowsThatDoNotFit) {
  expectRefused("a.ply",
                {{kHeader + "0 0 0\n1 0 0\n1 2 0\n", "ends within the 1 rows announced for element 'face'"},
                 {kHeader + kData + "3 2 1 0\n", "line 14: more rows than the header announces"},
                 {kHeader + "0 0 0 0\n1 0 0\n1 2 0\n3 0 1 2\n", "line 10: too many values for element 'vertex'"},
                 {kHeader + "0 0\n1 0 0\n1 2 0\n3 0 1 2\n", "line 10: too few values for element 'vertex'"},
                 {kHeader + "0 0 0\n1 0 0\n1 2 0\n4 0 1 2\n", "line 13: too few values for element 'face'"},
                 {kHeader + "0 0 0\n1 0 0\n1 2 0\n300 0 1 2\n", "'300' is not an integer from 0 to 255"},
                 {kHeader + "0 0 0\n1 0 0\n1 2 0\n3 0 1 2.0\n", "'2.0' is not an integer"},
                 {kHeader + "0 0 0\n1 0 0\n1 2 0\n3 0 1 3\n", "face 0 names vertex 3, but there are 3", ErrorCode::kIndexOutOfRange},
                 {kHeader + "0 0 0\n1 0 0\n1 2 0\n3 0 1 -1\n", "face 0 names vertex -1", ErrorCode::kIndexOutOfRange},
                 {kHeader + "0 0 0\n1 0 0\n1 2 0\n3 0 1 4294967297\n", "'4294967297' is not an integer from -2147483648"}});
  std::string bytes = replaced(kHeader, "ascii", "binary_little_endian");
  for (const Eigen::Vector3d& p : kFirst)
    for (const double x : p) bytes += raw(static_cast<float>(x));
  const std::string whole = bytes + '\3' + raw(0) + raw(1) + raw(2);
  expectMesh("a.ply", whole + "\n", kFirst, kOne);
  expectRefused("a.ply", {{whole + "x", "has 1 bytes more than its header announces"},
                          {whole.substr(0, whole.size() - 1), "ends within the 1 rows"},
                          {bytes + '\xff', "ends within the 1 rows"},
                          {bytes + '\3' + raw(0) + raw(1) + raw(-1), "names vertex -1", ErrorCode::kIndexOutOfRange}});
  const std::string textured = replaced(replaced(kHeader, "ascii", "binary_little_endian"), "int vertex_indices\n",
                                        "int vertex_indices\nproperty list uint double uv\n");
  expectRefused("a.ply", {{textured + bytes.substr(bytes.find("end_header\n") + 11) + '\3' + raw(0) + raw(1) + raw(2) + raw(0xffffffffu),
                           "ends within"}});
}

}  // namespace
}  // namespace collision_hulls
