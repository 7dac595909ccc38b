# SPDX-License-Identifier: LGPL-2.1-or-later
"""The views of a case in ParaView: von Mises stress on the deformed bodies, the
mesh at the contact with the pressure on the slave, pressure and shear over the
arc. Of a case in 3-D: the bodies clipped by a plane through the contact, the
mesh on this cut, the pressure on the slave, and its status with the shear as
arrows.

As a macro (Macros, Import new macro ...): open bodies.pvd of a case, select it
in the pipeline, press the button. From a shell

    pvpython paraview_macro.py DIRECTORY [PICTURE.png] [STATE.pvsm]

reads output/<case>, and saves a picture or a state that paraview opens.
"""

import csv
import math
import os
import sys

from paraview import simple as pv

LARGEST_ZONE = 1.5  # of the arc that is shown, by the arc in contact


def case_directory():
    """The argument, or where the selected source has its files."""
    if len(sys.argv) > 1:
        return os.path.abspath(sys.argv[1])
    source = pv.GetActiveSource()
    files = getattr(source, "FileName", "") if source else ""
    if not files:
        raise RuntimeError("open bodies.pvd of a case and select it, or name "
                           "the directory of the case")
    return os.path.dirname(files if isinstance(files, str) else files[0])


def is_in_space(directory):
    """Whether the profile has no arc length but three coordinates."""
    with open(os.path.join(directory, "profile.csv"), newline="") as file:
        return "Z_mm" in next(csv.reader(file))


def contact_zone(directory):
    """Where the slave is in contact, moved: bounds of x, of y and of the arc
    length; and the largest pressure."""
    x, y, arc, pressure = [], [], [], []
    with open(os.path.join(directory, "profile.csv"), newline="") as file:
        for row in csv.DictReader(file):
            if (row["surface"] == "slave"
                    and int(row["status_0_open_1_slip_2_stick"]) > 0):
                x.append(float(row["X_mm"]) + float(row["displacement_x_mm"]))
                y.append(float(row["Y_mm"]) + float(row["displacement_y_mm"]))
                arc.append(float(row["arc_length_mm"]))
                pressure.append(float(row["pressure_MPa"]))
    if not x:
        raise RuntimeError("no point of " + directory + " is in contact")
    return (min(x), max(x)), (min(y), max(y)), (min(arc), max(arc)), \
        max(pressure)


def moved(directory, name):
    """A series of the case, moved by its displacement, at its last time."""
    reader = pv.PVDReader(registrationName=name, FileName=os.path.join(
        directory, name + ".pvd"))
    reader.UpdatePipeline(reader.TimestepValues[-1])
    warp = pv.WarpByVector(registrationName=name + " moved", Input=reader)
    warp.Vectors = ["POINTS", "displacement"]
    return warp


def render_view(title, window=None):
    """A plane view, of everything or of a window about (x, y)."""
    view = pv.CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.InteractionMode = "2D"
    view.OrientationAxesVisibility = 0
    text = pv.Text(registrationName=title, Text=title)
    pv.Show(text, view).Color = [0, 0, 0]
    if window:
        (x, y), half = window
        view.CameraPosition = [x, y, 1]
        view.CameraFocalPoint = [x, y, 0]
        view.CameraParallelScale = half
    return view


def show(source, view, field, representation="Surface"):
    display = pv.Show(source, view)
    display.SetRepresentationType(representation)
    pv.ColorBy(display, ("POINTS", field))
    display.SetScalarBarVisibility(view, True)
    bar = pv.GetScalarBar(pv.GetColorTransferFunction(field), view)
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    return display


