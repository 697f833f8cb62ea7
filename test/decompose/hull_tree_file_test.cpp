#include "collision_hulls/decompose/hull_tree_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <thread>

#include "collision_hulls/error.h"
#include "geometry/bytes.h"

namespace collision_hulls {
namespace {

namespace fs = std::filesystem;

class HullTreeFile : public ::testing::Test {
 protected:
  HullTreeFile() {
    std::string pattern = (fs::temp_directory_path() / "collision_hulls_test-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~HullTreeFile() override { fs::remove_all(folder_); }

  std::string write(const std::string& bytes) {
    std::ofstream(file(), std::ios::binary) << bytes;
    return file();
  }
  std::string read() {
    std::ifstream in(file(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  std::string file() const { return (folder_ / "part.hulltree").string(); }

  /// The message for a file with these bytes.
  std::string refusal(const std::string& bytes) {
    try {
      loadHullTree(write(bytes));
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::kNotAHullTree) << e.what();
      EXPECT_NE(std::string(e.what()).find(file()), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find("create it again"), std::string::npos) << e.what();
      return e.what();
    }
    return "";
  }

  fs::path folder_;
};

ConvexHull randomHull(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 20; ++i) points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  return convexHull(points);
}

/// Leaves first, then merges of two roots chosen at random.
HullTree randomTree(std::size_t leaves, unsigned seed) {
  std::mt19937 random(seed);
  HullTree tree;
  tree.tolerance = 0.1;
  std::vector<int> roots;
  const auto add = [&](const HullNode& node) {
    roots.push_back(static_cast<int>(tree.nodes.size()));
    tree.nodes.push_back(node);
  };
  const auto taken = [&] {
    std::swap(roots[random() % roots.size()], roots.back());
    const int root = roots.back();
    roots.pop_back();
    tree.nodes[static_cast<std::size_t>(root)].parent = static_cast<int>(tree.nodes.size());
    return root;
  };
  for (std::size_t i = 0; i < leaves; ++i) add({randomHull(random), 1e-3 / (1 + static_cast<double>(i)), -1, -1, -1});
  while (roots.size() > 1) {
    const double protrusion = 0.01 * static_cast<double>(tree.nodes.size());
    const int left = taken(), right = taken();
    add({randomHull(random), protrusion, -1, left, right});
  }
  return tree;
}

void expectEqual(const HullTree& a, const HullTree& b) {
  EXPECT_EQ(a.tolerance, b.tolerance);
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    const HullNode &m = a.nodes[i], &n = b.nodes[i];
    EXPECT_EQ(std::vector<int>({m.parent, m.left, m.right}), std::vector<int>({n.parent, n.left, n.right}));
    EXPECT_EQ(m.protrusion, n.protrusion);
    EXPECT_EQ(m.hull.vertices, n.hull.vertices);
    EXPECT_EQ(m.hull.triangles, n.hull.triangles);
    ASSERT_EQ(m.hull.faces.size(), n.hull.faces.size());
    for (std::size_t f = 0; f < m.hull.faces.size(); ++f) {
      EXPECT_EQ(m.hull.faces[f].normal, n.hull.faces[f].normal);
      EXPECT_EQ(m.hull.faces[f].offset, n.hull.faces[f].offset);
    }
    EXPECT_EQ(m.hull.thickness, n.hull.thickness);
    EXPECT_EQ(m.hull.slack, n.hull.slack);
  }
}

/// The bytes of a tree that encodeHullTree would reject: fields in the order of the format, in its frame.
std::string unchecked(const HullTree& tree) {
  ByteWriter out;
  out(tree.tolerance, std::uint64_t{tree.nodes.size()});
  for (const HullNode& node : tree.nodes) out(node.parent, node.left, node.right, node.protrusion, node.hull);
  return sealed({{'C', 'H', 'U', 'L', 'T', 'R', 'E', 'E'}, 1}, out.take());
}

TEST_F(HullTreeFile, EmptyTreeAndSingleNode) {
  saveHullTree(HullTree{}, file());
  EXPECT_TRUE(loadHullTree(file()).nodes.empty());
  const HullTree one = randomTree(1, 1);
  saveHullTree(one, file());
  expectEqual(loadHullTree(file()), one);
}

TEST_F(HullTreeFile, MissingFiles) {
  for (const std::string& file : {(folder_ / "none").string(), folder_.string()}) {
    try {
      loadHullTree(file);
      ADD_FAILURE() << file;
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::kFileNotFound) << e.what();
    }
  }
  EXPECT_NE(refusal(""), "");
  EXPECT_NE(refusal("solid cube"), "");
}

TEST_F(HullTreeFile, UnwritablePath) {
  write("a file");
  try {
    saveHullTree(randomTree(2, 1), file() + "/tree");
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kUnwritableOutput) << e.what();
  }
}

TEST_F(HullTreeFile, ThreadsMaySaveToOneFile) {
  const HullTree tree = randomTree(5, 1);
  const auto save = [&] {
    for (int i = 0; i < 100; ++i) EXPECT_NO_THROW(saveHullTree(tree, file()));
  };
  std::thread other(save);
  save();
  other.join();
  EXPECT_EQ(encodeHullTree(loadHullTree(file())), encodeHullTree(tree));
}

TEST_F(HullTreeFile, IsReadBackToTheLastBit) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const HullTree tree = randomTree(5 * seed, seed);
    saveHullTree(tree, file());
    const HullTree back = loadHullTree(file());
    expectEqual(back, tree);
    EXPECT_EQ(back.cutTo(3), tree.cutTo(3));
    EXPECT_EQ(encodeHullTree(back), read());
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1) << "something else was left behind in the folder";
}

