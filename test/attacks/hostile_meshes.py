"""Small meshes in every format, spellings of numbers, and damage to both. Standard library only."""
import json
import re
import struct

# Words that stand where a number should: plain ones, which everybody reads alike, and those that readers are known to differ on.
PLAIN_SPELLINGS = "1.5 -1.5 +1 .5 -.5 1. 0001 1e+00 1E0 5e-1 1.e0 0.1234567890123456789012345".split()
ODD_SPELLINGS = """1.00000000000000000000000000001 0.00000000000000000000000001e26 10000000000000000000000e-22 1e0005 1.0f 0x1p0 0x1 0x10
  1_000 99999999999999999999 18446744073709551617 18446744073709551616 1e5000 1e-5000 1.5e1.5 1d1 1,5 1e - -- --3 1-2
  1+1 +-1 inf -inf infinity nan nan(1) 123456789.123456789 1e38 3.4028235e38 3.4028236e38 1e-45 1e-320 2e2147483649
  2e-4294967295 2e4294967297 1.#INF 1.#QNAN ٣ １ ½ 1..5 . e5 1e5e5 0b1 1L 1' $1 1% 1;2 -0""".split()
COUNTS = "0 -1 1 2 3 4 5 7 100 255 256 65536 2147483647 2147483648 4294967295 4294967296 -2147483648 18446744073709551615 1e3 0x3".split()

BOX = ([(x, y, z) for x in (0, .1) for y in (0, .2) for z in (0, .3)],
       [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])


def bracket():
    """An L, extruded: two faces of six corners, which are not convex."""
    outline = [(0, 0), (.2, 0), (.2, .03), (.03, .03), (.03, .2), (0, .2)]
    n = len(outline)
    vertices = [(x, y, z) for z in (0, .1) for x, y in outline]
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    return vertices, [tuple(reversed(range(n))), tuple(range(n, 2 * n)), *sides]


def triangulated(mesh):
    """A mesh's faces as triangles; those of bracket() as its corner sees them, from the inner one."""
    def fan(face):
        start = next((i for i, corner in enumerate(face) if len(face) == 6 and corner % 6 == 3), 0)
        turned = face[start:] + face[:start]
        return [(turned[0], turned[i], turned[i + 1]) for i in range(1, len(turned) - 1)]
    vertices, faces = mesh
    return vertices, [triangle for face in faces for triangle in fan(face)]


def spelled(vertices):
    """Vertices as text; a coordinate may be a word already."""
    return [tuple(x if isinstance(x, str) else f"{x:g}" for x in vertex) for vertex in vertices]


def obj(mesh):
    faces = [" ".join(str(1 + corner) for corner in face) for face in mesh[1]]
    vertices = ["v %s %s %s\n" % vertex for vertex in spelled(mesh[0])]
    return ("# made for a test\no part\n" + "".join(vertices) + "".join(f"f {face}\n" for face in faces)).encode()


def off(mesh):
    faces = [" ".join(map(str, (len(face), *face))) for face in mesh[1]]
    lines = ["OFF", f"{len(mesh[0])} {len(faces)} 0", *("%s %s %s" % vertex for vertex in spelled(mesh[0])), *faces]
    return ("\n".join(lines) + "\n").encode()


def stl(mesh):
    words = spelled(mesh[0])
    facets = ["".join("   vertex %s %s %s\n" % words[corner] for corner in triangle) for triangle in triangulated(mesh)[1]]
    body = "".join(f" facet normal 0 0 0\n  outer loop\n{facet}  endloop\n endfacet\n" for facet in facets)
    return f"solid part\n{body}endsolid part\n".encode()


def binary_stl(mesh):
    vertices, triangles = triangulated(mesh)
    facets = [struct.pack("<12fH", 0, 0, 0, *(x for corner in triangle for x in vertices[corner]), 0) for triangle in triangles]
    return b"binary".ljust(80) + struct.pack("<I", len(facets)) + b"".join(facets)


def ply_header(kind, mesh):
    return (f"ply\nformat {kind} 1.0\ncomment made for a test\nelement vertex {len(mesh[0])}\nproperty float x\nproperty float y\n"
            f"property float z\nproperty uchar red\nelement face {len(mesh[1])}\nproperty list uchar int vertex_indices\n"
            "end_header\n").encode()


def ply(mesh):
    rows = ["%s %s %s 7\n" % v for v in spelled(mesh[0])] + [" ".join(map(str, (len(f), *f))) + "\n" for f in mesh[1]]
    return ply_header("ascii", mesh) + "".join(rows).encode()


def binary_ply(mesh, order="<"):
    rows = [struct.pack(order + "3fB", *v, 7) for v in mesh[0]] + [struct.pack(f"{order}B{len(f)}i", len(f), *f) for f in mesh[1]]
    return ply_header("binary_little_endian" if order == "<" else "binary_big_endian", mesh) + b"".join(rows)


