"""batch.html: what a batch has to tell, as a page that opens from disk and needs no network. Its style is that of report.html.

Totals, charts and the lists of the failed, slowest and worst are written here; a script fills the table of all inputs, a part at a time.
"""
import html
import json
import math
import pathlib
import re
import textwrap
import urllib.parse

import progress

HERE = pathlib.Path(__file__).resolve().parent
LISTED = 15  # rows of the slowest and of the worst
FAILED_LISTED = 200
WIDTH, HEIGHT, BASE = 460, 150, 118  # of a chart


def style():
    """report.html's, from the sources or from where it is installed, and a few words more."""
    places = (HERE / "style.css", HERE.parents[1] / "src/web/page/style.css")
    return next(place for place in places if place.exists()).read_text(encoding="utf-8") + (HERE / "page.css").read_text(encoding="utf-8")


def figure(value):
    return f"{value:.3g}" if value < 1000 else f"{value:,.0f}"


def counted(number, noun):
    return f"{number:,} {noun}{'s' * (number != 1)}"


def edges(low, high):
    """1, 2, 5, 10...: around both."""
    steps = [base * 10.0 ** power for power in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1) for base in (1, 2, 5)]
    first = max(i for i, step in enumerate(steps) if step <= low)
    last = min((i for i, step in enumerate(steps) if step > high), default=len(steps) - 1)
    return steps[first : last + 1]


