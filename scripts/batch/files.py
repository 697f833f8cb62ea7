"""Files that appear whole or not at all, and what they hold; and what is told on the way."""
import contextlib
import hashlib
import json
import os
import pathlib
import sys


MOST_MESH, MOST_TEXT = 1 << 30, 1 << 28  # [bytes] larger ones decompose does not read
MOST_PATH = 4096  # [bytes] that Linux takes
PIECE = 1 << 20  # [bytes]


def tell(text, end="\n"):
    """On standard error. That nobody reads it any more is no reason to stop."""
    with contextlib.suppress(BrokenPipeError):
        print(text, end=end, file=sys.stderr, flush=True)


def encoded(text):
    """Names of files may hold any bytes."""
    return text.encode("utf-8", "surrogateescape")


def sha256(data):
    return hashlib.sha256(encoded(data) if isinstance(data, str) else data).hexdigest()


def entries_of(folder):
    """The names of its folders, links to some among them, and of all else. A folder that cannot be read has none."""
    try:
        names = os.listdir(folder)
    except OSError:
        return [], []
    folders = {name for name in names if os.path.isdir(os.path.join(folder, name))}
    return sorted(folders), sorted(set(names) - folders)


def files_below(folder):
    """Regular ones, links to some among them, in no order. Links to folders are not followed. Python's own ways call themselves for each level."""
    folders = [str(folder)]
    while folders:
        top = folders.pop()
        below, others = entries_of(top)
        folders += [path for path in (os.path.join(top, name) for name in below) if not os.path.islink(path)]
        yield from (pathlib.Path(top, name) for name in others if os.path.isfile(os.path.join(top, name)))


def sizes_of(folder):
    """{name: size} of all regular files below a folder."""
    return {str(file.relative_to(folder)): os.path.getsize(file) for file in sorted(pathlib.Path(folder).rglob("*")) if file.is_file()}


def pieces(path, size):
    """The first bytes of a file: some of the kernel's have no end."""
    with open(path, "rb") as file:
        while size > 0 and (piece := file.read(min(size, PIECE))):
            size -= len(piece)
            yield piece


def read_text(path):
    """Empty for what decompose would not read as text either: no regular file, or one that is too large."""
    try:
        size = os.path.getsize(path) if os.path.isfile(path) else 0
        return b"".join(pieces(path, size)).decode(errors="replace") if 0 < size <= MOST_TEXT else ""
    except OSError:
        return ""


def write(path, text):
    """Leaves a file alone that holds this text already: its date tells when something last changed."""
    path = pathlib.Path(path)
    data = encoded(text)
    if path.exists() and path.read_bytes() == data:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f".{path.name}.{os.uname().nodename}.{os.getpid()}")
    part.write_bytes(data)
    os.replace(part, path)


def write_json(path, value):
    write(path, json.dumps(value, indent=1, sort_keys=True) + "\n")


def read_json(path):
    """None if the file is missing, or damaged as after a loss of power."""
    try:
        return json.loads(pathlib.Path(path).read_bytes())
    except (OSError, ValueError):
        return None


def digest(path, state):
    """SHA-256 of a file. One that is too large for decompose is not read: its size and date tell of a change."""
    if state.st_size > MOST_MESH:
        return sha256(f"{state.st_size} {state.st_mtime_ns}")
    whole = hashlib.sha256()
    for piece in pieces(path, state.st_size):
        whole.update(piece)
    return whole.hexdigest()


class Digests:
    """Of files. A file of the same size and date as before is not read again."""

    def __init__(self, memory):
        self.memory, self.before, self.now = memory, read_json(memory) or {}, {}

    def of(self, path):
        """None if there is no such file."""
        path = str(path)
        try:
            state = os.stat(path)
            if not os.path.isfile(path):
                return None
            known = self.now.get(path) or self.before.get(path)
            if not known or known[:2] != [state.st_size, state.st_mtime_ns]:
                known = [state.st_size, state.st_mtime_ns, digest(path, state)]
        except (OSError, ValueError):  # a name with a zero in it is none
            return None
        self.now[path] = known
        return known[2]

    def keep(self):
        write(self.memory, json.dumps(self.now, sort_keys=True))
