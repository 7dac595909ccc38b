#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of results, drawn without a screen.

    gallery.py [--output DIR] [--pictures DIR] CONTACT

CONTACT is the program; it computes the cases into DIR (output/gallery), the
pictures go to results beside this file. VTK draws the bodies, gnuplot the
curves; convergence is that of the study, from its results. VTK of Debian
(python3-vtk9) draws on X only: xvfb-run gallery.py ..., as ./run gallery does.
Exit status: 0, 1 if a case or a picture has failed.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401, names draw text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersGeneral import vtkWarpVector
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor,
    vtkWindowToImageFilter)

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tests/study"))
import plots  # noqa: E402
import report  # noqa: E402

BODIES = ("ssnp154_a", "ssnp154_g")  # in colours
PRESSURES = ("ssnp154_a", "ssnp154_c", "ssnp154_d", "nested")
FRICTION = ("ssnp154_d", "nested_friction")
CONVERGENCE = "rings_orders"
SETTINGS = {"Output/VTU": "true", "Output/Profile": "true",
            "Output/Screen": "none"}

# Viridis: dark to light, even in grey and to the colour-blind. Blue to red for
# what has a sign.
VIRIDIS = ["440154", "472d7b", "3b528b", "2c728e", "21918c", "28ae80",
           "5ec962", "addc30", "fde725"]
DIVERGING = ["3b4cc0", "7b9ff9", "c0d4f5", "f2f2f2", "f2cbb7", "ee8468",
             "b40426"]
BANDS = 12
# Drawn larger, then averaged: edges get smooth, without the seams that samples
# within a pixel leave between the triangles of a cell.
SIZE, FINER = (1000, 700), 3
STATUS = {0: ("open", "808080"), 1: ("slip", "d08000"), 2: ("stick", "2060b0")}
TEXT = (0.1, 0.1, 0.1)


def rgb(colour: str) -> tuple[float, ...]:
    return tuple(int(colour[i:i + 2], 16) / 255 for i in (0, 2, 4))


def run_case(contact: Path, name: str, output: Path) -> Path:
    """The directory with the results of a case."""
    call = [contact, ROOT / "parameters" / f"{name}.prm", "--quiet", "--set",
            f"Output/Directory={output}"]
    for entry, value in SETTINGS.items():
        call += ["--set", f"{entry}={value}"]
    run = subprocess.run(call)
    # 1: a value outside of its tolerance, which is no picture's business
    if run.returncode not in (0, 1):
        sys.exit(f"gallery.py: {name} ends with exit status {run.returncode}")
    return output / name


def summary(case: Path) -> dict:
    return json.loads((case / "summary.json").read_text())


def describe(case: Path) -> str:
    effects = summary(case)["effects"]
    friction = effects["friction"].split(",")[0]
    if friction == "none":
        friction = "no friction"
    return ", ".join([effects["element"], effects["contact"].split(",")[0],
                      friction])


def value(case: Path, probe: str) -> float:
    return next(p["value"] for p in summary(case)["probes"]
                if p["name"] == probe)


# -------------------------------------------------------------------- the bodies

def last_grid(case: Path, name: str):
    """Bodies or contact surface at the end of the load, moved."""
    sets = xml.parse(case / f"{name}.pvd").findall(".//DataSet")
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(case / sets[-1].get("file")))
    reader.Update()
    grid = reader.GetOutput()
    grid.GetPointData().SetActiveVectors("displacement")
    warp = vtkWarpVector()
    warp.SetInputData(grid)
    warp.Update()
    return warp.GetOutput()


def extreme(grid, name: str, window) -> float:
    """The largest modulus of a field in a window (x0, x1, y0, y1)."""
    field, largest = grid.GetPointData().GetArray(name), 0.0
    for i in range(grid.GetNumberOfPoints()):
        x, y, _ = grid.GetPoint(i)
        if window[0] <= x <= window[1] and window[2] <= y <= window[3]:
            largest = max(largest, abs(field.GetValue(i)))
    return largest


