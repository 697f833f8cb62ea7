"""What is to be done: each item with a fingerprint of all that its result depends on, and jobs of those whose row is missing or of another one.

The fingerprint of a description takes in every file that a mesh URI of it could lead to, as decompose looks for them, and that of a .gltf mesh
every file that it names, its textures, too: more than the files that decompose reads, so that it changes whenever one of those does. Meshes of
other formats lie in one file each.
"""
import html
import itertools
import json
import os
import pathlib
import re
import shutil
import urllib.parse

from files import MOST_PATH, encoded, entries_of, files_below, read_json, read_text, sha256, write_json
from inputs import ADVICE, Failure, merged

JOB_SECONDS = 180  # about what a job of meshes takes
JOB_MESHES = 200  # at most
JOBS_A_CORE = 4  # so that the last ones end about together
FAILED = ("failed", "incomplete")  # states of inputs
UNWRITABLE = "UnwritableOutput"  # the cause of a failure that is not the input's fault: the next start does it again
MOST_NAMED = 10_000  # files of a .gltf that are looked for: decompose reads at most a thousand, but textures may stand before them
MOST_ESCAPED = 6 * MOST_PATH  # characters of a path in JSON
SECONDS_A_MESH, SECONDS_A_MEGABYTE = 0.3, 4  # roughly what decompose takes with default options


def packages(folders):
    """{name: folders} of all packages below, each by its folder's name and by its manifest's."""
    found, seen, following = {}, set(), list(reversed(folders))
    while following:
        folder = following.pop()
        try:
            state = os.stat(folder)
        except OSError:
            continue
        if (state.st_dev, state.st_ino) in seen:  # links may lead round and round
            continue
        seen.add((state.st_dev, state.st_ino))
        below, files = entries_of(folder)
        if "package.xml" not in files:
            following += [os.path.join(folder, name) for name in reversed(below) if not name.startswith(".")]
            continue
        name = re.search(r"<name>\s*([^<\s]+)", read_text(pathlib.Path(folder, "package.xml")))
        for each in {os.path.basename(folder), name.group(1) if name else ""}:
            found.setdefault(each, []).append(folder)
    return found


def decoded(uri):
    """Without percent-encoding, which may stand for any bytes."""
    return os.fsdecode(urllib.parse.unquote_to_bytes(encoded(uri)))


def named_by(mesh):
    """Paths that a .gltf file names, in its folder or below: decompose takes no others. Searching the text costs little whatever it holds, parsing
    it may take any memory."""
    found = re.finditer(rf'"uri"\s*:\s*("(?!data:)[^"]{{1,{MOST_ESCAPED}}}")', read_text(mesh))
    for text in {match.group(1) for match in itertools.islice(found, MOST_NAMED)}:
        try:
            path = os.path.normpath(decoded(json.loads(text)))
        except ValueError:  # it is no string of JSON
            continue
        if not os.path.isabs(path) and path.split("/")[0] != "..":
            yield os.path.join(os.path.dirname(mesh), path)


class Sources:
    """Where files may come from."""

    def __init__(self, digests):
        self.digests, self.crawls, self.named = digests, {}, {}

    def ros(self, given):
        """Packages on ROS's path and below --package-path."""
        key = tuple(given) + (os.environ.get("ROS_PACKAGE_PATH", ""),)
        if key not in self.crawls:
            self.crawls[key] = packages([folder for folder in [*given, *key[-1].split(":")] if folder])
        return self.crawls[key]

    def has(self, item, options):
        """Whether the input is there."""
        if "/" in item.path:
            return os.path.exists(item.path)
        given = options.get("package-path", [])
        prefixes = [prefix for prefix in os.environ.get("CMAKE_PREFIX_PATH", "").split(":") if prefix]
        return (item.path in {text.partition("=")[0] for text in given if "=" in text} or item.path in self.ros(given)
                or any(os.path.isdir(os.path.join(prefix, "share", item.path)) for prefix in prefixes))

    def candidates(self, description, uri, package_path):
        """Paths that a mesh's URI may mean."""
        near = pathlib.Path(description).parent
        in_package = re.fullmatch(r"(?:package|model)://+([^/]*)/*(.*)", uri, flags=re.S)
        if not in_package:
            return [near / re.sub(r"^file://(localhost(?=/))?", "", uri)]
        name, rest = in_package.groups()
        given = [pathlib.Path(item.partition("=")[2] or item) for item in package_path]
        prefixes = [pathlib.Path(prefix, "share") for prefix in os.environ.get("CMAKE_PREFIX_PATH", "").split(":") if prefix]
        known = [pathlib.Path(folder) for folder in self.ros(map(str, given)).get(name, [])]
        bases = [*known, *given, *prefixes, near, *near.parents]
        return [base / part / rest for base in bases for part in ("", name, "meshes", f"meshes/{name}")]

    def of_description(self, path, package_path):
        found = re.findall(r"""filename\s*=\s*(["'])(.*?)\1""", read_text(path))
        written = {uri for uri in (html.unescape(text) for _, text in found) if len(uri) <= MOST_PATH}
        uris = written | set(map(decoded, written))
        return [path, *(file for uri in sorted(uris) for file in self.candidates(path, uri, package_path))]

    def with_named(self, files):
        """These and those that .gltf files among them name."""
        for file in map(str, files):
            yield file
            if file.lower().endswith(".gltf"):
                if file not in self.named:
                    self.named[file] = list(named_by(file))
                yield from self.named[file]

    def of_package(self, path):
        """Of a package or a .xacro file, which may read any file of its package."""
        start = pathlib.Path(path)
        above = [folder for folder in [start, *start.parents] if os.path.exists(folder / "package.xml")]
        top = above[0] if above else start.parent
        return sorted(files_below(top))

    def of(self, item, options):
        if "/" not in item.path:  # a package, for ROS to find
            return None
        if item.is_mesh() or not os.path.exists(item.path):
            return self.with_named([item.path])
        if item.path.lower().endswith(".urdf"):
            return self.with_named(self.of_description(item.path, options.get("package-path", [])))
        return self.of_package(item.path)

    def fingerprint(self, item, options, version):
        """Of everything that the result depends on; empty if that is not known, as of a package that ROS has to find."""
        files = self.of(item, options)
        if files is None:
            return ""
        files = [*files, *options.get("config", [])]
        held = sorted((file, digest) for file in {*map(str, files), *map(os.path.normpath, files)} if (digest := self.digests.of(file)))
        return sha256(json.dumps([version, item.path, options, held], sort_keys=True))