// Files of version 1 must stay readable; this is what they contain.
TEST_F(HullTreeFile, TheFormatAsDocumented) {
  const HullTree tree = randomTree(4, 2);
  EXPECT_EQ(encodeHullTree(tree), unchecked(tree));
  EXPECT_EQ(encodeHullTree(HullTree{}),
            std::string("CHULTREE\1\0\0\0\20\0\0\0\0\0\0\0", 20) + std::string(16, '\0') + encodeHullTree(HullTree{}).substr(36));
}

TEST_F(HullTreeFile, TruncatedAnywhere) {
  const std::string bytes = encodeHullTree(randomTree(2, 3));
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 16) EXPECT_NE(refusal(bytes.substr(0, size)), "") << size;
  EXPECT_NE(refusal(bytes.substr(0, bytes.size() - 1)), "");
  EXPECT_NE(refusal(bytes + "\n"), "");
}

TEST_F(HullTreeFile, AnyBitFlipped) {
  const std::string bytes = encodeHullTree(randomTree(2, 4));
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += 8 * (bit < 400 ? 1 : 7) + 1) {
    std::string flipped = bytes;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    EXPECT_THROW(decodeHullTree(flipped, "flipped"), Error) << "bit " << bit << " of " << 8 * bytes.size();
  }
}

TEST_F(HullTreeFile, AnotherVersionIsNamed) {
  std::string bytes = encodeHullTree(randomTree(2, 5));
  bytes[8] = 2;
  EXPECT_NE(refusal(bytes).find("version 2"), std::string::npos);
}

TEST_F(HullTreeFile, MoreThanTheTree) {
  EXPECT_NE(refusal(sealed({{'C', 'H', 'U', 'L', 'T', 'R', 'E', 'E'}, 1}, toBytes(0.0, std::uint64_t{0}, 1))).find("4 bytes follow"),
            std::string::npos);
}

TEST_F(HullTreeFile, InvalidTrees) {
  const HullTree sound = randomTree(3, 6);  // leaves 0, 1, 2; 3 is an inner node, 4 the root
  ASSERT_EQ(sound.nodes.size(), 5u);
  EXPECT_EQ(refusal(unchecked(sound)), "");
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto leaf_of_root = [](HullTree& tree) -> int& { return tree.nodes[4].left == 3 ? tree.nodes[4].right : tree.nodes[4].left; };
  const std::vector<std::pair<std::string, std::function<void(HullTree&)>>> faults = {
      {"tolerance", [&](HullTree& tree) { tree.tolerance = nan; }},
      {"protrusion", [&](HullTree& tree) { tree.nodes[4].protrusion = infinity; }},
      {"protrusion", [&](HullTree& tree) { tree.nodes[0].protrusion = -1; }},
      {"smaller than that of child", [&](HullTree& tree) { tree.nodes[4].protrusion = tree.nodes[3].protrusion / 2; }},
      {"parent", [&](HullTree& tree) { tree.nodes[4].parent = 5; }},
      {"parent", [&](HullTree& tree) { tree.nodes[3].parent = 3; }},
      {"parent", [&](HullTree& tree) { tree.nodes[3].parent = 2147483647; }},
      {"parent", [&](HullTree& tree) { tree.nodes[0].parent = -1; }},
      {"does not precede it", [&](HullTree& tree) { tree.nodes[4].left = 4; }},
      {"does not precede it", [&](HullTree& tree) { tree.nodes[4].right = -1; }},
      {"does not precede it", [&](HullTree& tree) { tree.nodes[3].left = -7; }},
      {"children are the same node", [&](HullTree& tree) { tree.nodes[4].left = tree.nodes[4].right; }},
      {"another parent", [&](HullTree& tree) { leaf_of_root(tree) = tree.nodes[3].left; }},
      {"not a child of the parent", [&](HullTree& tree) { tree.nodes[3].left = tree.nodes[3].right = -1; }},
      {"vertex is not finite", [&](HullTree& tree) { tree.nodes[1].hull.vertices[2].y() = nan; }},
      {"face is not finite", [&](HullTree& tree) { tree.nodes[1].hull.faces[2].offset = infinity; }},
      {"no vertices", [&](HullTree& tree) { tree.nodes[2].hull = {}; }},
      {"not a length", [&](HullTree& tree) { tree.nodes[2].hull.slack = nan; }},
      {"names vertex -1", [&](HullTree& tree) { tree.nodes[2].hull.triangles[0][1] = -1; }},
      {"names vertex 1000", [&](HullTree& tree) { tree.nodes[2].hull.triangles[0][1] = 1000; }},
  };
  for (const auto& [words, spoil] : faults) {
    HullTree tree = sound;
    spoil(tree);
    EXPECT_NE(refusal(unchecked(tree)).find(words), std::string::npos) << words << ": " << refusal(unchecked(tree));
    EXPECT_THROW(encodeHullTree(tree), Error) << words;
  }
}

}  // namespace
}  // namespace collision_hulls