def glb(mesh):
    """Binary glTF: points, then the corners of triangles, in a node that is moved."""
    points = b"".join(struct.pack("<3f", *v) for v in mesh[0])
    corners = [corner for face in mesh[1] for i in range(2, len(face)) for corner in (face[0], face[i - 1], face[i])]
    binary = points + struct.pack(f"<{len(corners)}I", *corners)
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "translation": [0, 0, 1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(mesh[0]), "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5125, "count": len(corners), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": len(points)},
                        {"buffer": 0, "byteOffset": len(points), "byteLength": 4 * len(corners)}],
        "buffers": [{"byteLength": len(binary)}]}).encode()
    text += -len(text) % 4 * b" "
    header = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary))
    return header + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary


def dae(mesh):
    vertices = " ".join(" ".join(v) for v in spelled(mesh[0]))
    count, corners = len(mesh[0]), " ".join(str(corner) for face in mesh[1] for corner in face)
    sizes = " ".join(str(len(face)) for face in mesh[1])
    return f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="shape"><mesh>
<source id="points"><float_array id="array" count="{3 * count}">{vertices}</float_array>
<technique_common><accessor source="#array" count="{count}" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="vertices"><input semantic="POSITION" source="#points"/></vertices>
<polylist count="{len(mesh[1])}"><input semantic="VERTEX" source="#vertices" offset="0"/><vcount>{sizes}</vcount><p>{corners}</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="scene"><node id="outer"><translate>0 0 0.1</translate><node id="inner">
<instance_geometry url="#shape"/></node></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene></COLLADA>
""".encode()


TEXT_WRITERS = {".obj": obj, ".off": off, ".stl": stl, ".ply": ply, ".dae": dae}


def seed_meshes(folder):
    """[(extension, content)]: two small shapes in every format, and some of the package's meshes."""
    seeds = [(extension, write(mesh)) for mesh in (BOX, bracket(), triangulated(bracket())) for extension, write in TEXT_WRITERS.items()]
    seeds += [(".stl", binary_stl(bracket())), (".ply", binary_ply(bracket())), (".ply", binary_ply(BOX, ">")),
              (".glb", glb(bracket())), (".glb", glb(BOX))]
    for name in ("base.dae", "gripper.dae", "elbow_bracket.obj", "finger.stl"):
        seeds.append((name[name.index("."):], (folder / name).read_bytes()))
    return seeds



def nested_nodes(depth):
    return depth * "<node>" + "<instance_geometry url='#shape'/>" + depth * "</node>"


def doubling_nodes(count):
    """Each node holds the next one twice: 2^count instances."""
    nodes = [f"<node id='&#100;{i}'>" + 2 * f"<instance_node url='#d{i + 1}'/>" + "</node>" for i in range(count)]
    return "".join(nodes) + f"<node id='d{count}'><instance_geometry url='#shape'/></node>"


STATEMENTS = {
    ".obj": ["f 1 2 3", "f -1 -2 -3", "f 1//1 2//2 3//3", "f 1 2 3 4 5 6", "f 1 1 1", "f 1 2", "l 1 2", "p 1", "o x", "usemtl a",
             "vn 0 0 1", "v 1 2 3 1", "v 1 2 3 4", "v .1 .2 .3 .4 .5 .6", "v 1 2", "\\", "# \\", "cstype bezier", "end", "curv 0 1 2",
             "call x.obj", "csh -c id"],
    ".off": ["OFF", "4OFF", "COFF", "BINARY", "#", "3 0 1 2", "4 0 1 2 3 1 0 0", "2 0 1", "0"],
    ".stl": ["solid a", "endsolid", "endsolid b", "facet normal 0 0 0", "outer loop", "vertex 0 0 0", "endloop", "endfacet", "COLOR="],
    ".ply": ["end_header", "element vertex 3", "element face 2", "element tristrips 1", "element edge 2", "property float x",
             "property double y", "property list uchar int vertex_indices", "property list double int vertex_index",
             "format ascii 1.0", "junk", "obj_info x", "comment"],
    ".dae": ["<node id='a'><instance_node url='#a'/></node>", "<node id='&#97;'><instance_node url='#a'/></node>", "<p>0 0 0</p>",
             "<vcount>4</vcount>", "<skew>1</skew>", "<lookat>0 0 0 0 0 0 0 0 0</lookat>", "<matrix>nan</matrix>",
             "<scale>0 0 0</scale>", "<!--", "-->", "<![CDATA[", "]]>", "<?x --> ?>", "<!DOCTYPE a [<!ENTITY b 'c'>]>", "&b;", "&#0;",
             "<instance_geometry url='#shape'/>", "<tristrips>", "<unit meter='0'/>", nested_nodes(100), nested_nodes(5000),
             doubling_nodes(4), doubling_nodes(26)],
}


def spot(rng, content):
    return rng.randrange(len(content) + 1)


def flip_bits(rng, extension, content):
    changed = bytearray(content)
    for _ in range(rng.choice([1, 4, 32])):
        changed[rng.randrange(len(changed))] ^= 1 << rng.randrange(8)
    return bytes(changed)


