"""A second reader of OBJ, OFF, PLY and STL, written apart from the package's, and the check that hulls hold what it reads.

It takes what doc/limits.md says that the package takes, and raises ValueError for all else. Standard library only.
"""
import math
import re
import struct

LINE_END = re.compile(r"\r\n|[\n\r\f]")
WORD = re.compile(r"[^ \t\n\r\f]+")
NUMBER = re.compile(r"[+-]?((\d+\.?\d*|\.\d+)(e[+-]?\d+)?|nan|inf|infinity)", re.ASCII | re.IGNORECASE)
INTEGER = re.compile(r"-?\d+", re.ASCII)
BYTE_ORDER_MARK = "\xef\xbb\xbf"  # of UTF-8, decoded as Latin-1
OBJ_WITHOUT_SURFACE = frozenset("vt vn vp g o s mg usemtl mtllib usemap maplib bevel c_interp d_interp lod shadow_obj trace_obj".split())
STL_HEADER, STL_FACET = 84, 50  # bytes
PLY_TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d",
             "int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}
MOST_POINTS = 400  # of a mesh that are looked for in its hulls


def number(word):
    """What a word spells: float() takes "1_000" and digits of other scripts as well."""
    if not NUMBER.fullmatch(word):
        raise ValueError(f"{word!r} is no number")
    return float(word)


def integer(word):
    if not INTEGER.fullmatch(word):
        raise ValueError(f"{word!r} is no integer")
    return int(word)


def single(value):
    try:
        return struct.unpack("<f", struct.pack("<f", value))[0]
    except OverflowError:
        return math.copysign(math.inf, value)


def point(words):
    if len(words) != 3:
        raise ValueError("a point has three coordinates")
    return tuple(single(number(word)) for word in words)


def text_of(content):
    if b"\0" in content:
        raise ValueError("a zero byte in a text")
    text = content.decode("latin-1")
    return text[len(BYTE_ORDER_MARK):] if text.startswith(BYTE_ORDER_MARK) else text


def uncommented(line):
    words = WORD.findall(line)
    comment = next((i for i, word in enumerate(words) if word.startswith("#")), len(words))
    return words[:comment]


def obj_statements(text):
    """The words of each statement, which goes on in the next line after a backslash."""
    lines = iter(LINE_END.split(text))
    for line in lines:
        while line.endswith("\\"):
            line = line[:-1] + " " + next(lines, "")
        words = uncommented(line)
        if words:
            yield words


def obj_index(word, count):
    """Which vertex a corner such as 3//1 or -1/2 names."""
    parts = word.split("/")
    index = integer(parts[0])
    if len(parts) > 3 or index == 0 or index < -count:
        raise ValueError(f"{word!r} is no corner")
    for part in parts[1:]:
        integer(part or "0")
    return index - 1 if index > 0 else count + index


def obj_vertex(words):
    numbers = [number(word) for word in words]
    if len(numbers) not in (3, 4, 6) or (len(numbers) == 4 and numbers[3] != 1):
        raise ValueError("not a vertex")
    return point(words[:3])


def read_obj(content):
    points, faces = [], []
    for keyword, *words in obj_statements(text_of(content)):
        if keyword == "v":
            points.append(obj_vertex(words))
        elif keyword in ("f", "fo"):
            faces.append([obj_index(word, len(points)) for word in words])
        elif keyword in ("l", "p"):
            for word in words:
                obj_index(word, len(points))
        elif keyword not in OBJ_WITHOUT_SURFACE:
            raise ValueError(f"unknown statement {keyword!r}")
    return polygons(points, faces)


def read_off(content):
    lines = [words for words in map(uncommented, LINE_END.split(text_of(content))) if words]
    if lines and re.fullmatch("(ST)?C?N?OFF", lines[0][0]):
        lines[0] = lines[0][1:]
        lines = lines if lines[0] else lines[1:]
    if not lines or len(lines[0]) not in (2, 3):
        raise ValueError("no header")
    vertices, faces = [integer(word) for word in lines[0]][:2]
    if min(vertices, faces) < 0 or len(lines) != 1 + vertices + faces:
        raise ValueError("not as many lines as announced")
    return polygons([point(words[:3]) for words in lines[1:1 + vertices]], [off_face(words) for words in lines[1 + vertices:]])


def off_face(words):
    count = integer(words[0])
    if not 0 < count < len(words):
        raise ValueError("a face without its corners")
    return [integer(word) for word in words[1:1 + count]]


def read_stl(content):
    if len(content) >= STL_HEADER and len(content) == STL_HEADER + STL_FACET * struct.unpack_from("<I", content, STL_HEADER - 4)[0]:
        facets = [struct.unpack_from("<9f", content, start + 12) for start in range(STL_HEADER, len(content), STL_FACET)]
        points = [facet[i:i + 3] for facet in facets for i in (0, 3, 6)]
    else:
        points = stl_text_points(text_of(content))
    return polygons(points, [[i, i + 1, i + 2] for i in range(0, len(points), 3)])


