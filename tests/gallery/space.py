# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a scene in 3-D that is cut in its plane of symmetry y = 0: the
cut faces the viewer, and surfaces of contact are mirrored in it."""

from __future__ import annotations

from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkArrowSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

from drawing import (BAR, SIZE, STATUS, TITLE, VIRIDIS, bar_actor,
                     body_actor, colours, frame_actor, last_grid, parallel_view,
                     renderer, rgb, save, strip, summary, text_actor, view)

# From the front and above, a little from the left.
TOWARDS_VIEWER = (-0.45, -1.0, 0.5)
# The areas of a status, lighter than the arrows on them.
FILLS = {-1: "e4e4e4", 0: "e4e4e4", 1: "f0b45a", 2: "7fa8e0"}


def field(grid, name: str):
    return vtk_to_numpy(grid.GetPointData().GetArray(name))


def places(grid):
    return vtk_to_numpy(grid.GetPoints().GetData())


def facets(grid):
    """The corners of the cells of a surface of elements of degree 1, row by
    row."""
    return numpy.array([[grid.GetCell(i).GetPointId(k) for k in range(4)]
                        for i in range(grid.GetNumberOfCells())])


def polygons(points, corners, place=vtkPolyData.SetPolys) -> vtkPolyData:
    """Polygons, or with vtkPolyData.SetLines polygonal lines, by their points."""
    data, cells, nodes = vtkPolyData(), vtkCellArray(), vtkPoints()
    nodes.SetData(numpy_to_vtk(numpy.ascontiguousarray(points, float), deep=True))
    for row in corners:
        cells.InsertNextCell(len(row), [int(i) for i in row])
    data.SetPoints(nodes)
    place(data, cells)
    return data


def with_values(data: vtkPolyData, name: str, values) -> vtkPolyData:
    array = numpy_to_vtk(numpy.ascontiguousarray(values, float), deep=True)
    array.SetName(name)
    data.GetPointData().AddArray(array)
    return data


def mirrored(make, data: vtkPolyData) -> list[vtkActor]:
    """What make(data) draws, and its image in the plane y = 0."""
    actors = [make(data), make(data)]
    actors[1].SetScale(1, -1, 1)
    return actors


def plain_actor(data: vtkPolyData, colour: str) -> vtkActor:
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*rgb(colour))
    actor.GetProperty().LightingOff()
    return actor


def shaded(actor: vtkActor) -> vtkActor:
    """Lit, but little: the colours have a meaning."""
    actor.GetProperty().LightingOn()
    actor.GetProperty().SetAmbient(0.6)
    actor.GetProperty().SetDiffuse(0.45)
    actor.GetProperty().SetSpecular(0)
    return actor


def space_view(part, towards_viewer, bounds, actors, labels=(),
               nearer=1.0, up=(0, 0, 1)) -> vtkRenderer:
    """A part of the picture with a view in perspective of what is in bounds."""
    shown = renderer(part, actors, labels)
    camera = shown.GetActiveCamera()
    centre = [(bounds[2 * d] + bounds[2 * d + 1]) / 2 for d in range(3)]
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(c + t for c, t in zip(centre, towards_viewer)))
    camera.SetViewUp(*up)
    camera.SetViewAngle(18)
    shown.ResetCamera(*bounds)
    # VTK fits what it shows into the height of a part, here narrower than high.
    camera.Zoom(nearer * (part[2] - part[0]) * SIZE[0]
                / ((part[3] - part[1]) * SIZE[1]))
    shown.ResetCameraClippingRange()
    return shown


def cut_window(surface, part):
    """A window of this part's shape on the cut around the contact."""
    touching = places(surface)[field(surface, "status") > 0]
    half = 1.25 * numpy.abs(touching[:, 0] - touching[:, 0].mean()).max()
    x, z = touching[:, 0].mean(), touching[:, 2].max()
    aspect = ((part[3] - part[1]) * SIZE[1]) / ((part[2] - part[0]) * SIZE[0])
    return x - half, x + half, z - half * aspect, z + half * aspect


def front_view(part, window, actors) -> vtkRenderer:
    """The plane y = 0 as one sees it along y."""
    x, z = (window[0] + window[1]) / 2, (window[2] + window[3]) / 2
    return parallel_view(part, (x, 0, z), (0, -1, 0), (0, 0, 1),
                         (window[3] - window[2]) / 2, actors)


def largest_on_cut(bodies, window) -> float:
    x = places(bodies)
    inside = ((window[0] <= x[:, 0]) & (x[:, 0] <= window[1])
              & (window[2] <= x[:, 2]) & (x[:, 2] <= window[3])
              & (numpy.abs(x[:, 1]) < 1e-3 * (window[1] - window[0])))
    return field(bodies, "von_mises")[inside].max()


def draw_cut(case: Path, path: Path) -> None:
    """The von Mises stress of both bodies, and on the cut around the contact
    with the mesh."""
    bodies, surface = last_grid(case, "bodies"), last_grid(case, "contact")
    left, right = (0, 0, 0.46, 0.94), (0.46, 0, 0.88, 0.94)
    window = cut_window(surface, right)
    table = colours(VIRIDIS, 0, largest_on_cut(bodies, window))
    frame = frame_actor(window)
    frame.RotateX(90)
    title = (f"Sphere on a block, cut in the middle: von Mises stress [MPa], "
             f"displacements x 1; {describe_space(case)}")
    save([strip(TITLE, [text_actor(title, 0.02, 0.3)]),
          space_view(left, TOWARDS_VIEWER, bodies.GetBounds(),
                     [shaded(body_actor(bodies, "von_mises", table, False)),
                      frame], nearer=1.35),
          front_view(right, window,
                     [body_actor(bodies, "von_mises", table, True)]),
          strip(BAR, [bar_actor(table)])], path)