def overwrite_four_bytes(rng, extension, content):
    at = spot(rng, content)
    word = rng.choice([0xffffffff, 0, 0x7fffffff, 0x7f800000, 0x7fc00000, 0x80000000, rng.getrandbits(32)]).to_bytes(4, "little")
    return content[:at] + word + content[at + 4:]


def cut_off(rng, extension, content):
    return content[:spot(rng, content)]


def drop_piece(rng, extension, content):
    at = spot(rng, content)
    return content[:at] + content[at + rng.choice([1, 4, 50, 200]):]


def double_piece(rng, extension, content):
    at, other = spot(rng, content), spot(rng, content)
    return content[:at] + content[other:other + rng.choice([1, 12, 50, 300])] + content[at:]


def move_lines(rng, extension, content):
    """Drops, doubles or swaps lines."""
    lines = content.split(b"\n")
    i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
    action = rng.randrange(3)
    if action == 0:
        del lines[i]
    elif action == 1:
        lines.insert(i, lines[j])
    else:
        lines[i], lines[j] = lines[j], lines[i]
    return b"\n".join(lines)


def replace_number(rng, content, words, most):
    numbers = list(re.finditer(rb"-?\d[\d.eE+-]*", content[:20000]))[:most]
    if not numbers:
        return content
    chosen = rng.choice(numbers)
    return content[:chosen.start()] + rng.choice(words).encode() + content[chosen.end():]


def respell_number(rng, extension, content):
    return replace_number(rng, content, PLAIN_SPELLINGS + ODD_SPELLINGS, 10000)


def change_digits(rng, extension, content):
    """What remains is most often a mesh, of another shape."""
    start = max(0, content.find(b"end_header"))
    digits = [match.start() for match in re.finditer(rb"(?<=[\d.])\d", content[:20000]) if match.start() >= start]
    changed = bytearray(content)
    for at in rng.sample(digits, min(len(digits), rng.choice([1, 3, 10]))):
        changed[at] = rng.choice(b"0123456789")
    return bytes(changed)


def change_count(rng, extension, content):
    """Counts are among a file's first numbers, or in an attribute."""
    if extension == ".stl" and len(content) > 84 and not content.startswith(b"solid"):
        count = rng.choice([0, 1, 0x80000000, 0xffffffff, len(content) // 50, rng.getrandbits(32)])
        return content[:80] + struct.pack("<I", count) + content[84:]
    counts = list(re.finditer(rb'(?:count|stride|offset)="(\d+)"', content))
    if not counts:
        return replace_number(rng, content, COUNTS, 8)
    chosen = rng.choice(counts)
    return content[:chosen.start(1)] + rng.choice(COUNTS).encode() + content[chosen.end(1):]


def insert_statement(rng, extension, content):
    statement = rng.choice(STATEMENTS.get(extension, ["#"])).encode()
    if extension == ".dae":
        at = content.find(b">", spot(rng, content)) + 1
        return content[:at] + statement + content[at:]
    lines = content.split(b"\n")
    lines.insert(rng.randrange(len(lines)), statement)
    return b"\n".join(lines)


def change_blanks(rng, extension, content):
    old, new = rng.choice([("\n", "\r"), ("\n", "\r\n"), ("\n", "\f"), ("\n", " \n"), ("\n", "\\\n"), ("\n", "\n\n"),
                           (" ", "\t"), (" ", "  "), (" ", "\v"), (".", ","), ("0", "00")])
    return content.replace(old.encode(), new.encode(), rng.choice([1, 3, -1]))


def prepend(rng, extension, content):
    return rng.choice([b"\xef\xbb\xbf", b"\xff\xfe", b"\0", b"#\n", b" ", b"\n\n", b"solid ", b"ply\n"]) + content


def change_tags(rng, extension, content):
    """Renames a tag, or an id, or nests an element in a copy of itself."""
    tags = sorted(set(re.findall(rb"</?(\w+)", content)))
    if not tags:
        return move_lines(rng, extension, content)
    tag = rng.choice(tags)
    if rng.random() < .4:
        return re.sub(rb"(</?)" + tag + rb"\b", rb"\1" + rng.choice(tags + [b"other"]), content)
    if rng.random() < .5:
        value = rng.choice([b"#shape", b"outer", b"#outer", b"", b"#", b"&#111;uter"])
        return re.sub(rb'(id|url|source)="#?(\w+)"', rb'\1="' + value + b'"', content, count=rng.choice([1, 2, 5]))
    return re.sub(rb"<" + tag + rb"\b([^>]*[^/])?>", lambda match: match.group() * rng.choice([2, 3, 3000]), content, count=1)


MUTATIONS = [change_digits, change_digits, change_digits, flip_bits, overwrite_four_bytes, cut_off, drop_piece, double_piece,
             move_lines, respell_number, respell_number, change_count, change_count, insert_statement, insert_statement, change_blanks,
             prepend, change_tags]


def mutated(rng, extension, content):
    for _ in range(rng.choice([1, 1, 1, 1, 2, 3])):
        usable = [each for each in MUTATIONS if each is not change_tags or extension == ".dae"]
        content = rng.choice(usable)(rng, extension, content) or b" "
    return content
