// Lengths as text, the options' ranges, and the consumers' profiles.
//
// Values that are out of range, or are plainly a mistake in the unit, are refused here, before any work: command line, services and
// parameters all give the same message.
#include "collision_hulls/report/options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <locale>
#include <set>
#include <sstream>

#include "base/decimal.h"
#include "collision_hulls/decompose/reduce_vertices.h"
#include "collision_hulls/error.h"
#include "report/largest_tolerance.h"
#include "report/link_pattern.h"
#include "storage/names.h"

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
constexpr std::size_t kLongestModelName = 64, kMostModels = 20;
constexpr int kMostReading = 1'000'000;  // [MiB] or [s]

[[noreturn]] void badOption(const std::string& option, const std::string& value, const std::string& allowed) {
  throw Error(ErrorCode::kBadOption, option + " '" + value + "' is invalid: use " + allowed);
}

void checkRange(const std::string& option, int value, int low, int high, const std::string& meaning) {
  if (value == 0 || (value >= low && value <= high)) return;
  badOption(option, std::to_string(value),
            "a number from " + std::to_string(low) + " to " + std::to_string(high) + ", or 0 for " + meaning);
}

void checkPositive(const std::string& option, int value) {
  if (value < 1 || value > kMostReading) badOption(option, std::to_string(value), "a number from 1 to " + std::to_string(kMostReading));
}

bool isSet(double part) {
  return part != Length::kUnset;
}

/// A number and its unit.
struct Quantity {
  double value = 0;  // metres, or a fraction
  std::string unit;
  bool isShare() const { return unit == "%"; }
};

/// The value nearest to a hundredth of what a text says: to divide what was rounded would round twice.
double hundredthOf(const std::string& text) {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  int exponent = 0;
  if (e < text.size()) std::istringstream(text.substr(e + 1)) >> exponent;
  std::istringstream in(text.substr(0, e) + "e" + std::to_string(std::int64_t{exponent} - 2));
  in.imbue(std::locale::classic());
  double value = 0;
  in >> value;
  return value;
}

std::optional<Quantity> parseQuantity(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double number = 0;
  std::string unit, rest;
  if (!(in >> number) || !std::isfinite(number)) return std::nullopt;
  const auto end = static_cast<std::size_t>(std::max<std::streamoff>(in.tellg(), 0));  // 0: nothing follows the number
  in >> unit >> rest;
  const auto found = std::find_if(kLengthUnits.begin(), kLengthUnits.end(), [&](const Unit& u) { return unit == u.name; });
  if (found == kLengthUnits.end() || !rest.empty()) return std::nullopt;
  Quantity quantity{number * found->numerator / found->denominator, unit};
  if (quantity.isShare()) quantity.value = hundredthOf(text.substr(0, end));
  const bool in_range = quantity.value > 0 && !(quantity.isShare() && quantity.value > 1);
  return in_range ? std::optional(quantity) : std::nullopt;
}

Length toLength(const Quantity& quantity) {
  return quantity.isShare() ? shareOf(quantity.value) : lengthOf(quantity.value);
}

/// One length and one share, each with its unit.
std::optional<Length> pairOf(const std::optional<Quantity>& first, const std::optional<Quantity>& second) {
  if (!first || !second || first->unit.empty() || second->unit.empty() || first->isShare() == second->isShare()) return std::nullopt;
  return first->isShare() ? Length{second->value, first->value} : Length{first->value, second->value};
}

/// The fewest digits that are read back as the same value; nothing where 17 do not suffice in this unit.
std::optional<std::string> shortest(double value, const char* unit) {
  const auto known = std::find_if(kLengthUnits.begin(), kLengthUnits.end(), [&](const Unit& u) { return std::string(unit) == u.name; });
  for (int digits = 3; digits <= 17; ++digits) {
    std::ostringstream text = decimalStream(digits);
    text << static_cast<long double>(value) * known->denominator / known->numerator << unit;  // rounds once, when it is written
    const std::optional<Quantity> back = parseQuantity(text.str());
    if (back && back->value == value) return text.str();
  }
  return std::nullopt;
}

