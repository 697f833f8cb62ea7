#!/usr/bin/env python3
"""Inputs to begin with, FOLDER/TARGET/*: small shapes, descriptions and scenes of the project. Standard library only.

usage: seeds.py FOLDER
"""
import pathlib
import re
import struct
import sys

PACKAGE = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(PACKAGE / "test" / "attacks"))
import hostile_meshes as hostile

URDF = """<?xml version="1.0"?>
<!-- a robot --><robot name="r"><link name="a"><visual name="v"><origin xyz="0 0 1" rpy="0 0 1.57"/><geometry>
<mesh filename="package://p/a%20b.stl" scale="1 1 -1"/></geometry><material name="m"><color rgba="1 0 0 1"/></material></visual>
<collision><geometry><box size="1 2 3"/></geometry></collision></link><link name="b"><collision><geometry><cylinder radius="1"
length='2'/></geometry></collision><collision><geometry><capsule radius="1"/></geometry></collision></link><link name="c"/>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/><origin xyz="1 0 0"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint><joint name="k" type="prismatic"><parent link="b"/><child link="c"/>
<limit effort="1" velocity="1"/><mimic joint="j" multiplier="2" offset=".1"/></joint><![CDATA[x]]></robot>
"""
GLTF = """{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"children": [1], "scale": [1, 2, 1]},
{"mesh": 0, "rotation": [0, 0, 0, 1], "translation": [0, 0, 1]}], "meshes": [{"primitives": [{"mode": 4, "indices": 1,
"attributes": {"POSITION": 0}}, {"mode": 5, "attributes": {"POSITION": 2}}]}], "accessors": [{"bufferView": 0, "componentType": 5126,
"count": 3, "type": "VEC3"}, {"bufferView": 1, "componentType": 5121, "count": 3, "type": "SCALAR"}, {"componentType": 5126, "count": 3,
"type": "VEC3", "sparse": {"count": 3, "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 0}}}],
"bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 3}], "buffers": [{"byteLength": 39,
"uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAEC"}]}"""
GLTF_PART = bytes(12) + struct.pack("<6f", 1, 0, 0, 0, 1, 0) + b"\0\1\2"  # of GLTF, the buffer
SRDF = """<robot name="r"><group name="g"/><disable_default_collisions link="c"/><enable_collisions link1="a" link2="c"/>
<disable_collisions link1="a" link2="b" reason="Adjacent"/><disable_collisions link1="x" link2="b"/></robot>
"""
SCENE_YAML = """name: cell
bodies:
- {name: table, box: [1.2, 0.8, 0.04], pose: {xyz: [0.6, 0, -0.02], rpy: [0, 0, 0]}}
- {name: can, cylinder: [0.03, 0.12], pose: {xyz: [0, 0, 1], quaternion: [0, 0, 0, 1]}}
- {name: floor, plane: [0, 0, 1, 0]}
- {name: tip, cone: [0.05, 0.1]}
"""
SCENE_SDF = """<sdf version="1.7"><world name="w"><model name="m"><pose relative_to="f">1 0 0 0 0 1</pose><frame name="g"/>
<link name="l"><collision name="c"><geometry><box><size>1 2 3</size></box></geometry></collision><collision name="d">
<pose>0 0 1 0 0 0</pose><geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link></model><frame name="f">
<pose>1 2 3 0 0 0</pose></frame><state world_name="w"><model name="m"><pose>0 0 0 0 0 0</pose></model></state></world></sdf>
"""
SCENE_MOVEIT = """cell
* box
0.5 0 0.25
0 0 0 1
2
box
1 1 0.5
0 0 0
0 0 0 1
0 0 0 0
mesh
3 1
0 0 0
1 0 0
0 1 0
0 1 2
0 0 0
0 0 0 1
0 0 0 0
0
.
"""
OCTOMAP = (b"# Octomap OcTree binary file\nid OcTree\nsize 1\nres 0.1\ndata\n" + b"\x02\x00" * 15 + b"\xff\x55",
           b"# Octomap OcTree binary file\nid OcTree\nsize 17\nres 0.05\ndata\n" + b"\x03\x00" * 15 + b"\xaa\xaa")
CONFIGURATIONS_CSV = "time;j;k\n0;0.5;-0.1\n# comment\n1;.2;3\n", "%time,field.name0,field.name1,field.position0,field.position1\n1,j,k,0.5,1\n"
CONFIGURATIONS_YAML = "name: [j, k]\nposition: [0.5, 1]\n---\njoint_names: [j]\npoints:\n- {positions: [0.1]}\n- {positions: [0.3]}\n"
LENGTHS = "5mm", "0.5 cm", "0.005", "1%", "1cm,5%", "5%, 1cm", "100um", "1e-3m"


