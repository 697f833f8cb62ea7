// What the programs that make a robot's collision model take, check and make, whoever calls: a terminal or Python.
#pragma once

#include <functional>
#include <iostream>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/in_context.h"
#include "base/roots.h"
#include "base/string_parts.h"
#include "collision_hulls/config/config.h"
#include "collision_hulls/consumers/consumers.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "collision_hulls/pipeline/decompose_robot.h"
#include "collision_hulls/pipeline/output.h"
#include "command_line.h"
#include "decompose_options.h"
#include "pipeline/stages.h"
#include "robot/package_place.h"
#include "storage/files.h"
#include "storage/names.h"
#include "storage/replace_folder.h"

namespace collision_hulls {

/// The command line of such a program.
struct RobotCommand {
  std::string program, input, output, json;
  std::vector<std::string> package_path, xacro_arguments, roots;
  bool quiet = false;
  std::string to_wait_less;         // what to tell those who wait long
  std::string config, config_text;  // file, and what it holds
  std::vector<std::string> models;  // NAME=LENGTH
  std::vector<std::string> consumer_names;
  std::vector<Consumer> consumers;  // once they are known
  GivenOptions given;
  Options options;                 // once they are known: the defaults, then the file, then what is given
  std::vector<std::string> notes;  // on them
  /// Refuses an input and an output for what only this program knows, before anything long; may be empty.
  std::function<void(const Input& input, const std::string& output, const RunControl& control)> refuse_early;
  const CommandLine* line = nullptr;  // that fills it
};

/// Input, output, report and the options of a decomposition.
inline void addRobotOptions(CommandLine& app, const std::string& input, RobotCommand& command) {
  app.add_option("INPUT", command.input, input)->type_name("")->required();
  addXacroArguments(app, command.xacro_arguments, "INPUT");
  app.add_option("-o,--output", command.output, "Output folder; default ./<robot>_collision. An earlier output there is replaced")
      ->type_name("DIR")
      ->check(notEmpty("a folder"))
      ->group("Output");
  addPackagePath(app, command.package_path);
  app.add_option("--root", command.roots, "Read and write only below this folder (packages may be read too); repeatable; default: anywhere")
      ->type_name("DIR")
      ->check(notEmpty("a folder"))
      ->group("Run");
  app.add_option("--json", command.json, "Write the report to this file as well; - writes it to standard output, instead of the table")
      ->type_name("FILE")
      ->check(notEmpty("a file, or - for standard output"))
      ->group("Output");
  app.add_flag("--quiet", command.quiet, "Print errors only")->group("Output");
  app.add_option("--config", command.config,
                 "Settings link by link (YAML), see doc/configuration.md; options given here override its defaults")
      ->type_name("FILE")
      ->check(notEmpty("a file"))
      ->group("Input");
  app.add_option("--for", command.consumer_names, "Also write the files of a consumer; repeat it for several: " + consumerChoices())
      ->type_name("NAME")
      ->group("Output");
  DecomposeOptionAdder(app, command.given).addAll();
  command.line = &app;
}

/// The option of programs that make several models.
inline void addModelOption(CommandLine& app, RobotCommand& command) {
  app.add_option("--model", command.models, "Make a model of this name with this tolerance; repeat it for several models from one run")
      ->type_name("NAME=LENGTH")
      ->check(notEmpty("a name and a tolerance, as in contact=2mm"))
      ->group("Accuracy");
}

/// False for a shell's pipe such as /dev/fd/63, which leads to no path.
inline bool liesWithin(const std::string& file, const std::string& folder) {
  std::error_code none;
  const auto real = [&](const std::string& path) { return std::filesystem::weakly_canonical(std::filesystem::absolute(path), none); };
  const std::filesystem::path within = real(file).lexically_relative(real(folder));
  return !within.empty() && *within.begin() != "..";
}

/// Refuses a file within the output folder, which holds the output alone, and one that cannot be written.
inline void checkBeside(const std::string& file, const std::string& output) {
  checkNamedFile(file);  // first, as it says what is wrong with links that lead in a circle
  if (liesWithin(file, output))
    throw Error(ErrorCode::kBadOption,
                "'" + file + "' lies in the output folder, which is replaced as a whole; choose a place outside of it");
}

/// Writes the output, and the file of --json even if the output fails. False if there was nothing to write.
inline bool writeOutputAndReport(RobotResult& result, const RobotCommand& command, const std::string& output, const RunControl& control) {
  const auto report = [&] {
    if (isFile(command.json)) writeReport(result.report, command.json, control);
  };
  bool written = false;
  try {
    written = writeOutput(result, output, control);
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kCancelled) report();
    throw;
  }
  report();
  return written;
}

