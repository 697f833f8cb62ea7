"""The programs of a build, for the scripts that run them: the option --programs, and where a build of this checkout has them."""
import os
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = pathlib.Path(os.environ.get("COLLISION_HULLS_BUILD", ROOT / "build")) / "devel/lib/collision_hulls"


def add_option(parser):
    parser.add_argument("--programs", type=pathlib.Path, default=FOLDER, help="their folder (default: devel/lib/collision_hulls "
                        "of the build, which is build/ or what the variable COLLISION_HULLS_BUILD says)")


def folder(parser, arguments, *needed):
    """The folder of the programs. Ends the script as for a usage error where one of those needed is missing."""
    for program in needed:
        if not (arguments.programs / program).exists():
            parser.error(f"no program '{program}' in '{arguments.programs}'; build first, or name the folder with --programs")
    return arguments.programs.resolve()