def seconds(item):
    """What it may take."""
    try:
        return SECONDS_A_MESH + SECONDS_A_MEGABYTE * os.path.getsize(item.path) / 1e6
    except OSError:
        return SECONDS_A_MESH


def folder_of(item):
    """Where its results go: below 256 folders, as decompose lists the folder around its output each time."""
    return os.path.join("results", sha256(item.name)[:2], item.name)


def expect_there(items, given):
    """Throws Failure if inputs are missing: a wrong path on the command line, or a disk that is not mounted, would replace earlier results
    by failures. One input of many that a list names may be missing. items, given: the inputs, and the options of the command line."""
    sources = Sources(None)
    lost = [item for item in items if not sources.has(item, merged(given, item.options))]
    for item in lost:
        if not item.listed:
            what = "does not exist" if "/" in item.path else "is neither a file, nor a folder, nor a package that is found"
            raise Failure(f"INPUT '{item.path}' {what}; {ADVICE}")
    if len(lost) == len(items):
        raise Failure(f"no listed input exists, such as '{lost[0].path}'; {ADVICE}")


def plan_of(items, given, digests, version):
    """The plan as it is stored: an entry an item, in their order."""
    sources, entries = Sources(digests), []
    for item in items:
        options = merged(given, item.options)
        entries.append({"name": item.name, "input": item.path, "kind": "mesh" if item.is_mesh() else "description", "options": options,
                        "folder": folder_of(item), "fingerprint": sources.fingerprint(item, options, version), "seconds": seconds(item)})
    return entries


def row_file(state, name):
    return pathlib.Path(state, "rows", name + ".json")


def row_of(entry, state):
    """Its row, if that is of this fingerprint."""
    row = read_json(row_file(state, entry["name"]))
    return row if row and row["fingerprint"] == entry["fingerprint"] else None


def has_result(row, output):
    """Whether every file of its result is still there, as large as it was."""
    try:
        return all(os.path.getsize(os.path.join(output, row["folder"], name)) == size for name, size in row["files"].items())
    except (OSError, KeyError):  # gone, or the row of an earlier version
        return False


def missing(entries, state):
    """Those without a row, those whose result could not be written or has lost files, and those of which nobody knows what they depend on."""
    output = os.path.dirname(state)
    rows = [(entry, row_of(entry, state)) for entry in entries]
    return [entry for entry, row in rows if not (entry["fingerprint"] and row and row["cause"] != UNWRITABLE and has_result(row, output))]


def forget(entries, state):
    """They are done again, wherever that starts."""
    for entry in entries:
        row_file(state, entry["name"]).unlink(missing_ok=True)


def forget_failed(entries, state):
    rows = [(entry, row_of(entry, state)) for entry in entries]
    forget([entry for entry, row in rows if row and row["status"] in FAILED], state)


def jobs_of(entries, at_once):
    """A description each, and meshes together: enough jobs for all that run at once to be busy, none of more than some minutes."""
    meshes = [entry for entry in entries if entry["kind"] == "mesh"]
    most = min(JOB_SECONDS, max(JOB_SECONDS / 10, sum(entry["seconds"] for entry in meshes) / (JOBS_A_CORE * at_once)))
    jobs, total = [[entry] for entry in entries if entry["kind"] != "mesh"] + [[]], 0
    for entry in meshes:
        if jobs[-1] and (total + entry["seconds"] > most or len(jobs[-1]) == JOB_MESHES):
            jobs.append([])
            total = 0
        jobs[-1].append(entry)
        total += entry["seconds"]
    return jobs if jobs[-1] else jobs[:-1]


def write_jobs(jobs, state):
    """A file each; returns their names, which what they do decides: a job of an earlier start that ends late stands for no other."""
    names = ["job_" + sha256(json.dumps(entries, sort_keys=True))[:16] for entries in jobs]
    shutil.rmtree(os.path.join(state, "jobs"), ignore_errors=True)
    for name, entries in zip(names, jobs):
        write_json(pathlib.Path(state, "jobs", name + ".json"), entries)
    return names
