"""Runs decompose on one input after another, within limits, and keeps a row for each.

A row is written after its result, and both appear in one step: whoever is killed in between leaves no row, and the input is done again, from
decompose's cache. The input's earlier row went before, and its earlier result goes now, so that no row describes another result.
"""
import ctypes
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import threading
import time

from files import read_json, sha256, sizes_of, write_json
from plan import UNWRITABLE, row_file

MEGABYTE = 1 << 20
READER = {"reader-memory": 512, "reader-time": 4}  # defaults of decompose, which an attempt doubles like its own limits
MOST = 2**31 - 1  # that decompose takes for these
SCARCE = {"OutOfMemory", "OutOfTime"}  # causes that more of it may mend
NOT_WRITTEN = 2  # status of decompose for a refused input, a single mesh that failed, and an output that cannot be written
INTERRUPTED = {130, -signal.SIGINT, -signal.SIGTERM}  # statuses of decompose
GRACE = 10  # [s] to end cleanly
MEASURED = ("report.json", "report.html")  # files with times in them
PR_SET_PDEATHSIG = 1
MESH_FIELDS = ("link", "element", "uri", "status", "reason", "triangles", "hulls", "primitives", "least_hulls", "protrusion", "tolerance", "sha256")


def die_with_parent(number=signal.SIGTERM, parent=None):
    """The calling process gets this signal when the one that started it ends in whatever way; also where `parent`, its number, has ended before."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, number)
    if parent not in (None, os.getppid()):
        os.kill(os.getpid(), number)


def limited(settings, attempt):
    """MB and seconds that an input may take: doubled with each attempt."""
    return settings["memory"] * 2 ** (attempt - 1), settings["minutes"] * 60 * 2 ** (attempt - 1)


def command(entry, settings, attempt, report):
    options = dict(entry["options"])
    if attempt > 1:
        for name, default in READER.items():
            options[name] = [str(min(int(options.get(name, [default])[0]) * 2 ** (attempt - 1), MOST))]
    words = [word for name, values in options.items() for value in values for word in ["--" + name, value][:1 + bool(value)]]
    return [settings["decompose"], entry["input"], "--output", os.path.join(settings["output"], entry["folder"]), "--json", str(report), "--quiet",
            "--replace-complete", "--jobs", str(settings["threads"]), *words]


class Run:
    """One run of decompose: how it ended, and what it took."""

    def __init__(self, words, errors, memory, seconds):
        parent = os.getpid()

        def prepare():
            die_with_parent(parent=parent)
            resource.setrlimit(resource.RLIMIT_DATA, (memory * MEGABYTE, memory * MEGABYTE))

        start = time.monotonic()
        self.late = False
        with open(errors, "wb") as file:
            self.child = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=file, preexec_fn=prepare)
        timers = [threading.Timer(seconds, self.stop), threading.Timer(seconds + GRACE, self.child.kill)]
        for timer in timers:
            timer.daemon = True  # whoever interrupts this does not wait for it
            timer.start()
        try:
            _, status, usage = os.wait4(self.child.pid, 0)
        finally:
            for timer in timers:
                timer.cancel()
        self.child.returncode = self.status = -os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status)
        self.text = pathlib.Path(errors).read_text(encoding="utf-8", errors="replace")
        self.measured = {"seconds": round(time.monotonic() - start, 3), "cpu": round(usage.ru_utime + usage.ru_stime, 3), "memory": usage.ru_maxrss // 1024}

    def stop(self):
        self.late = True
        self.child.terminate()

    def cause(self):
        """Why there is no result, as the name of an error."""
        if self.late:
            return "OutOfTime"
        if self.status == NOT_WRITTEN and re.search("^decompose: (--json: )?cannot write '", self.text, flags=re.M):
            return UNWRITABLE
        if self.status in (-signal.SIGKILL, 127) or re.search(r"out of memory|memory did not suffice|bad_alloc", self.text, flags=re.I):
            return "OutOfMemory"
        return f"Crashed ({signal.Signals(-self.status).name})" if self.status < 0 else "Refused"

    def reason(self, memory, seconds):
        said = " ".join(line.partition("decompose: ")[2] or line for line in self.text.splitlines() if "; nothing was written to" not in line)
        said = said.replace("; 'batch' takes folders of meshes", "")  # this is batch
        by_cause = {UNWRITABLE: f"{said.strip()}. The next start tries again",
                    "OutOfTime": f"not done after {seconds / 60:g} min; --minutes allows more",
                    "OutOfMemory": f"{memory} MB of memory did not suffice; --memory allows more"}
        return by_cause.get(self.cause(), said.strip() or f"ended with status {self.status} and said nothing")


def hash_of(folder):
    """Of a result: of all its files but those with times in them."""
    files = sorted(file for file in pathlib.Path(folder).rglob("*") if file.is_file() and file.name not in MEASURED)
    return sha256("".join(f"{file.relative_to(folder)} {sha256(file.read_bytes())}\n" for file in files)) if files else ""


def cause_of(mesh):
    """The name of its error. Threads that cannot start lack memory, too."""
    scarce = mesh["error"] == "Internal" and re.search("pthread_create|Cannot allocate memory", mesh["reason"])
    return "OutOfMemory" if scarce else mesh["error"]


def mesh_rows(report):
    """Every mesh of every model."""
    for model in [report, *report.get("models", [])]:
        for mesh in model["links"]:
            row = {name: mesh[name] for name in MESH_FIELDS}
            yield {**row, "model": model.get("model", ""), "cause": cause_of(mesh), "seconds": round(sum(mesh["seconds"].values()), 3), "cached": mesh["cached"]}


def status_of(meshes, written):
    states = {mesh["status"] for mesh in meshes}
    if "failed" in states:
        return "incomplete" if written else "failed"
    return "degraded" if "degraded" in states else "ok"


def is_refuted(report):
    """Whether a check found what the proof rules out. report: of decompose."""
    checks = [model.get("validation") or {} for model in [report, *report.get("models", [])]]
    return any(check.get(count, 0) > 0 for check in checks for count in ("missed", "phantom"))


def is_complete(run, meshes, written):
    """Whether decompose has written what its report says: a result, or none where all meshes failed."""
    all_failed = bool(meshes) and all(mesh["status"] == "failed" for mesh in meshes)
    return run.status in (0, 1) or (run.status == NOT_WRITTEN and (written or all_failed))


def row_of(entry, run, report, settings, limits):
    folder = os.path.join(settings["output"], entry["folder"])
    row = {"name": entry["name"], "input": entry["input"], "fingerprint": entry["fingerprint"], "folder": entry["folder"], "reason": "", "cause": "",
           "hash": hash_of(folder), "files": sizes_of(folder), **run.measured}
    meshes = list(mesh_rows(report or {"links": []}))
    if report is None or not is_complete(run, meshes, bool(row["hash"])):
        return {**row, "status": "failed", "cause": run.cause(), "reason": run.reason(*limits), "meshes": []}
    failed = sum(mesh["status"] == "failed" for mesh in meshes)
    row["reason"] = f"{failed} of {len(meshes)} meshes failed" if failed else ""
    if not failed and is_refuted(report):
        return {**row, "status": "incomplete", "cause": "Refuted", "reason": run.reason(*limits), "meshes": meshes}
    return {**row, "status": status_of(meshes, bool(row["hash"])), "meshes": meshes}


def lacks(row):
    """Whether more memory or time may mend it."""
    return bool(SCARCE & {row["cause"], *(mesh["cause"] for mesh in row["meshes"])})


def do(entry, settings, attempt):
    """The row of an input, kept unless another attempt is to follow."""
    report, row_path = (row_file(settings["state"], entry["name"]).with_suffix(end) for end in (".report", ".json"))
    errors = report.with_suffix(".errors")
    report.parent.mkdir(parents=True, exist_ok=True)
    folder = pathlib.Path(settings["output"], entry["folder"])
    shutil.rmtree(folder, ignore_errors=True)
    folder.parent.mkdir(parents=True, exist_ok=True)
    report.unlink(missing_ok=True)
    limits = limited(settings, attempt)
    run = Run(command(entry, settings, attempt, report), errors, *limits)
    if run.status in INTERRUPTED and not run.late:
        raise KeyboardInterrupt
    row = {**row_of(entry, run, read_json(report), settings, limits), "attempts": attempt}
    report.unlink(missing_ok=True)
    errors.unlink(missing_ok=True)
    if attempt == settings["attempts"] or not lacks(row):
        write_json(row_path, row)
    return row


def do_all(entries, settings, attempts, step=lambda row: None):
    """Each of the entries, each with as many of these attempts as it needs. Returns how many need yet another one."""
    unfinished = 0
    for entry in entries:
        for attempt in attempts:
            row = do(entry, settings, attempt)
            if not lacks(row):
                break
        unfinished += lacks(row) and attempt < settings["attempts"]
        step(row)
    return unfinished
