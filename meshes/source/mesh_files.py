"""Triangle meshes from OpenSCAD, and writers for binary STL, OBJ and Collada. Standard library only.

Every writer gives the same bytes for the same mesh: vertices and faces are sorted, numbers are rounded to 7 digits.
"""
import collections
import math
import struct

Mesh = collections.namedtuple("Mesh", "vertices faces")  # [(x, y, z)], [(i, j, k)] counter-clockwise seen from outside
Node = collections.namedtuple("Node", "name mesh material placement")  # a Collada node; placement: its transform elements
Material = collections.namedtuple("Material", "name rgb")


def read_off(text):
    """Reads a mesh from OpenSCAD's OFF: faces become fans of triangles, in a canonical order."""
    rows = [line.split() for line in text.splitlines() if line.strip()]
    count, face_count = int(rows[0][1]), int(rows[0][2])
    points = [tuple(float(number) + 0.0 for number in row[:3]) for row in rows[1:1 + count]]
    vertices = sorted(set(points))
    index = {point: i for i, point in enumerate(vertices)}
    polygons = [[index[points[int(i)]] for i in row[1:1 + int(row[0])]] for row in rows[1 + count:1 + count + face_count]]
    triangles = [(p[0], p[i], p[i + 1]) for p in polygons for i in range(1, len(p) - 1)]
    return Mesh(vertices, sorted(starting_lowest(t) for t in triangles if len(set(t)) == 3))


def starting_lowest(face):
    start = face.index(min(face))
    return tuple(face[start:] + face[:start])


def scaled(mesh, factor):
    return Mesh([tuple(factor * c for c in v) for v in mesh.vertices], mesh.faces)


def y_up(mesh):
    """The mesh in a frame with y up instead of z: (x, y, z) becomes (x, z, -y)."""
    return Mesh([(x, z, -y + 0.0) for x, y, z in mesh.vertices], mesh.faces)


def volume(mesh):
    corners = ([mesh.vertices[i] for i in face] for face in mesh.faces)
    return sum(dot(a, cross(b, c)) for a, b, c in corners) / 6


def check_solid(name, mesh):
    """Raises ValueError unless the mesh is a closed, consistently oriented 2-manifold that faces outward."""
    edges = collections.Counter((face[i - 1], face[i]) for face in mesh.faces for i in range(3))
    bad = [edge for edge, uses in edges.items() if uses != 1 or edges[edge[::-1]] != 1]
    if bad:
        raise ValueError(f"{name}: {len(bad)} edges are not shared by exactly two faces, the first at {mesh.vertices[bad[0][0]]}")
    if volume(mesh) <= 0:
        raise ValueError(f"{name}: the volume is {volume(mesh):g}, so the faces point inward")
    if not 100 <= len(mesh.faces) <= 8000:
        raise ValueError(f"{name}: {len(mesh.faces)} triangles, wanted are 100 to 8,000")


def write_stl(path, mesh):
    """Writes binary STL."""
    facets = []
    for face in mesh.faces:
        a, b, c = (mesh.vertices[i] for i in face)
        facets.append(struct.pack("<12fH", *normal(a, b, c), *a, *b, *c, 0))
    path.write_bytes(path.stem.encode().ljust(80, b" ") + struct.pack("<I", len(facets)) + b"".join(facets))


def write_obj(path, mesh, material, library):
    """Writes OBJ with flat pairs of triangles merged into quads; the colour comes from the material library beside it."""
    lines = [f"mtllib {library}", f"o {path.stem}"]
    lines += ["v " + " ".join(number(c) for c in v) for v in mesh.vertices]
    lines += [f"usemtl {material.name}", "s off"]
    lines += ["f " + " ".join(str(i + 1) for i in face) for face in with_quads(mesh)]
    path.write_text("\n".join(lines) + "\n")


