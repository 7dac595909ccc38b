# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the pictures of bodies are put together from, by VTK."""

from __future__ import annotations

import sys
from pathlib import Path

import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401, names draw text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersGeneral import vtkWarpVector
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor,
    vtkWindowToImageFilter)

from contact_results import COMPONENTS, Results
from curves import STATUS

# Viridis: dark to light, even in grey and to the colour-blind. Blue to red for
# what has a sign.
VIRIDIS = ["440154", "472d7b", "3b528b", "2c728e", "21918c", "28ae80",
           "5ec962", "addc30", "fde725"]
DIVERGING = ["3b4cc0", "7b9ff9", "c0d4f5", "f2f2f2", "f2cbb7", "ee8468",
             "b40426"]
BANDS = 12
# Drawn larger, then averaged: edges get smooth, without the seams that samples
# within a pixel leave between the triangles of a cell.
SIZE, FINER = (1000, 700), 1 if "--coarse" in sys.argv else 3
TEXT = (0.1, 0.1, 0.1)


def rgb(colour: str) -> tuple[float, ...]:
    return tuple(int(colour[i:i + 2], 16) / 255 for i in (0, 2, 4))


def summary(case: Path) -> dict:
    return Results(case).summary


def parameter(case: Path, section: str, entry: str) -> str:
    """The text of an entry in a top section of the parameters used."""
    return Results(case).parameters[f"{section}/{entry}"]


def describe(case: Path) -> str:
    effects = summary(case)["effects"]
    friction = effects["friction"].split(",")[0]
    if friction == "none":
        friction = "no friction"
    return ", ".join([effects["element"], effects["contact"].split(",")[0],
                      friction])


# -------------------------------------------------------------------- the bodies

def unmoved_grid(case: Path, name: str, time=1.0):
    """Bodies or contact surface at the end of the increment nearest to a time,
    the load's end is 1, where they were before; with the stresses one by one."""
    grid = Results(case).grid(name, time)
    data = grid.GetPointData()
    if stress := data.GetArray("stress"):
        for component, c in COMPONENTS[9].items():
            array = vtkFloatArray()
            array.SetName(f"stress_{component}")
            array.SetNumberOfTuples(stress.GetNumberOfTuples())
            array.CopyComponent(0, stress, c)
            data.AddArray(array)
    return grid


def last_grid(case: Path, name: str):
    """Bodies or contact surface at the end of the load, moved."""
    return moved_grid(case, name, float("inf"))


def moved_grid(case: Path, name: str, time: float):
    grid = unmoved_grid(case, name, time)
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


def bar_actor(table, labels="%.0f") -> vtkScalarBarActor:
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat(labels)
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


def renderer(part, actors, labels=()) -> vtkRenderer:
    """A part (x0, y0, x1, y1) of the picture."""
    shown = vtkRenderer()
    shown.SetViewport(*part)
    shown.SetBackground(1, 1, 1)
    for actor in actors:
        shown.AddActor(actor)
    for label in labels:
        shown.AddActor2D(label)
    return shown


def parallel_view(part, centre, towards_viewer, up, half_height, actors,
                  labels=()) -> vtkRenderer:
    """A part of the picture without perspective."""
    shown = renderer(part, actors, labels)
    camera = shown.GetActiveCamera()
    camera.ParallelProjectionOn()
    # Outside of all that is shown: VTK cuts off what is close to the camera.
    low_high = shown.ComputeVisiblePropBounds()
    far = 2 * sum(b - a for a, b in zip(low_high[::2], low_high[1::2])) \
        if actors else 1
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(c + far * t for c, t in zip(centre, towards_viewer)))
    camera.SetViewUp(*up)
    camera.SetParallelScale(half_height)
    shown.ResetCameraClippingRange()
    return shown


def view(part, window, actors, labels) -> vtkRenderer:
    """A part of the picture that shows a window of the plane."""
    centre = (window[0] + window[1]) / 2, (window[2] + window[3]) / 2, 0
    return parallel_view(part, centre, (0, 0, 1), (0, 1, 0),
                         (window[3] - window[2]) / 2, actors, labels)


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


def with_margin(bounds, margin=0.03):
    m = margin * (bounds[3] - bounds[2])
    return bounds[0] - m, bounds[1] + m, bounds[2] - m, bounds[3] + m


TITLE, BAR = (0, 0.94, 1, 1), (0.88, 0, 1, 0.94)
