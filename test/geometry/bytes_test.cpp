#include "geometry/bytes.h"

#include <gtest/gtest.h>

#include <limits>

namespace collision_hulls {
namespace {

constexpr FileKind kKind{{'T', 'E', 'S', 'T', 'F', 'I', 'L', 'E'}, 7};

std::string faultOf(const FileKind& kind, const std::string& bytes) {
  try {
    opened(kind, bytes);
    return "";
  } catch (const ByteFault& fault) {
    return fault.what();
  }
}

TEST(Bytes, EmptyPayload) {
  EXPECT_EQ(toBytes(), "");
  EXPECT_NO_THROW(fromBytes(""));
  char value = 0;
  EXPECT_THROW(fromBytes("", value), ByteFault);
  EXPECT_EQ(opened(kKind, sealed(kKind, "")), "");
}

TEST(Bytes, AreLittleEndian) {
  EXPECT_EQ(toBytes(std::uint32_t{0x01020304}), "\x04\x03\x02\x01");
  EXPECT_EQ(toBytes(1.0), std::string("\0\0\0\0\0\0\xf0\x3f", 8));
  EXPECT_EQ(toBytes(std::string("ab")), std::string("\2\0\0\0\0\0\0\0ab", 10));
}

TEST(Bytes, ValuesAreReadBackUnchanged) {
  const std::vector<std::string> texts = {"", std::string("a\0b", 3)};
  const Eigen::Vector3d point(-0.0, std::numeric_limits<double>::denorm_min(), 1.0 / 3);
  const std::string bytes = toBytes(true, -5, texts, point);
  bool flag = false;
  int number = 0;
  std::vector<std::string> texts_back = {"was here before"};
  Eigen::Vector3d point_back;
  fromBytes(bytes, flag, number, texts_back, point_back);
  EXPECT_TRUE(flag);
  EXPECT_EQ(number, -5);
  EXPECT_EQ(texts_back, texts);
  EXPECT_EQ(toBytes(point_back), toBytes(point)) << "to the last bit, including the sign of a zero";
}

TEST(Bytes, TooFewOrTooManyBytesAreFaults) {
  const std::string bytes = toBytes(std::vector<double>{1, 2, 3});
  std::vector<double> values;
  EXPECT_THROW(fromBytes(bytes.substr(0, bytes.size() - 1), values), ByteFault);
  EXPECT_THROW(fromBytes(bytes + "x", values), ByteFault);
  EXPECT_NO_THROW(fromBytes(bytes, values));
  EXPECT_EQ(values, (std::vector<double>{1, 2, 3}));
  EXPECT_THROW(fromBytes(toBytes(std::numeric_limits<std::uint64_t>::max()), values), ByteFault) << "a count larger than any memory";
}

TEST(SealedBytes, EveryFlippedBitIsDetected) {
  const std::string whole = sealed(kKind, "the payload");
  EXPECT_EQ(opened(kKind, whole), "the payload");
  for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_NE(faultOf(kKind, whole.substr(0, size)), "") << size;
  EXPECT_NE(faultOf(kKind, whole + '\0'), "");
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string flipped = whole;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    EXPECT_NE(faultOf(kKind, flipped), "") << "bit " << bit;
  }
}

TEST(SealedBytes, FaultsAreNamed) {
  const std::string whole = sealed(kKind, "the payload");
  EXPECT_NE(faultOf({kKind.magic, 8}, whole).find("version 7"), std::string::npos);
  EXPECT_NE(faultOf({{'O', 'T', 'H', 'E', 'R', '.', '.', '.'}, 7}, whole).find("first bytes"), std::string::npos);
  EXPECT_NE(faultOf(kKind, whole.substr(0, 30)).find("30 bytes"), std::string::npos);
  EXPECT_NE(faultOf(kKind, whole.substr(0, 30) + "X" + whole.substr(31)).find("checksum"), std::string::npos);
}

}  // namespace
}  // namespace collision_hulls
