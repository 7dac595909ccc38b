# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the examples to start from, parameters/examples: bodies of the
plane beside rigid obstacles."""

from __future__ import annotations

import math
from pathlib import Path

import numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor

from drawing import (DIVERGING, FINER, SIZE, TITLE, VIRIDIS, bar_actor,
                     body_actor, colours, moved_grid, parameter, save, strip,
                     summary, text_actor, unmoved_grid, view)
from space import (field, places, plain_actor, polygons, shaded,
                   space_view)

RIGID, HILL = "c4c4c4", "e08030"
FAR = 100.0  # mm: beyond each window
ARC_DEGREES = 3.0


# --------------------------------------------------------------------- obstacles

def numbers(case: Path, section: str) -> tuple[str, list[float]]:
    """Kind and numbers of the obstacle of a section."""
    kind, _, values = parameter(case, section, "Obstacle").partition(":")
    return kind, [float(v) for v in values.split(",")]


def rounded(corners) -> list[numpy.ndarray]:
    """A polygonal line of rows x, y, radius with its corners rounded."""
    line = [corners[0][:2]]
    for before, corner, after in zip(corners, corners[1:], corners[2:]):
        (a, b), radius = [(p[:2] - corner[:2]) / numpy.linalg.norm(
            p[:2] - corner[:2]) for p in (before, after)], corner[2]
        half = math.acos(numpy.clip(a @ b, -1, 1)) / 2
        middle = (a + b) / numpy.linalg.norm(a + b)
        centre = corner[:2] + middle * radius / math.sin(half)
        spread = math.pi / 2 - half
        first = a / math.tan(half) * radius + corner[:2] - centre
        last = b / math.tan(half) * radius + corner[:2] - centre
        for s in numpy.linspace(0, 1, 2 + int(math.degrees(spread) / ARC_DEGREES)):
            line.append(centre + (math.sin(2 * spread * (1 - s)) * first
                                  + math.sin(2 * spread * s) * last)
                        / math.sin(2 * spread))
    return line + [corners[-1][:2]]


def obstacle_actor(case: Path, section: str, motion=(0.0, 0.0)) -> vtkActor:
    """The rigid body of a section, moved; a profile's is above it."""
    kind, values = numbers(case, section)
    if kind == "half plane":
        place, normal = numpy.reshape(values, (2, 2))
        normal = normal / numpy.linalg.norm(normal)
        along = FAR * numpy.array([-normal[1], normal[0]])
        depth = FAR * normal
        points = [place + along, place - along, place - along - depth,
                  place + along - depth]
        cells = [range(4)]
    elif kind == "circle":
        angles = numpy.radians(numpy.arange(0, 360, ARC_DEGREES / 6))
        points = [numpy.add(values[:2], values[2] * numpy.array(
            [math.cos(a), math.sin(a)])) for a in angles]
        cells = [range(len(points))]
    elif kind == "profile":
        line = rounded(numpy.reshape(values, (-1, 3)))
        points = line + [(p[0], FAR) for p in line]
        n = len(line)
        cells = [(i, i + 1, n + i + 1, n + i) for i in range(n - 1)]
    else:
        raise SystemExit(f"examples.py: no drawing of an obstacle '{kind}'")
    moved = numpy.add(points, motion)
    return plain_actor(polygons(numpy.c_[moved, numpy.zeros(len(moved))], cells),
                       RIGID)


def probe(case: Path, name: str, time=1.0) -> float:
    """The value of a probe at the end of the increment nearest to a time."""
    increment = min(summary(case)["increments"],
                    key=lambda i: abs(i["load_factor"] - time))
    return increment["probes"][name]


# ------------------------------------------------------------------------ actors

def behind(actor: vtkActor, depth=0.1) -> vtkActor:
    """Farther from the viewer, who looks along -z."""
    actor.AddPosition(0, 0, -depth)
    return actor


def edges_of(grid, at) -> tuple[list[tuple], list[tuple]]:
    """All edges of the cells and those of one cell alone, each by its nodes, the
    middle one of degree 2 in between; cells share edges that are in the same
    place of at."""
    shared: dict[tuple, list[tuple]] = {}
    for i in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(i)
        for k in range(cell.GetNumberOfEdges()):
            ids = [cell.GetEdge(k).GetPointId(j)
                   for j in range(cell.GetEdge(k).GetNumberOfPoints())]
            nodes = (ids[0], *ids[2:], ids[1])
            place = frozenset(tuple(at[n].round(6)) for n in (ids[0], ids[1]))
            shared.setdefault(place, []).append(nodes)
    return ([e[0] for e in shared.values()],
            [e[0] for e in shared.values() if len(e) == 1])


def lines_actor(points, lines, width: float, colour="404040") -> vtkActor:
    actor = plain_actor(polygons(points, lines, vtkPolyData.SetLines), colour)
    actor.GetProperty().SetLineWidth(width * FINER)
    return actor


def mesh_actor(case: Path, time: float) -> vtkActor:
    grid = unmoved_grid(case, "bodies", time)
    edges, _ = edges_of(grid, places(grid))
    return lines_actor(places(moved_grid(case, "bodies", time)), edges, 1)


