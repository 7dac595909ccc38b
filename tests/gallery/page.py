# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a case as a page of HTML, one file with its pictures in it."""

from __future__ import annotations

import base64
import html
from pathlib import Path

from contact_results import Results

STYLE = """
body { font: 15px/1.45 "DejaVu Sans", sans-serif; max-width: 1000px;
       margin: 2em auto; padding: 0 1em; color: #1a1a1a; background: white; }
table { border-collapse: collapse; margin: 0.5em 0 1.5em; font-size: 14px; }
th, td { padding: 0.2em 0.8em; border-bottom: 1px solid #ddd; text-align: right;
         vertical-align: top; }
th:first-child, td:first-child, td.text, th.text { text-align: left; }
img { max-width: 100%; } figure { margin: 1em 0; }
summary { font-size: 1.5em; font-weight: bold; margin: 0.8em 0; }
figcaption, .quiet { color: #555; font-size: 14px; }
.bad { color: #c00020; font-weight: bold; }
"""
TYPES = {".png": "image/png", ".svg": "image/svg+xml"}
DIGITS = 8
INCREMENTS = {"load_factor": "t", "newton_iterations": "Newton steps",
              "friction_iterations": "friction iterations",
              "geometry_iterations": "geometry iterations", "active": "active",
              "stick": "stick", "slip": "slip", "halved_steps": "halved steps"}


def shown(value, digits=DIGITS) -> str:
    """A number, a word or "-" for what there is not."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if value is None or value != value:
        return "-"
    if isinstance(value, float):
        return f"{value:.{digits}g}"
    return html.escape(str(value))


def table(head: list[str], rows: list[list]) -> str:
    """Columns of words are aligned left, as the first one is."""
    if not rows:
        return ""
    words = [all(isinstance(row[i], str) for row in rows)
             for i in range(len(head))]

    def line(tag, cells):
        return "<tr>" + "".join(
            f"<{tag}{' class=text' if w else ''}>{c}</{tag}>"
            for c, w in zip(cells, words)) + "</tr>"
    return "\n".join(["<table>", line("th", map(html.escape, head)),
                      *(line("td", map(shown, row)) for row in rows), "</table>"])


def state(case: Results) -> str:
    summary = case.summary
    if summary["converged"] and not summary["interrupted"]:
        missed = summary.get("accuracy_missed")
        return (f'<p class="bad">{html.escape(missed)}</p>' if missed else
                "<p>All increments converged.</p>")
    said = summary["message"] or "the run did not come to its end"
    return (f'<p class="bad">Not converged: {html.escape(said)}</p>'
            "<p>What is below is of the increments before.</p>")


def facts(case: Results) -> str:
    """What was computed, by what and when: of summary.json all that is a word or a
    number."""
    summary = case.summary
    # The state has these.
    told = {"converged", "interrupted", "message", "accuracy_missed"}
    rows = {key.replace("_", " "): value for key, value in summary.items()
            if isinstance(value, (str, int, float)) and value != ""
            and key not in told}
    rows |= {f"unknowns, {name}": n for name, n in summary["unknowns"].items()}
    rows |= summary["effects"]
    rows["units"] = "mm, N, MPa"
    return table(["", ""], [[name, value if isinstance(value, str) else
                             shown(value, 4)] for name, value in rows.items()])


def probes(case: Results) -> str:
    rows = []
    for name, probe in case.probes.iterrows():
        deviation, tolerance = probe["relative_deviation"], probe["tolerance"]
        known = deviation == deviation and deviation is not None
        judged = known and tolerance == tolerance and tolerance is not None
        rows.append([name, float_or_none(probe["value"]), probe["unit"],
                     float_or_none(probe["estimated_error"], 2),
                     float_or_none(probe["reference"]),
                     f"{100 * deviation:+.4f} %" if known else None,
                     f"{100 * tolerance:g} %" if judged else None,
                     bool(abs(deviation) <= tolerance) if judged else None])
    return table(["probe", "value", "unit", "estimated error", "reference",
                  "deviation", "tolerance", "within"], rows)


def float_or_none(value, digits=DIGITS):
    if value is None or value != value:
        return None
    return float(f"{float(value):.{digits}g}")


def at_the_end(case: Results) -> str:
    """Forces of contact, reactions and works: the last row of history.csv."""
    if not any(i["converged"] for i in case.summary["increments"]):
        return ""
    history = case.history
    last, units, parts = history.iloc[-1], history.attrs["units"], []
    for word, title in (("contact", "Contact"), ("reaction", "Reactions"),
                        ("work", "Works, sums from the start")):
        rows = [[name.removeprefix(word + " ").replace("_", " "), float(last[name]),
                 units[name]] for name in history.columns
                if name.startswith(word + " ")]
        if rows:
            parts += [f"<h2>{title}, at t = {shown(float(history.index[-1]))}</h2>",
                      table(["", "value", "unit"], rows)]
    return "\n".join(parts)


def findings(case: Results) -> str:
    rows = [[f["severity"], f["where"], f["text"]]
            for f in case.summary["findings"]]
    return ("<h2>Findings</h2>"
            + (table(["", "where", "finding"], rows) or "<p>None.</p>"))


def increments(case: Results) -> str:
    rows = [[*(i.get(key) for key in INCREMENTS), i["converged"],
             i["message"]] for i in case.summary["increments"]]
    return (f"<details><summary>Increments: {len(rows)}</summary>" + table(
        [*INCREMENTS.values(), "converged", "message"], rows) + "</details>")


def picture(path: Path, words: str) -> str:
    data = base64.b64encode(path.read_bytes()).decode()
    words = html.escape(words)
    return (f'<figure><img alt="{words}" src="data:{TYPES[path.suffix]};'
            f'base64,{data}"><figcaption>{words}</figcaption></figure>')


def write_page(case: Results, pictures: dict[Path, str], missing: list[str],
               path: Path) -> None:
    """pictures: files and captions; missing: why there are no others."""
    name = html.escape(case.name)
    files = ", ".join(f'<a href="{html.escape(f.name)}">{html.escape(f.name)}</a>'
                      for f in sorted(case.folder.iterdir())
                      if f.suffix in (".csv", ".json", ".prm", ".pvd"))
    parts = ['<!DOCTYPE html>', '<html lang="en"><head><meta charset="utf-8">',
             f"<title>{name}</title><style>{STYLE}</style></head><body>",
             f"<h1>{name}</h1>", state(case), "<h2>Probes</h2>",
             probes(case) or "<p>The case has none.</p>", findings(case),
             *(picture(file, words) for file, words in pictures.items()),
             *(f'<p class="quiet">{html.escape(why)}</p>' for why in missing),
             at_the_end(case), increments(case), "<h2>The case</h2>", facts(case),
             f'<p class="quiet">Files: {files}</p>', "</body></html>", ""]
    path.write_text("\n".join(parts), encoding="utf-8")
