"""Convex hulls that cover a robot's meshes, with a proved bound on how far they protrude.

    import collision_hulls

    result = collision_hulls.decompose(mesh.vertices, mesh.faces, tolerance=0.005)   # [m]
    for hull in result.hulls:
        print(len(hull.vertices), hull.volume)
    print(result.bound)

    report = collision_hulls.decompose_robot("arm.urdf", "arm_collision", tolerance="5mm")
    report = collision_hulls.fit_scene("arm.urdf", "kitchen.scene", "2cm", "arm_in_kitchen")

Lengths are in metres. All functions give the same result for the same input, on any number of threads. They let other threads of Python run,
and Ctrl-C ends them within a second, unless a mesh of a million triangles is just being repaired. Beside this module, collision_hulls.msg and
collision_hulls.srv are the messages of the ROS package, where that is installed; they need nothing of it.
"""
from __future__ import annotations

import atexit
import contextlib
import difflib
import json
import os
import re
import threading
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

if TYPE_CHECKING:
    import numpy
    from numpy.typing import ArrayLike

    Array = numpy.ndarray
else:  # without numpy, which the messages do not need, type hints are resolved all the same
    Array = ArrayLike = Any

__all__ = ["Error", "Hull", "Result", "decompose", "decompose_robot", "fit_scene"]


def __getattr__(name: str) -> Any:
    """The version is the library's."""
    if name != "__version__":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from . import _core

    return _core.version()


Length = Union[float, str]
Path = Union[str, bytes, "os.PathLike[str]"]
Progress = Callable[[float], Any]


class Error(RuntimeError):
    """Why there is no result. The text names the item, its value and what to do about it.

    name: what programs can tell errors apart by, such as "BadOption", "FileNotFound" or "NonFiniteCoordinate".
    message: the text.
    """

    def __init__(self, message: str, name: str = "Internal"):
        super().__init__(message, name)
        self.message = message
        self.name = name

    def __str__(self) -> str:
        return self.message


@dataclass(frozen=True, eq=False)
class Hull:
    """A convex polyhedron.

    vertices: N x 3, float64 [m]; single-precision numbers, so that mesh files hold them as they are.
    faces: M x 3, int32: rows of vertices, counter-clockwise seen from outside. It is closed.
    volume: [m^3]
    """

    vertices: Array
    faces: Array
    volume: float


@dataclass(frozen=True, eq=False)
class Result:
    """Hulls that together hold every point of every face of a mesh, with what is proved of them. Lengths in metres, in the mesh's frame.

    hulls: in a fixed order.
    bound: proved: no point of a hull is further than this from the solid, which is the mesh's surface and what it encloses.
    found: the largest such distance found. The true one, the protrusion, lies between found and bound.
    where: the point of a hull at that distance; nearest: the point of the solid that is nearest to it.
    tolerance: what the tolerance asked for is for this mesh.
    status: "ok", or "degraded" where the bound exceeds the tolerance (and the padding); the hulls cover the mesh all the same.
    reason: why it is degraded, and what to do about it; else empty. It names options as the program does: max-hulls is max_hulls.
    least_hulls: proved: no cover within the tolerance has fewer hulls. None: the search did not need to know, so it was not computed.
    """

    hulls: List[Hull]
    bound: float
    found: float
    where: Array
    nearest: Array
    tolerance: float
    status: str
    reason: str
    least_hulls: Optional[int] = None


def decompose(
    vertices: ArrayLike,
    faces: ArrayLike,
    tolerance: Length = "1cm,5%",
    *,
    method: str = "certified",
    effort: str = "quick",
    max_hulls: int = 0,
    max_vertices: int = 64,
    padding: Length = 0,
    close_openings: Length = 0,
    fill: bool = False,
    seed: int = 1,
    jobs: int = 0,
    progress: Optional[Progress] = None,
) -> Result:
    """Covers a triangle mesh with few convex hulls.

    vertices: N x 3 numbers [m]. faces: M x 3 rows of vertices, of any integer type. Any arrays or lists will do, in any memory order, such as
    those of a trimesh.Trimesh. The hulls are those that the program decompose makes of a file with this mesh.

    tolerance: how far the hulls may protrude: metres, or a text such as "5mm", "1%" of the mesh's diagonal, or "1cm,5%", the smaller of both.
    method: "certified", "hacd", "acd", "single_hull" or "bounding_box".
    effort: how long to look for fewer hulls: "instant", "quick" or "best".
    max_hulls, max_vertices: most hulls, and most vertices of a hull (at least 8); 0: no limit.
    padding: the hulls hold everything within this distance of the surface, and may protrude by padding and tolerance.
    close_openings: first close openings of a shell up to this width; protrusion is then measured from the closed mesh.
    fill: cover the inside of a closed mesh as well, not its surface alone.
    seed: of everything random; another one may lead to other hulls.
    jobs: threads; 0: as many as cores.
    progress: called with the share done, from 0 to 1, a few times a second. What it raises ends the work.

    Raises Error, and KeyboardInterrupt soon after a Ctrl-C.
    """
    from . import _core

    look = _look(progress)
    points = _vertices(vertices)
    corners = _faces(faces, len(points))
    options = {"tolerance": tolerance, "method": method, "effort": effort, "max_hulls": max_hulls, "max_vertices": max_vertices,
               "padding": padding, "close_openings": close_openings, "fill": fill, "seed": seed, "jobs": jobs}
    words = _words("decompose", options)
    with _at_work():
        fields = _core.decompose(points, corners, words, look)
    fields["hulls"] = [Hull(*hull) for hull in fields["hulls"]]
    return Result(**fields)