def describe_space(case: Path) -> str:
    effects = summary(case)["effects"]
    return ", ".join([effects["contact"].split(",")[0],
                      effects["friction"].split(",")[0]])


def footprint_window(surface, part):
    touching = places(surface)[field(surface, "status") > 0]
    middle = (touching[:, 0].min() + touching[:, 0].max()) / 2
    half = 1.3 * max(numpy.ptp(touching[:, 0]) / 2, touching[:, 1].max())
    aspect = ((part[3] - part[1]) * SIZE[1]) / ((part[2] - part[0]) * SIZE[0])
    wide, high = half * max(1, 1 / aspect), half * max(1, aspect)
    return middle - wide, middle + wide, -high, high


def flat(surface, height=0.0):
    """The places of a surface from above, at a height."""
    x = places(surface).copy()
    x[:, 2] = height
    return x


def draw_footprint(case: Path, path: Path) -> None:
    """The pressure from above, and as a hill."""
    surface = last_grid(case, "contact")
    left, right = (0, 0, 0.44, 0.94), (0.44, 0, 0.88, 0.94)
    window = footprint_window(surface, left)
    pressure, corners = field(surface, "pressure"), facets(surface)
    table = colours(VIRIDIS, 0, pressure.max())

    def coloured(data):
        return body_actor(data, "pressure", table, True)

    # The hill is about as high as its half width.
    half = (window[1] - window[0]) / 2.6
    hill = flat(surface, 0.9 * half * pressure / pressure.max())
    kept = (pressure[corners] > 0).any(axis=1)
    title = (f"Contact pressure [MPa] of the sphere, from above and as a hill; "
             f"{describe_space(case)}")
    save([strip(TITLE, [text_actor(title, 0.02, 0.3)]),
          view(left, window, mirrored(coloured, with_values(
              polygons(flat(surface), corners), "pressure", pressure)), []),
          space_view(right, TOWARDS_VIEWER,
                     (*window[:2], -half, half, 0, half),
                     mirrored(lambda data: shaded(coloured(data)), with_values(
                         polygons(hill, corners[kept]), "pressure", pressure)),
                     nearer=1.25),
          strip(BAR, [bar_actor(table)])], path)


def node_cells(surface) -> dict[int, vtkPolyData]:
    """Of each status the parts of the facets that are closest to its nodes."""
    x, status, corners = flat(surface), field(surface, "status"), facets(surface)
    points, cells = [], {}
    for row in corners:
        centre = x[row].mean(axis=0)
        for k in range(4):
            node, after, before = row[k], row[(k + 1) % 4], row[k - 1]
            first = len(points)
            points += [x[node], (x[node] + x[after]) / 2, centre,
                       (x[node] + x[before]) / 2]
            cells.setdefault(int(status[node]), []).append(
                range(first, first + 4))
    return {kind: polygons(numpy.array(points), rows)
            for kind, rows in cells.items()}


def arrow_actor(data: vtkPolyData, factor: float) -> vtkActor:
    """The vectors "shear" at the points, as long as factor times them."""
    arrow = vtkArrowSource()
    arrow.SetTipLength(0.32)
    arrow.SetTipRadius(0.13)
    arrow.SetShaftRadius(0.04)
    arrow.SetTipResolution(24)
    glyphs = vtkGlyph3D()
    glyphs.SetInputData(data)
    glyphs.SetSourceConnection(arrow.GetOutputPort())
    data.GetPointData().SetActiveVectors("shear")
    glyphs.SetVectorModeToUseVector()
    glyphs.SetScaleModeToScaleByVector()
    glyphs.SetScaleFactor(factor)
    glyphs.Update()
    return plain_actor(glyphs.GetOutput(), "101010")


def draw_stick_and_slip(case: Path, path: Path) -> None:
    """Where the sphere sticks and slips, from above, with the shear on it."""
    surface = last_grid(case, "contact")
    part = (0, 0, 0.88, 0.94)
    window = footprint_window(surface, part)
    shear, status = field(surface, "shear"), field(surface, "status")
    _, nodes = numpy.unique(flat(surface).round(9), axis=0, return_index=True)
    nodes = nodes[status[nodes] > 0]
    arrows = vtkPolyData()
    points = vtkPoints()
    lift = 0.1 * (window[1] - window[0])
    points.SetData(numpy_to_vtk(flat(surface, lift)[nodes], deep=True))
    arrows.SetPoints(points)
    flat_shear = shear[nodes] * (1, 1, 0)
    with_values(arrows, "shear", flat_shear)
    spacing = numpy.sqrt(numpy.ptp(flat(surface)[:, 0])
                         * numpy.ptp(flat(surface)[:, 1]) / len(facets(surface)))
    factor = 1.3 * spacing / numpy.linalg.norm(flat_shear, axis=1).max()
    actors = []
    for kind, data in node_cells(surface).items():
        actors += mirrored(lambda d: plain_actor(d, FILLS[kind]), data)
    actors += mirrored(lambda d: arrow_actor(d, factor), arrows)
    title = (f"Shear on the sphere, from above, where it sticks and where it "
             f"slips; {describe_space(case)}")
    names = [text_actor(STATUS[kind][0], 0.3, 0.5 - 0.04 * kind,
                        rgb(STATUS[kind][1])) for kind in STATUS]
    save([strip(TITLE, [text_actor(title, 0.02, 0.3)]),
          view(part, window, actors, []), strip(BAR, names)], path)