/// Refuses options that do not go together, before anything is read.
inline void checkCommand(const RobotCommand& command) {
  const Options& options = command.options;
  check(options);
  check(command.consumers, options);
  if (needsCertified(options.effort) && options.method != Method::kCertified)  // the node's parameters hold for requests of any method
    throw Error(ErrorCode::kBadOption, std::string("effort '") + name(options.effort) +
                                           "' needs method 'certified'; leave it out with method '" + name(options.method) + "'");
}

/// A model's name and tolerance.
inline ModelOptions modelOf(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw Error(ErrorCode::kBadOption, "--model '" + text + "' is invalid: use a name and a tolerance, as in contact=2mm");
  return {text.substr(0, equals), parseTolerance(text.substr(equals + 1), "--model " + text.substr(0, equals))};
}

/// No name has a comma.
inline Consumer consumerOf(const std::string& text) {
  if (text.find(',') == std::string::npos) return choice("--for", text, consumerNamed, consumerChoices());
  throw Error(ErrorCode::kBadOption, "--for '" + text + "' is a list, and takes one name: repeat --for, as in --for moveit --for gazebo");
}

/// Fills command.options.
inline void configure(RobotCommand& command, const RunControl& control) {
  bool has_format = command.given.names.count("format") > 0;
  bool has_shapes = command.given.names.count("shapes") + command.given.names.count("spheres") > 0;
  if (!command.config.empty()) {
    const Config config = readConfig(command.config, control);
    has_format = has_format || config.format;
    has_shapes = has_shapes || config.defaults.shapes;
    apply(config, command.options);
    command.config_text = config.text;
    std::set<std::string> given = command.given.names;
    if (!command.models.empty()) given.insert("model");
    command.notes = overridingNotes(config, given);
  }
  if (command.given.names.count("spheres") > 0 && command.given.names.count("shapes") > 0)
    throw Error(ErrorCode::kBadOption, "--spheres is --shapes spheres, which contradicts another --shapes; leave one of them out");
  command.given.apply(command.options);
  for (const std::string& name : command.consumer_names) command.consumers.push_back(consumerOf(name));
  if (!has_format) command.options.format = formatFor(command.consumers, command.options.format);
  if (!has_shapes) command.options.shapes = shapesFor(command.consumers, command.options.shapes);
  if (command.models.empty()) return;
  if (command.given.names.count("tolerance"))
    throw Error(ErrorCode::kBadOption, "--tolerance contradicts --model, which gives each model its own; leave out one of them");
  command.options.models.clear();
  for (const std::string& model : command.models) command.options.models.push_back(modelOf(model));
}

/// A folder 'hulls.obj' is hardly what anybody means.
inline void checkNamesFolder(const std::string& output) {
  std::error_code error;
  if (std::filesystem::is_directory(output, error) || !(isMeshFile(output) || lowerExtension(output) == ".urdf")) return;
  throw Error(ErrorCode::kBadOption, "--output '" + output + "' has a file's extension, but the output is a folder; give one, such as '" +
                                         std::filesystem::path(output).replace_extension().string() + "'");
}

/// A configuration in the output folder would be replaced by the one that the run writes there.
inline void checkConfig(const RobotCommand& command, const Input& input, const std::string& output) {
  if (command.config.empty() || input.kind != Input::Kind::kRobot) return;
  if (liesWithin(command.config, output) && command.config_text != configText(command.options))
    throw Error(ErrorCode::kBadOption,
                "--config '" + command.config +
                    "' lies in the output folder, which is replaced, and the run would write it differently, such as "
                    "without its comments; copy it to a place outside");
}