/// In the unit that makes the shortest text; metres, which every value can be written in, if there is none.
std::string shortestLength(double metres) {
  std::string best;
  for (const char* const unit : {"m", "cm", "mm"}) {
    const std::optional<std::string> text = shortest(metres, unit);
    if (text && (best.empty() || text->size() < best.size())) best = *text;
  }
  return best;
}

/// Throws for a length in metres above the largest: 5 for 5 mm is the usual mistake. `text`: as it was given, with or without a unit, or in
/// metres, if that is no longer known; `otherwise`: a sentence on what else helps.
void expectUnit(const std::string& option, const std::string& text, double metres, bool has_unit, const std::string& otherwise = "") {
  if (!isSet(metres) || metres <= kLargestTolerance) return;
  const bool is_metres = text.find_first_of("ciu") == std::string::npos && text.find("mm") == std::string::npos;
  const double thousandth = metres / 1000;
  throw Error(ErrorCode::kBadOption,
              option + " '" + text + "' is more than " + decimal(kLargestTolerance) + " m, the largest that makes sense for a mesh" +
                  (has_unit ? "" : ": a number without a unit is in metres") +
                  (is_metres && thousandth <= kLargestTolerance ? "; did you mean " + toString(lengthOf(thousandth)) + "?"
                                                                : "; give a smaller length, as in 5mm.") +
                  otherwise);
}

constexpr const char* kForLarger = " For a larger machine give a percentage, such as 5%";

/// Whether a length was given with a unit.
bool hasUnit(const std::string& text) {
  return text.find_first_of("mi") != std::string::npos;  // of each
}

void checkLength(const std::string& option, const Length& length) {
  const char* const allowed = "a length above 0, a percentage above 0% and up to 100%, or both";
  if (!isSet(length.limit) && !isSet(length.share)) badOption(option, "inf", allowed);
  if (isSet(length.limit) && !(std::isfinite(length.limit) && length.limit > 0)) badOption(option, decimal(length.limit) + "m", allowed);
  if (isSet(length.share) && !(length.share > 0 && length.share <= 1)) badOption(option, decimal(100 * length.share) + "%", allowed);
  expectUnit(option, toString(length), length.limit, false, kForLarger);
}

/// Of a padding or an opening.
void checkPositiveLength(const std::string& option, double metres) {
  if (!(std::isfinite(metres) && metres > 0)) badOption(option, decimal(metres) + "m", "0 or a positive length");
  expectUnit(option, toString(lengthOf(metres)), metres, false);
}

/// Models become files of their own.
void checkModels(const std::vector<ModelOptions>& models) {
  if (models.size() > kMostModels)
    throw Error(ErrorCode::kBadOption, "there are " + std::to_string(models.size()) + " models, beginning with '" + models.front().name +
                                           "'; at most " + std::to_string(kMostModels) +
                                           " are allowed: make the others in a run of their own");
  std::set<std::string> names;
  for (const ModelOptions& model : models) {
    const bool is_name =
        !model.name.empty() && model.name.size() <= kLongestModelName &&
        model.name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") == std::string::npos;
    if (!is_name) badOption("model", model.name, "a name of up to 64 letters, digits, '_' and '-', which becomes part of a file's name");
    if (!names.insert(model.name).second)
      throw Error(ErrorCode::kBadOption, "model '" + model.name + "' is given twice; give each model a name of its own");
    checkTolerance(model.tolerance, "tolerance of model '" + model.name + "'");
  }
}

/// Whether `tree` is the larger length for every mesh, whatever its size. Where only some meshes make it larger, these take the
/// tolerance instead.
bool alwaysLarger(const Length& tree, const Length& tolerance) {
  const auto larger = [](double a, double b) { return a > b || (!isSet(a) && !isSet(b)); };
  return larger(tree.limit, tolerance.limit) && larger(tree.share, tolerance.share);
}

