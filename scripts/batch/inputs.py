"""What a batch is to decompose: paths, folders, lists and manifests become one list of items.

A manifest is a CSV file with a column `input`, optionally `name`, and a column for each option of decompose that rows set, such as `tolerance`
or `config`; an empty cell leaves the option as the command line has it. Paths in a list or manifest are relative to its folder.
"""
import collections
import csv
import dataclasses
import difflib
import io
import os
import pathlib
import re
import subprocess

from files import MOST_PATH, files_below, sha256, tell

MESHES = {".stl", ".dae", ".obj", ".off", ".ply", ".glb", ".gltf"}
DESCRIPTIONS = {".urdf", ".xacro"}
PATH_OPTIONS = {"config", "package-path", "root"}
OWN = {"help", "version", "output", "json", "quiet", "jobs", "package-name", "replace-complete"}  # of decompose, but the batch's to set
ADVICE = "check the path, and that its disk is mounted; nothing was done, and earlier results stay"


class Failure(Exception):
    """Wrong use; for the user."""


@dataclasses.dataclass
class Item:
    path: str  # absolute, or the name of a package
    options: dict  # of its row in a manifest: {name: [value...]}, with an empty value for a flag
    name: str = ""
    listed: bool = False  # in a file, not on the command line
    empty: bool = False  # a folder with nothing to decompose

    def is_mesh(self):
        return pathlib.Path(self.path).suffix.lower() in MESHES


