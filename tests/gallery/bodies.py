# SPDX-License-Identifier: LGPL-2.1-or-later
"""The deformed bodies of any case in the colours of the von Mises stress, the mesh
where they touch, and in 3-D the pressure on the slaves."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersGeneral import vtkTableBasedClipDataSet
from vtkmodules.vtkRenderingCore import vtkActor

from contact_results import Results
from drawing import (BAR, SIZE, TITLE, VIRIDIS, bar_actor, body_actor, colours,
                     moved_grid, parallel_view, save, strip, text_actor)
from examples import edges_of, lines_actor
from space import field, places, shaded, space_view

AROUND = 1.5  # the size of a view by that of the zone in contact
DEPTH = 0.75  # of a flat zone, by its length: stresses are largest below it
SMALLEST, OF_A_POINT = 1e-4, 0.05  # of the bodies: below the first it is a point
FACE = 1e-3  # of the bodies: what is closer to their end than that is on it
DIGITS, FIXED = 3, (1e-3, 1e6)  # of the numbers beside colours; else a power
MOST_POINTS = 20000  # of a view that has the edges of cells
LEFT, RIGHT = (0, 0, 0.44, 0.94), (0.44, 0, 0.88, 0.94)
ALL = (0, 0, BAR[0], BAR[3])
UPPER, LOWER = (0, 0.47, 0.88, 0.94), (0, 0, 0.88, 0.47)


@dataclass
class Box:
    low: numpy.ndarray
    high: numpy.ndarray

    @property
    def centre(self):
        return (self.low + self.high) / 2

    @property
    def size(self):
        return self.high - self.low

    def around(self, factor: float, smallest=0.0) -> Box:
        half = numpy.maximum(factor * self.size, smallest) / 2
        return Box(self.centre - half, self.centre + half)

    def holds(self, x):
        return ((self.low <= x) & (x <= self.high)).all(axis=1)


def box(points) -> Box:
    return Box(points.min(axis=0), points.max(axis=0))


def touching_box(surface) -> Box | None:
    """Of what is in contact, if anything is."""
    touching = places(surface)[field(surface, "status") > 0]
    return box(touching) if len(touching) else None


def zone_around(touching: Box, whole: Box) -> Box:
    """What is seen of a contact."""
    size, all_of_it = touching.size.max(), whole.size.max()
    return touching.around(AROUND, DEPTH * size if size > SMALLEST * all_of_it
                           else OF_A_POINT * all_of_it)


def fitted(seen: Box, part, axes) -> Box:
    """The box that a view of this part shows, right and up along the axes, when
    it shows all of another one."""
    right, up = axes
    aspect = ((part[3] - part[1]) * SIZE[1]) / ((part[2] - part[0]) * SIZE[0])
    size = seen.size.copy()
    size[up] = max(size[up], aspect * size[right])
    size[right] = size[up] / aspect
    return Box(seen.centre - size / 2, seen.centre + size / 2)


def unit(axis: int, sign=1):
    return tuple(sign if d == axis else 0 for d in range(3))


def seen_along(part, seen: Box, axes, sign, actors):
    """A view of a box along the axis that is not in axes: right and up."""
    right, up = axes
    return parallel_view(part, seen.centre, unit(3 - right - up, sign), unit(up),
                         fitted(seen, part, axes).size[up] / 2, actors)


def stress_table(bodies, zone: Box | None):
    """Colours up to the largest von Mises stress in the zone: under the force on
    a node it has no limit."""
    stress = field(bodies, "von_mises")
    if zone is not None:
        stress = stress[zone.holds(places(bodies))]
    largest = stress.max() if len(stress) else field(bodies, "von_mises").max()
    return colours(VIRIDIS, 0, largest or 1.0)


def labels(table) -> str:
    largest = table.GetRange()[1]
    if not FIXED[0] <= largest < FIXED[1]:
        return f"%.{DIGITS - 1}e"
    return f"%.{max(0, DIGITS - 1 - math.floor(math.log10(largest)))}f"


def stressed(grid, table, seen: Box) -> list[vtkActor]:
    """Bodies with the edges of their cells, unless these are so many in what is
    seen that they would hide the colours."""
    with_edges = seen.holds(places(grid)).sum() < MOST_POINTS
    # Of a cell of degree 2 VTK shows the edges of its parts as well.
    is_linear = grid.GetCell(0).IsLinear()
    actors = [body_actor(grid, "von_mises", table, bool(with_edges and is_linear))]
    if with_edges and not is_linear:
        edges, _ = edges_of(grid, places(grid))
        actors.append(lines_actor(places(grid), edges, 1))
    return actors


def plane_views(bodies, whole: Box, touching: Box | None):
    """All of the bodies, and the mesh at the contact; and the colours."""
    seen, axes = whole.around(1.06), (0, 1)
    if touching is None:
        table = stress_table(bodies, None)
        return table, [seen_along(ALL, seen, axes, 1, stressed(bodies, table, seen))]
    zone = zone_around(touching, whole)
    wide = whole.size[0] > 1.3 * whole.size[1]
    first, second = (UPPER, LOWER) if wide else (LEFT, RIGHT)
    shown = fitted(zone, second, axes)
    table = stress_table(bodies, shown)
    return table, [seen_along(first, seen, axes, 1,
                              [body_actor(bodies, "von_mises", table, False)]),
                   seen_along(second, zone, axes, 1,
                              stressed(bodies, table, shown))]


def cut(bodies, origin, axis: int):
    """The part of the bodies beyond a plane across an axis."""
    plane = vtkPlane()
    plane.SetOrigin(*origin)
    plane.SetNormal(*unit(axis))
    clip = vtkTableBasedClipDataSet()
    clip.SetInputData(bodies)
    clip.SetClipFunction(plane)
    clip.Update()
    return clip.GetOutput()


def directions(touching: Box) -> tuple[int, int, int]:
    """The axes across a cut through the contact, along it, and along the normal,
    in which the contact is thinnest."""
    normal = int(touching.size.argmin())
    across = 0 if normal == 1 else 1
    return across, 3 - normal - across, normal


def space_views(bodies, whole: Box, touching: Box | None):
    """All of the bodies, and the mesh on a cut through the contact, which is a
    plane of symmetry, or in the middle of what touches; and the colours."""
    across, along, normal = directions(touching or whole)
    aslant = [0.0, 0.0, 0.0]
    aslant[across], aslant[along], aslant[normal] = -1.0, -0.45, 0.5
    bounds = numpy.c_[whole.low, whole.high].ravel()
    zone = zone_around(touching, whole) if touching else None
    table = stress_table(bodies, zone)
    actors = [shaded(body_actor(bodies, "von_mises", table, zone is None))]
    if zone is None:
        return table, [space_view(ALL, aslant, bounds, actors, up=unit(normal))]
    origin, tiny, side = touching.centre, FACE * whole.size.max(), -1
    # Just beyond a face, which is kept whole by that.
    if touching.low[across] < whole.low[across] + tiny:
        origin[across] = whole.low[across] - tiny
    elif touching.high[across] > whole.high[across] - tiny:
        origin[across], side = whole.low[across] - tiny, 1
        aslant[across] = 1.0
    on_cut = body_actor(cut(bodies, origin, across), "von_mises", table, True)
    return table, [
        space_view(LEFT, aslant, bounds, actors, nearer=1.2, up=unit(normal)),
        seen_along(RIGHT, zone, (along, normal), side, [on_cut])]


def in_space(case: Results) -> bool:
    if (case.folder / "contact.pvd").exists():
        return case.grid("contact").GetCell(0).GetCellDimension() == 2
    return "Z" in case.profile()


def time_shown(case: Results) -> float:
    """The end or, where nothing touches there, when the pressure was largest."""
    last = case.times("bodies")[-1]
    if not (case.folder / "contact.pvd").exists():
        return last
    if (field(case.grid("contact"), "status") > 0).any():
        return last
    pressures = {t: field(case.grid("contact", t), "pressure").max()
                 for t in case.times("contact")}
    return max(pressures, key=pressures.get) if max(pressures.values()) > 0 else last


def draw_bodies(case: Results, path: Path) -> list[Path]:
    """The von Mises stress, beside it where bodies touch."""
    time = time_shown(case)
    bodies, touching = moved_grid(case.folder, "bodies", time), None
    whole = box(places(bodies))
    if (case.folder / "contact.pvd").exists():
        touching = touching_box(moved_grid(case.folder, "contact", time))
    draw = plane_views if whole.size[2] == 0 else space_views
    table, views = draw(bodies, whole, touching)
    title = (f"{case.name}: von Mises stress [MPa], displacements x 1, "
             f"t = {time:g}")
    save([strip(TITLE, [text_actor(title, 0.02, 0.3)]),
          *views, strip(BAR, [bar_actor(table, labels(table))])], path)
    return [path]


def draw_pressure(case: Results, path: Path) -> list[Path]:
    """The pressure on the slaves in 3-D, seen along the normal of the contact."""
    time = time_shown(case)
    surface = moved_grid(case.folder, "contact", time)
    whole = box(places(surface))
    touching = touching_box(surface)
    if touching is None:
        raise ValueError("nothing has touched")
    zone, (_, _, normal) = zone_around(touching, whole), directions(touching)
    right, up = (d for d in range(3) if d != normal)
    # From outside of a body that is round there.
    sign = 1 if zone.centre[normal] > whole.centre[normal] else -1
    table = colours(VIRIDIS, 0, field(surface, "pressure").max() or 1.0)
    title = f"{case.name}: pressure on the slaves [MPa], t = {time:g}"
    save([strip(TITLE, [text_actor(title, 0.02, 0.3)]),
          seen_along(ALL, zone, (right, up), sign,
                     [body_actor(surface, "pressure", table, True)]),
          strip(BAR, [bar_actor(table, labels(table))])], path)
    return [path]