def curves(table, view, columns, zone):
    """Columns (name, label) of the profile over the arc length."""
    display = pv.Show(table, view)
    display.UseIndexForXAxis = 0
    display.XArrayName = "arc_length_mm"
    display.SeriesVisibility = [name for name, _ in columns]
    display.SeriesLabel = [word for column in columns for word in column]
    # The status has an axis of its own, on the right.
    display.SeriesPlotCorner = [word for name, _ in columns for word in
                                (name, "1" if name.startswith("status") else
                                 "0")]
    view.BottomAxisTitle = "arc length on the slave [mm]"
    view.BottomAxisUseCustomRange = 1
    view.BottomAxisRangeMinimum = zone[0]
    view.BottomAxisRangeMaximum = zone[0] + LARGEST_ZONE * (zone[1] - zone[0])


def plane_views(directory):
    """The layout of a plane case, and the largest pressure."""
    bodies, surface = moved(directory, "bodies"), moved(directory, "contact")
    x, y, arc, largest = contact_zone(directory)
    centre = (sum(x) / 2, sum(y) / 2)
    # Of a view that is twice as wide as high.
    half = LARGEST_ZONE / 4 * max(x[1] - x[0], 2 * (y[1] - y[0]))

    whole = render_view("von Mises stress [MPa]")
    show(bodies, whole, "von_mises")
    pv.ResetCamera(whole)

    close = render_view("pressure on the slave [MPa]", (centre, half))
    mesh = pv.Show(bodies, close)
    mesh.SetRepresentationType("Surface With Edges")
    mesh.ColorArrayName = ["POINTS", ""]
    line = show(surface, close, "pressure")
    line.LineWidth = 6

    table = pv.CSVReader(registrationName="profile", FileName=[
        os.path.join(directory, "profile.csv")])
    slave = pv.ProgrammableFilter(registrationName="slave", Input=table)
    slave.OutputDataSetType = "vtkTable"
    slave.Script = """
import numpy
chosen = numpy.array([inputs[0].RowData["surface"].GetValue(i) == "slave"
                      for i in range(inputs[0].GetNumberOfRows())])
for name in inputs[0].RowData.keys():
    if name != "surface":
        output.RowData.append(inputs[0].RowData[name][chosen], name)
"""
    pressure = pv.CreateView("XYChartView")
    pressure.LeftAxisTitle = "pressure [MPa]"
    curves(slave, pressure, [("pressure_MPa", "contact")], arc)
    shear = pv.CreateView("XYChartView")
    shear.LeftAxisTitle = "shear [MPa]"
    shear.RightAxisTitle = "0 open, 1 slip, 2 stick"
    curves(slave, shear, [("shear_MPa", "shear"),
                          ("status_0_open_1_slip_2_stick", "status")], arc)

    # Cells of a layout are numbered as in a binary heap.
    layout = pv.CreateLayout(name=os.path.basename(directory))
    layout.SplitHorizontal(0, 0.3)
    layout.SplitVertical(2, 0.5)
    layout.SplitHorizontal(6, 0.5)
    for cell, view in ((1, whole), (5, close), (13, pressure), (14, shear)):
        layout.AssignView(cell, view)
    return layout, largest


def contact_box(directory):
    """Where the slave is in contact, moved: least and largest coordinates; and
    the largest pressure and shear."""
    places, pressure, shear = [], [], []
    with open(os.path.join(directory, "profile.csv"), newline="") as file:
        for row in csv.DictReader(file):
            if (row["surface"].startswith("slave")
                    and int(row["status_0_open_1_slip_2_stick"]) > 0):
                places.append([float(row[c.upper() + "_mm"])
                               + float(row["displacement_" + c + "_mm"])
                               for c in "xyz"])
                pressure.append(float(row["pressure_MPa"]))
                shear.append(math.hypot(*(float(row["shear_" + c + "_MPa"])
                                          for c in "xyz")))
    if not places:
        raise RuntimeError("no point of " + directory + " is in contact")
    columns = list(zip(*places))
    return ([min(c) for c in columns], [max(c) for c in columns], max(pressure),
            max(shear))


def look(view, centre, direction, up, half):
    """A view in 3-D at a place, from a direction, of a window about it."""
    view.InteractionMode = "3D"
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = centre
    view.CameraPosition = [c + 10 * half * d for c, d in zip(centre, direction)]
    view.CameraViewUp = up
    view.CameraParallelScale = half