def options_of(decompose):
    """{name: (its letter or "", its value's name or "")} as --help lists them."""
    ended = subprocess.run([decompose, "--help"], capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        raise Failure(f"'{decompose} --help' ended with status {ended.returncode}: {ended.stderr.strip()}")
    found = re.findall(r"^ +(?:-(\w),)?--([a-z-]+)(?: ([A-Z]+))?", ended.stdout, flags=re.M)
    return {name: (letter, value) for letter, name, value in found if name not in OWN}


def absolute(name, value, folder):
    """A path that options name, seen from any folder."""
    if name not in PATH_OPTIONS:
        return value
    named = re.fullmatch(r"([A-Za-z0-9_.-]+)=(.*)", value)
    if name != "package-path" or not named or (folder / value).is_dir():
        return os.path.normpath(folder / value)
    return named.group(1) + "=" + os.path.normpath(folder / named.group(2))


def located(word, folder):
    """The input as a path, or the name of a package for decompose to find."""
    path = folder / word
    return str(path) if os.path.exists(path) or "/" in word or path.suffix.lower() in MESHES | DESCRIPTIONS else word


def note_left_out(folder, files, urdfs):
    """.xacro files that no .urdf file was made from; many hold macros alone, so the user has to tell."""
    made = {file.stem for file in urdfs}
    left = [file for file in files if file.suffix.lower() == ".xacro" and pathlib.Path(file.stem).suffix not in {".srdf", ".sdf"}
            and pathlib.Path(file.stem).stem not in made]
    if left:
        taken, not_taken = (f"{len(some)} .{kind} file{' is' if len(some) == 1 else 's are'}" for some, kind in ((urdfs, "urdf"), (left, "xacro")))
        tell(f"note: of folder '{folder}', {taken} taken and {not_taken} not: give those that describe robots, such as '{left[0]}' may do, "
             "as inputs of their own")


def of_folder(folder, options, name):
    """The descriptions in a folder; without any, the package that it is; else its meshes."""
    files = sorted(file for file in files_below(folder) if not any(part.startswith(".") for part in file.relative_to(folder).parts))
    urdfs = [file for file in files if file.suffix.lower() == ".urdf"]
    if urdfs:
        note_left_out(folder, files, urdfs)
        return [Item(str(file), options, name if len(urdfs) == 1 else "") for file in urdfs]
    if os.path.exists(folder / "package.xml"):
        return [Item(str(folder), options, name)]
    meshes = [Item(str(file), options) for file in files if file.suffix.lower() in MESHES]
    return meshes or [Item(str(folder), options, name, empty=all(file.suffix.lower() != ".xacro" for file in files))]


def of_word(word, folder, options, name=""):
    if len(os.fsencode(word)) >= MOST_PATH:
        raise Failure(f"the input '{word[:60]}...' has {len(word)} characters; a path has less than {MOST_PATH}: give one, as a line of its own in a list")
    if re.match(r"[A-Za-z_]\w*:=", word):
        raise Failure(f"'{word}' is an argument for xacro, and a batch passes none on: expand the description once for each variant, "
                      f"as in 'xacro my_robot.urdf.xacro {word} > my_robot.urdf', and give those files")
    path = pathlib.Path(located(word, folder))
    return of_folder(path, options, name) if os.path.isdir(path) else [Item(str(path), options, name)]


def text_of(path):
    try:
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        raise Failure(f"'{path}' is not UTF-8 (byte {error.start}); save it as UTF-8") from error
    if "\0" in text:
        raise Failure(f"'{path}' has a zero (character {text.index(chr(0))}), as no text has; save it as UTF-8")
    return text


def of_list(path):
    lines = [line.strip() for line in text_of(path).splitlines()]
    return [item for line in lines if line and not line.startswith("#") for item in of_word(line, path.parent, {})]


def merged(given, of_row):
    """The options of an input: a manifest's row counts before the command line; None is a flag that it takes away."""
    return {name: values for name, values in {**given, **of_row}.items() if values is not None}


def is_set(flag, value, where):
    if value.lower() in {"yes", "true", "1"}:
        return True
    if value.lower() in {"no", "false", "0"}:
        return False
    raise Failure(f"{where}: {flag} is '{value}'; it is yes or no")


def of_manifest(path, known):
    rows = csv.DictReader(io.StringIO(text_of(path), newline=""), strict=True)
    items = []
    try:
        unknown = [column for column in rows.fieldnames or [] if column not in {"input", "name", *known}]
        if unknown or "input" not in (rows.fieldnames or []):
            what = f"has a column '{unknown[0]}', which is not an option of decompose" if unknown else "has no column 'input'"
            meant = difflib.get_close_matches(unknown[0], ["input", "name", *known], 1) if unknown else []
            raise Failure(f"'{path}' {what}; " + (f"did you mean '{meant[0]}'?" if meant else
                                                  "its columns are input, name, and options such as tolerance or config"))
        for row in rows:
            if not row["input"]:
                raise Failure(f"'{path}', line {rows.line_num}: no input")
            where = f"'{path}', line {rows.line_num}"
            options = {name: [absolute(name, value, path.parent)] if known[name][1] else [""] if is_set(name, value, where) else None
                       for name, value in row.items() if name in known and value}
            items += of_word(row["input"], path.parent, options, row.get("name") or "")
    except csv.Error as error:
        raise Failure(f"'{path}', after line {rows.line_num}: {error}; write it as comma-separated values") from error
    return items


def name_of(item):
    """What its results are called: a name that ROS takes for a package."""
    stem = item.name or pathlib.Path(item.path).stem
    name = re.sub(r"[^a-z0-9]+", "_", stem.lower()).strip("_") or "input"
    name = name[:80] if name[0].isalpha() else "m_" + name[:78]
    return name if item.name or item.is_mesh() else name + "_collision"


def named(items):
    """Each once, with a name of its own: one that several would have is followed by digits of a hash, and so stays theirs."""
    items = list({(item.path, str(item.options), item.name): item for item in items}.values())
    names = [name_of(item) for item in items]
    count = collections.Counter(names)
    for item, name in zip(items, names):
        digits = sha256(item.path + str(item.options) + item.name)[:8]
        item.name = name if count[name] == 1 else f"{name}_{digits}"
    return items


def items_of(words, known):
    """All that the command line names."""
    items = []
    for word in words:
        path = pathlib.Path(word)
        if path.suffix.lower() not in (".csv", ".txt"):
            found = of_word(word, pathlib.Path.cwd(), {})
            if any(item.empty for item in found):
                raise Failure(f"folder '{word}' holds no description or mesh; {ADVICE}")
            items += found
            continue
        if not path.is_file():
            raise Failure(f"the list '{word}' does not exist; check the path")
        found = of_manifest(path.resolve(), known) if path.suffix.lower() == ".csv" else of_list(path.resolve())
        if not found:
            raise Failure(f"'{word}' names no input; an empty list would remove earlier results: check it, or leave it out")
        items += [dataclasses.replace(item, listed=True) for item in found]
    return named(items)
