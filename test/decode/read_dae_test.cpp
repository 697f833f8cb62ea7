// Also tests src/decode/collada/collada.cpp, src/decode/collada/collada_shape.cpp and src/decode/collada/collada_xml.cpp.
#include <gtest/gtest.h>

#include "base/at.h"
#include "decode/collada/collada.h"
#include "mesh/files.h"
#include "mesh/reading.h"

namespace collision_hulls {
namespace {

using namespace test_files;

LoadedMesh read(const std::string& bytes) {
  return readHere(bytes, "a.dae");
}

void expectBox(const LoadedMesh& loaded, const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  const Eigen::AlignedBox3d box = boundingBox(loaded.mesh);
  const double tolerance = 1e-6 * box.diagonal().norm();
  EXPECT_LT((box.min() - min).norm(), tolerance) << box.min().transpose();
  EXPECT_LT((box.max() - max).norm(), tolerance) << box.max().transpose();
}

/// The heights z of each triangle's corners, in order: kHeights gives every point one of its own.
std::vector<std::vector<int>> heights(const LoadedMesh& loaded) {
  std::vector<std::vector<int>> result;
  for (const Triangle& t : loaded.mesh.triangles) {
    result.emplace_back();
    for (const int v : t) result.back().push_back(static_cast<int>(loaded.mesh.vertices[at(v)].z()));
  }
  return result;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

const std::string kGood = dae("", kTwoTriangles, kPlainNode);
const std::string kPoints = "0 0 0  1 0 0  1 2 0  0 2 0  0 0 3";

/// The document with other primitives, around points at the heights 0 to 4 over a parabola.
std::string primitives(const std::string& text) {
  return replaced(dae("", text, kPlainNode), kPoints, "0 0 0  1 1 1  2 4 2  3 9 3  4 16 4");
}

using Heights = std::vector<std::vector<int>>;

// --- What is read ---

TEST(ReadDae, AMeshInstancedTwiceCountsTwice) {
  const std::string scene = R"(<node id="a"><instance_geometry url="#shape"/></node>
    <node id="b"><translate>10 0 0</translate><instance_geometry url="#shape"/></node>
    <node id="c"><translate>0 10 0</translate><instance_node url="#library"/></node>)";
  const std::string library =
      R"(<library_nodes><node id="library"><scale>2 2 2</scale><instance_geometry url="#shape"/></node></library_nodes>)";
  const LoadedMesh loaded = read(dae("", kTwoTriangles, scene, library));
  EXPECT_EQ(3, loaded.submeshes);
  EXPECT_EQ(6u, loaded.mesh.triangles.size());
  expectBox(loaded, {0, 0, 0}, {11, 14, 6});
}

TEST(ReadDae, NodeTransformsNest) {
  const std::string scene = R"(<node id="a"><translate>5 0 0</translate><rotate>0 0 1 90</rotate><node id="b"><scale>2 1 1</scale>
    <instance_geometry url="#shape"/></node></node>)";
  expectBox(read(dae("", kTwoTriangles, scene)), {3, 0, 0}, {5, 2, 3});
}

// --- Collada's unit and up-axis as in rviz: the unit counts, the up-axis does not ---

struct UnitCase {
  const char* meter;
  double factor;
};
class ColladaUnit : public testing::TestWithParam<UnitCase> {};

TEST_P(ColladaUnit, IsConvertedToMetres) {
  for (const std::string up : {"", "<up_axis>X_UP</up_axis>", "<up_axis>Y_UP</up_axis>", "<up_axis>Z_UP</up_axis>"}) {
    const std::string scene = R"(<node id="n"><translate>4 0 0</translate><instance_geometry url="#shape"/></node>)";
    const LoadedMesh loaded = read(dae(unit(GetParam().meter) + up, kTwoTriangles, scene));
    expectBox(loaded, GetParam().factor * Eigen::Vector3d(4, 0, 0), GetParam().factor * Eigen::Vector3d(5, 2, 3));
  }
}

INSTANTIATE_TEST_SUITE_P(Units, ColladaUnit,
                         testing::Values(UnitCase{"1", 1}, UnitCase{"0.01", 0.01}, UnitCase{"0.001", 0.001}, UnitCase{"0.0254", 0.0254}));

TEST(ReadDae, WithoutUnitIsInMetres) {
  expectBox(read(dae("", kTwoTriangles, kPlainNode)), {0, 0, 0}, {1, 2, 3});
}

TEST(ReadDae, EveryKindOfPrimitive) {
  EXPECT_EQ(heights(read(primitives("<triangles count='2'>" + kVertexInput + "<p>0 1 2 2 3 4</p></triangles>"))),
            (Heights{{0, 1, 2}, {2, 3, 4}}));
  EXPECT_EQ(heights(read(primitives("<triangles count='2'>" + kVertexInput + "<p>0 1 2</p><p>2 3 4</p></triangles>"))),
            (Heights{{0, 1, 2}, {2, 3, 4}}));
  EXPECT_EQ(heights(read(primitives("<polylist count='2'>" + kVertexInput + "<vcount>3 4</vcount><p>0 1 2 0 1 2 3</p></polylist>"))),
            (Heights{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(heights(read(primitives("<polygons count='2'>" + kVertexInput + "<p>0 1 2 3</p><p>0 3 4</p></polygons>"))),
            (Heights{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  EXPECT_EQ(heights(read(primitives("<trifans count='1'>" + kVertexInput + "<p>4 0 1 2</p></trifans>"))), (Heights{{4, 0, 1}, {4, 1, 2}}));
  EXPECT_EQ(heights(read(primitives("<tristrips count='2'>" + kVertexInput + "<p>0 1 2 3 4</p><p>2 1 0</p></tristrips>"))),
            (Heights{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {2, 1, 0}}));
}

TEST(ReadDae, WhatHasNoSurfaceIsCounted) {
  const LoadedMesh loaded = read(primitives("<lines count='7'>" + kVertexInput + "<p>0 1 2 3</p></lines><linestrips count='1'>" +
                                            kVertexInput + "<p>0 1 2 3</p></linestrips><polylist count='3'>" + kVertexInput +
                                            "<vcount>2 3 0</vcount><p>0 1 0 1 2</p></polylist>"));
  EXPECT_EQ(loaded.skipped_primitives, 2u + 3 + 2);
  EXPECT_EQ(loaded.mesh.triangles.size(), 1u);
  EXPECT_EQ(loaded.submeshes, 1);
}

TEST(ReadDae, IndicesOfOtherInputsAreSkipped) {
  const std::string inputs = "<input semantic='NORMAL' source='#none' offset='0'/><input semantic='VERTEX' source='#corners' offset='2'/>";
  EXPECT_EQ(heights(read(primitives("<triangles count='1'>" + inputs + "<p>9 9 0 9 9 1 9 9 2</p></triangles>"))), (Heights{{0, 1, 2}}));
}

TEST(ReadDae, AccessorsStepThroughTheirArray) {
  const std::string spread =
      replaced(replaced(kGood, "count=\"15\">" + kPoints, "count=\"22\">7 7 0 0 0 7 0 0 1 7 0 2 1 7 0 2 0 7 3 0 0 7"),
               "count=\"5\" stride=\"3\"", "count=\"5\" stride=\"4\" offset=\"2\"");
  // z, y, x
  const std::string turned =
      replaced(replaced(replaced(spread, "name=\"X\"", "name=\"W\""), "name=\"Z\"", "name=\"X\""), "name=\"W\"", "name=\"Z\"");
  const LoadedMesh loaded = read(turned);
  EXPECT_EQ(loaded.mesh.vertices, read(kGood).mesh.vertices);
}

TEST(ReadDae, OtherMaterialsElsewhereDoNotMixUpASecondInstance) {
  // Assimp would take the second instance's second part from where the first part lies.
  const auto instance = [](const std::string& material) {
    return R"(<instance_geometry url="#shape"><bind_material><technique_common><instance_material symbol="a" target="#m"/>
      <instance_material symbol="b" target="#)" +
           material + R"("/></technique_common></bind_material></instance_geometry>)";
  };
  const auto part = [](const std::string& material, const std::string& p) {
    return "<triangles count='1' material='" + material + "'>" + kVertexInput + "<p>" + p + "</p></triangles>";
  };
  const std::string text =
      replaced(primitives(part("a", "0 1 2") + part("b", "2 3 4")), R"(<instance_geometry url="#shape"/>)", instance("m") + instance("n"));
  EXPECT_EQ(heights(read(text)), (Heights{{0, 1, 2}, {2, 3, 4}, {0, 1, 2}, {2, 3, 4}}));
}

TEST(ReadDae, SkinsAndMorphsAreTheirGeometry) {
  const std::string controllers =
      R"(<library_controllers><controller id="m"><morph source="#shape"/></controller>
      <controller id="s"><skin source="#m"><bind_shape_matrix>2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1</bind_shape_matrix></skin></controller>
      </library_controllers>)";
  const std::string node = R"(<node id="n"><instance_controller url="#s"/></node>)";
  EXPECT_EQ(read(dae("", kTwoTriangles, node, controllers)).mesh.vertices, read(kGood).mesh.vertices);
  const std::string circle = R"(<library_controllers><controller id="s"><skin source="#t"/></controller>
      <controller id="t"><skin source="#s"/></controller></library_controllers>)";
  expectRefused("a.dae", {{dae("", kTwoTriangles, node, circle), "<controller> begins a circle"}});
}

TEST(ReadDae, NodesWithoutSurfaceMayHoldAnything) {
  const std::string camera = R"(<node><lookat>1 2 3 4 5 6 7 8 9</lookat><skew>45 1 0 0 0 1 0</skew><instance_camera url="#none"/></node>)";
  EXPECT_EQ(read(dae("", kTwoTriangles, camera + kPlainNode)).mesh.triangles.size(), 2u);
  for (const char* const transform : {"<rotate>-0.5 -0.4 0 78</rotate>", "<translate>0 nan 0</translate>", "<scale>1 1</scale>"}) {
    const std::string light = std::string("<node>") + transform + "<instance_light url=\"#none\"/></node>";
    EXPECT_EQ(read(dae("", kTwoTriangles, light + kPlainNode)).mesh.triangles.size(), 2u) << transform;
    expectRefused("a.dae", {{dae("", kTwoTriangles, std::string("<node>") + transform + kPlainNode + "</node>"), ""}});
  }
}

TEST(ReadDae, ReferencesAreDecoded) {
  EXPECT_EQ(
      read(replaced(replaced(kGood, "id=\"array\"", "id=\"arr&#97;y\""), "url=\"#shape\"", "url=\"#&#x73;hape\"")).mesh.triangles.size(),
      2u);
}

TEST(ReadDae, AnEmptyIdIsAnId) {
  EXPECT_EQ(read(replaced(replaced(kGood, "id=\"scene\"", "id=\"\""), "url=\"#scene\"", "url=\"#\"")).mesh.triangles.size(), 2u);
}

TEST(ReadDae, AnInstancedNodeIsFoundByIdOrElseByName) {
  const std::string scene = R"(<node name="lamp"><instance_geometry url="#shape"/></node><node id="n"><instance_node url="#lamp"/></node>)";
  EXPECT_EQ(read(dae("", kTwoTriangles, scene)).submeshes, 2);
}

// --- What is handed to Assimp ---

TEST(Collada, IsWrittenAgainWithoutWhatItDoesNotNeed) {
  const std::string text = replaced(
      replaced(replaced(replaced(kGood, "<COLLADA", "<!-- <node/> --><COLLADA"), "<p>0 1 2 0 2 4</p>", "<p><![CDATA[0 1 2 0 2\n4]]></p>"),
               "0 0 3", "+.0 1e-2000 3.0000000000000000000000000000000000000000000000001"),
      "</mesh>", "<extra><float_array id='array' count='9000'/></extra></mesh>");
  const RunControl control;
  EXPECT_EQ(
      readCollada(text, "a.dae", 100, control).canonical,
      "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\"><library_geometries><geometry id=\"g0\"><mesh><source id=\"s0\"><float_array "
      "id=\"a0\" count=\"15\">0 0 0 1 0 0 1 2 0 0 2 0 +.0 0 3 </float_array><technique_common><accessor source=\"#a0\" count=\"5\" "
      "stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" "
      "type=\"float\"/></accessor></technique_common></source><vertices id=\"v0\"><input semantic=\"POSITION\" "
      "source=\"#s0\"/></vertices><triangles count=\"2\"><input semantic=\"VERTEX\" source=\"#v0\" offset=\"0\"/><p>0 1 2 0 2 4 "
      "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"scene\"><node><instance_geometry "
      "url=\"#g0\"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#scene\"/></scene></COLLADA>\n");
  expectBox(read(text), {0, 0, 0}, {1, 2, 3});
}

TEST(Collada, NumbersThatAssimpMisreadsAreSpeltOtherwise) {
  for (const char* word : {"30000000000000000000000e-22", "0.00000000000000000000000003e26", "3e0000", "+3", "3.", "0.3e1", "0003"})
    expectBox(read(replaced(kGood, "0 0 3", std::string("0 0 ") + word)), {0, 0, 0}, {1, 2, 3});
}

// --- What is refused ---

TEST(ReadDae, RefusesNumbersThatOthersGuess) {
  for (const std::string& word : misspeltNumbers()) {
    expectRefused("a.dae",
                  {{replaced(kGood, "0 0 3", "0 0 " + word), "line 5: <float_array> holds '" + word + "', which is not a number"},
                   {replaced(kGood, "<instance_geometry", "<translate>0 0 " + word + "</translate><instance_geometry"),
                    "<translate> holds '" + word + "', which is not a finite number"},
                   {dae(unit(word), kTwoTriangles, kPlainNode), "<unit> has meter = '" + word + "'; it must be a positive number"}});
  }
  for (const char* word : {"0", "-1", "nan", "inf", "1e39", "1e-60", ""})
    expectRefused("a.dae", {{dae(unit(word), kTwoTriangles, kPlainNode), "it must be a positive number"}});
  for (const char* word : {"nan", "1e39"})
    expectRefused("a.dae",
                  {{replaced(kGood, "0 0 3", std::string("0 0 ") + word), "not a finite number", ErrorCode::kNonFiniteCoordinate}});
}

TEST(ReadDae, RefusesIndicesThatOthersGuess) {
  for (const char* word : {"5", "-1", "4294967298", "4294967296"})
    expectRefused("a.dae", {{replaced(kGood, "0 2 4<", std::string("0 2 ") + word + "<"),
                             "line 9 names vertex " + std::string(word) + ", but there are 5", ErrorCode::kIndexOutOfRange}});
  for (const char* word : {"x", "4.0", "+4", "0x4", "99999999999999999999", "4,"})
    expectRefused("a.dae", {{replaced(kGood, "0 2 4<", std::string("0 2 ") + word + "<"),
                             "<p> holds '" + std::string(word) + "', which is not an index"}});
}

TEST(ReadDae, RefusesReferencesThatLeadNowhereOrToSeveral) {
  const std::string second_array = "<source id='more'><float_array id='array' count='1'>0</float_array></source><vertices";
  const std::string geometry = "<library_geometries><geometry id='shape'/></library_geometries>";
  expectRefused(
      "a.dae",
      {{replaced(kGood, "accessor source=\"#array\"", "accessor source=\"#other\""),
        "refers to <float_array> 'other', which its mesh does not have"},
       {replaced(kGood, "<vertices", second_array), "refers to <float_array> 'array', which its mesh has twice"},
       {replaced(kGood, "accessor source=\"#array\"", "accessor source=\"array\""), "refers to 'array', not to something in this file"},
       {replaced(kGood, "source=\"#positions\"", "source=\"#corners\""), "<source> 'corners', which its mesh does not have"},
       {replaced(kGood, "source=\"#corners\"", "source=\"#shape\""), "<vertices> 'shape', which its mesh does not have"},
       {replaced(kGood, "url=\"#shape\"", "url=\"#other\""), "refers to '#other', which is not there"},
       {replaced(kGood, "url=\"#shape\"", "url=\"other.dae#shape\""), "put everything into one file"},
       {dae("", kTwoTriangles, kPlainNode, geometry), "refers to 'shape', of which there are several"},
       {replaced(kGood, "url=\"#scene\"", "url=\"#other\""), "<instance_visual_scene> refers to '#other'"},
       {replaced(kGood, "<instance_visual_scene url=\"#scene\"/>", ""), "instances no scene"}});
}

TEST(ReadDae, AGeometryWithoutPointsHasNoTriangles) {
  const std::string empty =
      "<geometry id='none'><mesh><source id='no_points'><float_array id='nothing' count='0'/><technique_common>"
      "<accessor source='#nothing' count='0' stride='3'><param name='X' type='float'/><param name='Y' type='float'/>"
      "<param name='Z' type='float'/></accessor></technique_common></source><vertices id='no_vertices'><input "
      "semantic='POSITION' source='#no_points'/></vertices><triangles count='0'><input semantic='VERTEX' "
      "source='#no_vertices' offset='0'/><p/></triangles></mesh></geometry>";
  const std::string text = replaced(replaced(kGood, "</library_geometries>", empty + "</library_geometries>"), "</node>",
                                    "<instance_geometry url='#none'/></node>");
  EXPECT_EQ(read(text).mesh.vertices, read(kGood).mesh.vertices);
}

TEST(ReadDae, RefusesArraysThatAreTooShort) {
  expectRefused("a.dae", {{replaced(kGood, "0 0 3<", "0 0<"), "<float_array> announces 15 values but holds 14"},
                          {replaced(kGood, "0 0 3<", "0 0 3 1<"), "<float_array> announces 15 values but holds 16"},
                          {replaced(kGood, "count=\"5\"", "count=\"6\""), "reads value 18 of the array 'array', which has only 15",
                           ErrorCode::kIndexOutOfRange},
                          {replaced(kGood, "stride=\"3\"", "stride=\"4\""), "reads value 19", ErrorCode::kIndexOutOfRange},
                          {replaced(kGood, "stride=\"3\"", "stride=\"3\" offset=\"1\""), "reads value 16", ErrorCode::kIndexOutOfRange},
                          {replaced(kGood, "count=\"5\"", "count=\"1000\""), "has count = '1000'; expected an integer from 0 to 15"},
                          {replaced(kGood, "count=\"5\"", "count=\"-1\""), "has count = '-1'"},
                          {replaced(kGood, "<param name=\"Z\" type=\"float\"/>", ""), "lacks a <param> named X, Y or Z"},
                          {replaced(kGood, "name=\"Z\"", "name=\"Y\""), "has Y twice"}});
}

TEST(ReadDae, RefusesPrimitivesThatOthersCutOrSkip) {
  const auto one = [](const std::string& kind, const std::string& count, const std::string& rest) {
    return primitives("<" + kind + " count='" + count + "'>" + kVertexInput + rest + "</" + kind + ">");
  };
  expectRefused(
      "a.dae",
      {{one("triangles", "2", "<p>0 1 2</p>"), "<triangles> announces 2 of them but holds 1"},
       {one("triangles", "0", "<p>0 1 2</p>"), "announces 0 of them but holds 1"},
       {one("triangles", "4294967295", "<p>0 1 2</p>"), "announces 4294967295 of them"},
       {one("triangles", "4294967297", "<p>0 1 2</p>"), "has count = '4294967297'"},
       {one("triangles", "1", "<p>0 1</p>"), "has a <p> of 2 corners, which is not a multiple of 3"},
       {one("polygons", "1", "<p>0 1 2</p><p>0 2 3</p>"), "announces 1 of them but holds 2"},
       {one("polygons", "1", "<ph><p>0 1 2 3</p><h>0 1 2</h></ph>"), "<ph> is a polygon with holes"},
       {one("polylist", "1", "<p>0 1 2</p>"), "has no <vcount>"},
       {one("polylist", "2", "<vcount>3</vcount><p>0 1 2</p>"), "announces 2 of them but holds 1"},
       {one("polylist", "1", "<vcount>4</vcount><p>0 1 2</p>"), "counts more than the 3 corners"},
       {one("polylist", "1", "<vcount>3</vcount><p>0 1 2 3</p>"), "counts 3 corners, but there are 4"},
       {one("polylist", "1", "<vcount>-3</vcount><p>0 1 2</p>"), "holds '-3', which is not a number of corners"},
       {one("polylist", "1", "<vcount>3</vcount><p>0 1 2</p><p>0 1 2</p>"), "holds more than one <p>"},
       {one("triangles", "1", "<input semantic='NORMAL' offset='1'/><p>0 1 2</p>"), "holds 3 indices, which is not a multiple of 2"},
       {one("triangles", "1", "<input semantic='NORMAL' offset='4000000000'/><p>0 1 2</p>"), "has offset = '4000000000'"},
       {one("triangles", "1", "<input semantic='POSITION' source='#positions'/><p>0 1 2</p>"), "has POSITION outside <vertices>"},
       {one("triangles", "1", kVertexInput + "<p>0 1 2</p>"), "has two VERTEX inputs"},
       {one("triangles", "1", "<p>0 1 <!-- 2 --> 2</p>"), "<p> holds more than a text"},
       {one("nurbs", "1", "<p>0 1 2</p>"), "<nurbs> is not known in a mesh"},
       {primitives("<triangles count='1'><p>0 1 2</p></triangles>"), "lies without a VERTEX input"},
       {replaced(kGood, "<mesh>", "<convex_mesh/><mesh>"), "<convex_mesh> is not supported"},
       {replaced(kGood, "semantic=\"POSITION\"", "semantic=\"NORMAL\""), "has no POSITION input"}});
}

TEST(ReadDae, RefusesTransformsThatOthersGuess) {
  struct Case {
    std::string transform, part;
  };
  for (const Case& c : {Case{"<translate>1 2</translate>", "holds fewer than 3 numbers"},
                        {"<translate>1 2 3 4</translate>", "holds more than 3 numbers"},
                        {"<translate/>", "holds fewer than 3 numbers"},
                        {"<rotate>0 0 2 90</rotate>", "has an axis of length 2"},
                        {"<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 2</matrix>", "does not end with the row 0 0 0 1"},
                        {"<lookat>1 2 3 4 5 6 7 8 9</lookat>", "<lookat> is not supported here"},
                        {"<skew>45 1 0 0 0 1 0</skew>", "<skew> is not supported here"},
                        {"<instance_rigid_body url='#x'/>", "<instance_rigid_body> is not supported"}})
    expectRefused("a.dae", {{replaced(kGood, "<instance_geometry", c.transform + "<instance_geometry"), c.part}});
  expectRefused("a.dae", {{dae("", kTwoTriangles, "<scale>2 2 2</scale>" + kPlainNode), "<scale> is not supported"}});
  // In single precision, such an angle is anything.
  expectRefused("a.dae",
                {{replaced(kGood, "<instance_geometry", "<rotate>0 0 1 1e9</rotate><instance_geometry"), "Assimp finds other triangles"}});
}

TEST(ReadDae, RefusesWhatReadersOfXmlDifferOn) {
  expectRefused("a.dae", {{replaced(kGood, "<COLLADA", "<!DOCTYPE COLLADA [<!ENTITY b '1'>]><COLLADA"), "line 2: "},
                          {replaced(kGood, "<COLLADA", "<!DOCTYPE COLLADA><COLLADA"), "line 2: a declaration such as DOCTYPE"},
                          {replaced(kGood, "<asset>", "<!ELEMENT a><asset>"), "line 3: a declaration such as DOCTYPE"},
                          {replaced(kGood, "<asset>", "<?x ?><asset>"), "line 3: not well-formed XML"},
                          {replaced(kGood, "</COLLADA>", "</COLLADA><COLLADA/>"), "not a document with <COLLADA> as its only root"},
                          {replaced(kGood, "</mesh>", ""), "not well-formed XML"},
                          {replaced(kGood, "<mesh>", "<mesh>" + std::string(1, '\0')), "zero byte"},
                          {"<x/>", "not a document with <COLLADA> as its only root"}});
}

TEST(ReadDae, RefusesWhatNestsWithoutEnd) {
  const std::string circle = R"(<node id="a"><instance_node url="#&#98;"/></node><node id="b"><instance_node url="#a"/></node>)";
  expectRefused("a.dae", {{dae("", kTwoTriangles, circle), "instances itself in a circle"},
                          {dae("", kTwoTriangles, R"(<node><instance_node url="#scene"/></node>)"), "instances itself in a circle"}});
  std::string deep, doubling = "<node id=\"n0\"><instance_geometry url=\"#shape\"/></node>";
  for (int i = 0; i < 300; ++i) deep += "<node>";
  expectRefused("a.dae", {{dae("", kTwoTriangles, deep), "elements nest too deeply"}});
  for (int i = 1; i < 40; ++i) {
    const std::string inner = "<instance_node url=\"#n" + std::to_string(i - 1) + "\"/>";
    doubling += "<node id=\"n" + std::to_string(i) + "\">" + inner + inner + "</node>";
  }
  expectRefused("a.dae", {{dae("", kTwoTriangles, doubling), "more than 200000 nodes and instances", ErrorCode::kTooLarge},
                          {dae("", "", doubling), "more than 200000 nodes and instances", ErrorCode::kTooLarge}});
}

TEST(ReadDae, RefusesMoreThanTheParserCanTake) {
  std::string attributes, elements;
  for (int i = 0; i < 201; ++i) attributes += " a" + std::to_string(i) + (i % 2 == 0 ? "='1'" : " = \"1\"");
  expectRefused(
      "a.dae", {{replaced(kGood, "<mesh>", "<mesh" + attributes + ">"), "an element with more than 200 attributes", ErrorCode::kTooLarge}});
  EXPECT_NO_THROW(read(replaced(kGood, "<mesh>", "<!-- " + std::string(1000, '=') + " --><mesh>")));
  for (int i = 0; i < 5'000'000; ++i) elements += "<a/>";
  expectRefused("a.dae", {{"<COLLADA>" + elements + "</COLLADA>", "more than 5000000 elements", ErrorCode::kTooLarge}});
}

TEST(ReadDae, CountsTrianglesBeforeAssimpMakesThem) {
  std::string instances;
  for (int i = 0; i < 60; ++i) instances += R"(<instance_geometry url="#shape"/>)";
  MeshLimits limits;
  limits.max_triangles = 100;
  const std::string text = dae("", kTwoTriangles, "<node>" + instances + "</node>");
  EXPECT_THROW(readHere(text, "a.dae", limits), Error);
  EXPECT_EQ(read(text).mesh.triangles.size(), 120u);
}

}  // namespace
}  // namespace collision_hulls