def colours(names: list[str], low: float, high: float) -> vtkLookupTable:
    """Bands between the colours of a list."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(BANDS)
    table.SetRange(low, high)
    for i in range(BANDS):
        place = i / (BANDS - 1) * (len(names) - 1)
        k = min(int(place), len(names) - 2)
        mixed = [(1 - place + k) * a + (place - k) * b
                 for a, b in zip(rgb(names[k]), rgb(names[k + 1]))]
        table.SetTableValue(i, *mixed, 1)
    return table


def body_actor(grid, name: str, table, edges: bool) -> vtkActor:
    """The bodies in the colours of a field."""
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(name)
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    if edges:
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetEdgeColor(0.25, 0.25, 0.25)
        actor.GetProperty().SetLineWidth(FINER)
    return actor


def status_actor(grid, status: int) -> vtkActor:
    """Nodes of the slave with this status, as dots."""
    nodes = vtkThreshold()
    nodes.SetInputData(grid)
    nodes.SetInputArrayToProcess(0, 0, 0,
                                 vtkDataObject.FIELD_ASSOCIATION_POINTS,
                                 "status")
    nodes.SetLowerThreshold(status - 0.5)
    nodes.SetUpperThreshold(status + 0.5)
    nodes.AllScalarsOff()
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputConnection(nodes.GetOutputPort())
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*rgb(STATUS[status][1]))
    actor.GetProperty().SetRepresentationToPoints()
    actor.GetProperty().SetPointSize(14 * FINER)
    actor.GetProperty().RenderPointsAsSpheresOn()
    actor.GetProperty().LightingOff()
    return actor


def frame_actor(window) -> vtkActor:
    """The border of a window."""
    plane = vtkPlaneSource()
    plane.SetOrigin(window[0], window[2], 0)
    plane.SetPoint1(window[1], window[2], 0)
    plane.SetPoint2(window[0], window[3], 0)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(plane.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetRepresentationToWireframe()
    actor.GetProperty().SetColor(*TEXT)
    actor.GetProperty().SetLineWidth(2 * FINER)
    actor.GetProperty().LightingOff()
    return actor


def text_actor(text: str, x: float, y: float, colour=TEXT) -> vtkTextActor:
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(x, y)
    actor.GetTextProperty().SetFontSize(17 * FINER)
    actor.GetTextProperty().SetColor(*colour)
    return actor


def bar_actor(table) -> vtkScalarBarActor:
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.0f")
    bar.UnconstrainedFontSizeOn()
    text = bar.GetLabelTextProperty()
    text.SetColor(*TEXT)
    text.SetFontSize(17 * FINER)
    text.ItalicOff()
    text.BoldOff()
    text.ShadowOff()
    bar.SetPosition(0.15, 0.2)
    bar.SetWidth(0.7)
    bar.SetHeight(0.7)
    return bar


def view(part, window, actors, labels) -> vtkRenderer:
    """A part (x0, y0, x1, y1) of the picture that shows a window."""
    renderer = vtkRenderer()
    renderer.SetViewport(*part)
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    for label in labels:
        renderer.AddActor2D(label)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    centre = (window[0] + window[1]) / 2, (window[2] + window[3]) / 2
    camera.SetFocalPoint(*centre, 0)
    camera.SetPosition(*centre, 1)
    camera.SetParallelScale((window[3] - window[2]) / 2)
    renderer.ResetCameraClippingRange()
    return renderer


def strip(part, labels) -> vtkRenderer:
    """A part of the picture for words and bars."""
    return view(part, (0, 1, 0, 1), [], labels)


def save(renderers, path: Path) -> None:
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(FINER * SIZE[0], FINER * SIZE[1])
    for renderer in renderers:
        window.AddRenderer(renderer)
    window.Render()
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    shrink = vtkImageShrink3D()
    shrink.SetInputConnection(picture.GetOutputPort())
    shrink.SetShrinkFactors(FINER, FINER, 1)
    shrink.MeanOn()
    writer = vtkPNGWriter()
    writer.SetInputConnection(shrink.GetOutputPort())
    writer.SetFileName(str(path))
    writer.SetCompressionLevel(9)
    writer.Write()


def around_contact(case: Path, part):
    """A window of this part's shape on the contact zone and as much beside."""
    width, bottom = summary(case)["contact"]["width"], value(case, "DY(B)")
    aspect = ((part[3] - part[1]) * SIZE[1]) / ((part[2] - part[0]) * SIZE[0])
    half = width * aspect
    return -0.05 * width, 1.95 * width, bottom - half, bottom + half


