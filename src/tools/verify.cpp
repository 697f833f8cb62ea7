// verify ORIGINAL RESULT: whether one description is a collision model of the other, whoever made it.
#include "collision_hulls/verify/verify.h"

#include <map>

#include "base/counted.h"
#include "base/failure_cause.h"
#include "base/in_context.h"
#include "base/shell_word.h"
#include "collision_hulls/pipeline/input.h"
#include "decompose_options.h"
#include "file_options.h"
#include "storage/files.h"
#include "terminal_program.h"

namespace collision_hulls {
namespace {

constexpr const char* kFooter = R"(
Compares <collision> of RESULT with <visual> of ORIGINAL, so that one file can be both; but output of decompose and fit_scene with what it
was made from, as its report says (--source chooses otherwise). A mesh of RESULT counts as what it is, even if some consumers take its
convex hull.

Exit status: 0 every link was measured and is within the gates; 1 some link is not, or a mesh of it cannot be read (each is named), or it
lacks all geometry on one side while there is a gate on it, or a query contradicts a bound; 2 usage error, unreadable input, or no
link with geometry in both; 130 interrupted.

Examples:
  verify arm.urdf arm_collision/urdf/arm.urdf --max-uncovered 0 --max-protrusion 1cm
  verify ur_description ur_description
  verify bracket.stl bracket_hulls.obj --json -)";

struct Command {
  std::string original, result, source, close_openings, max_uncovered, max_protrusion, json;
  std::vector<std::string> package_path, xacro_arguments;
  int configurations = 1000, jobs = 0;
  std::uint64_t seed = 1;
  bool quiet = false;
  VerifyOptions options;
};

void addOptions(CommandLine& app, Command& command) {
  app.add_option("ORIGINAL", command.original, "What the robot is: a ROS package, a .urdf or .xacro file, or one mesh")
      ->type_name("")
      ->required();
  app.add_option("RESULT", command.result, "Its collision model, likewise")->type_name("")->required();
  addXacroArguments(app, command.xacro_arguments, "ORIGINAL and RESULT");
  const auto add = [&](const std::string& name, std::string& value, const std::string& type, const std::string& help,
                       const std::string& group) {
    app.add_option(name, value, help)->type_name(type)->group(group)->check(notEmpty("a value"));
  };
  add("--max-uncovered", command.max_uncovered, "LENGTH", "Fail if a link's surface may be further than this from RESULT: 0, 1mm", "Gates");
  add("--max-protrusion", command.max_protrusion, "LENGTH", "Fail if RESULT may protrude further than this from a link: 1cm", "Gates");
  add("--source", command.source, "NAME",
      "Elements of ORIGINAL that count (auto: a link's visual elements if it has any, else its collision ones): auto, visual, collision. "
      "Default: those that RESULT was made from, if its report says so, else auto",
      "Input");
  add("--close-openings", command.close_openings, "LENGTH",
      "First close openings of ORIGINAL's shells up to this width, as decompose does: 5cm", "Input");
  add("--links", command.options.links, "REGEX", "Links to compare: a regular expression that matches the whole name; default: all",
      "Input");
  addPackagePath(app, command.package_path);
  app.add_option("--configurations", command.configurations,
                 "Number of configurations of the robot in which collisions are queried; 0: none")
      ->type_name("N [1000]")
      ->check(range(0, 1e7))
      ->group("Run");
  app.add_option("--seed", command.seed, "Seed of the configurations")->type_name("N [1]")->group("Run");
  app.add_option("--jobs", command.jobs, "Threads; 0: as many as cores. The result is the same for any number")
      ->type_name("N [0]")
      ->check(range(0, 1024))
      ->group("Run");
  app.add_option("--json", command.json,
                 "Write what was measured to this file as well; - writes it to standard output, instead of the table")
      ->type_name("FILE")
      ->check(notEmpty("a file, or - for standard output"))
      ->group("Output");
  app.add_flag("--quiet", command.quiet, "Print errors and failing links only")->group("Output");
}

std::optional<double> gate(const std::string& text, const std::string& option) {
  if (text.empty()) return std::nullopt;
  return parsePadding(text, option);
}

void interpret(Command& command) {
  VerifyOptions& options = command.options;
  if (!command.source.empty()) options.source = choice("--source", command.source, sourceNamed, "auto, visual, collision");
  options.close_openings = gate(command.close_openings, "--close-openings").value_or(0);
  options.max_uncovered = gate(command.max_uncovered, "--max-uncovered");
  options.max_protrusion = gate(command.max_protrusion, "--max-protrusion");
  options.configurations = static_cast<std::size_t>(command.configurations);
  options.seed = command.seed;
  options.jobs = command.jobs;
}

Description described(const Input& input) {
  if (input.kind == Input::Kind::kMesh) return describeMesh(input.path);
  return {input.robot, input.find_package};
}

void checkSameKind(const Input& original, const Input& result) {
  if (original.kind == result.kind) return;
  const std::string& mesh = original.kind == Input::Kind::kMesh ? original.path : result.path;
  throw Error(ErrorCode::kBadOption, "'" + mesh + "' is a mesh, and the other is a robot; give two robots or two meshes");
}

/// Whether a row is the reason for an exit status other than 0.
bool isFailure(const LinkVerification& row, const VerifyOptions& options) {
  if (row.status == LinkStatus::kMissing) return options.max_uncovered.has_value();
  if (row.status == LinkStatus::kAdded) return options.max_protrusion.has_value();
  return row.status != LinkStatus::kOk;
}

/// The table, without what printFailures() says.
std::string tableOf(Verification seen, const VerifyOptions& options) {
  for (LinkVerification& row : seen.links)
    if (isFailure(row, options)) row.reason.clear();
  return toTable(seen);
}

/// Rows in groups with the same key, in the order of their first ones.
template <typename Key>
std::vector<std::vector<const LinkVerification*>> grouped(const std::vector<const LinkVerification*>& rows, const Key& key) {
  std::vector<std::vector<const LinkVerification*>> groups;
  std::map<std::string, std::size_t> places;  // in it
  for (const LinkVerification* row : rows) {
    const std::size_t place = places.emplace(key(*row), groups.size()).first->second;
    if (place == groups.size()) groups.emplace_back();
    groups[place].push_back(row);
  }
  return groups;
}

/// A line for each reason: links that lack the same package share one, and many meshes of the same cause do.
std::vector<std::string> linesFor(const std::vector<const LinkVerification*>& rows) {
  constexpr std::size_t kFew = 3;
  std::vector<std::string> lines;
  for (const auto& links : grouped(rows, [](const LinkVerification& row) { return row.reason; })) {
    const std::string others = links.size() > 1 ? " and " + counted(links.size() - 1, "more link") : "";
    lines.push_back(links.front()->link + others + ": " + links.front()->reason);
  }
  if (lines.size() <= kFew) return lines;
  return {lines.front() + theSameFor(lines.size() - 1, rows.size())};
}

void printFailures(const Verification& seen, const VerifyOptions& options) {
  std::vector<const LinkVerification*> failed;
  for (const LinkVerification& row : seen.links)
    if (isFailure(row, options)) failed.push_back(&row);
  const auto cause = [](const LinkVerification& row) {
    return row.status == LinkStatus::kFailed ? failureCause(row.reason, row.uri, row.link, Folder::kKept) : row.reason;
  };
  for (const auto& rows : grouped(failed, cause))
    for (const std::string& line : linesFor(rows)) std::cerr << "verify: " << line << "\n";
}

void print(const Verification& seen, const Command& command, const RunControl& control) {
  const std::string json = toJson(seen, command.options, command.original, command.result);
  if (isFile(command.json)) writeNamedFile(command.json, json, control);
  endOnSignals();
  if (command.json == "-") {
    std::cout << json;
  } else if (!command.quiet) {
    std::cout << tableOf(seen, command.options);
  }
  if (!std::cout.flush() && !nobodyReadsOutput())
    throw Error(ErrorCode::kUnwritableOutput, "cannot write to standard output; --json FILE keeps the figures");
  printFailures(seen, command.options);
  if (seen.contradictions > 0)
    std::cerr << "verify: the bounds are contradicted by " << counted(seen.contradictions, "collision query", "collision queries")
              << "; the notes name some\n";
}

int run(Command& command, const CommandLine& line) {
  static RunControl control;  // a signal may come until the program ends
  cancelOnSignals(control);
  interpret(command);
  if (isFile(command.json))
    inContext("--json", [&] { checkNamedFile(command.json), expectFolderOf(command.json), checkHoldsReport(command.json); });
  const std::string given = line.given(), before = line.call() + " " + shellWord(command.original),
                    after = shellWord(command.result) + " " + given;
  const Input original = openInput(command.original, {command.package_path, command.xacro_arguments, true, line.call(), after}, control);
  const Input result = openInput(command.result, {command.package_path, command.xacro_arguments, true, before, given}, control);
  if (original.robot.xacro_arguments.empty() && result.robot.xacro_arguments.empty() && !command.xacro_arguments.empty())
    throw Error(ErrorCode::kBadOption, "'" + command.xacro_arguments.front() + "' is an argument for xacro, but neither '" +
                                           command.original + "' nor '" + command.result + "' is a .xacro file; leave it out");
  checkSameKind(original, result);
  if (!command.quiet) std::cerr << "comparing '" << command.original << "' with '" << command.result << "'\n";
  const Description of_original = described(original);
  Description of_result = described(result);
  // Hulls of another program often lie outside of the workspace, and still name the robot's package.
  of_result.find_package =
      of_result.find_package.askingFirst([&](const std::string& package) { return of_original.find_package.knownPackage(package); });
  if (command.source.empty()) command.options.made_from = madeFrom(of_original, of_result);
  const Verification seen = verify(of_original, of_result, command.options, control);
  print(seen, command, control);
  return passed(seen, command.options) ? kDone : kSomeFailed;
}

int main(int argc, char** argv) {
  Command command;
  CommandLine app("Measures how well one description's collision geometry covers another's shape, whoever made it.", "verify");
  app.footer(kFooter);
  addOptions(app, command);
  return runTerminalProgram(app, argc, argv, [&] { return run(command, app); });
}

}  // namespace
}  // namespace collision_hulls

int main(int argc, char** argv) {
  return collision_hulls::main(argc, argv);
}
