"""Attacks on the reading of meshes: mutated files, odd numbers, files that change. Standard library only."""
import hashlib
import os
import shutil
import threading
import time

import hostile_meshes as hostile
import strict_mesh
from arena import PACKAGE, QUICK, hulls_of, in_folder, report_of, rows_of

METHODS = ["certified", "certified", "hacd", "acd", "single_hull", "bounding_box"]
MESHES_A_BATCH = 11


def polygons_of(file):
    """What the strict reader takes a file for; None if it refuses it."""
    try:
        return strict_mesh.READERS[file.suffix](file.read_bytes())
    except ValueError:
        return None


def check_cover(arena, output, row, file, command):
    """A row that is done covers the mesh that the strict reader reads."""
    if row["status"] == "failed":
        arena.expect(row["reason"], f"a failed row without a reason: {command}", file)
    elif file.suffix in strict_mesh.READERS:
        mesh = polygons_of(file)
        if arena.expect(mesh, f"'{row['link']}' is {row['status']}, but the strict reader refuses it: {command}", file):
            bare = strict_mesh.outside(mesh, hulls_of(output, row))
            arena.expect(bare is None, f"'{row['link']}' is {row['status']}, but no hull holds {bare}: {command}", file)


def attack_meshes(arena, rng):
    """Mutated meshes of all formats, a good one among them: that one is done, and so is no other that is not covered."""
    seeds = hostile.seed_meshes(PACKAGE / "meshes")
    done = 0
    for batch in range(arena.batches):
        folder, output = arena.folder("meshes"), arena.work / "meshes_out"
        meshes = {"good": (".obj", hostile.obj(hostile.bracket()))}
        for i in range(MESHES_A_BATCH):
            extension, content = rng.choice(seeds)
            meshes[f"bad_{batch}_{i}"] = (extension, hostile.mutated(rng, extension, content))
        files, robot = in_folder(folder, meshes)
        run = arena.run("decompose", robot, "-o", output, "-m", rng.choice(METHODS), *QUICK)
        whole = run.status in (0, 1) and output.is_dir()
        if not arena.expect(whole, f"one bad mesh loses the others: {run.command}\n{run.errors[:2000]}", *files.values()):
            continue
        rows = rows_of(output)
        arena.expect(rows["good"]["status"] != "failed", f"the good mesh failed: {rows['good']['reason']}", *files.values())
        for name, file in files.items():
            check_cover(arena, output, rows[name], file, run.command)
        done += sum(row["status"] != "failed" for row in rows.values()) - 1
        shutil.rmtree(output)
    arena.expect(done >= arena.batches, "hardly any mutated mesh is read at all, so nothing was compared")
    return f"{arena.batches * MESHES_A_BATCH} meshes, {done} of them read"


def meaning(word):
    """The number that a word spells, in single precision; None for none."""
    try:
        return strict_mesh.single(strict_mesh.number(word))
    except ValueError:
        return None


def check_spelling(arena, output, row, file, word):
    wanted = meaning(word)
    if row["status"] == "failed":
        arena.expect(word not in hostile.PLAIN_SPELLINGS, f"{file.suffix}: {word!r} is refused: {row['reason']}", file)
        return
    reach = [corner[0] for hull in hulls_of(output, row) for polygon in hull for corner in polygon]
    slack = 1e-4 * max(1, abs(wanted or 0)) + row["thickness"]
    agrees = wanted is not None and abs(min(reach) - min(wanted, 0)) < slack and abs(max(reach) - max(wanted, 0)) < slack
    arena.expect(agrees, f"{file.suffix}: {word!r} is not taken for {wanted}: the hull is from {min(reach)} to {max(reach)}", file)


def attack_numbers(arena, rng):
    """One coordinate in many spellings: what is accepted is the number that float() takes it for."""
    folder, output = arena.folder("numbers"), arena.work / "numbers_out"
    words = {f"{extension[1:]}_{i}": (extension, word) for i, word in enumerate(hostile.PLAIN_SPELLINGS + hostile.ODD_SPELLINGS)
             for extension in hostile.TEXT_WRITERS}
    corner = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
    meshes = {name: (extension, hostile.TEXT_WRITERS[extension](([(word, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 0)], corner)))
              for name, (extension, word) in words.items()}
    files, robot = in_folder(folder, meshes)
    run = arena.run("decompose", robot, "-o", output, "-m", "single_hull", *QUICK)
    if arena.expect(output.is_dir(), f"nothing was written: {run.command}\n{run.errors[:2000]}"):
        rows = rows_of(output)
        for name, (_, word) in words.items():
            check_spelling(arena, output, rows[name], files[name], word)
    return f"{len(words)} spellings"


def cube(side):
    """With a comment that makes it long enough to be exchanged while it is read."""
    vertices = [tuple(side * bool(x) for x in vertex) for vertex in hostile.BOX[0]]
    return hostile.obj((vertices, hostile.BOX[1])) + b"#" * 2_000_000 + b"\n"


class Flipping:
    """A link that leads to one of two files, and to the other one in the next moment."""

    def __init__(self, link, files, rng):
        self.link, self.files, self.rng = link, files, rng
        self.stopped = threading.Event()
        self.thread = threading.Thread(target=self.flip)

    def flip(self):
        new = self.link.with_name("new_link")
        while not self.stopped.is_set():
            for file in self.files:
                new.symlink_to(file)
                new.replace(self.link)
                time.sleep(self.rng.uniform(0, .05))

    def __enter__(self):
        self.link.symlink_to(self.files[0])
        self.thread.start()

    def __exit__(self, *error):
        self.stopped.set()
        self.thread.join()


def check_side(arena, output, sides, command):
    """The hulls are those of the file that has the reported hash."""
    row = report_of(output)["links"][0]
    reach = max(x for hull in hulls_of(output, row) for polygon in hull for corner in polygon for x in corner)
    side = sides.get(row["sha256"])
    arena.expect(side and abs(reach - side) < .01, f"the hash of a cube of {side}, the hulls of one of {reach}: {command}")


def attack_changing_file(arena, rng):
    """A mesh that flips between two contents: hash, hulls and the cache's entry are of one of them."""
    folder, output, cache = arena.folder("changing"), arena.work / "changing_out", arena.work / "changing_cache"
    files = {side: folder / f"cube_{side}.obj" for side in (1, 2)}
    for side, file in files.items():
        file.write_bytes(cube(side))
        os.utime(file, (1e9, 1e9))
    sides = {hashlib.sha256(file.read_bytes()).hexdigest(): side for side, file in files.items()}
    tolerances = [f"{5 + i / 100}%" for i in range(20)]

    def run(mesh, tolerance):
        shutil.rmtree(output, ignore_errors=True)
        ended = arena.run("decompose", mesh, "-o", output, "-m", "single_hull", "--no-validate", "--quiet", "-t", tolerance, cache=cache)
        if output.is_dir():
            check_side(arena, output, sides, ended.command)
        else:
            arena.expect("changed while" in ended.errors, f"failed for another reason than the change: {ended.command}\n{ended.errors}")
        return output.is_dir()

    with Flipping(folder / "mesh.obj", list(files.values()), rng):
        done = sum(run(folder / "mesh.obj", tolerance) for tolerance in tolerances)
    for tolerance in tolerances:
        for file in files.values():
            arena.expect(run(file, tolerance), f"{file} fails when nothing changes any more", file)
    return f"{len(tolerances)} runs during changes, {done} of them done"