def answer(points, triangles):
    """A worker's answer: vertices, triangles, sub-meshes, skipped primitives, resolution, and its kind."""
    return (struct.pack("<Q", len(points)) + b"".join(struct.pack("<3d", *p) for p in points) + struct.pack("<Q", len(triangles))
            + b"".join(struct.pack("<3i", *t) for t in triangles) + struct.pack("<iQd", 1, 0, 1e-8) + b"a")


def text(content):
    return struct.pack("<Q", len(content)) + content


def element(depth, name):
    """Of XML: depth, line, name, text, and an attribute."""
    return struct.pack("<IQ", depth, 1) + text(name) + text(b"") + struct.pack("<Q", 1) + text(b"k") + text(b"v")


def glb(json):
    """A .glb file with this chunk of JSON alone."""
    json += -len(json) % 4 * b" "
    return struct.pack("<4sIIII", b"glTF", 2, 20 + len(json), len(json), 0x4E4F534A) + json


def packed_gltf(json, *files):
    """A .gltf file and the files of its buffers, as the library packs them."""
    chunks = struct.pack("<II", len(json), 0x4E4F534A) + json + b"".join(struct.pack("<II", len(file), 0x004E4942) + file for file in files)
    return struct.pack("<4sII", b"glTP", 2, 12 + len(chunks)) + chunks


def value(kind, content, *children):
    """Of YAML: kind, line, text, and what it holds."""
    return struct.pack("<BQ", kind, 0) + text(content) + struct.pack(f"<Q{len(children)}I", len(children), *children)


def seeds():
    """{target: inputs}"""
    meshes = {target: [] for target in ("off", "ply", "obj", "stl", "dae", "gltf")}
    for extension, content in hostile.seed_meshes(PACKAGE / "meshes"):
        if len(content) < 10000:
            meshes["gltf" if extension == ".glb" else extension[1:]].append(content)
    beside = re.sub('"data:[^"]*"', '"part.bin"', GLTF).encode()
    meshes["gltf"] += [GLTF.encode(), glb(GLTF.encode()), packed_gltf(beside, GLTF_PART)]
    scenes = [b"\0" + SCENE_YAML.encode(), b"\1" + SCENE_SDF.encode(), b"\2" + SCENE_MOVEIT.encode(), *(b"\3" + map_ for map_ in OCTOMAP)]
    scenes += [b"\0" + file.read_bytes() for file in sorted((PACKAGE / "test/data/scenes").glob("*.yaml"))]
    points, triangle = [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]
    hull = struct.pack("<Q", 3) + b"".join(struct.pack("<3d", *p) for p in points)
    configurations = [*(b"\0" + each.encode() for each in CONFIGURATIONS_CSV), b"\1" + CONFIGURATIONS_YAML.encode()]
    # What the targets found.
    scenes.append(b"\0,x")  # yaml-cpp's loader never ended, and took all memory
    configurations.append(b"\1\xef\xbb\xbf,uuuu=\0\xfa")
    configurations.append(b"\0j,k\n0,1.7e308\n1,-1.7e308\n")  # the way between was infinite, and steps on it not numbers
    no_name = b"<!-ameoM/>"  # tinyxml2 took it for a declaration, and there was no root
    return {
        **meshes, "urdf": [URDF.encode(), (PACKAGE / "urdf/demo_arm.urdf").read_bytes(), no_name], "srdf": [SRDF.encode(), no_name],
        "scene": scenes, "configurations": configurations,
        "length": [length.encode() for length in LENGTHS], "hull_tree": [b"\1" + hull, b"\0CHULTREE\1\0\0\0"],
        "cache": [b"\0" + text(64 * b"a") + bytes(200), b"\1" + text(b"CHULTREE\1\0\0\0"), b"\2" + bytes(96)],
        "wire": [b"\0" + answer(points, triangle), b"\0" + struct.pack("<i", 3) + text(b"no mesh") + b"e", b"\0oddx",
                 b"\1m" + text(b"a.obj") + struct.pack("<QQ", 1000, 1000),
                 b"\3" + struct.pack("<Q", 2) + element(0, b"a") + element(1, b"b"),
                 b"\4" + struct.pack("<QQ", 1, 2) + value(1, b"a") + value(2, b"", 0),
                 b"\5" + struct.pack("<QQ", 1, 0) + text(b"part.bin"),
                 b"\2" + text(b"r") + struct.pack("<Q", 1) + text(b"a") + struct.pack("<QQ12dQQQ", 0, 0, *12 * [0], 0, 0, 0)],
    }


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for target, inputs in seeds().items():
        folder = pathlib.Path(sys.argv[1]) / target
        folder.mkdir(parents=True, exist_ok=True)
        for i, content in enumerate(inputs):
            (folder / f"seed_{i}").write_bytes(content)


if __name__ == "__main__":
    main()
