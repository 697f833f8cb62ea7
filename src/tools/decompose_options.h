// The options of a decomposition on a command line, shared by the programs that take them.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/finite_number.h"
#include "collision_hulls/error.h"
#include "collision_hulls/report/options.h"
#include "command_line.h"

namespace collision_hulls {

/// A number without sign or unit, up to `limit`.
inline std::uint64_t wholeNumber(const std::string& option, const std::string& text, std::uint64_t limit) {
  std::istringstream in(text);
  std::uint64_t value = 0;
  const bool digits_only = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  if (digits_only && in >> value && value <= limit) return value;
  throw Error(ErrorCode::kBadOption, option + " '" + text + "' is invalid: use a whole number" +
                                         (digits_only ? " from 0 to " + std::to_string(limit) : ", 0 or more"));
}

/// A positive number without a unit.
inline double positiveNumber(const std::string& option, const std::string& text) {
  double value = 0;
  if (parseFinite(text, value) && value > 0) return value;
  throw Error(ErrorCode::kBadOption, option + " '" + text + "' is invalid: use a number above 0 without a unit, as in 0.001");
}

/// The enumerator that a text names.
template <typename T>
T choice(const std::string& option, const std::string& text, std::optional<T> (*parse)(const std::string&), const std::string& choices) {
  if (const std::optional<T> value = parse(text)) return *value;
  throw Error(ErrorCode::kBadOption, option + " '" + text + "' is unknown: use one of " + choices);
}

/// The options of a decomposition that a command line names. They can be applied to the defaults, or to what a file says.
struct GivenOptions {
  std::set<std::string> names;  ///< without dashes: "tolerance"
  std::vector<std::function<void(Options&)>> settings;

  void apply(Options& options) const {
    for (const auto& set : settings) set(options);
  }
};

/// Adds options that fill `given`, which has to outlive the parsing; this object need not. An invalid value makes parse() throw
/// kBadOption.
class DecomposeOptionAdder {
 public:
  DecomposeOptionAdder(CommandLine& app, GivenOptions& given) : app_(app), given_(given) {}

  void addAll() {
    addAccuracy();
    addLimits();
    addInput();
    addOutput();
    addRun();
  }

 private:
  using Setter = std::function<void(Options& options, const std::string& option, const std::string& text)>;

  /// Sets an option now, for its error, and again wherever `given` is applied.
  static void give(GivenOptions& given, const std::string& option, const std::function<void(Options&)>& set) {
    Options tried;
    set(tried);
    given.names.insert(option.substr(2));
    given.settings.push_back(set);
  }

  CommandLine::Option* add(const std::string& group, const std::string& names, const std::string& type, const std::string& fallback,
                           const std::string& help, const Setter& set) {
    const std::string option = names.substr(names.find("--"));
    const auto take = [&given = given_, option, set](const std::string& text) {
      give(given, option, [=](Options& options) { set(options, option, text); });
    };
    return app_.add_option_function(names, take, help)->type_name(fallback.empty() ? type : type + " [" + fallback + "]")->group(group);
  }

  void addFlag(const std::string& group, const std::string& name, const std::function<void(Options&)>& set, const std::string& help) {
    const auto take = [&given = given_, name, set] { give(given, name, set); };
    app_.add_flag_callback(name, take, help)->group(group);
  }

  template <class Holder>
  void addNumber(const std::string& group, const std::string& names, int Holder::*value, const std::string& help) {
    add(group, names, "N", std::to_string(Options().*value), help,
        [value](Options& options, const std::string& option, const std::string& text) {
          options.*value = static_cast<int>(wholeNumber(option, text, std::numeric_limits<int>::max()));
        });
  }

  template <class Holder, typename T>
  void addChoice(const std::string& group, const std::string& names, T Holder::*value, std::optional<T> (*parse)(const std::string&),
                 const std::string& choices, const std::string& fallback, const std::string& help) {
    add(group, names, "NAME", fallback, help + ": " + choices, [=](Options& options, const std::string& option, const std::string& text) {
      options.*value = choice(option, text, parse, choices);
    });
  }

