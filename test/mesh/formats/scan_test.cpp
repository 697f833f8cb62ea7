#include "mesh/formats/scan.h"

#include <gtest/gtest.h>

#include <vector>

namespace collision_hulls {
namespace {

TEST(LineScanner, NumbersLinesWhateverEndsThem) {
  LineScanner lines("one\r\ntwo\rthree\n\n  \nsix", 1);
  std::string_view line;
  std::vector<std::string> found;
  std::vector<std::size_t> numbers;
  while (lines.next(&line)) {
    found.emplace_back(line);
    numbers.push_back(lines.number());
  }
  EXPECT_EQ(found, (std::vector<std::string>{"one", "two", "three", "six"}));
  EXPECT_EQ(numbers, (std::vector<std::size_t>{1, 2, 3, 6}));
  EXPECT_TRUE(lines.passedBlanks() || !lines.next(&line));
}

TEST(LineScanner, TellsBlankLinesFromEmptyOnes) {
  std::string_view line;
  LineScanner empty("a\n\nb"), blank("a\n \nb");
  for (LineScanner* lines : {&empty, &blank}) ASSERT_TRUE(lines->next(&line) && lines->next(&line));
  EXPECT_FALSE(empty.passedBlanks());
  EXPECT_TRUE(blank.passedBlanks());
}

TEST(NextWord, TakesWordsOffTheFront) {
  std::string_view rest = "  f 1/2\t3 ";
  EXPECT_EQ(nextWord(&rest), "f");
  EXPECT_EQ(nextWord(&rest), "1/2");
  EXPECT_EQ(nextWord(&rest), "3");
  EXPECT_EQ(nextWord(&rest), "");
}

TEST(ParseInteger, RefusesWhatOthersGuess) {
  std::int64_t value = 0;
  EXPECT_TRUE(parseInteger("-42", &value));
  EXPECT_EQ(value, -42);
  for (const char* word : {"", "+1", "01", "1.0", "1e3", "0x1", "99999999999999999999"}) EXPECT_FALSE(parseInteger(word, &value)) << word;
}

TEST(Checks, SayWhatIsWrong) {
  EXPECT_NO_THROW(checkIsText("solid x", "a.stl"));
  EXPECT_THROW(checkIsText(std::string_view("a\0b", 3), "a.obj"), Error);
  EXPECT_NO_THROW(checkTriangleCount("a.ply", 5, 5));
  EXPECT_THROW(checkTriangleCount("a.ply", 6, 5), Error);
}

}  // namespace
}  // namespace collision_hulls