def outline_actor(case: Path) -> vtkActor:
    """The boundary of the undeformed bodies."""
    grid = unmoved_grid(case, "bodies")
    _, boundary = edges_of(grid, places(grid))
    return lines_actor(places(grid), boundary, 1.5, "101010")


def hill_actors(case: Path, time: float, walls, per_mpa: float, level: float):
    """The contact pressure as a hill within the walls, per_mpa mm high for a MPa,
    and where both ends of an edge touch a line at the height of a pressure.
    Walls: rows of a place and the normal that points out of the wall."""
    surface = moved_grid(case, "contact", time)
    x, pressure = places(surface)[:, :2], field(surface, "pressure")
    status = field(surface, "status")
    points, hills, levels = [], [], []
    for i in range(surface.GetNumberOfCells()):
        ends = [surface.GetCell(i).GetPointId(k) for k in (0, 1)]
        if pressure[ends].max() <= 0:
            continue
        middle = x[ends].mean(axis=0)
        _, normal = min(walls, key=lambda wall: abs((middle - wall[0]) @ wall[1]))
        n = len(points)
        points += [x[e] - per_mpa * p * normal
                   for e, p in zip(ends, pressure[ends])]
        points += [x[e] - per_mpa * level * normal for e in ends]
        points += [x[e] for e in ends]
        hills.append((n + 4, n + 5, n + 1, n))
        if status[ends].min() > 0:
            levels.append((n + 2, n + 3))
    flat = numpy.c_[points, numpy.zeros(len(points))]
    return [behind(plain_actor(polygons(flat, hills), HILL), 0.05),
            lines_actor(flat, levels, 2, "101010")]


def mirrored_in_middle(case: Path, name: str, table, time: float):
    """Both halves of bodies whose plane of symmetry is y = 0."""
    grid = moved_grid(case, "bodies", time)
    actors = [make() for make in (lambda: body_actor(grid, name, table, False),
                                  lambda: mesh_actor(case, time))
              for _ in range(2)]
    for actor in actors[1::2]:
        actor.SetScale(1, -1, 1)
    return actors


def window_around(centre, width: float, part):
    """A window of this part's shape."""
    high = width * ((part[3] - part[1]) * SIZE[1]) / ((part[2] - part[0]) * SIZE[0])
    return (centre[0] - width / 2, centre[0] + width / 2,
            centre[1] - high / 2, centre[1] + high / 2)


def title(text: str):
    return strip(TITLE, [text_actor(text, 0.02, 0.3)])


def row(i: int, n: int, right=0.88):
    """Of row i of n below the title the parts for the view, for the words above
    it, and for the bar on its right."""
    high = 0.94 / n
    y = 0.94 - (i + 1) * high
    return ((0, y, right, y + high - 0.04), (0, y + high - 0.04, right, y + high),
            (right, y, 1, y + high))


# ---------------------------------------------------------------------- pictures

def draw_seal(case: Path, path: Path) -> None:
    """Squeezed, and pressurised; the contact pressures as hills on the walls."""
    fluid = 1.0  # MPa, at the end
    times = {0.5: "lid down by 1 mm", 1.0: f"and a fluid of {fluid:g} MPa on the left"}
    grids = {t: moved_grid(case, "bodies", t) for t in times}
    table = colours(VIRIDIS, 0, max(field(g, "von_mises").max()
                                    for g in grids.values()))
    sections = [f"Contact {name}" for name in ("bottom", "lid", "wall")]
    parts = [strip((0, 0, 1, 0.94), [])]
    for i, (time, name) in enumerate(times.items()):
        part = (0.44 * i, 0, 0.44 * i + 0.43, 0.94)
        motions = [(0, probe(case, "lid motion", time)) if "lid" in section
                   else (0, 0) for section in sections]
        walls = [numpy.reshape(numbers(case, section)[1], (2, 2)) + [motion, (0, 0)]
                 for section, motion in zip(sections, motions)]
        parts.append(view(
            part, window_around((0.75, -0.5), 7.8, part),
            [behind(obstacle_actor(case, *s)) for s in zip(sections, motions)]
            + [body_actor(grids[time], "von_mises", table, False),
               mesh_actor(case, time), outline_actor(case)]
            + hill_actors(case, time, walls, 1.0, fluid),
            [text_actor(name, 0.04, 0.95)]))
    save([title("Rubber seal: von Mises stress [MPa], displacements x 1; orange: "
                f"contact pressure, black bar: {fluid:g} MPa")]
         + parts + [strip((0.88, 0, 1, 0.94), [bar_actor(table, "%.1f")])], path)


