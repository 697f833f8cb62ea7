// The entry of libFuzzer, which has main(): feeds the program's only target.
#include <cstddef>
#include <cstdint>

#include "fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace collision_hulls::fuzz;
  feed(targets().front(), std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
