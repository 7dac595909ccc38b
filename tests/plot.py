#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures and pages of results (./run plot), and the Python module that reads them.

Proves of a case in 2-D, one in 3-D and one on two processes with levels that

- the pictures of the bodies have the colours of all stresses, from the lowest band
  to the highest, in a good part of the picture, and those of the pressure in 3-D;
- the curves of history and tractions, as drawn, go through the values of history.csv
  and profile.csv under their names: within 0.02 pixels a linear map of the
  values, the same one for all curves of a panel;
- the page has the probes, the forces of contact and the findings of summary.json in
  its tables, all pictures in itself, and refers to no other address;
- the module has the numbers of summary.json: probes, those of the history to the
  last bit, the largest pressure of profile.csv (to 1e-8) and of the VTU (single
  precision); and the units;
- the notebook runs, has no outputs, and finds the same;
- the module is among what cmake installs.

A case that has not been run, a folder without results, damaged files, a piece that
is missing end with what to do; files that a case did not ask for are named.

Usage: plot.py CONTACT PARAMETERS MESHES
"""

import html
import json
import os
import pathlib
import re
import shutil
import sys

import numpy
from plot_scenes import ROOT, colours_in, compute, plot, share

sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tests/gallery"))
from contact_results import Results  # noqa: E402

contact = pathlib.Path(sys.argv[1]).resolve()
parameters = pathlib.Path(sys.argv[2]).resolve()
meshes = pathlib.Path(sys.argv[3]).resolve()
failures = []
# The ends of the colours, and one between them.
LOWEST, HIGHEST, BANDS = "440154", "fde725", 12
PIXEL = 0.02  # places of a drawing have two digits
SINGLE = 1e-6


def check(what, ok, detail=""):
    print(f"{'ok' if ok else 'FAILED'}: {what} {'' if ok else detail}")
    if not ok:
        failures.append(what)


# ----------------------------------------------------------------- the pictures

def check_bodies(picture):
    for colour in (LOWEST, HIGHEST):
        check(f"  {picture.name} has {colour}", share(picture, colour) > 0.001,
              share(picture, colour))
    check(f"  {picture.name}: bands of colours and the background",
          colours_in(picture) > BANDS, colours_in(picture))


def drawn_curves(picture):
    """Of each panel of a drawing the curves: name and places, in pixels."""
    panels, last = [], None
    for number, name, body in re.findall(
            r'<g id="gnuplot_plot_(\d+)[a-z]*" ?><title>(.*?)</title>(.*?)'
            r"(?=<g id=\"gnuplot_plot_|</svg>)", picture.read_text(), re.S):
        path = re.search(r"<path [^>]*d='(M[^']*)'", body)
        if last is None or int(number) <= last:
            panels.append({})
        last = int(number)
        if path:
            # The first two places are those of the line beside the name.
            panels[-1][html.unescape(name)] = numpy.array(
                re.findall(r"[ML]\s*([-\d.]+),([-\d.]+)", path[1]), float)[2:]
    return panels


def check_panel(what, curves, values):
    """One linear map from the values to the places, for all curves."""
    for d, axis in enumerate("xy"):
        drawn = numpy.concatenate([curves[name][:, d] for name in values])
        wanted = numpy.concatenate([v[:, d] for v in values.values()])
        if len(drawn) != len(wanted):
            check(f"  {what}: points", False, f"{len(drawn)} {len(wanted)}")
            return
        matrix = numpy.c_[wanted, numpy.ones(len(wanted))]
        fit, *_ = numpy.linalg.lstsq(matrix, drawn, rcond=None)
        worst = numpy.abs(matrix @ fit - drawn).max()
        check(f"  {what}: {axis}", worst < PIXEL and
              (fit[0] > 0) == (axis == "x"), f"{worst} {fit}")


def check_history(case, picture):
    """Each panel has columns of one kind, whose names are in front of its own."""
    history = case.history
    for k, curves in enumerate(drawn_curves(picture)):
        values = {}
        for name in curves:
            column = next(c for c in history.columns if c == name or any(
                c == f"{kind} {name}" for kind in ("contact", "reaction", "work"))
                and c not in values)
            values[name] = numpy.c_[history.index, history[column]]
        check(f"  panel {k} of the history", len(curves) > 0)
        check_panel(f"panel {k} of the history, {', '.join(values)}", curves, values)
    names = {n for curves in drawn_curves(picture) for n in curves}
    check("  the history has the force of contact", "normal_force" in names, names)


def check_tractions(case, picture):
    curves, rows = drawn_curves(picture)[0], case.profile("slave")
    n = len(curves["pressure"])
    arc = rows["arc_length"][rows["status"] > 0]
    first = next(i for i in range(len(rows)) if numpy.isclose(
        rows["arc_length"][i], arc.min()) or rows["arc_length"][i] >= arc.min()
        - 0.25 * (arc.max() - arc.min()))
    rows = rows.iloc[first:first + n]
    check("  the tractions have all of the contact",
          rows["arc_length"].max() >= arc.max())
    check_panel("tractions", curves, {name: rows[["arc_length", name]].to_numpy()
                                      for name in ("pressure", "shear")})


# ---------------------------------------------------------------------- the page

def cells(page):
    return [html.unescape(c) for c in re.findall(r"<td[^>]*>(.*?)</td>", page)]


def check_page(case, page):
    text = page.read_text()
    found, summary = cells(text), case.summary
    for probe in summary["probes"]:
        check(f"  the page has {probe['name']}", probe["name"] in found and
              f"{probe['value']:.8g}" in found, probe)
    for name, value in summary["contact"].items():
        check(f"  the page has {name}", name.replace("_", " ") in found and
              f"{value:.8g}" in found, value)
    for finding in summary["findings"]:
        check("  the page has the finding", finding["text"] in found)
    check("  three pictures are in it",
          len(re.findall(r'<img [^>]*src="data:image/', text)) == 3)
    check("  it needs no other file",
          not re.findall(r'(?:src|href)="(?!data:)[^"]*[/:]', text))


# -------------------------------------------------------------------- the module

def check_numbers(case):
    summary, last = case.summary, case.summary["increments"][-1]
    for probe in summary["probes"]:
        row = case.probes.loc[probe["name"]]
        check(f"  probe {probe['name']}", row["value"] == probe["value"] and
              row["unit"] in ("mm", "MPa"), row)
    end = case.history.iloc[-1]
    for name, value in last["probes"].items():
        check(f"  {name} of the history", end[name] == value, end[name])
    for name, value in last["contact"].items():
        check(f"  {name} of the history", end[f"contact {name}"] == value)
    slave = case.profile("slave")
    largest = summary["contact"]["max_pressure"]
    check("  largest pressure of the profile",
          abs(slave["pressure"].max() / largest - 1) < 1e-8)
    points = case.points("contact")
    check("  largest pressure of the VTU",
          abs(points["pressure"].max() / largest - 1) < SINGLE)
    check("  units of the profile", slave.attrs["units"]["pressure"] == "MPa" and
          slave.attrs["units"]["gap"] == "mm", slave.attrs)
    check("  times", case.times("bodies") == [
        i["load_factor"] for i in summary["increments"]
        if i["level"] == last["level"]], case.times("bodies"))
    first = case.points("bodies", time=0)
    check("  the first increment has displacements of its own",
          len(first) == len(case.points("bodies")) and
          not first["displacement_x"].equals(case.points("bodies")["displacement_x"]))


def check_notebook(folder):
    notebook = json.loads((ROOT / "tests/gallery/results.ipynb").read_text())
    cells_of_code = [c for c in notebook["cells"] if c["cell_type"] == "code"]
    check("  the notebook has no outputs", not any(
        c["outputs"] or c["execution_count"] for c in cells_of_code))
    try:
        import matplotlib
        matplotlib.use("agg")
    except ImportError:
        check("  the notebook: NOT RUN, needs python3-matplotlib", True)
        return
    os.environ["CONTACT_RESULTS"] = str(folder)
    names = {}
    for cell in cells_of_code:
        exec("".join(cell["source"]), names)  # noqa: S102, its own cells
    force = names["case"].summary["contact"]["normal_force"]
    check("  the notebook: sum of the nodal forces",
          abs(names["slave"]["nodal_force"].sum() / force - 1) < 1e-9)


def check_installed():
    rules = [d / "cmake_install.cmake" for d in contact.parents
             if (d / "CMakeCache.txt").exists()]
    if not rules:
        check("what is installed: NOT SEEN, the program is in no build folder", True)
        return
    text = rules[0].read_text()
    check("the module and the notebook are installed", all(
        name in text for name in ("dist-packages", "contact_results.py",
                                  "results.ipynb")))


# ---------------------------------------------------------------------- the cases

def case(name, file, *settings, processes=1):
    print(f"{name}:")
    folder = compute(contact, file, *settings, processes=processes)
    status, said = plot(file)
    check("  exit status", status == 0, said)
    results = Results(folder)
    check_bodies(folder / "von_mises.png")
    check_history(results, folder / "history.svg")
    check("  history.png is no blank", colours_in(folder / "history.png") > 1)
    check_page(results, folder / "report.html")
    check_numbers(results)
    return results


def refused(what, arguments, *words):
    status, said = plot(*arguments)
    check(f"{what} is refused", status == 2 and all(w in said for w in words)
          and "Traceback" not in said, f"{status} {said}")


def damaged(original):
    """A copy of results to spoil."""
    copy = pathlib.Path("damaged")
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(original, copy)
    return copy


def check_bad_input(folder):
    refused("a case that has not been run", [parameters / "ssnp154_h.prm"],
            "compute it first", f"./run {parameters / 'ssnp154_h.prm'}", "VTU=true")
    refused("no such file", ["nothing.prm"], "no file nothing.prm")
    refused("no such folder", ["nothing"], "no folder nothing")
    pathlib.Path("empty").mkdir(exist_ok=True)
    refused("a folder without results", ["empty"], "summary.json")
    copy = damaged(folder)
    (copy / "summary.json").write_text('{"converged": tr')
    refused("a damaged summary", [copy], "summary.json", "damaged")
    for file, why in (("bodies.pvd", "Output/VTU = true"),
                      ("profile.csv", "Output/Profile = true")):
        copy = damaged(folder)
        (copy / file).unlink()
        status, said = plot(copy)
        check(f"without {file} the page says why", status == 0 and why in said and
              why in (copy / "report.html").read_text(), said)
    copy = damaged(folder)
    next(iter(sorted(copy.glob("bodies_*.vtu"))[-1:])).write_text("<VTKFile")
    status, said = plot(copy)
    check("damaged VTU are told, and an earlier picture is gone", status == 0 and
          "damaged" in said and not (copy / "von_mises.png").exists(), said)


plane = case("in 2-D", parameters / "ssnp154_g.prm")
check_tractions(plane, plane.folder / "tractions.svg")
check_notebook(plane.folder)
space = case("in 3-D", parameters / "sphere_on_block.prm")
check_bodies(space.folder / "pressure.png")
pieces = case("two processes, two levels", parameters / "nested_friction.prm",
              "--set", f"Mesh/File={meshes / 'ssnp154_quads.msh'}",
              "--set", "Refinement/Levels=2", processes=2)
check("  pieces", list(pieces.folder.glob("bodies_*.0001.vtu")) != [])
check("  estimated errors are in the page", any(
    f"{p['estimated_error']:.2g}" in cells((pieces.folder / "report.html").read_text())
    for p in pieces.summary["probes"]))
piece = damaged(pieces.folder)
sorted(piece.glob("bodies_*.0001.vtu"))[-1].unlink()
status, said = plot(piece)
check("a missing piece is told", status == 0 and "0001.vtu is missing" in said, said)
check_bad_input(plane.folder)
check_installed()
print(len(failures), "failures")
sys.exit(bool(failures))
