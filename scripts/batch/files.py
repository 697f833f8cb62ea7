"""Files that appear whole or not at all, and what they hold."""
import hashlib
import json
import os
import pathlib


def sha256(data):
    return hashlib.sha256(data).hexdigest()


def write(path, text):
    """Leaves a file alone that holds this text already: its date tells when something last changed."""
    path = pathlib.Path(path)
    data = text.encode("utf-8", "surrogateescape")
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


class Digests:
    """SHA-256 of files. A file of the same size and date as before is not read again."""

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
                known = [state.st_size, state.st_mtime_ns, sha256(pathlib.Path(path).read_bytes())]
        except OSError:
            return None
        self.now[path] = known
        return known[2]

    def keep(self):
        write(self.memory, json.dumps(self.now, sort_keys=True))
