// decompose INPUT: the meshes of a robot, or one mesh, to convex hulls in a package of their own.
#include "base/string_parts.h"
#include "collision_hulls/mesh/mesh_io.h"
#include "robot_program.h"

namespace collision_hulls {
namespace {

constexpr const char* kFooter = R"(
Exit status: 0 all meshes done; 1 some failed (each is named, and all others are written; if all failed, nothing is
written, unless the robot has at least as many links with primitives alone), or the check found what the proof rules
out; 2 usage error, unreadable input, a single mesh that failed, unwritable output, or a report that could not be
printed or saved (--json); 130 interrupted.
"degraded" is not a failure: the hulls cover the mesh, but protrude further than the tolerance.

Examples:
  decompose pr2_description -t 5mm,5% -o pr2_collision
  decompose arm.urdf --links '.*_finger' --max-hulls 8 --json report.json
  decompose bracket.stl -t 0.5%)";

int main(int argc, char** argv) {
  RobotCommand command;
  command.program = "decompose";
  command.to_wait_less =
      "This takes long. To finish sooner, press Ctrl-C and give a larger tolerance, such as -t 3cm,20%, or --effort instant, or "
      "--time-limit 1min.";
  CommandLine app(
      "Replaces the meshes of a robot with convex hulls that cover them, and writes the hulls as a ROS package with a new description.",
      command.program);
  app.footer(kFooter);
  addRobotOptions(app, "A ROS package, a .urdf or .xacro file, or one mesh (" + listed(meshExtensions(), " ") + ")", command);
  addModelOption(app, command);
  const RobotWork work = [&](const Input& input, const std::string& output, const RunControl& control, const StepCallback& step) {
    return decompose(input, command.options, output, control, step);
  };
  return runTerminalProgram(app, argc, argv, [&] { return runRobotCommand(command, work); });
}

}  // namespace
}  // namespace collision_hulls

int main(int argc, char** argv) {
  return collision_hulls::main(argc, argv);
}
