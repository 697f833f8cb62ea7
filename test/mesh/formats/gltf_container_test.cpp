#include "mesh/formats/gltf_container.h"

#include "../reading.h"

namespace collision_hulls {
namespace {

using namespace test_files;

std::string refusal(const std::string& bytes, const std::string& path = "a.gltf") {
  try {
    gltfParts(bytes, path);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNotAMesh) << error.what();
    return error.what();
  }
  return "";
}

TEST(GltfContainer, PacksAnyLengths) {
  const std::string bytes = packedGltf("{} ", {"", "five!", std::string(3, '\0')});
  EXPECT_TRUE(isPackedGltf(bytes));
  EXPECT_TRUE(isGltfContainer(bytes));
  const GltfParts parts = gltfParts(bytes, "a.gltf");
  EXPECT_TRUE(parts.packed);
  EXPECT_EQ(parts.json, "{} ");
  EXPECT_EQ(parts.binaries, (std::vector<std::string_view>{"", "five!", std::string_view("\0\0\0", 3)}));
}

TEST(GltfContainer, WhereAFileEndsMatters) {
  EXPECT_NE(packedGltf("{}", {"ab", "c"}), packedGltf("{}", {"a", "bc"}));
  EXPECT_NE(packedGltf("{}", {"ab"}), packedGltf("{}a", {"b"}));
}

TEST(GltfContainer, AGlbFileHasOneBuffer) {
  const std::string bytes = glb("{}  ", "1234");
  EXPECT_FALSE(isPackedGltf(bytes));
  const GltfParts parts = gltfParts(bytes, "a.glb");
  EXPECT_FALSE(parts.packed);
  EXPECT_EQ(parts.json, "{}  ");
  EXPECT_EQ(parts.binaries, std::vector<std::string_view>{"1234"});
}

TEST(GltfContainer, TextIsJson) {
  EXPECT_FALSE(isGltfContainer("{}"));
  EXPECT_EQ(gltfParts("\xEF\xBB\xBF{}", "a.gltf").json, "{}");
  EXPECT_EQ(gltfParts(packedGltf("\xEF\xBB\xBF{}", {}), "a.gltf").json, "{}");
  for (const std::string& bytes : {std::string("{\0}", 3), packedGltf(std::string("{\0}", 3), {})})
    EXPECT_NE(refusal(bytes).find("holds a zero byte"), std::string::npos);
}

TEST(GltfContainer, ABinaryFileThatBeginsOtherwiseIsNone) {
  for (const std::string bytes : {"", "glTF", "solid cube of a length", "\x7F\x45\x4C\x46 and more bytes"})
    EXPECT_NE(refusal(bytes, "a.GLB").find("does not begin with 'glTF' and a version"), std::string::npos) << bytes;
  EXPECT_EQ(refusal(" \n{\"asset\": {}}", "a.glb"), "") << "the text alone";
}

TEST(GltfContainer, DamagedOnes) {
  const std::string bytes = packedGltf("{}", {"1234"});
  EXPECT_NE(refusal(bytes.substr(0, bytes.size() - 1)).find("announces 34 bytes, but has 33"), std::string::npos);
  for (std::size_t i = 4; i < 26; ++i) {  // version, length, and the header of the first chunk, which says where the second begins
    if (i >= 20 && i < 22) continue;      // the JSON itself
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    EXPECT_NE(refusal(damaged), "") << i;
  }
  EXPECT_NE(refusal(bytes.substr(0, 12)), "");
}

}  // namespace
}  // namespace collision_hulls