def write_mtl(path, materials):
    rows = [[f"newmtl {m.name}", "Ka " + rgb(m), "Kd " + rgb(m), "Ks 0.2 0.2 0.2", "Ns 20", "illum 2"] for m in materials]
    path.write_text("\n\n".join("\n".join(row) for row in rows) + "\n")


def write_dae(path, up_axis, unit, metres, nodes):
    """Writes Collada 1.4: one geometry per mesh, one material per colour, one instance per node."""
    meshes = unique((node.mesh[0], node.mesh[1]) for node in nodes)
    materials = unique(node.material for node in nodes)
    path.write_text(f"""<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><created>2000-01-01T00:00:00Z</created><modified>2000-01-01T00:00:00Z</modified>
<unit name="{unit}" meter="{metres}"/><up_axis>{up_axis}</up_axis></asset>
<library_effects>
{lines(effect(m) for m in materials)}
</library_effects>
<library_materials>
{lines(f'<material id="{m.name}"><instance_effect url="#{m.name}-effect"/></material>' for m in materials)}
</library_materials>
<library_geometries>
{lines(geometry(name, mesh) for name, mesh in meshes)}
</library_geometries>
<library_visual_scenes><visual_scene id="scene">
{lines(scene_node(node) for node in nodes)}
</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
""")


def effect(material):
    return (f'<effect id="{material.name}-effect"><profile_COMMON><technique sid="common"><lambert><ambient><color>{rgb(material)} 1'
            f'</color></ambient><diffuse><color>{rgb(material)} 1</color></diffuse></lambert></technique></profile_COMMON></effect>')


def geometry(name, mesh):
    positions = "\n".join(" ".join(number(c) for c in v) for v in mesh.vertices)
    corners = "\n".join(" ".join(map(str, face)) for face in mesh.faces)
    return f"""<geometry id="{name}"><mesh>
<source id="{name}-positions"><float_array id="{name}-array" count="{3 * len(mesh.vertices)}">
{positions}
</float_array><technique_common><accessor source="#{name}-array" count="{len(mesh.vertices)}" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="{name}-vertices"><input semantic="POSITION" source="#{name}-positions"/></vertices>
<triangles material="paint" count="{len(mesh.faces)}"><input semantic="VERTEX" source="#{name}-vertices" offset="0"/><p>
{corners}
</p></triangles></mesh></geometry>"""


def scene_node(node):
    return (f'<node id="{node.name}-node">{node.placement}<instance_geometry url="#{node.mesh[0]}"><bind_material><technique_common>'
            f'<instance_material symbol="paint" target="#{node.material.name}"/></technique_common></bind_material></instance_geometry></node>')


def with_quads(mesh):
    """The faces, each merged with the first neighbour with which it forms a flat, strictly convex quad."""
    owner = {(face[i - 1], face[i]): face for face in mesh.faces for i in range(3)}
    faces, used = [], set()
    for face in mesh.faces:
        if face in used:
            continue
        used.add(face)
        joined = face
        for i in range(3):
            a, b, c = face[i - 1], face[i], face[(i + 1) % 3]
            other = owner[(b, a)]
            d = next(v for v in other if v not in (a, b))
            if other not in used and is_flat_convex([mesh.vertices[v] for v in (a, d, b, c)]):
                used.add(other)
                joined = starting_lowest((a, d, b, c))
                break
        faces.append(joined)
    return faces


def is_flat_convex(quad):
    normals = [normal(quad[i - 1], quad[i], quad[(i + 1) % 4]) for i in range(4)]
    return all(dot(normals[0], n) > 1 - 1e-9 for n in normals)


def normal(a, b, c):
    n = cross([q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)])
    length = math.sqrt(dot(n, n))
    return tuple(x / length for x in n) if length else (0.0, 0.0, 0.0)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def number(value):
    return f"{value:.7g}"


def rgb(material):
    return " ".join(number(c) for c in material.rgb)


def lines(items):
    return "\n".join(items)


def unique(items):
    result = []
    for item in items:
        if item not in result:
            result.append(item)
    return result
