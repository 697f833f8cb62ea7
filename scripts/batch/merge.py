"""The rows of all inputs as batch.csv and batch.html, in the order of the plan."""
import csv
import io
import os
import pathlib
import shutil

import page
from files import read_json, write
from plan import row_of

# Columns up to `hash` are the same whenever and wherever a batch runs; those after it are what was measured.
RESULT = ("row", "name", "input", "model", "link", "element", "mesh", "status", "cause", "reason", "triangles", "hulls", "primitives", "least_hulls",
          "protrusion", "tolerance", "report", "hash")
MEASURED = ("seconds", "cpu", "memory", "attempts", "cached")
COLUMNS = RESULT + MEASURED


def lost(entry, state):
    """The row of an input whose job ended without one."""
    return {"name": entry["name"], "input": entry["input"], "folder": entry["folder"], "status": "failed", "cause": "NoResult", "hash": "", "meshes": [],
            "reason": f"its job ended before it was done, at each attempt; see {state}/snakemake.log. The next start tries again"}


def rows_of(entries, state):
    for entry in entries:
        yield row_of(entry, state) or lost(entry, state)


def report_of(row, output):
    """Where it is read, relative to the output: the page, unless there is none."""
    names = ("report.html", "report.json") if row["hash"] else ()
    return next((os.path.join(row["folder"], name) for name in names if os.path.exists(os.path.join(output, row["folder"], name))), "")


def lines_of(row):
    """The input's line, then one for each of its meshes."""
    report = row["report"]
    sums = {name: sum(mesh[name] for mesh in row["meshes"]) for name in ("triangles", "hulls", "primitives", "least_hulls")} if row["meshes"] else {}
    sums["protrusion"] = max((mesh["protrusion"] for mesh in row["meshes"] if mesh["protrusion"] is not None), default="")
    yield {**row, **sums, "row": "input", "report": report}
    for mesh in row["meshes"]:
        yield {**mesh, "row": "mesh", "name": row["name"], "input": row["input"], "mesh": mesh["uri"], "hash": mesh["sha256"], "report": report}


def table_of(rows):
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, extrasaction="ignore", lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerows(lines_of(row))
    return text.getvalue()


def remove_others(entries, output, state):
    """Results of inputs that are no longer in the list. Only what a row says that a batch has made."""
    wanted = {entry["name"] for entry in entries}
    for file in pathlib.Path(state, "rows").glob("*.json"):
        row = read_json(file)
        if row and row["name"] not in wanted:
            shutil.rmtree(os.path.join(output, row["folder"]), ignore_errors=True)
            file.unlink()


def merge(state):
    """Writes both files; returns the rows."""
    entries, output = read_json(os.path.join(state, "plan.json")), os.path.dirname(state)
    remove_others(entries, output, state)
    rows = list(rows_of(entries, state))
    for row in rows:
        row["report"] = report_of(row, output)
    write(os.path.join(output, "batch.csv"), table_of(rows))
    write(os.path.join(output, "batch.html"), page.page_of(rows))
    return rows
