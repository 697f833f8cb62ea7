// fit_scene INPUT --scene FILE --clearance LENGTH: makes a robot's collision model that is no finer than a scene needs.
#include "robot_program.h"
#include "scene_command.h"

namespace collision_hulls {
namespace {

constexpr const char* kFooter = R"(
Wherever the original robot keeps the clearance from the scene and from itself, the model should be free of collisions, too; and it
never misses a collision. The report says what each link needed, what is proved, and gives an upper bound on the share of
configurations in which the model still collides although the original keeps the clearance.

The model is of certified hulls. The options of decompose that this leaves no room for are refused, with a reason each: other methods,
--padding, --scale, --segments, --shapes, --spheres, --time-limit, --tree and --for curobo. There is no --model: a scene decides on the
detail.

Exit status: as for decompose.

Examples:
  fit_scene arm.urdf --scene kitchen.scene --clearance 2cm
  fit_scene ur_description --scene cell.yaml --clearance 1cm --configurations path.csv --srdf ur.srdf)";

int main(int argc, char** argv) {
  SceneCommand command;
  command.robot.program = "fit_scene";
  CommandLine app("Makes a robot's collision model that is no finer than a scene needs.", command.robot.program);
  app.footer(kFooter);
  addSceneOptions(app, command);
  return runTerminalProgram(app, argc, argv, [&] {
    interpret(command);
    const int status = runRobotCommand(command.robot, fitting(command));
    writeComparison(command);
    return status;
  });
}

}  // namespace
}  // namespace collision_hulls

int main(int argc, char** argv) {
  return collision_hulls::main(argc, argv);
}