def unit(axis, sign=1):
    return [sign if c == axis else 0 for c in range(3)]


def show_status(surface, view, longest, half):
    """Open, slip and stick, in three colours that nothing is between, and the
    shear as arrows."""
    show(surface, view, "status", "Surface With Edges")
    colours = pv.GetColorTransferFunction("status")
    colours.RescaleTransferFunction(-0.5, 2.5)
    colours.NumberOfTableValues = 3
    bar = pv.GetScalarBar(colours, view)
    bar.UseCustomLabels = 1
    bar.CustomLabels = [0, 1, 2]
    bar.AddRangeLabels = 0
    arrows = pv.Glyph(registrationName="shear", Input=surface,
                      GlyphType="Arrow")
    arrows.OrientationArray = ["POINTS", "shear"]
    arrows.ScaleArray = ["POINTS", "shear"]
    arrows.GlyphMode = "All Points"
    # The longest arrow is a third of the zone.
    arrows.ScaleFactor = half / 3 / longest if longest > 0 else 1
    display = pv.Show(arrows, view)
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = [0, 0, 0]


def space_views(directory):
    """The layout of a case in 3-D, and the largest pressure."""
    bodies, surface = moved(directory, "bodies"), moved(directory, "contact")
    low, high, largest, longest = contact_box(directory)
    centre = [(a + b) / 2 for a, b in zip(low, high)]
    half = LARGEST_ZONE / 2 * max(b - a for a, b in zip(low, high))

    # The zone is thinnest along its normal; the cut is across it.
    normal = min(range(3), key=lambda c: high[c] - low[c])
    across = 0 if normal == 1 else 1
    along = 3 - normal - across
    # Just beyond the middle: a plane of symmetry has its own face there.
    origin = list(centre)
    if abs(low[across]) < 1e-6 * half:
        origin[across] = low[across] + 1e-6 * half
    clip = pv.Clip(registrationName="clip", Input=bodies)
    clip.ClipType = "Plane"
    clip.ClipType.Origin = origin
    clip.ClipType.Normal = unit(across)
    clip.Invert = 0
    whole = render_view("von Mises stress [MPa]")
    show(clip, whole, "von_mises")
    aslant = {along: -0.4, across: -0.8, normal: 0.4}
    look(whole, centre, [aslant[c] for c in range(3)], unit(normal), half)
    pv.ResetCamera(whole)

    close = render_view("von Mises stress [MPa], mesh on the cut")
    show(clip, close, "von_mises", "Surface With Edges")
    look(close, centre, unit(across, -1), unit(normal), half)

    pressure = render_view("pressure on the slave [MPa]")
    show(surface, pressure, "pressure", "Surface With Edges")
    look(pressure, centre, unit(normal), unit(across), half)

    status = render_view("0 open, 1 slip, 2 stick; shear on the slave")
    show_status(surface, status, longest, half)
    look(status, centre, unit(normal), unit(across), half)

    layout = pv.CreateLayout(name=os.path.basename(directory))
    layout.SplitHorizontal(0, 0.5)
    layout.SplitVertical(1, 0.5)
    layout.SplitVertical(2, 0.5)
    for cell, view in ((3, whole), (4, pressure), (5, close), (6, status)):
        layout.AssignView(cell, view)
    return layout, largest


def main():
    directory = case_directory()
    pv._DisableFirstRenderCameraReset()
    layout, largest = (space_views if is_in_space(directory)
                       else plane_views)(directory)
    pv.GetAnimationScene().GoToLast()
    # Under a force on a node stresses have no limit; under a contact they stay
    # below its pressure.
    for field in ("von_mises", "pressure"):
        pv.GetColorTransferFunction(field).RescaleTransferFunction(0, largest)
    pv.RenderAllViews()

    for file in sys.argv[2:]:
        if file.endswith(".pvsm"):
            pv.SaveState(file)
        else:
            layout.SetSize(1400, 900)
            pv.SaveScreenshot(file, layout)



main()