def _several(items):
    """A single path or name stays one."""
    return list(items) if hasattr(items, "__iter__") and not isinstance(items, (str, bytes, os.PathLike)) else items


def decompose_robot(
    path: Path,
    output: Optional[Path] = None,
    *,
    tolerance: Optional[Length] = None,
    config: Optional[Path] = None,
    package_paths: Sequence[Path] = (),
    xacro_arguments: Optional[Mapping[str, Any]] = None,
    consumers: Sequence[str] = (),
    progress: Optional[Progress] = None,
    **options: Any,
) -> dict:
    """Makes the collision model of a robot, writes it, and returns what report.json says. It does what the program decompose does.

    path: a .urdf or .xacro file, a ROS package's name, or a single mesh.
    output: the folder to write; default: ./<robot>_collision. An earlier output there is replaced, in one step at the end.
    tolerance: as for decompose().
    config: a YAML file with settings link by link.
    package_paths: folders to search for packages, or "NAME=FOLDER" for one package.
    xacro_arguments: values for the arguments of a .xacro file, by name: {"prefix": "left_", "hand": True}.
    consumers: what to write files for, beside URDF: "moveit", "gazebo", "mujoco", ...
    progress: as for decompose(). What it raises at the very end, when the output is complete, leaves that in place.
    options: every other option of the program, with _ for -: max_hulls=8, links=".*_finger", no_validate=True. None and False leave one out;
        a list gives it several times, and a dict several times as NAME=VALUE: model={"fine": "5mm", "coarse": "2cm"}. doc/options.md lists them.

    The report is a dict. report["links"] has a row for each mesh, with its "status", "hulls", "protrusion" (the proved bound) and "files". A mesh
    that fails has the status "failed" and the "reason"; if all fail, so that nothing is written, Error is raised.

    Raises Error, and KeyboardInterrupt soon after a Ctrl-C; then the output was written completely or not at all.
    """
    named = {"output": output, "tolerance": tolerance, "config": config, "package_paths": _several(package_paths), "consumers": _several(consumers)}
    return _run("decompose", path, xacro_arguments, {**named, **options}, progress)


def fit_scene(
    path: Path,
    scene: Path,
    clearance: Length,
    output: Optional[Path] = None,
    *,
    tolerance: Optional[Length] = None,
    config: Optional[Path] = None,
    package_paths: Sequence[Path] = (),
    xacro_arguments: Optional[Mapping[str, Any]] = None,
    consumers: Sequence[str] = (),
    progress: Optional[Progress] = None,
    **options: Any,
) -> dict:
    """Makes the collision model of a robot that is no finer than a scene needs, writes it, and returns what report.json says. It does what the
    program fit_scene does.

    path: a .urdf or .xacro file, or a ROS package's name.
    scene: what stands around the robot, in the frame of its root link: a .scene, .urdf, .sdf, .world, .bt, .ot or .yaml file, or a mesh.
    clearance: wherever the robot keeps this distance from the scene and from itself, the model does not collide, except in a share of all
        configurations that report["scene"]["phantom_rate_bound"] bounds.
    tolerance: that of the finest hulls.
    options: every other option of the program, with _ for -: samples=100000, srdf="arm.srdf", configurations="path.csv", hulls_only=True, at={"elbow": 1.5}.
        doc/scenes.md lists them.
    output, config, package_paths, xacro_arguments, consumers, progress: as for decompose_robot().

    Returns and raises what decompose_robot() does; report["scene"] has what is known of the fit.
    """
    named = {"scene": scene, "clearance": clearance, "output": output, "tolerance": tolerance, "config": config,
             "package_paths": _several(package_paths), "consumers": _several(consumers)}
    return _run("fit_scene", path, xacro_arguments, {**named, **options}, progress)


def _run(program: str, path: Path, xacro_arguments: Optional[Mapping[str, Any]], options: Dict[str, Any], progress: Optional[Progress]) -> dict:
    from . import _core

    look = _look(progress)
    words = [*_words(program, options), b"--", _encoded("path", path), *_assignments(xacro_arguments)]
    with _at_work():
        return json.loads(_core.run(program, words, look))


