"""Attacks through descriptions and scenes: what they name, how large they are, how they nest. Standard library only."""
import os
import shutil

import hostile_meshes as hostile
from arena import PACKAGE, QUICK, description, robot_of_three, rows_of

MOST_WORDS = 30000  # bytes of errors, tables, reports: what is long is shortened
CANARY = "made_by_a_uri"  # a file that shows that a URI was run as a command


def hostile_files(folder):
    """{link: URI} of what is no mesh, or must not be read."""
    os.mkfifo(folder / "fifo.stl")
    with open(folder / "sparse.stl", "wb") as sparse:
        sparse.truncate(1 << 40)
    (folder / "folder.stl").mkdir()
    (folder / "loop.stl").symlink_to("loop.stl")
    (folder / "zero.stl").symlink_to("/dev/zero")
    (folder / "empty.stl").touch()
    uris = ["fifo.stl", "sparse.stl", "folder.stl", "loop.stl", "zero.stl", "empty.stl", "file:///dev/tty", "file:///dev/full",
            "/proc/self/mem", "package://-x/mesh.stl", "package://--help/mesh.stl", "package:///mesh.stl", "package://../mesh.stl",
            "package://collision_hulls/../../etc/passwd", "package://collision_hulls/%2e%2e/%2e%2e/etc/passwd",
            f"package://a;touch {CANARY}/mesh.stl", f"package://$(touch {CANARY})/mesh.stl", "mesh%00.stl", "%00", "mesh&#10;.stl",
            "mesh%0a.stl", "http://localhost/mesh.stl", "file://other_host/mesh.stl", "x" * 5000 + ".stl", "../" * 1000 + "mesh.stl"]
    return {f"bad_{i}": uri for i, uri in enumerate(uris)}


def hostile_texts():
    """{what: description} that must be refused or read, but not slowly."""
    link = "<link name='a'><collision><geometry><mesh filename='good.obj'/></geometry></collision></link>"
    between = "</link><link name='a'>"
    joint = "<joint name='%s' type='fixed'><parent link='a'/><child link='%s'/></joint>"
    attributes = " ".join(f"a{i}='x'" for i in range(40000))
    names = ["a", *(f"l{i}" for i in range(5000))]
    chain = "".join(f"<link name='{child}'/><joint name='to_{child}' type='fixed'><parent link='{parent}'/><child link='{child}'/></joint>"
                    for parent, child in zip(names, names[1:]))
    entities = "".join(f"<!ENTITY e{i} '{10 * f'&e{i - 1};'}'>" for i in range(1, 12))
    return {
        "40,000 attributes": f"<robot name='r'>{link}<link name='b' {attributes}/></robot>",
        "a link's name of 100 kB": f"<robot name='r'>{link}<link name='{100000 * 'n'}'/></robot>",
        "a robot's name of 100 kB": f"<robot name='{100000 * 'n'}'>{link}</robot>",
        "a URI of 1 MB": f"<robot name='r'>{link.replace('good', 1000000 * 'u')}</robot>",
        "a URI of 1 MB beside a mesh": f"<robot name='r'>{(link + link).replace('good', 1000000 * 'u', 1).replace(between, '')}</robot>",
        "an element's name of 1 MB": f"<robot name='r'>{link.replace('mesh', 1000000 * 'm')}</robot>",
        "an attribute's name of 1 MB": f"<robot name='r'>{link.replace('filename', 1000000 * 'm')}</robot>",
        "a scale of 1 MB": f"<robot name='r'>{link.replace('/></g', ' scale=%s/></g' % repr(1000000 * '1'))}</robot>",
        "a tag of 1 MB that is not closed": f"<robot name='r'><{1000000 * 't'}>{link}</robot>",
        "a joint's name of 1 MB": f"<robot name='r'>{link}<link name='b'/>{joint % (1000000 * 'j', 'b')}</robot>",
        "a joint's parent of 1 MB": f"<robot name='r'>{link}<link name='b'/>{joint % ('j', 1000000 * 'p')}</robot>",
        "10,000 elements without geometry": f"<robot name='r'>{link}<link name='b'>{10000 * '<visual/>'}</link>{joint % ('j', 'b')}</robot>",
        "20,000 nested elements": f"<robot name='r'>{link}{20000 * '<a>'}{20000 * '</a>'}</robot>",
        "a chain of 5,000 links": f"<robot name='r'>{link}{chain}</robot>",
        "entities of entities": f"<!DOCTYPE r [<!ENTITY e0 'x'>{entities}]><robot name='r'>{link}<link name='&e11;'/></robot>",
        "an entity of a file": f"<!DOCTYPE r [<!ENTITY e SYSTEM 'file:///etc/passwd'>]><robot name='&e;'>{link}</robot>",
        "a link in a circle": f"<robot name='r'>{link}<joint name='j' type='fixed'><parent link='a'/><child link='a'/></joint></robot>",
        "a zero byte": f"<robot name='r\0'>{link}</robot>",
        "odd scales": f"<robot name='r'>{link.replace('/></g', ' scale=%s/></g' % repr('nan 1e39 -0'))}</robot>",
        "nothing": "",
        "open elements": "<robot name='r'><link name='a'" + 100000 * "<",
    }