/// What goes with some methods alone.
void checkMethod(const Options& options) {
  if (options.tree) checkLength("tree", *options.tree);
  if (options.fill && options.method != Method::kCertified)
    throw Error(ErrorCode::kBadOption,
                std::string("fill needs method 'certified'; leave it out with method '") + name(options.method) + "'");
  if (options.tree && options.method != Method::kCertified)
    throw Error(ErrorCode::kBadOption,
                std::string("tree needs method 'certified'; leave it out with method '") + name(options.method) + "'");
  if (options.segments && options.method != Method::kHacd)
    throw Error(ErrorCode::kBadOption, std::string("segments needs method 'hacd', whose clusters it shows; leave it out with method '") +
                                           name(options.method) + "', or choose --method hacd");
  if (options.tree && alwaysLarger(*options.tree, options.tolerance))
    badOption("tree", toString(*options.tree), "a length up to the tolerance, which is " + toString(options.tolerance));
}

/// Where the limit would be ignored.
void checkTimeLimit(const Options& options) {
  if (options.time_limit == 0) return;
  const std::string limit = decimal(options.time_limit) + " s";
  if (!(std::isfinite(options.time_limit) && options.time_limit > 0)) badOption("time-limit", limit, "0 (no limit) or a time above it");
  const auto refuse = [&](const std::string& setting, const std::string& why) {
    throw Error(ErrorCode::kBadOption, "time-limit '" + limit + "' contradicts " + setting + ", which " + why + "; leave one of them out");
  };
  if (options.method != Method::kCertified) refuse(std::string("method '") + name(options.method) + "'", "cannot be cut short");
  if (options.tree) refuse("tree '" + toString(*options.tree) + "'", "is cached whole");
  if (options.shapes != Shapes::kHulls && options.shapes != Shapes::kMixed)
    refuse(std::string("shapes '") + name(options.shapes) + "'", "cannot be cut short");
}

template <typename T>
std::string choicesOf(const std::vector<T>& all) {
  std::string choices;
  for (const T& one : all) choices += (choices.empty() ? "" : ", ") + std::string(name(one));
  return choices;
}

}  // namespace

Length parseLength(const std::string& text, const std::string& option) {
  const std::size_t comma = text.find(',');
  std::optional<Length> length;
  if (comma != std::string::npos) {
    length = pairOf(parseQuantity(text.substr(0, comma)), parseQuantity(text.substr(comma + 1)));
  } else if (const std::optional<Quantity> quantity = parseQuantity(text)) {
    length = toLength(*quantity);
  }
  if (length) return *length;
  badOption(
      option, text,
      "a positive length, as in 5mm, 0.5cm, 0.005 or 0.005m (metres), 200um, 0.2in; a percentage of each mesh's bounding-box diagonal "
      "above 0% and up to 100%, as in 1%; or the smaller of both, each with its unit, as in 1cm,5%");
}

Length parseTolerance(const std::string& text, const std::string& option) {
  const Length length = parseLength(text, option);
  expectUnit(option, text, length.limit, hasUnit(text), kForLarger);
  return length;
}

double parseMetres(const std::string& text, const std::string& option) {
  const std::optional<Quantity> quantity = parseQuantity(text);
  if (quantity && !quantity->isShare()) return quantity->value;
  badOption(option, text, "a positive length, as in 2cm, 20mm or 0.02 (metres)");
}

double parseMetresOrZero(const std::string& text, const std::string& option) {
  const bool is_zero = text.find_first_not_of("0.") == std::string::npos && text.find('0') != std::string::npos;
  if (is_zero) return 0;
  const std::optional<Quantity> quantity = parseQuantity(text);
  if (quantity && !quantity->isShare()) return quantity->value;
  badOption(option, text, "0 or a positive length, as in 2cm, 20mm or 0.02 (metres)");
}