def with_margin(bounds, margin=0.03):
    m = margin * (bounds[3] - bounds[2])
    return bounds[0] - m, bounds[1] + m, bounds[2] - m, bounds[3] + m


TITLE, BAR = (0, 0.94, 1, 1), (0.88, 0, 1, 0.94)


def draw_von_mises(case: Path, path: Path) -> None:
    """All of the bodies, and the mesh at the contact, whose largest value ends
    the colours: under the force on a node it has none."""
    bodies = last_grid(case, "bodies")
    left, right = (0, 0, 0.32, 0.94), (0.32, 0, 0.88, 0.94)
    zone = around_contact(case, right)
    table = colours(VIRIDIS, 0, extreme(bodies, "von_mises", zone))
    title = (f"Modeling {case.name[-1].upper()}: von Mises stress [MPa], "
             f"displacements x 1; {describe(case)}")
    save([strip(TITLE, [text_actor(title, 0.02, 0.3)]),
          view(left, with_margin(bodies.GetBounds()),
               [body_actor(bodies, "von_mises", table, False),
                frame_actor(zone)], []),
          view(right, zone, [body_actor(bodies, "von_mises", table, True)], []),
          strip(BAR, [bar_actor(table)])], path)


def draw_stick_and_slip(case: Path, path: Path) -> None:
    """The shear stress in the bodies, and what the nodes of the slave do."""
    bodies, surface = last_grid(case, "bodies"), last_grid(case, "contact")
    part = (0, 0, 0.88, 0.94)
    zone = around_contact(case, part)
    largest = extreme(bodies, "stress_xy", zone)
    table = colours(DIVERGING, -largest, largest)
    title = (f"Modeling {case.name[-1].upper()}: shear stress xy [MPa], "
             f"displacements x 1; {describe(case)}")
    names = [text_actor(text, 0.3, 0.15 - 0.04 * i, rgb(colour))
             for i, (text, colour) in enumerate(STATUS.values())]
    save([strip(TITLE, [text_actor(title, 0.02, 0.3)]),
          view(part, zone, [body_actor(bodies, "stress_xy", table, True)]
               + [status_actor(surface, status) for status in STATUS], []),
          strip(BAR, [bar_actor(table)] + names)], path)


# -------------------------------------------------------------------- the curves

def profile(case: Path) -> list[dict[str, str]]:
    """The rows of the slave up to one and a half of the half width."""
    width = summary(case)["contact"]["width"]
    with open(case / "profile.csv", newline="") as file:
        return [row for row in csv.DictReader(file)
                if row["surface"] == "slave"
                and float(row["arc_length_mm"]) <= 1.5 * width]


def gnuplot(lines: list[str], path: Path, size="1000,560") -> None:
    head = [f'set terminal pngcairo size {size} font "DejaVu Sans,12" '
            'background "white"', f'set output "{path}"', "set encoding utf8",
            "set border 3", "set tics nomirror",
            'set grid back lw 1 lc rgb "#dddddd" dt 1',
            'set xlabel "arc length on the slave [mm]"']
    # Signs such as that of a degree, whatever the language of the machine.
    outcome = subprocess.run(["gnuplot"], input="\n".join(head + lines + [""]),
                             text=True, capture_output=True, encoding="utf-8",
                             env=os.environ | {"LC_ALL": "C.UTF-8"})
    if outcome.returncode != 0 or outcome.stderr:
        sys.exit(f"gnuplot, {path.name}: {outcome.stderr.strip()}")


def block(name: str, rows, *columns: str) -> list[str]:
    return [f"{name} << EOD", *(" ".join(row[c] or "NaN" for c in columns)
                                for row in rows), "EOD"]


