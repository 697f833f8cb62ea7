"""Runs the package's programs in a folder of their own, and collects what went wrong. Standard library only."""
import collections
import hashlib
import json
import os
import pathlib
import resource
import shlex
import shutil
import signal
import struct
import subprocess
import tempfile
from xml.sax.saxutils import quoteattr

import hostile_meshes as hostile

PACKAGE = pathlib.Path(__file__).resolve().parent.parent.parent
QUICK = ("--no-validate", "--quiet", "-t", "5%")
PATIENCE = 120  # s, after which a run counts as hung; none comes near it

Ended = collections.namedtuple("Ended", "status out errors command")


class Arena:
    """A work folder, which stays if something went wrong."""

    def __init__(self, programs, seed, batches):
        self.programs, self.seed, self.batches = pathlib.Path(programs).resolve(), seed, batches
        self.work = pathlib.Path(tempfile.mkdtemp(prefix="attacks-"))
        self.faults = []

    def folder(self, name):
        """A new, empty folder."""
        result = self.work / name
        shutil.rmtree(result, ignore_errors=True)
        result.mkdir(parents=True)
        return result

    def start(self, program, *arguments, cache=None, file_bytes=None):
        """A process that runs a program; `file_bytes`: the largest file that it may write."""
        def limit():
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            if file_bytes is not None:
                resource.setrlimit(resource.RLIMIT_FSIZE, (file_bytes, file_bytes))
        command = [str(self.programs / program), *map(str, arguments), *([] if cache else ["--no-cache"])]
        environment = dict(os.environ, HOME=str(self.work), COLLISION_HULLS_CACHE=str(cache or self.work / "cache"))
        return subprocess.Popen(command, env=environment, cwd=self.work, preexec_fn=limit,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def ended(self, process):
        """Waits for a process. A hang is a fault."""
        try:
            texts = process.communicate(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            texts = process.communicate()
            self.fault(f"still running after {PATIENCE} s: {shlex.join(process.args)}")
        return Ended(process.returncode, *(text.decode("utf-8", "replace") for text in texts), shlex.join(process.args))

    def run(self, program, *arguments, **limits):
        """A run to its end. A signal, or a failure without a word, is a fault."""
        run = self.ended(self.start(program, *arguments, **limits))
        if run.status not in (0, 1, 2):
            self.fault(f"exit status {run.status}: {run.command}\n{run.errors[:2000]}")
        elif run.status != 0 and not run.errors.strip():
            self.fault(f"exit status {run.status} without a word: {run.command}")
        return run

    def expect(self, condition, text, *files):
        if not condition:
            self.fault(text, *files)
        return condition

    def fault(self, text, *files):
        """`files` reproduce it: they are kept."""
        kept = self.work / "kept"
        kept.mkdir(exist_ok=True)
        copies = [kept / f"{len(self.faults)}-{file.name}" for file in files]
        for file, copy in zip(files, copies):
            shutil.copyfile(file, copy)
        self.faults.append(text)
        print(f"FAULT (seed {self.seed}): {text}", *(f"\n  kept: {copy}" for copy in copies), flush=True)

    def close(self):
        if not self.faults:
            shutil.rmtree(self.work, ignore_errors=True)


def description(meshes):
    """A description with a link for each mesh, {link: file or URI}."""
    links = "".join(f"<link name='{name}'><collision><geometry><mesh filename={quoteattr(str(mesh))}/></geometry></collision></link>\n"
                    for name, mesh in meshes.items())
    root, *others = meshes
    joints = "".join(f"<joint name='to_{name}' type='revolute'><parent link='{root}'/><child link='{name}'/><origin xyz='{i} 0 0'/>"
                     "<axis xyz='0 0 1'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint>\n"
                     for i, name in enumerate(others))
    return f"<robot name='victim'>\n{links}{joints}</robot>\n"


def in_folder(folder, meshes):
    """Writes {link: (extension, content)} and a description of them; returns {link: file} and the description."""
    files = {name: folder / (name + extension) for name, (extension, _) in meshes.items()}
    for name, (_, content) in meshes.items():
        files[name].write_bytes(content)
    robot = folder / "victim.urdf"
    robot.write_text(description({name: file.name for name, file in files.items()}), encoding="utf-8")
    return files, robot


def robot_of_three(arena, name):
    """A description of three parts in a new folder."""
    meshes = {"bracket": (".obj", hostile.obj(hostile.bracket())), "box": (".stl", hostile.binary_stl(hostile.BOX)),
              "finger": (".stl", (PACKAGE / "meshes" / "finger.stl").read_bytes())}
    return in_folder(arena.folder(name), meshes)[1]


def report_of(output):
    return json.loads((output / "report.json").read_text(encoding="utf-8"))


def rows_of(output):
    """{link: row}"""
    return {row["link"]: row for row in report_of(output)["links"]}


def hulls_of(output, row):
    """The hulls that a row of the report lists, each as polygons: the files are binary STL."""
    hulls = []
    for name in row["files"]:
        content = (output / name).read_bytes()
        if name.endswith(".stl"):
            facets = [struct.unpack_from("<9f", content, start + 12) for start in range(84, len(content), 50)]
            hulls.append([[facet[i:i + 3] for i in (0, 3, 6)] for facet in facets])
    return hulls


def without_times(value):
    """A report without what differs between two runs of the same work."""
    if isinstance(value, dict):
        return {key: without_times(each) for key, each in value.items()
                if key not in ("seconds", "cached", "notes", "no-cache") and not key.endswith("_us")}
    return [without_times(each) for each in value] if isinstance(value, list) else value


def digests(output):
    """{file: digest} of an output; None if there is none. Of the report counts what is repeatable."""
    if not output.is_dir():
        return None
    result = {}
    for file in sorted(each for each in output.rglob("*") if not each.is_dir()):
        if file.name == "report.html":  # says what the report says, times and notes too
            continue
        content = file.read_bytes()
        if file.name == "report.json":
            content = json.dumps(without_times(json.loads(content)), sort_keys=True).encode()
        result[str(file.relative_to(output))] = hashlib.sha256(content).hexdigest()
    return result


def strangers(output):
    """The names of what lies beside an output."""
    return sorted(each.name for each in output.parent.iterdir() if each != output)


def name_of(signal_number):
    return signal.Signals(signal_number).name
