"""Small robots, written into a temporary folder, and how the tests call the node with them."""
import math
import os
import shutil
import struct
import sys
import tempfile
import time

# Where this package's messages were generated, even if they were not there yet when the tests' environment was recorded.
sys.path[1:1] = [prefix + "/lib/python3/dist-packages" for prefix in os.environ.get("CMAKE_PREFIX_PATH", "").split(":")]

import rospy  # noqa: E402
from collision_hulls.srv import Decompose  # noqa: E402

NODE = "/collision_hulls"
ROOTS = [f"_{name}:={tempfile.gettempdir()}" for name in ("output_root", "read_roots")]  # of a node that a test starts


def box(x, y, z):
    vertices = [(i * x, j * y, k * z) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return vertices, [triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))]


def bracket(side, thickness, depth):
    """An L: two boxes' worth of solid, closed. Its convex hull protrudes far, two hulls fit exactly."""
    outline = [(0, 0), (side, 0), (side, thickness), (thickness, thickness), (thickness, side), (0, side)]
    vertices = [(x, y, z) for z in (0, depth) for x, y in outline]
    caps = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]
    sides = [(i, (i + 1) % 6) for i in range(6)]
    triangles = [(a, c, b) for a, b, c in caps] + [(a + 6, b + 6, c + 6) for a, b, c in caps]
    triangles += [t for i, j in sides for t in ((i, j, j + 6), (i, j + 6, i + 6))]
    return vertices, triangles


def torus(radius, tube, around, across):
    """2 * around * across triangles, curved all over: much work."""
    def point(i, j):
        u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
        ring = radius + tube * math.cos(v)
        return (ring * math.cos(u), ring * math.sin(u), tube * math.sin(v))

    def index(i, j):
        return (i % around) * across + j % across

    vertices = [point(i, j) for i in range(around) for j in range(across)]
    corners = [(index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)) for i in range(around) for j in range(across)]
    return vertices, [triangle for a, b, c, d in corners for triangle in ((a, b, c), (a, c, d))]


def write_obj(path, mesh):
    vertices, triangles = mesh
    with open(path, "w", encoding="ascii") as file:
        file.writelines("v %.9g %.9g %.9g\n" % v for v in vertices)
        file.writelines("f %d %d %d\n" % tuple(i + 1 for i in t) for t in triangles)


def write_stl(path, mesh):
    vertices, triangles = mesh
    with open(path, "wb") as file:
        file.write(bytes(80) + struct.pack("<I", len(triangles)))
        for triangle in triangles:
            file.write(struct.pack("<12fH", 0, 0, 0, *(x for i in triangle for x in vertices[i]), 0))


def link(name, uri, origin="0 0 0"):
    return (f'<link name="{name}"><visual><origin xyz="{origin}"/><geometry>'
            f'<mesh filename="{uri}"/></geometry></visual></link>')


def chain(name, links):
    """A robot whose links, as (name, XML), hang from each other by revolute joints."""
    joints = [f'<joint name="to_{child}" type="revolute"><parent link="{parent}"/><child link="{child}"/><axis xyz="0 0 1"/>'
              f'<limit lower="-1" upper="1" effort="1" velocity="1"/><origin xyz="0.2 0 0"/></joint>'
              for (parent, _), (child, _) in zip(links, links[1:])]
    return f'<robot name="{name}">' + "".join(xml for _, xml in links) + "".join(joints) + "</robot>"


class Folder:
    """A temporary folder with meshes, and an `output` that is not there yet."""

    def __init__(self):
        self.path = tempfile.mkdtemp(prefix="collision_hulls_test_")
        os.mkdir(self.file("results"))
        self.results = self.file("results")
        self.output = os.path.join(self.results, "made")

    def file(self, name):
        return os.path.join(self.path, name)

    def uri(self, name):
        return "file://" + self.file(name)

    def remove(self):
        shutil.rmtree(self.path)

    def small_robot(self, relative=False):
        """Two meshes, a second each at most: an L-bracket in OBJ and a box in STL; and a link without geometry."""
        write_obj(self.file("bracket.obj"), bracket(0.1, 0.02, 0.05))
        write_stl(self.file("box.stl"), box(0.1, 0.05, 0.03))
        prefix = "" if relative else "file://" + self.path + "/"
        return chain("small", [("base", link("base", prefix + "bracket.obj")), ("arm", link("arm", prefix + "box.stl", "0 0 0.1")),
                               ("tip", '<link name="tip"/>')])

    def slow_robot(self):
        """Many meshes that take a second or so each."""
        links = []
        for number in range(15):
            write_obj(self.file(f"torus{number}.obj"), torus(0.1 + 0.01 * number, 0.03, 100, 50))
            links.append((f"ring{number}", link(f"ring{number}", self.uri(f"torus{number}.obj"))))
        return chain("slow", links)


def decompose(node=NODE, **request):
    """Calls the service."""
    rospy.wait_for_service(node + "/decompose", timeout=30)
    return rospy.ServiceProxy(node + "/decompose", Decompose)(**request)


def answers():
    """Whether the node answers a call, be it busy or idle. (Its ~get_loggers would do too, but for Debian 12's rosconsole, which
    crashes any node when that is called twice.)"""
    return decompose(robot_description="rubbish").message != ""


def wait_until(condition, seconds=30):
    """Whether the condition came true in time."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.02)
    return True
