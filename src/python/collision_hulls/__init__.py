"""Convex hulls that cover a robot's meshes, with a proved bound on how far they protrude.

    import collision_hulls

    result = collision_hulls.decompose(mesh.vertices, mesh.faces, tolerance=0.005)   # [m]
    for hull in result.hulls:
        print(len(hull.vertices), hull.volume)
    print(result.bound)

    report = collision_hulls.decompose_robot("arm.urdf", "arm_collision", tolerance="5mm")

Lengths are in metres. Both functions give the same result for the same input, on any number of threads. They let other threads of Python run,
and Ctrl-C ends them within a second, unless a mesh of a million triangles is just being repaired. Beside this module, collision_hulls.msg and
collision_hulls.srv are the messages of the ROS package, where that is installed; they need nothing of it.
"""
from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, List, Optional, Sequence, Union

if TYPE_CHECKING:
    import numpy
    import numpy.typing

__all__ = ["Error", "Hull", "Result", "decompose", "decompose_robot"]

Length = Union[float, str]
Path = Union[str, "os.PathLike[str]"]
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

    vertices: numpy.ndarray
    faces: numpy.ndarray
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
    reason: why it is degraded, and what to do about it; else empty.
    """

    hulls: List[Hull]
    bound: float
    found: float
    where: numpy.ndarray
    nearest: numpy.ndarray
    tolerance: float
    status: str
    reason: str


def decompose(
    vertices: numpy.typing.ArrayLike,
    faces: numpy.typing.ArrayLike,
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
    close_openings: close openings of a shell no wider than this first; protrusion then counts from the closed mesh.
    fill: cover the inside of a closed mesh as well, not its surface alone.
    jobs: threads; 0: as many as cores.
    progress: called with the share done, from 0 to 1, a few times a second. What it raises ends the work.

    Raises Error, and KeyboardInterrupt soon after a Ctrl-C.
    """
    from . import _core

    points = _vertices(vertices)
    corners = _faces(faces, len(points))
    options = {"tolerance": tolerance, "method": method, "effort": effort, "max_hulls": max_hulls, "max_vertices": max_vertices,
               "padding": padding, "close_openings": close_openings, "fill": fill, "seed": seed, "jobs": jobs}
    fields = _core.decompose(points, corners, _words(options), progress)
    fields["hulls"] = [Hull(*hull) for hull in fields["hulls"]]
    return Result(**fields)


def _several(items):
    """A single path or name counts as a list of one."""
    return [items] if isinstance(items, (str, os.PathLike)) else list(items)


def decompose_robot(
    path: Path,
    output: Optional[Path] = None,
    *,
    tolerance: Optional[Length] = None,
    config: Optional[Path] = None,
    package_paths: Sequence[Path] = (),
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
    consumers: what to write files for, beside URDF: "moveit", "gazebo", "mujoco", ...
    progress: as for decompose().
    options: every other option of the program, with _ for -: max_hulls=8, links=".*_finger", no_validate=True. None and False leave one out;
        a list gives it several times. doc/options.md lists them.

    The report is a dict. report["links"] has a row for each mesh, with its "status", "hulls", "protrusion" (the proved bound) and "files". A mesh
    that fails has the status "failed" and the "reason"; if all fail, so that nothing is written, Error is raised.

    Raises Error, and KeyboardInterrupt soon after a Ctrl-C; then nothing was written.
    """
    from . import _core

    named = {"output": output, "tolerance": tolerance, "config": config, "package_path": _several(package_paths), "for": _several(consumers)}
    twice = sorted(named.keys() & options.keys())
    if twice:
        raise Error(f"there is no option '{twice[0]}' here: use package_paths or consumers", "BadOption")
    return json.loads(_core.decompose_robot([*_words({**named, **options}), "--", os.fspath(path)], progress))


def _words(options: dict) -> List[str]:
    """The options as a command line has them."""
    words = []
    for name, value in options.items():
        if value is True:
            words.append(_option(name))
        elif value is not None and value is not False:
            words += [f"{_option(name)}={_text(name, one)}" for one in (value if isinstance(value, (list, tuple)) else [value])]
    return words


def _option(name: str) -> str:
    if name in ("help", "version", "quiet"):
        raise Error(f"'{name}' is an option of programs alone; leave it out", "BadOption")
    return "--" + name.replace("_", "-")


def _text(name: str, value: Any) -> str:
    """Numbers with all of their digits."""
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if hasattr(value, "__index__"):
        return str(value.__index__())
    if hasattr(value, "__float__"):
        return repr(float(value))
    raise Error(f"{name} {value!r} is not understood: it takes a number or a text", "BadOption")


def _array(value: Any, name: str, kinds: str, content: str) -> numpy.ndarray:
    import numpy

    try:
        array = numpy.asarray(value)
    except ValueError as error:
        raise Error(f"{name} cannot be an array ({error}); give N x 3 {content}", "NotAMesh") from None
    if array.size == 0 and array.ndim < 3:
        return numpy.empty((0, 3))
    if array.ndim != 2 or array.shape[1] != 3:
        raise Error(f"{name} has the shape {array.shape}; give N x 3 {content}", "NotAMesh")
    if array.dtype.kind not in kinds:
        raise Error(f"{name} has the type {array.dtype}; give {content}", "NotAMesh")
    return array


def _vertices(value: Any) -> numpy.ndarray:
    import numpy

    array = _array(value, "vertices", "fiu", "numbers [m]").astype(numpy.float64)
    with numpy.errstate(over="ignore"):
        bad = ~numpy.isfinite(array.astype(numpy.float32)).all(axis=1)
    if bad.any():
        row = int(bad.argmax())
        raise Error(f"vertices[{row}] is {array[row].tolist()}, which is no finite number of single precision; correct or remove it", "NonFiniteCoordinate")
    return array


def _faces(value: Any, count: int) -> numpy.ndarray:
    import numpy

    array = _array(value, "faces", "iu", "whole numbers: rows of vertices, such as faces.astype(int)")
    if len(array) == 0:
        raise Error("faces is empty; a mesh needs at least one", "EmptyMesh")
    bad = ((array < 0) | (array >= count)).any(axis=1)
    if bad.any():
        row = int(bad.argmax())
        raise Error(f"faces[{row}] is {array[row].tolist()}, but there are {count} vertices, counted from 0; correct or remove it", "IndexOutOfRange")
    return array.astype(numpy.int32)