def draw_press_fit(case: Path, path: Path) -> None:
    """At full interference and after its removal, half a section, mirrored in the
    middle of the length."""
    panels = []
    for i, (time, name, words) in enumerate(
            ((0.5, "plastic_strain", "shrunk on: accumulated plastic strain"),
             (1.0, "stress_zz", "free again: hoop stress [MPa]"))):
        signed = name == "stress_zz"
        values = field(moved_grid(case, "bodies", time), name)
        largest = numpy.abs(values).max()
        table = (colours(DIVERGING, -largest, largest) if signed
                 else colours(VIRIDIS, 0, largest))
        part = (0.5 * i, 0, 0.5 * i + 0.37, 0.94)
        panels += [view(part, window_around((17.5, 0), 37, part),
                        mirrored_in_middle(case, name, table, time),
                        [text_actor(words, 0.05, 0.965)]),
                   strip((part[2], 0, part[2] + 0.13, 0.94),
                         [bar_actor(table, "%.0f" if signed else "%.4f")])]
    wider = probe(case, "bore")
    save([title("Press fit, axis on the left; the radius of the free bore has grown by "
                f"{wider:.4f} mm; displacements x 1")] + panels, path)


def draw_snap_hook(case: Path, path: Path) -> None:
    """Where the push is largest, where the pull back is, and behind the lip."""
    steps = summary(case)["increments"]
    by_push = sorted(steps, key=lambda s: s["probes"]["push"])
    chosen = [by_push[-1], by_push[0], steps[-1]]
    grids = [moved_grid(case, "bodies", s["load_factor"]) for s in chosen]
    table = colours(VIRIDIS, 0, max(field(g, "von_mises").max() for g in grids))
    parts = []
    for i, (step, grid, name) in enumerate(zip(chosen, grids, (
            "largest push", "largest pull, it snaps in", "at rest"))):
        part, words, _ = row(i, len(chosen))
        way = field(grid, "displacement")[:, 0].max()
        text = (f"moved by {way:.1f} mm: {name}, "
                f"{abs(step['probes']['push']):.2f} N/mm")
        parts += [strip(words, [text_actor(text, 0.02, 0.2)]),
                  view(part, window_around((23.6, 2.2), 40, part),
                       [behind(obstacle_actor(case, "Contact")),
                        body_actor(grid, "von_mises", table, False)], [])]
    save([title("Snap hook and lip: von Mises stress [MPa], displacements x 1")]
         + parts + [strip((0.88, 0, 1, 0.94), [bar_actor(table)])], path)


def draw_roller(case: Path, path: Path) -> None:
    """While it rolls, and what stays behind."""
    half = 0.5
    motion = [probe(case, f"motion {d}", half) for d in "xy"]
    panels = []
    for i, (time, name, signed, labels, words) in enumerate((
            (half, "von_mises", False, "%.0f",
             "rolling to the right: von Mises stress [MPa]"),
            (1.0, "plastic_strain", False, "%.3f",
             "lifted: accumulated plastic strain"),
            (1.0, "stress_xx", True, "%.0f", "lifted: stress xx [MPa]"))):
        grid = moved_grid(case, "bodies", time)
        largest = numpy.abs(field(grid, name)).max()
        table = (colours(DIVERGING, -largest, largest) if signed
                 else colours(VIRIDIS, 0, largest))
        part, above, beside = row(i, 3)
        actors = [body_actor(grid, name, table, False)]
        if time == half:
            actors.append(behind(obstacle_actor(case, "Contact", motion)))
        panels += [strip(above, [text_actor(words, 0.02, 0.2)]),
                   view(part, window_around((12, -1.1), 15, part), actors, []),
                   strip(beside, [bar_actor(table, labels)])]
    save([title("Roller on a block that yields, displacements x 1")] + panels, path)


def draw_lug(case: Path, path: Path) -> None:
    """Lug and pin from above, and the bore alone."""
    panels = []
    for i, (kind, name, towards_viewer, words) in enumerate((
            ("bodies", "von_mises", (0.5, -0.8, 0.9), "von Mises stress [MPa]"),
            ("contact", "pressure", (-1.0, -0.5, 0.7),
             "the bore: contact pressure [MPa]"))):
        grid = moved_grid(case, kind, 1.0)
        table = colours(VIRIDIS, 0, field(grid, name).max())
        part, above, beside = row(i, 2)
        wide = (part[2] - part[0]) * SIZE[0] / ((part[3] - part[1]) * SIZE[1])
        panels += [strip(above, [text_actor(words, 0.02, 0.2)]),
                   space_view(part, towards_viewer, grid.GetBounds(),
                              [shaded(body_actor(grid, name, table, True))],
                              nearer=1.3 / wide),
                   strip(beside, [bar_actor(table)])]
    save([title("A pin in the bore of a lug, meshed from its STEP file, "
                "displacements x 1")] + panels, path)


def with_probes(probes: str) -> dict[str, str]:
    return {"Probes/Probes": probes}


# Of each example the picture, entries for it, and those of a quicker run.
PICTURES = {
    "seal": (draw_seal, with_probes("lid motion: obstacle motion y, Contact lid"),
             {}),
    "press_fit": (draw_press_fit, {}, {}),
    "snap_hook": (draw_snap_hook, {}, {}),
    "lug": (draw_lug, {}, {"Mesh/Size": 6, "Mesh/Sizes": "Bore: 3, Shank: 3"}),
    "roller": (draw_roller,
               with_probes("motion x: obstacle motion x, Contact; "
                           "motion y: obstacle motion y, Contact"),
               {"Solution/Increments": 10}),
}