_callers: List[threading.Thread] = []  # in the library now
_python_ends = False


@contextlib.contextmanager
def _at_work() -> Iterator[None]:
    """Around every call of the library that takes long."""
    _callers.append(threading.current_thread())
    try:
        _leave_if_python_ends()
        yield
    finally:
        _callers.remove(threading.current_thread())


@atexit.register
def _end_work() -> None:
    """Python ends its daemon threads by force, and the process aborts if C++ is at work in one. So they have to leave the library first."""
    global _python_ends
    _python_ends = True
    while any(thread.is_alive() for thread in list(_callers)):  # after a fork, threads that are not in this process are not alive
        time.sleep(0.01)


def _leave_if_python_ends() -> None:
    if _python_ends and threading.current_thread() is not threading.main_thread():
        raise SystemExit  # ends the thread without a message


def _look(progress: Optional[Progress]) -> Progress:
    """What the library calls a few times a second with the share done. What it raises ends the work."""
    if progress is not None and not callable(progress):
        raise Error(f"progress {progress!r} is not understood: it takes a function of one argument", "BadOption")
    told = 0.0

    def look(share: float) -> None:
        nonlocal told
        _leave_if_python_ends()
        if progress is not None and share > told:
            told = share
            progress(share)

    return look


_PROGRAMS_ALONE = ("help", "version", "quiet")


def _keyword(option: str) -> str:
    """What an argument of the program is called here."""
    return {"for": "consumers", "package-path": "package_paths"}.get(option, option.replace("-", "_"))


# Quotations and indented lines, which are commands, stay as they are. Else: --OPTION; and OPTION at the start, before its value.
_NAMED_IN_A_MESSAGE = re.compile(r"(?<!\w)'[^']*'|\n  .*|(?:(?<![^\s(])--|\A(?=[A-Za-z-]+ '))([A-Za-z-]+)")


_SEE_HELP = re.compile("; see (decompose|fit_scene) --help")


def _error(message: bytes, name: str) -> Error:
    """From what the library says, which calls options as the program does."""
    text = message.decode("utf-8", "replace")
    text = _SEE_HELP.sub("; see help(collision_hulls)", text)
    return Error(_NAMED_IN_A_MESSAGE.sub(lambda found: _keyword(found[1]) if found[1] else found[0], text), name)


def _words(program: str, options: Dict[str, Any]) -> List[bytes]:
    """The options as a command line has them."""
    known = _known_options(program)
    words = []
    for keyword, value in options.items():
        if keyword not in known:
            raise _unknown(keyword, list(known))
        option, takes_value, may_repeat = known[keyword]
        if keyword == "links" and isinstance(value, (list, tuple)) and value:
            raise Error(f"links {value!r} is not understood: it takes one regular expression, as in links={'|'.join(map(str, value))!r}", "BadOption")
        if takes_value:
            for text in _texts(keyword, value, may_repeat):
                words += [option + b"=" + text] if text else [option, text]
        elif _is_set(keyword, value):
            words.append(option)
    return words


def _assignments(values: Optional[Mapping[str, Any]]) -> List[bytes]:
    """NAME:=VALUE, as xacro takes it."""
    if values is None:
        return []
    if not isinstance(values, Mapping):
        raise Error(f'xacro_arguments {values!r} is not understood: it takes a dict, as in {{"hand": True}}', "BadOption")
    for name, value in values.items():
        if not isinstance(name, str) or not re.fullmatch(r"[^\W_][^:/\s]*", name):
            raise Error(f"xacro_arguments has the name {name!r}, which no argument can have; give one such as 'hand'", "BadOption")
        if not isinstance(value, (str, bool, int, float)):
            raise Error(f"xacro_arguments[{name!r}] is {value!r}; give a text, a number, True or False", "BadOption")
    return [_encoded(f"xacro_arguments[{name!r}]", f"{name}:={value}") for name, value in values.items()]


def _known_options(program: str) -> Dict[str, Tuple[bytes, bool, bool]]:
    """By keyword, the words of a program's options, whether they take a value, and whether they may take several."""
    from . import _core

    return {_keyword(name): (b"--" + name.encode(), *takes) for name, takes in _core.options(program).items() if name not in _PROGRAMS_ALONE}


def _unknown(keyword: str, known: List[str]) -> Error:
    if keyword in _PROGRAMS_ALONE:
        return Error(f"'{keyword}' is an option of programs alone; leave it out", "BadOption")
    meant = _keyword(keyword.replace("_", "-"))
    nearest = [meant] if meant in known else difflib.get_close_matches(keyword, known, 1)
    hint = f"did you mean '{nearest[0]}'? See" if nearest else "see"
    return Error(f"there is no option '{keyword}'; {hint} help(collision_hulls)", "BadOption")