def draw_pressures(cases: list[Path], path: Path) -> None:
    """The contact pressure beside that of Hertz."""
    lines = ['set ylabel "contact pressure [MPa]"',
             'set title "Contact pressure of the cylinder on the block"',
             "set yrange [0:*]"]
    curves = []
    for i, case in enumerate(cases):
        lines += block(f"$case{i}", profile(case), "arc_length_mm",
                       "pressure_MPa")
        curves.append(f'$case{i} with linespoints lw 1.6 ps 0.7 '
                      f"pt {plots.POINTS[i + 1]} "
                      f'lc rgb "{plots.COLOURS[i + 1]}" '
                      f'title "{case.name}: {describe(case)}" noenhanced')
    # The curve of theory on a fine line of its own.
    exact = summary(cases[-1])["exact"]
    half_width = f"{exact['half_width']:.9g}"
    curves.append(f"abs(x) > {half_width} ? NaN : "
                  f"{exact['max_pressure']:.9g} * sqrt(1 - "
                  f"(x / {half_width})**2) "
                  'lw 2 dt 2 lc rgb "#000000" title "Hertz"')
    lines += ["set samples 2000", "set key top right",
              "plot " + ", \\\n  ".join(curves)]
    gnuplot(lines, path)


def friction_coefficient(case: Path) -> float:
    for line in (case / "parameters.prm").read_text().splitlines():
        words = line.split("=")
        if words[0].split() == ["set", "Friction", "coefficient"]:
            return float(words[1].split("#")[0])
    sys.exit(f"gallery.py: {case.name} has no friction coefficient")


def draw_shears(cases: list[Path], path: Path) -> None:
    """The shear between its bounds, and where it reaches them."""
    lines = [f"set multiplot layout 1,{len(cases)}", "set key top right",
             'set ylabel "traction [MPa]"', "set yrange [0:*]"]
    for i, case in enumerate(cases):
        mu = friction_coefficient(case)
        rows = profile(case)
        lines += [f'set title "{case.name}\\n{describe(case)}" noenhanced',
                  *block(f"$rows{i}", rows, "arc_length_mm", "pressure_MPa")]
        curves = [f'$rows{i} using 1:({mu} * $2) with lines lw 2 dt 2 lc rgb '
                  f'"#000000" title "{mu:g} x pressure"']
        for status, (name, colour) in STATUS.items():
            chosen = [r for r in rows
                      if int(r["status_0_open_1_slip_2_stick"]) == status]
            if not chosen:
                continue
            lines += block(f"$status{i}_{status}", chosen, "arc_length_mm",
                           "shear_MPa")
            curves.append(f"$status{i}_{status} using 1:(abs($2)) with points "
                          f'pt 7 ps 0.9 lc rgb "#{colour}" title '
                          f'"|shear|, {name}"')
        lines.append("plot " + ", \\\n  ".join(curves))
    gnuplot(lines + ["unset multiplot"], path)


def draw_convergence(pictures: Path, scratch: Path) -> None:
    """From the study's own results, with its own plots."""
    rows = report.read(ROOT / "tests/study/results")
    figures = [f for f in report.order_figures(rows) if f.name == CONVERGENCE]
    if plots.draw(figures, scratch) != [CONVERGENCE]:
        sys.exit("gallery.py: the study has no results of " + CONVERGENCE)
    shutil.copy(scratch / f"{CONVERGENCE}.png", pictures / "convergence.png")


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--output", type=Path, metavar="DIR",
                        default=ROOT / "output/gallery")
    parser.add_argument("--pictures", type=Path, metavar="DIR",
                        default=HERE / "results")
    parser.add_argument("contact", type=Path, metavar="CONTACT")
    arguments = parser.parse_args()
    output, pictures = arguments.output.resolve(), arguments.pictures.resolve()
    for directory in (output, pictures):
        directory.mkdir(parents=True, exist_ok=True)

    names = sorted({*BODIES, *PRESSURES, *FRICTION})
    cases = {name: run_case(arguments.contact.resolve(), name, output)
             for name in names}
    for name in BODIES:
        draw_von_mises(cases[name], pictures / f"von_mises_{name[-1]}.png")
    draw_stick_and_slip(cases["ssnp154_g"], pictures / "stick_and_slip.png")
    draw_pressures([cases[name] for name in PRESSURES],
                   pictures / "pressure.png")
    draw_shears([cases[name] for name in FRICTION], pictures / "friction.png")
    draw_convergence(pictures, output)
    for picture in sorted(pictures.glob("*.png")):
        print(f"{picture}: {picture.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
