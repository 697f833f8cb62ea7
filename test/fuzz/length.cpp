// Lengths as options take them: "1cm,5%".
#include "collision_hulls/report/options.h"
#include "fuzz/target.h"

namespace collision_hulls::fuzz {
namespace {

void takeLength(const std::string& bytes) {
  const Length length = parseLength(bytes);
  expect(length.metres(1) > 0, "a length is positive");
  const std::string text = toString(length);
  expect(toString(parseLength(text)) == text, "what is written is read back");
}

const Registered kLength("length", takeLength);

}  // namespace
}  // namespace collision_hulls::fuzz