def _plain(value: Any) -> Any:
    """A single number of numpy as one of Python."""
    return value.item() if getattr(value, "ndim", None) == 0 and hasattr(value, "item") else value


def _is_set(keyword: str, value: Any) -> bool:
    plain = _plain(value)
    if plain is None or isinstance(plain, bool):
        return bool(plain)
    raise Error(f"{keyword} {value!r} is not understood: it takes True or False", "BadOption")


_PATHS = ("output", "config", "scene", "package_paths", "srdf", "configurations", "compare", "json", "root")


def _texts(keyword: str, value: Any, may_repeat: bool) -> List[bytes]:
    plain = _plain(value)
    if plain is None or plain is False:
        return []
    if may_repeat and isinstance(plain, Mapping):
        return [_encoded(keyword, f"{name}=") + _text(keyword, one) for name, one in plain.items()]
    if may_repeat and isinstance(plain, (list, tuple)):
        return [_text(keyword, one) for one in plain]
    return [_text(keyword, plain, ", or several as a list" if may_repeat else "")]


def _text(keyword: str, value: Any, more: str = "") -> bytes:
    """Numbers with all of their digits. `more`: what else it takes."""
    plain = _plain(value)
    if isinstance(plain, (str, bytes, os.PathLike)):
        return _encoded(keyword, plain)
    if not isinstance(plain, bool) and keyword not in _PATHS:
        with contextlib.suppress(TypeError, ValueError, OverflowError):
            return str(plain.__index__() if hasattr(plain, "__index__") else float(plain)).encode()
    kinds = "a path" if keyword in _PATHS else "a number or a text"
    raise Error(f"{keyword} {value!r} is not understood: it takes {kinds}{more}", "BadOption")


def _encoded(keyword: str, value: Path) -> bytes:
    """As the names of files are encoded, which may be no UTF-8."""
    try:
        text = os.fsencode(value)
    except (TypeError, UnicodeEncodeError) as error:
        raise Error(f"{keyword} {value!r} cannot be used ({error}); give a text or a path", "BadOption") from None
    if b"\0" in text:
        raise Error(f"{keyword} {value!r} holds a NUL character, where the library would cut it; remove it", "BadOption")
    return text


def _array(value: Any, name: str, kinds: str, content: str) -> Array:
    import numpy

    try:
        if numpy.ma.is_masked(value):  # whose masked numbers numpy.asarray() gives as they are
            raise Error(f"{name} has masked numbers; fill them in, or leave out what has them", "NotAMesh")
        array = numpy.asarray(value)
    except ValueError as error:
        raise Error(f"{name} cannot be an array ({error}); give N x 3 {content}", "NotAMesh") from None
    if array.size == 0 and array.ndim < 3:
        return numpy.empty((0, 3))
    if array.ndim == 0:
        file = "; for a file use decompose_robot()" if isinstance(value, (str, bytes, os.PathLike)) else ""
        raise Error(f"{name} {value!r} is not an array; give N x 3 {content}{file}", "NotAMesh")
    if array.ndim != 2 or array.shape[1] != 3:
        divide = "divide each polygon into triangles, and " if name == "faces" and array.ndim == 2 and array.shape[1] > 3 else ""
        raise Error(f"{name} has the shape {array.shape}; {divide}give N x 3 {content}", "NotAMesh")
    if array.dtype.kind not in kinds:
        raise Error(f"{name} has the type {array.dtype}; give {content}", "NotAMesh")
    return array


def _vertices(value: Any) -> Array:
    import numpy

    given = _array(value, "vertices", "fiu", "numbers [m]")
    with numpy.errstate(over="ignore"):
        array = given.astype(numpy.float64)
        bad = ~numpy.isfinite(array.astype(numpy.float32)).all(axis=1)
    if bad.any():
        row = int(bad.argmax())
        raise Error(f"vertices[{row}] is {array[row].tolist()}, which is not a finite number of single precision; correct or remove it", "NonFiniteCoordinate")
    return array


def _faces(value: Any, count: int) -> Array:
    import numpy

    array = _array(value, "faces", "iu", "whole numbers, the vertices of triangles, such as faces.astype(int)")
    if len(array) == 0:
        raise Error("faces is empty; a mesh needs at least one", "EmptyMesh")
    bad = ((array < 0) | (array >= count)).any(axis=1)
    if bad.any():
        row = int(bad.argmax())
        remedy = "give faces - 1" if array.min() == 1 and array.max() == count else "correct or remove it"
        raise Error(f"faces[{row}] is {array[row].tolist()}, but there are {count} vertices, counted from 0; {remedy}", "IndexOutOfRange")
    return array.astype(numpy.int32)