double parseSeconds(const std::string& text, const std::string& option) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double number = 0;
  std::string unit, rest;
  in >> number;
  const bool is_number = !in.fail() && std::isfinite(number) && number >= 0;
  in >> unit >> rest;
  for (const auto& [name, seconds] : {std::pair<const char*, double>{"", 1}, {"s", 1}, {"ms", 0.001}, {"min", 60}, {"h", 3600}})
    if (is_number && rest.empty() && unit == name) return number * seconds;
  badOption(option, text, "0 or a positive time, as in 5s, 500ms, 2min or 5 (seconds)");
}

double parsePadding(const std::string& text, const std::string& option) {
  const double metres = parseMetresOrZero(text, option);
  expectUnit(option, text, metres, hasUnit(text));
  return metres;
}

std::string toString(const Length& length) {
  const std::string limit = isSet(length.limit) ? shortestLength(length.limit) : "";
  const std::string share = isSet(length.share) ? shortest(length.share, "%").value_or(decimal(100 * length.share, 17) + "%") : "";
  return limit + (limit.empty() || share.empty() ? "" : ",") + share;
}

const char* name(Action action) {
  switch (action) {
    case Action::kDecompose: return "decompose";
    case Action::kKeep: return "keep";
    case Action::kRemove: return "remove";
  }
  return "unknown";
}

std::optional<Action> actionNamed(const std::string& name) {
  for (const Action action : {Action::kDecompose, Action::kKeep, Action::kRemove})
    if (name == collision_hulls::name(action)) return action;
  return std::nullopt;
}

const char* name(Shapes shapes) {
  switch (shapes) {
    case Shapes::kHulls: return "hulls";
    case Shapes::kMixed: return "mixed";
    case Shapes::kPrimitives: return "primitives";
    case Shapes::kSpheres: return "spheres";
    case Shapes::kSphere: return "sphere";
    case Shapes::kBox: return "box";
    case Shapes::kCylinder: return "cylinder";
    case Shapes::kCapsule: return "capsule";
  }
  return "unknown";
}

const std::vector<Shapes>& allShapes() {
  static const std::vector<Shapes> all{Shapes::kHulls,  Shapes::kMixed, Shapes::kPrimitives, Shapes::kSpheres,
                                       Shapes::kSphere, Shapes::kBox,   Shapes::kCylinder,   Shapes::kCapsule};
  return all;
}

std::optional<Shapes> shapesNamed(const std::string& name) {
  for (const Shapes shapes : allShapes())
    if (name == collision_hulls::name(shapes)) return shapes;
  return std::nullopt;
}

bool isSingle(Shapes shapes) {
  return shapes >= Shapes::kSphere;
}

const char* name(Source source) {
  switch (source) {
    case Source::kAuto: return "auto";
    case Source::kVisual: return "visual";
    case Source::kCollision: return "collision";
  }
  return "unknown";
}

const char* name(UriStyle style) {
  switch (style) {
    case UriStyle::kPackage: return "package";
    case UriStyle::kFile: return "file";
    case UriStyle::kRelative: return "relative";
  }
  return "unknown";
}

std::optional<UriStyle> uriStyleNamed(const std::string& name) {
  if (name == "package") return UriStyle::kPackage;
  if (name == "file") return UriStyle::kFile;
  if (name == "relative") return UriStyle::kRelative;
  return std::nullopt;
}

std::string methodChoices() {
  return choicesOf(allMethods());
}

std::string effortChoices() {
  return choicesOf(allEfforts());
}

std::string shapesChoices() {
  return choicesOf(allShapes());
}

void checkTolerance(const Length& tolerance, const std::string& option) {
  checkLength(option, tolerance);
}

void checkLimits(const LinkOptions& options) {
  checkRange("max-hulls", options.max_hulls, 1, kMostHulls, "no limit");
  checkRange("max-vertices", options.max_vertices, kLeastVertices, kMostVertices, "no limit");
}