def check_text(arena, robot, what, text, program, options):
    """An output only if a mesh is done; and nothing repeats what is long."""
    output = arena.work / "texts_out"
    robot.write_text(text, encoding="utf-8")
    shutil.rmtree(output, ignore_errors=True)
    run = arena.run(program, robot, "-o", output, "--no-validate", "-t", "5%", *options)
    done = output.is_dir() and any(row["status"] != "failed" for row in rows_of(output).values())
    arena.expect(output.is_dir() == done and (done or run.status != 0),
                 f"{program} on {what} ends with {run.status}: {run.command}\n{run.errors[:2000]}", robot)
    words = {"errors": run.errors, "standard output": run.out}
    if done:
        words["report"] = (output / "report.json").read_text(encoding="utf-8")
    for name, written in words.items():
        arena.expect(len(written) < MOST_WORDS, f"{program} on {what}: {len(written)} bytes of {name}: {run.command}", robot)


def attack_descriptions(arena, rng):
    """Hostile links, URIs and texts: failed rows or clear errors, and nothing else is read or run."""
    folder, output = arena.folder("hostile"), arena.work / "hostile_out"
    (folder / "good.obj").write_bytes(hostile.obj(hostile.bracket()))
    uris = hostile_files(folder)
    robot = folder / "links.urdf"
    robot.write_text(description({"good": "good.obj", **uris}).replace("&amp;#10;", "&#10;"), encoding="utf-8")
    run = arena.run("decompose", robot, "-o", output, *QUICK)
    if arena.expect(run.status == 1 and output.is_dir(), f"hostile links end with {run.status}: {run.command}\n{run.errors[:2000]}"):
        rows = rows_of(output)
        arena.expect(rows["good"]["status"] == "ok", f"the good mesh is {rows['good']['status']}: {rows['good']['reason']}")
        for name, uri in uris.items():
            arena.expect(rows[name]["status"] == "failed" and rows[name]["reason"], f"{uri[:100]} is {rows[name]['status']}: {run.command}")
    arena.expect(not (arena.work / CANARY).exists(), f"a URI is run as a command: {run.command}", robot)
    texts = hostile_texts()
    scene = ("--scene", PACKAGE / "test/data/scenes/empty.yaml", "--clearance", "2cm", "--samples", "100")
    for what, text in texts.items():
        check_text(arena, folder / "victim.urdf", what, text, "decompose", ("-m", "single_hull"))
        check_text(arena, folder / "victim.urdf", what, text, "fit_scene", scene)
    return f"{len(uris)} links, {len(texts)} texts"


def attack_scenes(arena, rng):
    """Hostile scenes for fit_scene: a message, and no output; or an output, if the damage leaves a scene."""
    robot, folder = robot_of_three(arena, "scenes_robot"), arena.folder("scenes")
    os.mkfifo(folder / "fifo.yaml")
    (folder / "zero.yaml").symlink_to("/dev/zero")
    with open(folder / "sparse.bt", "wb") as sparse:
        sparse.truncate(1 << 40)
    (folder / "deep.yaml").write_text(100000 * "[")
    aliases = [f"a{i}: &a{i} [{', '.join(10 * [f'*a{i - 1}'])}]\n" for i in range(1, 12)]
    (folder / "aliases.yaml").write_text("a0: &a0 [x]\n" + "".join(aliases))
    (folder / "deep.sdf").write_text("<sdf>" + 20000 * "<model>")
    hopeless = sorted(folder.iterdir())
    table = (PACKAGE / "test/data/scenes/table.yaml").read_bytes()
    for i in range(10):
        (folder / f"table_{i}.yaml").write_bytes(hostile.mutated(rng, ".yaml", table))
        extension, content = rng.choice(hostile.seed_meshes(PACKAGE / "meshes")[:15])
        (folder / f"mesh_{i}{extension}").write_bytes(hostile.mutated(rng, extension, content))
    for scene in sorted(folder.iterdir()):
        output = arena.work / "scenes_out"
        shutil.rmtree(output, ignore_errors=True)
        run = arena.run("fit_scene", robot, "--scene", scene, "--clearance", "2cm", "--samples", "50", "-o", output, *QUICK)
        arena.expect(run.status == 2 or scene not in hopeless, f"{scene.name} is taken for a scene: {run.command}")
        arena.expect(output.is_dir() == (run.status == 0), f"{scene.name}: exit status {run.status}, and an output or not: {run.command}")
    return f"{len(hopeless) + 20} scenes"
