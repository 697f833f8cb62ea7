"""Who may work in a batch's folder: a whole run alone, or shards of one division side by side, each of them once.

A whole run has `lock` alone, shards share it, and its text says into how many parts they divide the list. A shard also has a lock of its own, and asks
for `lock` alone before it merges. A lock that changes from shared to alone is lost for a moment, and perhaps for good: so all that take or change one
do it in turn. A lock ends with its process. Where a file system has no locks, everyone gets them, and nothing tells of others.
"""
import contextlib
import fcntl

from inputs import Failure


def locked(file, kind):
    """Whether this process has that lock now."""
    try:
        fcntl.flock(file, kind)
    except BlockingIOError:
        return False
    except OSError:
        pass  # some file systems have no locks
    return True


def at_once(file):
    """Whether this process has it alone, without waiting for others."""
    return locked(file, fcntl.LOCK_EX | fcntl.LOCK_NB)


class Lock:
    """part: (I, N) of a shard, () of a whole run. OSError if the folder cannot be written."""

    def __init__(self, output, state, part=()):
        self.output, self.part, self.parts = output, part, str(part[1]) if part else ""
        # To be shared on a network, a file has to be open for reading; to be had alone, for writing.
        self.turn, self.all, self.own = (open(state / name, "a+", encoding="utf-8") for name in ("turn", "lock", "lock" + "-of-".join(map(str, part))))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for file in (self.turn, self.all, self.own):
            file.close()

    @contextlib.contextmanager
    def in_turn(self):
        locked(self.turn, fcntl.LOCK_EX)
        try:
            yield
        finally:
            locked(self.turn, fcntl.LOCK_UN)

    def take(self):
        """Failure if others are at work that would write the same files."""
        with self.in_turn():
            if at_once(self.all):
                self.all.truncate(0)
                self.all.write(self.parts)
                self.all.flush()
            else:
                self.all.seek(0)
                self.check_beside(self.all.read())
            if not self.part:
                return
            if not at_once(self.own):
                raise Failure("shard {}/{} is already at work in '{}'; wait for it, or end it".format(*self.part, self.output))
            locked(self.all, fcntl.LOCK_SH)  # waits at most for a shard of the same division that merges

    def check_beside(self, parts):
        """parts: of the shards that are at work, or empty for a whole run."""
        others = f"another batch is at work in '{self.output}'"
        if not parts:
            raise Failure(f"{others}; wait for it, or end it")
        if not self.part:
            raise Failure(f"{others}, in shards (--shard I/{parts}); wait for them, or end them")
        if parts != self.parts:
            raise Failure(f"{others}, in {parts} shards, and shard {self.part[0]}/{self.parts} would write the same results; "
                          f"give --shard I/{parts}, or wait until they have ended")

    def take_alone(self):
        """Of a shard that has done its part: whether no other is at work. Of those that end at the same time, the last one to ask is alone."""
        with self.in_turn():
            locked(self.all, fcntl.LOCK_UN)
            return at_once(self.all)