  void addAccuracy() {
    const Options defaults;
    add("Accuracy", "-t,--tolerance", "LENGTH", toString(defaults.tolerance),
        "How far the hulls may protrude from the solid: 5mm, 0.005 (metres), 1% of each mesh's bounding-box diagonal, or 1cm,5%: the "
        "smaller of both",
        [](Options& options, const std::string& option, const std::string& text) { options.tolerance = parseTolerance(text, option); });
    addChoice("Accuracy", "-m,--method", &Options::method, methodNamed, methodChoices(), name(defaults.method), "How to decompose meshes");
    addChoice("Accuracy", "--effort", &Options::effort, effortNamed, effortChoices(), name(defaults.effort),
              "instant: least time, more hulls; best: fewest hulls, several times the time (method certified)");
    addFlag(
        "Accuracy", "--fill", [](Options& options) { options.fill = true; },
        "Cover the inside of closed meshes as well, not their surface alone (method certified)");
    add("Accuracy", "--padding", "LENGTH", "0",
        "Make the hulls hold everything within this distance of the surface; they may then protrude by the padding and the tolerance",
        [](Options& options, const std::string& option, const std::string& text) { options.padding = parsePadding(text, option); });
    add("Accuracy", "--close-openings", "LENGTH", "0",
        "First close openings of shells up to this width; protrusion is then measured from the closed meshes",
        [](Options& options, const std::string& option, const std::string& text) { options.close_openings = parsePadding(text, option); });
    addChoice("Accuracy", "--shapes", &Options::shapes, shapesNamed, shapesChoices(), name(defaults.shapes),
              "Bodies that the model consists of: a primitive where it does as well as hulls (mixed), primitives or spheres alone, or a "
              "single one (method certified)");
    addFlag(
        "Accuracy", "--spheres", [](Options& options) { options.shapes = Shapes::kSpheres; }, "The same as --shapes spheres");
    add("Accuracy", "--tree", "LENGTH", "",
        "Build and cache hulls at every level of detail (a hull tree), down to this finer tolerance; later runs at coarser tolerances "
        "reuse them (method certified)",
        [](Options& options, const std::string& option, const std::string& text) { options.tree = parseTolerance(text, option); });
  }

  void addLimits() {
    // Before the limits themselves: callbacks run in this order, so that an explicit limit wins.
    add("Limits", "--profile", "NAME", "", "Limits that suit a collision checker or physics engine: fcl, moveit, bullet, physx, gazebo",
        [](Options& options, const std::string&, const std::string& text) { applyProfile(text, options); });
    addNumber("Limits", "--max-hulls", &Options::max_hulls, "Most hulls per mesh; 0: no limit");
    addNumber("Limits", "--max-vertices", &Options::max_vertices, "Most vertices per hull, at least 8; 0: no limit");
  }

  void addInput() {
    add("Input", "--links", "REGEX", "", "Links to decompose: a regular expression that matches the whole name; default: all",
        [](Options& options, const std::string&, const std::string& text) {
          options.links = text;
          options.links_place.clear();
        });
    addChoice("Input", "--source", &Options::source, sourceNamed, "auto, visual, collision", "auto",
              "Meshes to use (auto: a link's collision elements if it has any, else its visual ones)");
    add("Input", "--scale", "S", "1", "Scale a single mesh, such as 0.001 for millimetres; a URDF sets its own scale",
        [](Options& options, const std::string& option, const std::string& text) { options.scale = positiveNumber(option, text); });
  }

  void addOutput() {
    addChoice("Output", "--format", &Options::format, meshFormatNamed, "stl, obj, dae", "stl", "Mesh files of the hulls");
    addChoice("Output", "--uri", &Options::uri, uriStyleNamed, "package, file, relative", "package",
              "How the new description refers to the hulls");
    addFlag(
        "Output", "--rebase", [](Options& options) { options.rebase = true; },
        "Let relative file names of the elements that stay, such as <visual>, lead to the same files from the new description");
    add("Output", "--package-name", "NAME", "", "Name of the output package; default: the name of its folder",
        [](Options& options, const std::string&, const std::string& text) { options.package_name = text; })
        ->check(notEmpty("a name"));
    addFlag(
        "Output", "--segments", [](Options& options) { options.segments = true; },
        "Also write the mesh with a colour for each cluster (segments.ply), and the number of clusters at every concavity "
        "(hierarchy.csv); method hacd");
    addFlag(
        "Output", "--no-html", [](Options& options) { options.html = false; },
        "Do not write report.html, the report as a page with a 3D view");
    addFlag(
        "Output", "--replace-complete", [](Options& options) { options.replace_complete = true; },
        "Replace an earlier, complete output even if this run lacked memory or time for some meshes");
  }

  void addRun() {
    addNumber("Run", "--jobs", &Options::jobs, "Threads; 0: as many as cores. The result is the same for any number");
    add("Run", "--time-limit", "TIME", "none",
        "Time for making the hulls of all meshes, such as 5s or 2min: what was found by then counts, and is certified (method certified)",
        [](Options& options, const std::string& option, const std::string& text) { options.time_limit = parseSeconds(text, option); });
    addNumber("Run", "--reader-memory", &Options::reader_memory, "Memory [MiB] for reading a mesh; a large file may take more");
    addNumber("Run", "--reader-time", &Options::reader_time, "Computing time [s] for reading a mesh; a large file may take more");
    add("Run", "--seed", "N", std::to_string(Options().seed), "Seed of the validation's probes and of everything else that is random",
        [](Options& options, const std::string& option, const std::string& text) {
          options.seed = wholeNumber(option, text, std::numeric_limits<std::uint64_t>::max());
        });
    addFlag(
        "Run", "--no-validate", [](Options& options) { options.validate = false; },
        "Skip the collision queries that compare the hulls with the meshes");
    addFlag(
        "Run", "--no-cache", [](Options& options) { options.cache = false; },
        "Compute everything anew: neither read the cache nor add to it");
  }

  CommandLine& app_;
  GivenOptions& given_;
};

}  // namespace collision_hulls