def histogram(title, values):
    """Bars over steps of 1, 2, 5, 10..., as SVG. Values below a ten-thousandth of the largest are in its first bar."""
    values = [value for value in values if value > 0]
    if not values:
        return ""
    steps = edges(max(min(values), max(values) / 1e4), max(values))
    counts = [sum(low <= value < high for value in values) for low, high in zip(steps, steps[1:])]
    counts[0] += sum(value < steps[0] for value in values)
    bar, parts = WIDTH / len(counts), []
    for i, count in enumerate(counts):
        height = 90 * count / max(counts)
        parts.append(f'<rect x="{i * bar + 1:.1f}" y="{BASE - height:.1f}" width="{bar - 2:.1f}" height="{height:.1f}">'
                     f"<title>{figure(steps[i])} to {figure(steps[i + 1])}: {count}</title></rect>")
        if count:
            parts.append(f'<text class="count" x="{(i + 0.5) * bar:.1f}" y="{BASE - height - 5:.1f}">{count}</text>')
        parts.append(f'<text x="{i * bar:.1f}" y="{BASE + 16}">{figure(steps[i])}</text>')
    median = sorted(values)[len(values) // 2]
    return (f'<figure><figcaption>{title}: <span class="quiet">median {figure(median)}, most {figure(max(values))}</span></figcaption>'
            f'<svg class="chart" viewBox="-16 0 {WIDTH + 32} {HEIGHT}" role="img" aria-label="{title}">{"".join(parts)}</svg></figure>')


def link(text, report):
    text = html.escape(text)
    return f'<a href="{urllib.parse.quote(report)}">{text}</a>' if report else text


def table(heads, rows):
    """Cells are text that is escaped already; numbers go to the right."""
    head = "".join(f"<th>{name}</th>" for name in heads)
    body = "".join("<tr>" + "".join(f'<td class="number">{figure(cell)}</td>' if isinstance(cell, (int, float)) else f"<td>{cell}</td>" for cell in row) + "</tr>"
                   for row in rows)
    return f'<div class="wide"><table class="plain"><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>'


def report_of(row):
    return row["report"]


def meshes_of(rows):
    return [(row, mesh) for row in rows for mesh in row["meshes"]]


def bodies(mesh):
    """Hulls and what stands in their place."""
    return mesh["hulls"] + mesh["primitives"]


def bounds(meshes):
    """[mm] Of those that have one."""
    return [1000 * mesh["protrusion"] for mesh in meshes if mesh["protrusion"] is not None]


def failures(rows):
    """By reason, then one by one."""
    failed = [(row["name"], report_of(row), row) for row in rows if row["cause"]]
    failed += [(f"{row['name']}, {mesh['link']}", report_of(row), mesh) for row, mesh in meshes_of(rows) if mesh["status"] == "failed"]
    if not failed:
        return ""
    each = [(link(name, report), html.escape(item["cause"]), html.escape(item["reason"])) for name, report, item in failed[:FAILED_LISTED]]
    more = f"<p class=\"quiet\">{len(failed) - FAILED_LISTED:,} more are in batch.csv.</p>" if len(failed) > FAILED_LISTED else ""
    return ("<section><h2>Failures</h2>" + table(("Reason", "Inputs and meshes"), [(html.escape(kind), number) for number, kind, _ in progress.kinds(rows)])
            + f"<details><summary>One by one</summary>{table(('Input, link', 'Cause', 'Reason'), each)}{more}</details></section>")


def slowest(rows):
    best = sorted(rows, key=lambda row: (-row["seconds"], row["name"]))[:LISTED]
    return "<section><h2>The slowest</h2>" + table(("Input", "Time [s]", "CPU [s]", "Memory [MB]"), [
        (link(row["name"], report_of(row)), row["seconds"], row["cpu"], row["memory"]) for row in best]) + "</section>"


def worst(rows):
    """Those that come closest to their tolerance, or exceed it."""
    done = [(row, mesh, mesh["protrusion"] / mesh["tolerance"]) for row, mesh in meshes_of(rows) if bodies(mesh) and mesh["tolerance"]]
    done = sorted(done, key=lambda item: (-item[2], item[0]["name"]))[:LISTED]
    return "<section><h2>The largest bounds for their tolerance</h2>" + table(("Input, link", "Bound [mm]", "Of tolerance [%]", "Hulls, primitives"), [
        (link(f"{row['name']}, {mesh['link']}", report_of(row)), 1000 * mesh["protrusion"], 100 * share, bodies(mesh)) for row, mesh, share in done]) + "</section>"


def why(row):
    """Its reason, and that of its first mesh that failed."""
    first = next((mesh["reason"] for mesh in row["meshes"] if mesh["status"] == "failed"), "")
    return textwrap.shorten(row["reason"] + (": " if first else "") + first, 400, placeholder=" …")


def summary(rows):
    meshes = [mesh for _, mesh in meshes_of(rows)]
    states = ", ".join(f"{sum(row['status'] == state for row in rows):,} {state}" for state in ("ok", "degraded", "incomplete", "failed")
                       if any(row["status"] == state for row in rows))
    done = [mesh for mesh in meshes if mesh["status"] in ("ok", "degraded")]
    cpu = sum(row.get("cpu", 0) for row in rows)
    return (f'<p class="lead">{counted(len(rows), "input")}: {states}. {len(done):,} of {len(meshes):,} meshes covered, with '
            f'{sum(map(bodies, done)):,} hulls and primitives and a proved bound each, in {progress.duration(cpu)} of computing time.</p>')


def data_of(rows):
    """What the table of all inputs shows. "<" would let a name end the script."""
    cells = [[row["name"], row["status"], report_of(row), len(row["meshes"]), sum(map(bodies, row["meshes"])),
              max(bounds(row["meshes"]), default=0), row["seconds"], row["memory"], row["attempts"],
              why(row)] for row in rows]
    return json.dumps(cells, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")


def page_of(rows):
    rows = [{"seconds": 0, "cpu": 0, "memory": 0, "attempts": 0, **row} for row in rows]
    meshes = [mesh for _, mesh in meshes_of(rows)]
    charts = "".join([histogram("Hulls and primitives of a mesh", [bodies(mesh) for mesh in meshes]), histogram("Time of an input [s]", [row["seconds"] for row in rows]),
                      histogram("Bound of a mesh [mm]", bounds(meshes)), histogram("Memory of an input [MB]", [row["memory"] for row in rows])])
    parts = {"style": style(), "summary": summary(rows), "charts": charts, "failures": failures(rows), "slowest": slowest(rows), "worst": worst(rows),
             "script": (HERE / "page.js").read_text(encoding="utf-8"), "data": data_of(rows)}
    # All at once: a link may be called {{data}}.
    return re.sub(r"{{(\w+)}}", lambda place: parts[place.group(1)], (HERE / "page.html").read_text(encoding="utf-8"))
