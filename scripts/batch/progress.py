"""What a terminal shows of a batch: how many are done with which status, rate, time left; and at its end what came of it."""
import collections
import re
import sys
import textwrap
import time

from files import tell
from plan import row_of

PERIOD = 0.5  # [s] between looks
LINE_PERIOD = 30  # [s] between lines where there is no terminal
EXAMPLE = 160  # characters of a reason


def duration(seconds):
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"


def by_status(counts):
    """", 2 failed, 1 incomplete, 9 ok", in the words of batch.csv."""
    return "".join(f", {number} {status}" for status, number in sorted(counts.items()))


class Display:
    """Counts rows as they come."""

    def __init__(self, total):
        self.total, self.done, self.counts = total, 0, collections.Counter()
        self.start = self.told = time.monotonic()
        self.terminal = sys.stderr.isatty()

    def count(self, row):
        self.done += 1
        self.counts[row["status"]] += 1

    def step(self, row):
        self.count(row)
        self.show()

    def text(self):
        spent = time.monotonic() - self.start
        rate = self.done / spent if spent else 0
        left = f", {60 * rate:.3g} a minute, {duration((self.total - self.done) / rate)} left" if self.done else ""
        return f"{self.done} of {self.total} inputs done{by_status(self.counts)}{left}"

    def show(self):
        if self.terminal:
            tell(f"\r\x1b[K{self.text()}", end="")
        elif time.monotonic() - self.told > LINE_PERIOD:
            self.told = time.monotonic()
            tell(self.text())

    def end(self):
        if self.terminal:
            tell("\r\x1b[K", end="")


def watch(process, entries, state):
    """Until Snakemake has ended."""
    display, waiting = Display(len(entries)), list(entries)
    while process.poll() is None:
        time.sleep(PERIOD)
        rows = [(entry, row_of(entry, state)) for entry in waiting]
        waiting = [entry for entry, row in rows if not row]
        for row in filter(None, (row for _, row in rows)):
            display.count(row)
        display.show()
    display.end()


def kinds(rows):
    """[how many, which reason, the first in full] of the inputs and meshes that failed, the most frequent first. What decompose refuses is
    told apart by its own words, without names and numbers. rows: of all inputs."""
    found = {}
    for item in (item for row in rows for item in [row, *row["meshes"]] if item["cause"]):
        is_own = item["cause"] == "Refused"
        own_words = re.sub(r"'[^']*'|\[[^]]*\]|\d+", "…", item["reason"])
        kind = textwrap.shorten(own_words, 120, placeholder=" …") if is_own else item["cause"]
        found.setdefault(kind, [0, kind, item["reason"]])[0] += 1
    return sorted(found.values(), key=lambda kind: -kind[0])


def told(number, kind, first):
    """What kinds() says of one reason, in a line. number: how many have it; kind, first: its name or own words, and the first in full."""
    full = textwrap.shorten(first, EXAMPLE, placeholder=" …")
    if not full or kind == full or (number == 1 and "…" in kind):  # own words say no more than the reason itself
        return full or kind
    return f"{kind}{': ' if number == 1 else ', first: '}{full}"


def summary(rows, done, output):
    """A few lines: how many of what, failures by reason, where it is."""
    first = f"{done} input{'s' * (done != 1)} done" if done == len(rows) else f"{done} of {len(rows)} inputs done; all others are as they were"
    lines = [first if done else f"nothing to do: {len(rows)} input{'s are as they were' if len(rows) != 1 else ' is as it was'}"]
    for what, items in (("inputs", rows), ("meshes", [mesh for row in rows for mesh in row["meshes"]])):
        lines.append(f"{what}: {len(items)}{by_status(collections.Counter(item['status'] for item in items))}")
    lines += [f"  {number} {told(number, kind, first)}" for number, kind, first in kinds(rows)]
    return "\n".join([*lines, f"Written to {output}: batch.csv, batch.html"])