void checkShapes(const LinkOptions& options) {
  if (options.shapes == Shapes::kHulls) return;
  const auto refuse = [&](const std::string& setting, const std::string& why) {
    throw Error(ErrorCode::kBadOption,
                std::string("shapes '") + name(options.shapes) + "' contradicts " + setting + ", which " + why + "; leave one of them out");
  };
  if (options.method != Method::kCertified) refuse(std::string("method '") + name(options.method) + "'", "gives hulls alone");
  if (options.padding > 0) refuse("padding '" + toString(lengthOf(options.padding)) + "'", "hulls alone have");
  if (options.fill) refuse("fill", "hulls alone keep");
  if (!options.regions.empty()) refuse("region '" + options.regions.front().name + "'", "hulls alone keep");
}

void check(const Options& options) {
  checkTolerance(options.tolerance);
  checkShapes(options);
  if (options.padding != 0) checkPositiveLength("padding", options.padding);
  if (options.close_openings != 0) checkPositiveLength("close-openings", options.close_openings);
  checkMethod(options);
  checkLimits(options);
  checkModels(options.models);
  checkPositive("reader-memory", options.reader_memory);
  checkPositive("reader-time", options.reader_time);
  checkTimeLimit(options);
  checkRange("jobs", options.jobs, 1, kMostJobs, "as many threads as cores");
  if (!(std::isfinite(options.scale) && options.scale > 0))
    badOption("scale", decimal(options.scale), "a number above 0, as in 0.001 for a mesh in millimetres");
  if (!options.package_name.empty() && packageName(options.package_name) != options.package_name)
    badOption("package-name", options.package_name,
              "a lower-case letter, then lower-case letters, digits and '_', such as '" + packageName(options.package_name) + "'");
  const LinkPattern links(options.links, "links");
}

// Where the values come from:
//   fcl      32 vertices: up to there fcl::Convex finds a support point by looking at every vertex, beyond it by walking along edges
//            (kMinVertCountForEdgeWalking, pull request 488 of flexible-collision-library/fcl; before 0.6.1 it always looks at all)
//   bullet   42 vertices: btShapeHull, which Bullet offers "to simplify a complex convex object", keeps the support points of 42
//            directions; btConvexHullShape looks at every vertex for each support point
//   moveit   as bullet: its Bullet plugin makes a btConvexHullShape of every mesh (moveit_core, bullet_utils.cpp), its FCL plugin a
//            tree of the mesh's triangles, which a hull of fewer vertices has fewer of
//   physx    32 vertices: on the GPU it collides hulls of at most 64 vertices, 64 polygons and 32 faces at a vertex (PxConvexMeshDesc,
//            PhysX 5.5); 32 vertices have at most 2 * 32 - 4 = 60 triangles, and 31 at one vertex
//   gazebo   16 hulls a mesh: what its own convex decomposition makes at most (SDFormat 1.11, <max_convex_hulls>, default 16)
void applyProfile(const std::string& profile, Options& options) {
  struct Caps {
    const char* profile;
    int max_hulls, max_vertices;
  };
  const int kNoCap = 0, kDefault = DecomposeOptions{}.max_vertices;
  const Caps kProfiles[] = {
      {"fcl", kNoCap, 32}, {"moveit", kNoCap, 42}, {"bullet", kNoCap, 42}, {"physx", kNoCap, 32}, {"gazebo", 16, kDefault}};
  const auto* const found =
      std::find_if(std::begin(kProfiles), std::end(kProfiles), [&](const Caps& caps) { return profile == caps.profile; });
  if (found == std::end(kProfiles)) badOption("profile", profile, "fcl, moveit, bullet, physx or gazebo");
  options.max_hulls = found->max_hulls;
  options.max_vertices = found->max_vertices;
}

}  // namespace collision_hulls
