"""What scripts share that tabulate and draw: the methods' colours, rows of tables, pictures, pages. Only drawing needs matplotlib."""
import base64
import collections
import csv
import html
import importlib.machinery
import importlib.util
import pathlib
import re
import sys

# Okabe and Ito's colours, which the colour-blind tell apart, each with a marker of its own; in the order of charts.
METHODS = {"certified": ("#0072B2", "o"), "hacd": ("#D55E00", "s"), "acd": ("#009E73", "^"), "single_hull": ("#CC79A7", "D"), "bounding_box": ("#E69F00", "v")}
PEERS = [("#000000", "X", "-"), ("#888888", "*", "-"), ("#000000", "<", "--"), ("#888888", ">", "--")]
LETTERS = {"svg.fonttype": "none", "font.sans-serif": ["DejaVu Sans", "Verdana"]}  # as text, not as outlines
STYLE = """body{font:15px/1.5 sans-serif;margin:2em auto;max-width:1200px;padding:0 1em;color:#222}img{max-width:100%}
table{border-collapse:collapse;font-size:12px}td,th{padding:2px 8px;border-bottom:1px solid #ddd;text-align:left}
figure{margin:2em 0}figcaption{color:#444}.bad{color:#a03000}"""


def load(name):
    """Another script, as a module."""
    loader = importlib.machinery.SourceFileLoader(name, str(pathlib.Path(__file__).resolve().parent / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def given_folder(usage):
    """The one argument of the program; without it, this ends the program."""
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        print(usage)
        sys.exit(0 if sys.argv[1:] in (["-h"], ["--help"]) else 2)
    return pathlib.Path(sys.argv[1])


# --- Tables ---------------------------------------------------------------------------------------------------------------------------

def read_rows(file):
    """Of a CSV file; none if it is not there."""
    if not file.exists():
        return []
    with open(file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def grouped(rows, *keys):
    groups = collections.OrderedDict()
    for row in rows:
        groups.setdefault(tuple(row[key] for key in keys), []).append(row)
    return groups


def markdown(head, lines):
    rows = ["| " + " | ".join(map(str, line)) + " |" for line in [head, *lines]]
    return "\n".join([rows[0], "|" + "---|" * len(head), *rows[1:]]) + "\n"


# --- Pictures -------------------------------------------------------------------------------------------------------------------------

def pyplot_for(salt, **settings):
    """matplotlib's, drawing without a screen and the same bytes every time."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    pyplot.rcParams.update({"svg.hashsalt": salt, **settings})
    return pyplot


def pyplot_or_exit(salt):
    try:
        return pyplot_for(salt)
    except ImportError:
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: matplotlib is missing, so there are no charts: install python3-matplotlib")


def save(figure, folder, name, dpi=110):
    """Writes SVG and PNG, without dates; returns the chart as an element of a page. dpi: of the PNG, and of images within the SVG."""
    from matplotlib import pyplot
    figure.savefig(folder / f"{name}.svg", dpi=dpi, metadata={"Date": None})
    figure.savefig(folder / f"{name}.png", dpi=dpi)
    pyplot.close(figure)
    data = base64.b64encode((folder / f"{name}.svg").read_bytes()).decode()
    return f'<img alt="{name}" src="data:image/svg+xml;base64,{data}">'


def slim(svg):
    """Makes matplotlib's drawing half its size: hundredths of a point do, and nobody reads the indentation."""
    def rounded(tag):
        return re.sub(r"-?\d+\.\d+", lambda n: f"{float(n.group()):.2f}".rstrip("0").rstrip("."), tag.group())
    text = re.sub(r"<[a-z][^>]*>", rounded, re.sub(r"\n\s+", "\n", svg.read_text(encoding="utf-8")))
    text = re.sub(r' d="[^"]*"', lambda path: re.sub(r"\s*\n", "", path.group()), text)
    svg.write_text(text, encoding="utf-8")


# --- Pages ----------------------------------------------------------------------------------------------------------------------------

def table(rows, columns=None, bad=lambda row: False):
    """HTML."""
    columns = columns or list(rows[0])
    lines = ["<tr>" + "".join(f"<th>{html.escape(column)}</th>" for column in columns) + "</tr>"]
    lines += [f"<tr{' class=bad' if bad(row) else ''}>" + "".join(f"<td>{html.escape(str(row[column]))}</td>" for column in columns) + "</tr>" for row in rows]
    return "<table>" + "\n".join(lines) + "</table>"


def write_page(folder, title, body):
    (folder / "index.html").write_text(f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title><style>{STYLE}</style></head>\n'
                                       f"<body><h1>{title}</h1>{body}</body></html>\n", encoding="utf-8")
