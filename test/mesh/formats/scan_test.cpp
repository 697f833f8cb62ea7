#include "mesh/formats/scan.h"

#include <gtest/gtest.h>

#include <vector>

namespace collision_hulls {
namespace {

TEST(LineScanner, NumbersLinesWhateverEndsThem) {
  const RunControl control;
  LineScanner lines("one\r\ntwo\rthree\n\n  \nsix\fseven", control, 10);
  std::string_view line;
  std::vector<std::string> found;
  std::vector<std::size_t> numbers;
  while (lines.next(&line)) {
    found.emplace_back(line);
    numbers.push_back(lines.number());
  }
  EXPECT_EQ(found, (std::vector<std::string>{"one", "two", "three", "six", "seven"}));
  EXPECT_EQ(numbers, (std::vector<std::size_t>{10, 11, 12, 15, 16}));
}

TEST(LineScanner, EmptyLinesCanBeCancelled) {
  RunControl control;
  control.cancel();
  const std::string text(1 << 17, '\n');
  LineScanner lines(text, control);
  std::string_view line;
  EXPECT_THROW(lines.next(&line), Error);
}

TEST(NextWord, TakesWordsOffTheFront) {
  std::string_view rest = "  f 1/2\t3 ";
  EXPECT_EQ(nextWord(&rest), "f");
  EXPECT_EQ(nextWord(&rest), "1/2");
  EXPECT_EQ(nextWord(&rest), "3");
  EXPECT_EQ(nextWord(&rest), "");
}

TEST(Scan, ARemedyIsEnough) {
  const auto said = [](const auto&... words) -> std::string {
    try {
      failNotAMesh("a.obj", words...);
    } catch (const Error& error) {
      return error.what();
    }
  };
  EXPECT_EQ(said("is empty"), "a.obj: is empty; check the file or export it again");
  EXPECT_EQ(said("'4OFF' is not supported", "write it as OFF"), "a.obj: '4OFF' is not supported; write it as OFF");
  EXPECT_EQ(said("'a; b' is no number"), "a.obj: 'a; b' is no number; check the file or export it again");
}

TEST(Scan, SaysWhatIsWrong) {
  EXPECT_EQ(inQuotes("1\t" + std::string(60, 'x')), "'1?" + std::string(38, 'x') + "...'");
  EXPECT_EQ(withoutComment("1 2 # 3"), "1 2 ");
  EXPECT_EQ(withoutComment("# 1"), "");
  EXPECT_EQ(withoutComment("1 1.#QNAN 2 #3"), "1 1.#QNAN 2 ");
  EXPECT_EQ(checkedText("\xEF\xBB\xBFv 1", "a.obj"), "v 1");
  EXPECT_THROW(checkedText(std::string_view("a\0b", 3), "a.obj"), Error);
  for (const std::string_view wide : {std::string_view("\xFF\xFEv\0", 4), std::string_view("\xFE\xFF\0v", 4)}) try {
      checkedText(wide, "a.obj");
      ADD_FAILURE() << "UTF-16 was read";
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find("UTF-16"), std::string::npos) << e.what();
    }
  EXPECT_NO_THROW(checkTriangleCount("a.ply", 5, 5));
  EXPECT_THROW(checkTriangleCount("a.ply", 6, 5), Error);
  EXPECT_EQ(numberIn("2.5", "a.off", 3), 2.5);
  try {
    numberIn("2,5", "a.off", 3);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ("a.off: line 3: '2,5' is not a number; check the file or export it again", error.what());
  }
}

}  // namespace
}  // namespace collision_hulls
