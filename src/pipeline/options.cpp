#include "collision_hulls/pipeline/options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <regex>
#include <sstream>

#include "collision_hulls/decompose/reduce_vertices.h"
#include "collision_hulls/error.h"

namespace collision_hulls {
namespace {

struct Unit {
  const char* name;
  double numerator, denominator;  // two numbers, so that 5 mm is the double nearest to 0.005
};
constexpr std::array<Unit, 7> kLengthUnits = {
    {{"", 1, 1}, {"m", 1, 1}, {"cm", 1, 100}, {"mm", 1, 1000}, {"um", 1, 1'000'000}, {"in", 254, 10'000}, {"%", 1, 100}}};

constexpr int kMostHulls = 1'000'000;     // of a mesh
constexpr int kMostVertices = 1'000'000;  // of a hull
constexpr int kMostJobs = 1024;

[[noreturn]] void badOption(const std::string& option, const std::string& value, const std::string& allowed) {
  throw Error(ErrorCode::kBadOption, option + " '" + value + "' is not understood: it takes " + allowed);
}

void checkRange(const std::string& option, int value, int low, int high, const std::string& meaning) {
  if (value == 0 || (value >= low && value <= high)) return;
  badOption(option, std::to_string(value),
            "a number from " + std::to_string(low) + " to " + std::to_string(high) + ", or 0 for " + meaning);
}

void checkLength(const std::string& option, const Length& length) {
  if (std::isfinite(length.value) && length.value > 0 && !(length.relative && length.value > 1)) return;
  const double shown = length.relative ? length.value * 100 : length.value;
  badOption(option, std::to_string(shown) + (length.relative ? "%" : "m"), "a length above 0, or a share above 0% and up to 100%");
}

std::string shortest(double value, const Length& wanted, const char* unit) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  for (int digits = 3; digits <= 17; ++digits) {
    out.str("");
    out.precision(digits);
    out << value << unit;
    if (parseLength(out.str()).value == wanted.value) break;
  }
  return out.str();
}

}  // namespace

Length parseLength(const std::string& text, const std::string& option) {
  const char* const understood =
      "a positive length with its unit, as in 5mm, 0.5cm, 0.005 or 0.005m (metres), 200um, 0.2in, or a share of the mesh's bounding-box "
      "diagonal above 0% and up to 100%, as in 1%";
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double number = 0;
  std::string unit, rest;
  if (!(in >> number) || !std::isfinite(number) || number <= 0) badOption(option, text, understood);
  in >> unit >> rest;
  const auto found = std::find_if(kLengthUnits.begin(), kLengthUnits.end(), [&](const Unit& u) { return unit == u.name; });
  if (found == kLengthUnits.end() || !rest.empty()) badOption(option, text, understood);
  const Length length{number * found->numerator / found->denominator, unit == "%"};
  if (length.value <= 0 || (length.relative && length.value > 1)) badOption(option, text, understood);
  return length;
}

std::string toString(const Length& length) {
  return length.relative ? shortest(length.value * 100, length, "%") : shortest(length.value, length, "m");
}

std::optional<UriStyle> uriStyleNamed(const std::string& name) {
  if (name == "package") return UriStyle::kPackage;
  if (name == "file") return UriStyle::kFile;
  if (name == "relative") return UriStyle::kRelative;
  return std::nullopt;
}

std::string methodChoices() {
  std::string choices;
  for (const Method method : allMethods()) choices += (choices.empty() ? "" : ", ") + std::string(name(method));
  return choices;
}

void check(const Options& options) {
  const Length& tolerance = options.tolerance;
  checkLength("tolerance", tolerance);
  if (options.tree) checkLength("tree", *options.tree);
  if (options.fill && options.method != Method::kCertified)
    throw Error(ErrorCode::kBadOption,
                std::string("fill is not for method '") + name(options.method) + "': only certified fills; leave one of the two out");
  if (options.tree && options.method != Method::kCertified)
    throw Error(ErrorCode::kBadOption,
                std::string("tree is not for method '") + name(options.method) + "': only certified has one; leave one of the two out");
  if (options.tree && options.tree->relative == tolerance.relative && options.tree->value > tolerance.value)
    badOption("tree", toString(*options.tree), "a length up to the tolerance, which is " + toString(tolerance));
  checkRange("max-hulls", options.max_hulls, 1, kMostHulls, "no cap");
  checkRange("max-vertices", options.max_vertices, kLeastVertices, kMostVertices, "no cap");
  checkRange("jobs", options.jobs, 1, kMostJobs, "as many threads as cores");
  try {
    const std::regex compiled(options.links);
  } catch (const std::regex_error& e) {
    badOption("links", options.links, std::string("a regular expression (ECMAScript): ") + e.what());
  }
}

void applyProfile(const std::string& profile, Options& options) {
  // FCL and MoveIt name no limit: 64 vertices keep FCL's support search on its short path. Bullet walks every vertex for every
  // support point. PhysX takes at most 255 polygons a hull (2 * 64 - 4 triangles stay below) and collides on the GPU only hulls
  // of at most 64 vertices, and tools around it 64 hulls a shape. Gazebo's engines are the same ones.
  const bool hull_cap = profile == "physx" || profile == "gazebo";
  if (!hull_cap && profile != "fcl" && profile != "moveit" && profile != "bullet") {
    badOption("profile", profile, "fcl, moveit, bullet, physx or gazebo");
  }
  options.max_vertices = 64;
  options.max_hulls = hull_cap ? 64 : 0;
}

}  // namespace collision_hulls
