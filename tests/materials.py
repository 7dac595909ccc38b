#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies that yield, and bodies of rubber.

Proves that

- thick tubes and a hollow sphere under pressure have the displacements and the
  stresses of Hill, also those that are left when the pressure is taken off, and
  a tube of rubber those of a neo-Hookean one;
- Newton's method ends quadratically in increments in which points yield;
- the tube is the same in other units, and on two processes;
- no increment dissipates less than nothing, and the energy balance holds;
- a yield stress of an elastic body changes nothing but a line of the result;
- under a cylinder von Mises' stress is the largest where Hertz' pressure has it
  (p0 = 1.794 Y at first yield, 0.704 a deep, nu = 0.3; the stresses on the axis
  are those of Johnson, Contact Mechanics, 1985, equation 4.46);
- a block of the material of Mooney and Rivlin in uniaxial, biaxial and plane
  stretch has the stress of the closed form, and with a strain of 1e-6 the energy
  balance holds as well;
- bodies of different materials and kinematics touch in one scene.

Usage: materials.py CONTACT PARAMETERS MESHES
"""

import json
import math
import pathlib
import re
import subprocess
import sys

from volume_scenes import Volumes

contact, parameters, meshes = sys.argv[1:4]
cases = pathlib.Path(parameters).resolve() / "verification"
failures = []


def check(what, good, found=""):
    print(("ok: " if good else "FAILED: ") + what, found)
    if not good:
        failures.append(what)


def run(name, case, *options, ranks=1):
    command = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
    command += [contact, str(case), "--set", f"Output/Directory={name}"]
    for option in options:
        command += ["--set", option]
    process = subprocess.run(command, capture_output=True, text=True)
    summary = json.loads(
        (pathlib.Path(name) / pathlib.Path(case).stem / "summary.json").read_text())
    check(f"{name}: converged, no violation", process.returncode == 0,
          f"exit status {process.returncode}")
    return summary, process.stdout


def probes(summary):
    return {probe["name"]: probe["value"] for probe in summary["probes"]}


def difference(a, b):
    return max(abs(a[name] / b[name] - 1) for name in b)


for case in ("thick_tube", "thick_tube_unloaded", "plastic_sphere", "rubber_tube",
             "prandtl"):
    summary, text = run(case, cases / f"{case}.prm")
    works = [i["works"]["plastic_dissipation"] for i in summary["increments"]
             if i["converged"] and i["level"] == summary["increments"][-1]["level"]]
    check(f"{case}: dissipation grows or stays", works == sorted(works), works)
    if case == "prandtl":  # at the limit load the tangent has no inverse
        continue
    # On the first mesh, whose increments start from nothing better.
    for increment in text.split("Level 1")[0].split("Increment ")[1:]:
        residuals = [float(r) for r in re.findall(r"residual (\S+)", increment)]
        print("  residuals", residuals)
        if len(residuals) > 3 and residuals[-2] < 0.02:
            check(f"{case}: the last step gains quadratically",
                  residuals[-1] < 100 * residuals[-2] ** 2)
        check(f"{case}: at most 8 Newton steps", len(residuals) < 10)

tube = cases / "thick_tube_unloaded.prm"
base = probes(run("base", tube, "Refinement/Levels=2")[0])
found = probes(run("ranks", tube, "Refinement/Levels=2", ranks=2)[0])
check("two processes", difference(found, base) < 1e-6, difference(found, base))
# Lengths in m, stresses in Pa.
found = probes(run("units", tube, "Refinement/Levels=2", "Mesh/Scale=1e-3",
                   "Solids/Young's modulus=Tube: 210000e6",
                   "Solids/Yield stress=Tube: 240e6",
                   "Boundary conditions/Pressure=Bore: 170e6",
                   "Probes/References=", "Probes/Tolerances=")[0])
scaled = {name: value * (1e-3 if name[0] == "u" else 1e6)
          for name, value in base.items()}
check("other units", difference(found, scaled) < 1e-6, difference(found, scaled))

# A disk that is full at the third increment, and the rest from there.
for ranks, piece in ((1, "bodies_0003.vtu"), (2, "bodies_0003.0000.vtu")):
    name = f"restart{ranks}"
    directory = pathlib.Path(name) / tube.stem
    directory.mkdir(parents=True, exist_ok=True)
    (directory / f"{piece}.part").symlink_to("/dev/full")
    options = ["Refinement/Levels=2", "Output/VTU=true", "Output/Directory=" + name]
    command = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
    command += [contact, str(tube), "--quiet"]
    for option in options:
        command += ["--set", option]
    status = subprocess.run(command, capture_output=True).returncode
    check(f"{name}: full disk", status != 0, status)
    (directory / f"{piece}.part").unlink(missing_ok=True)
    status = subprocess.run(command + ["--restart"], capture_output=True).returncode
    summary = json.loads((directory / "summary.json").read_text())
    found = probes(summary)
    check(f"{name}: the rest", status == 0 and difference(found, base) < 1e-7,
          (status, difference(found, base)))
    check(f"{name}: no increment twice",
          len([i for i in summary["increments"] if i["level"] == 1]) == 4)

# A check of the stress alone.
elastic = ("Solids/Material=", "Refinement/Levels=2", "Probes/References=",
           "Probes/Tolerances=", "Boundary conditions/Histories=")
checked, text = run("checked", tube, *elastic)
bare = run("bare", tube, *elastic, "Solids/Yield stress=")[0]
check("the check changes nothing", probes(checked) == probes(bare))
share = checked["bodies"]["Tube"]["volume_share_above_yield"]
# Lame without change of volume: von Mises' stress is sqrt(3) p a^2 b^2/(r^2 (b^2 -
# a^2)) = Y at r = 127.9 mm.
radius2 = 3 ** 0.5 * 170 * 1e4 * 4e4 / 3e4 / 240
exact = (radius2 - 1e4) / 3e4
check("share above yield", abs(share - exact) < 0.03, (share, exact))
check("and its line", "above yield in" in text)

# A stamp of metal that yields in a ring of rubber: two materials and kinematics.
# The block of the benchmark, E of both bodies as there, P = 350 N/mm, R = 50 mm.
modulus = 1 / (0.91 / 210000 + 0.91 / 70000)
p0 = math.sqrt(350 * modulus / (math.pi * 50))
a = 2 * 350 / (math.pi * p0)
largest, depth = max(
    (math.sqrt(((x - z)**2 + (z - y)**2 + (y - x)**2) / 2), s)
    for s in (k / 1000 for k in range(2000))
    for x, z in ((2 * s - (1 + 2 * s**2) / math.sqrt(1 + s**2),
                  -1 / math.sqrt(1 + s**2)),)
    for y in (0.3 * (x + z),))
summary, text = run("first_yield", cases / "hertz.prm", "Element/Degree=2",
                    "Mesh/Refinements=2",
                    "Solids/Yield stress=Cylinder: 100, Block: 100")
found = summary["bodies"]["Block"]["von_mises"] / p0
place = float(re.search(r"Block.*up to .* at \(.*, -([0-9.]+)\) mm", text).group(1))
check("first yield below a cylinder", abs(found / largest - 1) < 0.005 and
      abs(place / (depth * a) - 1) < 0.05, f"{1 / found} {place / a}")

pathlib.Path("mixed.prm").write_text(f"""include {cases}/nested_cylinders.prm
subsection Solids
  set Young's modulus = Inner: 1000, Outer: 3
  set Poisson's ratio = Inner: 0.3, Outer: 0.499
  set Kinematics = Inner: small strain, Outer: large displacement
  set Material = Inner: elastic-plastic, Outer: neo-Hookean
  set Yield stress = Inner: 2
  set Hardening modulus = Inner: 100