/// Refuses options of robots for a mesh, and those of meshes for a robot.
inline void checkSuits(const Input& input, const RobotCommand& command) {
  const Options& options = command.options;
  if (input.kind == Input::Kind::kRobot) return checkForRobot(options);
  if (!command.consumers.empty())
    throw Error(ErrorCode::kBadOption, std::string("--for ") + name(command.consumers.front()) + ": '" + input.path +
                                           "' is a mesh, and only a robot's description has a form for it; leave the option out");
  for (const char* const option : {"uri", "source", "rebase"}) {
    if (command.given.names.count(option) > 0)
      throw Error(ErrorCode::kBadOption, std::string("--") + option + ": '" + input.path +
                                             "' is a mesh, and only a robot's description has elements and URIs; leave the option out");
  }
  if (!options.package_name.empty())
    throw Error(ErrorCode::kBadOption, "package-name '" + options.package_name + "': '" + input.path +
                                           "' is a mesh, and its output is not a package; leave the option out");
  checkForMesh(input.path, options);
}

/// A first sign of life: xacro alone may take seconds.
inline Input opened(const RobotCommand& command, const RunControl& control) {
  const bool is_quick = lowerExtension(command.input) == ".urdf" || isMeshFile(command.input);
  if (!command.quiet && !is_quick) std::cerr << "opening '" << command.input << "'\n";
  Input input = openInput(command.input,
                          {command.package_path, command.xacro_arguments, false, command.line->call(), command.line->given()}, control);
  checkSuits(input, command);
  return input;
}

/// What --root confines the program to: those folders, and packages. No roots: nothing.
inline void confine(const RobotCommand& command, std::optional<Confinement>& confinement) {
  if (command.roots.empty()) return;
  Roots roots;
  roots.read = roots.write = command.roots;
  for (const std::string& item : command.package_path) roots.read.push_back(packagePlace(item).folder.string());
  roots.package_with = [finder = defaultPackageFinder("", command.package_path)](const std::string& path) {
    return finder.packageWith(path);
  };
  roots.more_read = roots.more_write = "add --root with its folder";
  confinement.emplace(std::move(roots));
}

using RobotWork =
    std::function<RobotResult(const Input& input, const std::string& output, const RunControl& control, const StepCallback& step)>;

/// What a command makes, and the folder where it is to be written.
struct MadeRobot {
  RobotResult result;
  std::string output;
};

/// On a package that some consumers do not find; empty: all do.
inline std::string noteOnFolder(const Options& options, const Input& input, const std::string& output) {
  const std::filesystem::path folder = std::filesystem::path(replacedFolder(output)).filename();
  const std::string package = packageName(folder.string());
  if (input.kind == Input::Kind::kMesh || options.uri != UriStyle::kPackage || !options.package_name.empty() || folder == package)
    return "";
  return "the package is called '" + package + "', as ROS takes no '" + folder.string() +
         "'; Bullet and Gazebo look for a folder of the package's name: give one with --output";
}

/// Everything but writing: checks the command, reads the input, and works.
inline MadeRobot make(RobotCommand& command, const RobotWork& work, const RunControl& control, const StepCallback& step) {
  configure(command, control);
  checkCommand(command);
  const Input input = opened(command, control);
  checkNamesFolder(command.output);
  const std::string output = writablePath(command.output.empty() ? defaultOutput(input) : command.output);
  checkOutput(output, control);
  checkConfig(command, input, output);
  if (input.kind == Input::Kind::kRobot) check(command.consumers, command.options, input.robot, control);
  if (isFile(command.json))
    inContext("--json", [&] {
      checkBeside(command.json = writablePath(command.json), output);
      checkHoldsReport(command.json);
    });
  if (command.refuse_early) command.refuse_early(input, output, control);
  const std::string work_ahead = workOn(input, command.options, control);
  if (!command.quiet && !work_ahead.empty()) std::cerr << "reading " << work_ahead << "\n";
  MadeRobot made{work(input, output, control, step), output};
  addConsumerFiles(command.consumers, output, made.result, control, step);
  std::vector<std::string>& notes = made.result.report.notes;
  notes.insert(notes.begin(), command.notes.begin(), command.notes.end());
  if (const std::string note = noteOnFolder(command.options, input, output); !note.empty()) notes.push_back(note);
  return made;
}

}  // namespace collision_hulls
