// What a fuzz target is: a function that takes any bytes. It may throw an Error, which is how a reader refuses; whatever else it throws, a
// crash, an error that a sanitizer sees, and a broken expectation are finds.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace collision_hulls::fuzz {

struct Target {
  std::string name;
  void (*take)(const std::string& bytes);
};

/// Of this program: one under libFuzzer, all in the regression test.
inline std::vector<Target>& targets() {
  static std::vector<Target> all;
  return all;
}

/// `const Registered kOff("off", takeOff);` adds a target.
struct Registered {
  Registered(const char* name, void (*take)(const std::string&)) { targets().push_back({name, take}); }
};

inline void expect(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "expected: %s\n", what);
  std::abort();
}

/// Feeds bytes to a target, and lets it refuse them.
void feed(const Target& target, const std::string& bytes);

/// The path of a file of these bytes, which the next call replaces: for readers that take files.
std::string fileOf(const std::string& bytes, const std::string& extension);

/// Takes the first byte off and returns it; 0 where there is none. For targets that read several formats.
unsigned char firstOf(std::string& bytes);

}  // namespace collision_hulls::fuzz
