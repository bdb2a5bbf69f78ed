"""One self-contained HTML file with all tables and figures of a study, in the order of its pages."""

import base64
import platform
import re
from html import escape
from pathlib import Path

import markdown_it

import manipplan as mp
from studies.printed import Comparison

KINDS = {".png": "image/png", ".svg": "image/svg+xml"}
#: A heading, a table, or a figure with its description, as written in the pages of the studies.
PIECE = re.compile(
    r"^(?P<level>#+) (?P<heading>.+)$"
    r"|^```\{include\} (?P<table>\S+)$"
    r"|^```\{image\} (?P<image>\S+)\n:alt: (?P<alt>.+)$"
    r"|^!\[(?P<text>[^\]]*)\]\((?P<file>[^)]+)\)$",
    re.MULTILINE,
)
STYLE = """
:root { color-scheme: light; --text: #1b1f24; --muted: #59626e; --edge: #c9ced6; --bad: #9b1c1c; }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--text); background: #fff;
  max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1, h2, h3 { line-height: 1.2; margin: 2.2rem 0 0.8rem; }
figure, .table { margin: 1.2rem 0; overflow-x: auto; }
figure img { max-width: 100%; height: auto; }
figcaption, .note { color: var(--muted); font-size: 0.9rem; }
table { border-collapse: collapse; font-size: 0.85rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 0.25rem 0.7rem; border-bottom: 1px solid var(--edge); vertical-align: top; }
.different { color: var(--bad); }
"""


def study_text(page: Path) -> str:
    """The text of a study's page followed by that of the chapters in its toctree, whose headings are one level lower."""
    text = page.read_text(encoding="utf-8")
    names = re.search(r"```\{toctree\}\n:hidden:\n\n(.*?)\n```", text, re.DOTALL)
    chapters = [page.with_name(f"{name}.md").read_text(encoding="utf-8") for name in names[1].split()] if names else []
    return "\n".join([text, *(re.sub(r"^#", "##", chapter, flags=re.MULTILINE) for chapter in chapters)])


def write_report(page: Path, folder: Path, *, quick: bool, seconds: float, found: Comparison) -> Path:
    """Collect the tables and figures that a run wrote to `folder` in report.html there; returns that file.

    `page` is the study's page in the docs, which has the text, `seconds` the duration of the run, and `found` what the
    comparison with the expected results found.
    """
    text = study_text(page)
    title = re.sub(r"[`*]|\{[^}]*\}", "", text.split("\n", 1)[0].lstrip("# "))
    body = [f"<h1>{escape(title)}</h1>", *_head(page, quick, seconds, found)]
    pending: list[str] = []
    for piece in list(PIECE.finditer(text))[1:]:
        if piece["heading"]:
            level = len(piece["level"])
            pending = [heading for heading in pending if int(heading[2]) < level] + [
                f"<h{level}>{escape(re.sub('[`*]', '', piece['heading']))}</h{level}>"
            ]
            continue
        file = folder / Path(piece["table"] or piece["image"] or piece["file"]).name
        body += pending
        pending = []
        if not file.is_file():
            body.append(f'<p class="note">{escape(file.stem)}: left out by --quick.</p>')
        elif piece["table"]:
            made = markdown_it.MarkdownIt("commonmark").enable("table").render(file.read_text(encoding="utf-8"))
            body.append(f'<div class="table" tabindex="0">{made}</div>')
        else:
            body.append(_figure(file, piece["alt"] or piece["text"]))
    report = folder / "report.html"
    page_text = "\n".join(body)
    report.write_text(
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>{escape(title)}</title>\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n<link rel="icon" href="data:,">\n'
        f"<style>{STYLE}</style>\n</head>\n<body>\n<main>\n{page_text}\n</main>\n</body>\n</html>\n",
        encoding="utf-8",
    )
    return report


def _head(page: Path, quick: bool, seconds: float, found: Comparison) -> list[str]:
    command = f"manipplan study {page.stem}{' --quick' if quick else ''}"
    lines = [
        f'<p class="note"><code>{command}</code>: {seconds:.0f} s with manipplan {mp.__version__}, Python '
        f"{platform.python_version()}, {platform.machine()}. The study's page in the documentation explains each table and "
        "figure.</p>"
    ]
    if not found.differences:
        return [*lines, f"<p><strong>All figures are as expected:</strong> {escape(found.summary)}.</p>"]
    items = "".join(f"<li>{escape(line)}</li>" for line in found.differences)
    return [*lines, f'<p class="different"><strong>Not as expected:</strong></p><ul class="different">{items}</ul>']


def _figure(file: Path, alt: str) -> str:
    data = base64.b64encode(file.read_bytes()).decode()
    return (
        f'<figure><img alt="{escape(alt)}" src="data:{KINDS[file.suffix]};base64,{data}">'
        f"<figcaption>{escape(alt)}</figcaption></figure>"
    )
