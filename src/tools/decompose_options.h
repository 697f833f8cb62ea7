// The options of a decomposition on a command line, shared by the programs that take them.
#pragma once

#include <cmath>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <string>

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
  throw Error(ErrorCode::kBadOption, option + " '" + text + "' is invalid: use a whole number from 0 to " + std::to_string(limit));
}

/// A positive number without a unit.
inline double positiveNumber(const std::string& option, const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0;
  if (in >> value && in.peek() == std::istringstream::traits_type::eof() && value > 0 && std::isfinite(value)) return value;
  throw Error(ErrorCode::kBadOption, option + " '" + text + "' is invalid: use a number above 0 without a unit, as in 0.001");
}

/// The enumerator that a text names.
template <typename T>
T choice(const std::string& option, const std::string& text, std::optional<T> (*parse)(const std::string&), const std::string& choices) {
  if (const std::optional<T> value = parse(text)) return *value;
  throw Error(ErrorCode::kBadOption, option + " '" + text + "' is unknown: use one of " + choices);
}

/// Adds options whose callbacks fill `options`, which has to outlive the parsing; this object need not. An invalid value makes parse()
/// throw kBadOption.
class DecomposeOptionAdder {
 public:
  DecomposeOptionAdder(CommandLine& app, Options& options) : app_(app), options_(options) {}

  void addAll() {
    addAccuracy();
    addLimits();
    addInput();
    addOutput();
    addRun();
  }

 private:
  using Setter = std::function<void(const std::string& option, const std::string& text)>;

  void add(const std::string& group, const std::string& names, const std::string& type, const std::string& fallback,
           const std::string& help, const Setter& set) {
    const std::string option = names.substr(names.find("--"));
    CommandLine::Option* const added = app_.add_option_function(
        names, [=](const std::string& text) { set(option, text); }, help);
    added->type_name(fallback.empty() ? type : type + " [" + fallback + "]")->group(group);
  }

  void addNumber(const std::string& group, const std::string& names, int& value, const std::string& help) {
    add(group, names, "N", std::to_string(value), help, [&value](const std::string& option, const std::string& text) {
      value = static_cast<int>(wholeNumber(option, text, std::numeric_limits<int>::max()));
    });
  }

  template <typename T>
  void addChoice(const std::string& group, const std::string& names, T& value, std::optional<T> (*parse)(const std::string&),
                 const std::string& choices, const std::string& fallback, const std::string& help) {
    add(group, names, "NAME", fallback, help + ": " + choices,
        [=, &value](const std::string& option, const std::string& text) { value = choice(option, text, parse, choices); });
  }

  void addAccuracy() {
    add("Accuracy", "-t,--tolerance", "LENGTH", toString(options_.tolerance),
        "How far the hulls may protrude from the solid: 5mm, 0.005 (metres), 1% of each mesh's bounding-box diagonal, or 1cm,5%: the "
        "smaller of both",
        [&options = options_](const std::string&, const std::string& text) { options.tolerance = parseLength(text); });
    addChoice("Accuracy", "-m,--method", options_.method, methodNamed, methodChoices(), name(options_.method), "How to decompose meshes");
    addChoice("Accuracy", "--effort", options_.effort, effortNamed, effortChoices(), name(options_.effort),
              "best searches longer for fewer hulls (method certified)");
    app_.add_flag_callback(
            "--fill", [&options = options_] { options.fill = true; }, "Cover the inside of closed meshes as well, not their surface alone")
        ->group("Accuracy");
    add("Accuracy", "--tree", "LENGTH", "",
        "Build and cache a hull tree at this finer tolerance; later runs at coarser tolerances reuse it",
        [&options = options_](const std::string&, const std::string& text) { options.tree = parseLength(text, "--tree"); });
  }

  void addLimits() {
    // Before the limits themselves: callbacks run in this order, so that an explicit limit wins.
    add("Limits", "--profile", "NAME", "", "Limits that suit a collision checker or physics engine: fcl, moveit, bullet, physx, gazebo",
        [&options = options_](const std::string&, const std::string& text) { applyProfile(text, options); });
    addNumber("Limits", "--max-hulls", options_.max_hulls, "Most hulls per mesh; 0: no limit");
    addNumber("Limits", "--max-vertices", options_.max_vertices, "Most vertices per hull, at least 8; 0: no limit");
  }

  void addInput() {
    add("Input", "--links", "REGEX", "", "Links to decompose: a regular expression that matches the whole name; default: all",
        [&options = options_](const std::string&, const std::string& text) { options.links = text; });
    addChoice("Input", "--source", options_.source, sourceNamed, "auto, visual, collision", "auto",
              "Meshes to use (auto: a link's collision elements if it has any, else its visual ones)");
    add("Input", "--scale", "S", "1", "Scale a single mesh, such as 0.001 for millimetres; a URDF sets its own scale",
        [&options = options_](const std::string& option, const std::string& text) { options.scale = positiveNumber(option, text); });
  }

  void addOutput() {
    addChoice("Output", "--format", options_.format, meshFormatNamed, "stl, obj, dae", "stl", "Mesh files of the hulls");
    addChoice("Output", "--uri", options_.uri, uriStyleNamed, "package, file, relative", "package", "How the description refers to them");
    app_.add_flag_callback(
            "--segments", [&options = options_] { options.segments = true; },
            "Also write the mesh with a colour for each cluster (segments.ply), and the number of clusters for every tolerance "
            "(hierarchy.csv); method hacd")
        ->group("Output");
    app_.add_flag_callback(
            "--replace-complete", [&options = options_] { options.replace_complete = true; },
            "Replace an earlier output that has all meshes even if memory or time did not suffice for some of them now")
        ->group("Output");
  }

  void addRun() {
    addNumber("Run", "--jobs", options_.jobs, "Threads; 0: as many as cores. The result is the same for any number");
    addNumber("Run", "--reader-memory", options_.reader_memory, "Memory [MiB] for reading a mesh; a large file may take more");
    addNumber("Run", "--reader-time", options_.reader_time, "Computing time [s] for reading a mesh; a large file may take more");
    add("Run", "--seed", "N", std::to_string(options_.seed), "Seed of the validation's probes and of everything else that is random",
        [&options = options_](const std::string& option, const std::string& text) {
          options.seed = wholeNumber(option, text, std::numeric_limits<std::uint64_t>::max());
        });
    app_.add_flag_callback(
            "--no-validate", [&options = options_] { options.validate = false; },
            "Skip the collision queries that compare the hulls with the meshes")
        ->group("Run");
    app_.add_flag_callback(
            "--no-cache", [&options = options_] { options.cache = false; }, "Compute everything anew: neither read the cache nor add to it")
        ->group("Run");
  }

  CommandLine& app_;
  Options& options_;
};

}  // namespace collision_hulls