end
subsection Boundary conditions
  set Pressure = Bore: 4
end
subsection Solution
  set Increments = 5
  set Geometry = automatic
end
subsection Refinement
  set Levels = 2
end
subsection Probes
  set References =
  set Tolerances =
end
""")
summary, text = run("mixed", "mixed.prm")
check("the inner tube yields", summary["bodies"]["Inner"]["plastic_strain"] > 1e-3)
worst = max(i["invariants"]["energy_imbalance"] for i in summary["increments"]
            if i["level"] == 1)
check("balance of the energy", worst < 1e-6, worst)

# A unit cube on three planes of symmetry, stretched along one or two of its
# axes: with the stretches l that come about, one of them in a free direction,
# sigma_x - sigma_z = 2/J (C10 J^(-2/3) (l_x^2 - l_z^2)
#                          + C01 J^(-4/3) l_y^2 (l_x^2 - l_z^2)).
block = Volumes()
block.block("A", (1, 2, 1), lambda r, s, t: (r, s, t))
block.write("cube")
C10, C01, poisson = 0.4, 0.1, 0.49
for name, held in (("uniaxial", ""), ("biaxial", ", A_y1: 0.5"),
                   ("plane", ", A_y1: 0")):
    pathlib.Path(f"cube_{name}.prm").write_text(f"""subsection Mesh
  set File = cube.msh
end
subsection Solids
  set Young's modulus = A: {4 * (1 + poisson) * (C10 + C01)}
  set Poisson's ratio = A: {poisson}
  set Material = A: Mooney-Rivlin
  set Mooney-Rivlin constant = A: {C01}
end
subsection Boundary conditions
  set Displacement x = A_x0: 0, A_x1: 0.5
  set Displacement y = A_y0: 0{held}
  set Displacement z = A_z0: 0
end
subsection Solution
  set Increments = 4
end
subsection Probes
  set Probes = x: displacement x, A_111; y: displacement y, A_111; \\
               z: displacement z, A_111; sx: stress xx, A_111; \\
               sz: stress zz, A_111
end
""")
    found = probes(run(name, f"cube_{name}.prm")[0])
    l = [1 + found[c] for c in "xyz"]
    J = math.prod(l)
    exact = 2 / J * (l[0]**2 - l[2]**2) * (C10 * J**(-2 / 3) +
                                           C01 * J**(-4 / 3) * l[1]**2)
    check(f"Mooney-Rivlin, {name} stretch", abs(found["sz"]) < 1e-6 * exact and
          abs((found["sx"] - found["sz"]) / exact - 1) < 1e-9, (found, exact))
# Energies near zero are no differences of numbers near one.
run("tiny", "cube_uniaxial.prm", "Boundary conditions/Displacement x=A_x0: 0, "
    "A_x1: 1e-6")
sys.exit(bool(failures))