def stl_text_points(text):
    """A solid's lines first, whose names may hold any word; then nothing but facets may be left."""
    body, inside = [], False
    for line in LINE_END.split(text):
        words = WORD.findall(line)
        if words and words[0] == ("endsolid" if inside else "solid"):
            inside = not inside
        elif words and not inside:
            raise ValueError("something between the solids")
        elif words:
            rest = words.index("endsolid") if "endsolid" in words else len(words)
            body += words[:rest]
            inside = rest == len(words)
    if inside or len(body) % 21:
        raise ValueError("a facet or solid is cut off")
    return [corner for start in range(0, len(body), 21) for corner in facet_points(body[start:start + 21])]


def facet_points(words):
    """facet normal x y z outer loop, three times vertex x y z, endloop endfacet"""
    frame = words[:2] + words[5:7] + words[7:19:4] + words[19:]
    if frame != ["facet", "normal", "outer", "loop", "vertex", "vertex", "vertex", "endloop", "endfacet"]:
        raise ValueError("not a facet")
    return [point(words[i:i + 3]) for i in (8, 12, 16)]


def ply_header(text):
    """The format and [(element, rows, [property])], a property being (name, type) or (name, type of count, type of values)."""
    lines = [WORD.findall(line) for line in text.splitlines() if line.strip() and WORD.findall(line)[0] not in ("comment", "obj_info")]
    if lines[:1] != [["ply"]] or lines[1:2] not in [[["format", kind, "1.0"]] for kind in PLY_VALUES]:
        raise ValueError("no header")
    elements = []
    for words in lines[2:]:
        if words[0] == "element" and len(words) == 3:
            elements.append((words[1], integer(words[2]), []))
        elif words[0] == "property" and elements and len(words) == (5 if words[1] == "list" else 3):
            elements[-1][2].append((words[-1], *(PLY_TYPES[word] for word in words[1:-1] if word != "list")))
        else:
            raise ValueError(f"unknown line {words}")
    return lines[1][1], elements


def text_values(data):
    words = iter(WORD.findall(data.decode("latin-1")))

    def value(kind):
        if kind in "fd":
            return number(next(words))
        return struct.unpack("<" + kind, struct.pack("<" + kind, integer(next(words))))[0]  # refuses what its type cannot hold
    return value


def binary_values(order):
    def values(data):
        place = [0]

        def value(kind):
            place[0] += struct.calcsize(kind)
            return struct.unpack_from(order + kind, data, place[0] - struct.calcsize(kind))[0]
        return value
    return values


PLY_VALUES = {"ascii": text_values, "binary_little_endian": binary_values("<"), "binary_big_endian": binary_values(">")}


def ply_row(properties, value):
    """{property: its value, or list of values}"""
    return {name: value(kinds[0]) if len(kinds) == 1 else [value(kinds[1]) for _ in range(value(kinds[0]))] for name, *kinds in properties}


def read_ply(content):
    end = re.search(rb"\bend_header[ \t]*(\r\n|\n|\r)", content)
    try:
        kind, elements = ply_header(content[:end.start()].decode("latin-1"))
        value = PLY_VALUES[kind](content[end.end():])
        rows = {name: [ply_row(properties, value) for _ in range(count)] for name, count, properties in elements}
        faces = [row["vertex_indices"] if "vertex_indices" in row else row["vertex_index"] for row in rows["face"]]
        return polygons([tuple(single(row[axis]) for axis in "xyz") for row in rows["vertex"]], faces)
    except (AttributeError, KeyError, TypeError, StopIteration, struct.error) as error:
        raise ValueError(f"not a PLY file: {error!r}") from error


def polygons(points, faces):
    """The faces as lists of points: those with fewer than three corners are no surface."""
    if any(not 0 <= corner < len(points) for face in faces for corner in face):
        raise ValueError("an index beyond the vertices")
    result = [[points[corner] for corner in face] for face in faces if len(face) >= 3]
    if not result or not all(math.isfinite(x) for polygon in result for corner in polygon for x in corner):
        raise ValueError("no face, or one with a corner that is not finite")
    return result


READERS = {".obj": read_obj, ".off": read_off, ".ply": read_ply, ".stl": read_stl}


def half_spaces(polygons_of_hull):
    """[(unit normal, offset)] of a convex mesh whose faces look outward. The offset is that of the furthest vertex, not of the face: a
    sliver may be tilted by rounding."""
    points = sorted({corner for polygon in polygons_of_hull for corner in polygon})
    planes = []
    for a, b, c, *_ in polygons_of_hull:
        u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
        normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        length = math.sqrt(sum(x * x for x in normal))
        if length > 0:
            unit = tuple(x / length for x in normal)
            planes.append((unit, max(dot(unit, p) for p in points)))
    return planes


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def surface_points(mesh):
    """All corners, and the centroids of triangles; evenly spread ones if those are too many."""
    points = sorted({corner for polygon in mesh for corner in polygon})
    points += [tuple(sum(x) / 3 for x in zip(*polygon)) for polygon in mesh if len(polygon) == 3]
    return points[::1 + len(points) // MOST_POINTS]


def outside(mesh, hulls):
    """A point of the mesh's surface that none of the hulls holds, each given by its polygons; None if there is none."""
    spaces = [half_spaces(hull) for hull in hulls]
    tolerance = 1e-5 * max(abs(x) for polygon in mesh for corner in polygon for x in corner)  # as far as vertices are welded
    for each in surface_points(mesh):
        if not any(planes and all(dot(normal, each) <= offset + tolerance for normal, offset in planes) for planes in spaces):
            return each
    return None
