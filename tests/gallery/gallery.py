#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of results, drawn without a screen.

    gallery.py [--output DIR] [--pictures DIR] [--coarse] [--examples NAME,...]
               CONTACT

CONTACT is the program; it computes the cases into DIR (output/gallery), the
pictures go to results beside this file. VTK draws the bodies, gnuplot the
curves; convergence is that of the study, from its results. VTK of Debian
(python3-vtk9) draws on X only: xvfb-run gallery.py ..., as ./run gallery does.
With --coarse the scene in 3-D is not refined, and the roller takes fewer
increments. Exit status: 0, 1 if a case or a
picture has failed.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tests/study"))
sys.path.append(str(ROOT / "tests"))  # behind those of the same name here
import examples  # noqa: E402
import line_contact  # noqa: E402
import plots  # noqa: E402
import report  # noqa: E402
import space  # noqa: E402
from contact_results import Results  # noqa: E402
from curves import block, gnuplot  # noqa: E402
from drawing import (  # noqa: E402
    BAR, DIVERGING, SIZE, STATUS, TITLE, VIRIDIS, bar_actor, body_actor, colours,
    describe, extreme, frame_actor, last_grid, parameter, rgb, save,
    status_actor, strip, summary, text_actor, view, with_margin)

BODIES = ("ssnp154_a", "ssnp154_g")  # in colours
PRESSURES = ("ssnp154_a", "ssnp154_c", "ssnp154_d", "nested")
FRICTION = ("ssnp154_d", "nested_friction")
CONVERGENCE = "rings_orders"
IN_SPACE = "sphere_on_block"
REFINED = {"Mesh/Refinements": 1}
AXIS = ['set xlabel "arc length on the slave [mm]"']
SETTINGS = {"Output/VTU": "true", "Output/Profile": "true",
            "Output/Screen": "none"}


def run_case(contact: Path, name: str, output: Path, more={}) -> Path:
    """The directory with the results of a case."""
    call = [contact, ROOT / "parameters" / f"{name}.prm", "--quiet", "--set",
            f"Output/Directory={output}"]
    for entry, value in (SETTINGS | more).items():
        call += ["--set", f"{entry}={value}"]
    run = subprocess.run(call)
    # 1: a value outside of its tolerance, which is no picture's business
    if run.returncode not in (0, 1):
        sys.exit(f"gallery.py: {name} ends with exit status {run.returncode}")
    return output / Path(name).name


def value(case: Path, probe: str) -> float:
    return next(p["value"] for p in summary(case)["probes"]
                if p["name"] == probe)


# -------------------------------------------------------------------- the bodies

def around_contact(case: Path, part):
    """A window of this part's shape on the contact zone and as much beside."""
    width, bottom = summary(case)["contact"]["width"], value(case, "DY(B)")
    aspect = ((part[3] - part[1]) * SIZE[1]) / ((part[2] - part[0]) * SIZE[0])
    half = width * aspect
    return -0.05 * width, 1.95 * width, bottom - half, bottom + half


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

def profile(case: Path):
    """The rows of the slave up to one and a half of the half width."""
    rows = Results(case).profile("slave")
    return rows[rows["arc_length"] <= 1.5 * summary(case)["contact"]["width"]]


def draw_pressures(cases: list[Path], path: Path) -> None:
    """The contact pressure beside that of Hertz."""
    lines = ['set ylabel "contact pressure [MPa]"',
             'set title "Contact pressure of the cylinder on the block"',
             "set yrange [0:*]"]
    curves = []
    for i, case in enumerate(cases):
        lines += block(f"$case{i}", profile(case), "arc_length", "pressure")
        curves.append(f'$case{i} with linespoints lw 1.6 ps 0.7 '
                      f"pt {plots.POINTS[i + 1]} "
                      f'lc rgb "{plots.COLOURS[i + 1]}" '
                      f'title "{case.name}: {describe(case)}" noenhanced')
    # The curve of theory on a fine line of its own.
    exact = line_contact.ssnp154(35000)
    half_width = f"{exact.half_width:.9g}"
    curves.append(f"abs(x) > {half_width} ? NaN : "
                  f"{exact.max_pressure:.9g} * sqrt(1 - "
                  f"(x / {half_width})**2) "
                  'lw 2 dt 2 lc rgb "#000000" title "Hertz"')
    lines += ["set samples 2000", "set key top right",
              "plot " + ", \\\n  ".join(curves)]
    gnuplot(AXIS + lines, path)


def draw_shears(cases: list[Path], path: Path) -> None:
    """The shear between its bounds, and where it reaches them."""
    lines = [f"set multiplot layout 1,{len(cases)}", "set key top right",
             'set ylabel "traction [MPa]"', "set yrange [0:*]"]
    for i, case in enumerate(cases):
        mu = float(parameter(case, "Contact", "Friction coefficient"))
        rows = profile(case)
        lines += [f'set title "{case.name}\\n{describe(case)}" noenhanced',
                  *block(f"$rows{i}", rows, "arc_length", "pressure")]
        curves = [f'$rows{i} using 1:({mu} * $2) with lines lw 2 dt 2 lc rgb '
                  f'"#000000" title "{mu:g} x pressure"']
        for status, (name, colour) in STATUS.items():
            chosen = rows[rows["status"] == status]
            if chosen.empty:
                continue
            lines += block(f"$status{i}_{status}", chosen, "arc_length", "shear")
            curves.append(f"$status{i}_{status} using 1:(abs($2)) with points "
                          f'pt 7 ps 0.9 lc rgb "#{colour}" title '
                          f'"|shear|, {name}"')
        lines.append("plot " + ", \\\n  ".join(curves))
    gnuplot(AXIS + lines + ["unset multiplot"], path)


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
    parser.add_argument("--coarse", action="store_true")
    parser.add_argument("--examples", metavar="NAME,...",
                        default=",".join(examples.PICTURES))
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
    case = run_case(arguments.contact.resolve(), IN_SPACE, output,
                    {} if arguments.coarse else REFINED)
    space.draw_cut(case, pictures / "von_mises_space.png")
    space.draw_footprint(case, pictures / "pressure_space.png")
    space.draw_stick_and_slip(case, pictures / "stick_and_slip_space.png")
    for name in arguments.examples.split(","):
        draw, more, coarser = examples.PICTURES[name]
        case = run_case(arguments.contact.resolve(), f"examples/{name}", output,
                        more | (coarser if arguments.coarse else {}))
        draw(case, pictures / f"{name}.png")
    for picture in sorted(pictures.glob("*.png")):
        print(f"{picture}: {picture.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
