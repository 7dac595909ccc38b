#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies that yield, and bodies of rubber.

Proves that

- thick tubes and a hollow sphere under pressure have the displacements and the
  stresses of Hill, also those that are left when the pressure is taken off, and
  a tube of rubber those of a neo-Hookean one;
- Newton's method ends quadratically in increments in which points yield;
- the tube is the same in other units, on two processes and restarted, rubber too;
- no increment dissipates less than nothing, and the energy balance holds;
- a hardening curve may begin with no plastic strain and the yield stress;
- a yield stress of an elastic body changes nothing but a line of the result;
- under a cylinder von Mises' stress is the largest where Hertz' pressure has it
  (p0 = 1.794 Y at first yield, 0.704 a deep, nu = 0.3; the stresses on the axis
  are those of Johnson, Contact Mechanics, 1985, equation 4.46);
- in 3-D a quarter of the tube that yields has the same closed form, and so has
  the tube on a mesh that is refined adaptively;
- blocks of Mooney-Rivlin and neo-Hookean material in uniaxial, biaxial and plane
  stretch have the stress of the closed form, and with a strain of 1e-6 the energy
  balance holds as well; so have nearly incompressible ones, with at most 8 Newton
  steps, and when they are heated they expand;
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
    process = subprocess.run(command + ["--verbose"], capture_output=True, text=True)
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

# A curve may begin with the yield stress.
curves = [probes(run(f"curve_{len(points)}", tube, "Refinement/Levels=1",
                     f"Solids/Hardening curve=Tube: {points}",
                     "Probes/References=", "Probes/Tolerances=")[0])
          for points in ("0.01, 300", "0, 240, 0.01, 300")]
check("a curve that begins with the yield stress", curves[0] == curves[1], curves)

# A disk that is full at the third increment, and the rest from there.
rubber = cases / "rubber_tube.prm"
of_rubber = probes(run("rubber", rubber, "Refinement/Levels=2")[0])
found = probes(run("rubber2", rubber, "Refinement/Levels=2", ranks=2)[0])
check("rubber on two processes", difference(found, of_rubber) < 1e-6,
      difference(found, of_rubber))
for case, ranks, piece, expected in (
        (tube, 1, "bodies_0003_0.vtu", base),
        (tube, 2, "bodies_0003_0.0000.vtu", base),
        (rubber, 1, "bodies_0003_0.vtu", of_rubber)):
    name = f"restart{ranks}"
    directory = pathlib.Path(name) / case.stem
    directory.mkdir(parents=True, exist_ok=True)
    (directory / f"{piece}.part").symlink_to("/dev/full")
    options = ["Refinement/Levels=2", "Output/VTU=true", "Output/Directory=" + name]
    command = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
    command += [contact, str(case), "--quiet"]
    for option in options:
        command += ["--set", option]
    status = subprocess.run(command, capture_output=True).returncode
    check(f"{case.stem}, {name}: full disk", status != 0, status)
    (directory / f"{piece}.part").unlink(missing_ok=True)
    status = subprocess.run(command + ["--restart"], capture_output=True).returncode
    summary = json.loads((directory / "summary.json").read_text())
    found = probes(summary)
    check(f"{case.stem}, {name}: the rest",
          status == 0 and difference(found, expected) < 1e-7,
          (status, difference(found, expected)))
    last = summary["increments"][-1]["level"]
    check(f"{case.stem}, {name}: no increment twice", [
        i["load_factor"] for i in summary["increments"] if i["level"] == last] ==
          [0.25, 0.5, 0.75, 1])

# Refined where the estimate says, against Hill: cells whose points yield are
# divided, and the history begins anew on each mesh.
adaptive = run("adaptive", cases / "thick_tube.prm", "Refinement/Strategy=adaptive",
               "Refinement/Levels=4")[0]
cells = [level["cells"] for level in adaptive["levels"]]
check("adaptive tube: some cells are divided, not all", all(
    a < b < 4 * a for a, b in zip(cells, cells[1:])), cells)

# A quarter of the tube in 3-D, a layer of cells high: the same closed form.
quarter = Volumes()
quarter.block("Tube", (8, 8, 1), lambda r, s, t: (
    100 * 2**r * math.cos(s * math.pi / 2), 100 * 2**r * math.sin(s * math.pi / 2),
    20 * t), {"x0": "Bore", "x1": "Outside", "y0": "y", "y1": "x", "z0": "z",
              "z1": "z"}, {"000": "100", "100": "200"})
quarter.write("quarter")
pathlib.Path("sector_thick_tube.prm").write_text("""subsection Mesh
  set File = quarter.msh
  set Cylinders = Tube_Bore: 0, 0, 0, 0, 0, 1, 100; \\
                  Tube_Outside: 0, 0, 0, 0, 0, 1, 200
end
subsection Element
  set Degree = 2
end
subsection Solids
  set Young's modulus = Tube: 210000
  set Poisson's ratio = Tube: 0.4999
  set Kinematics      = small strain
  set Material        = Tube: elastic-plastic
  set Yield stress    = Tube: 240
end
subsection Boundary conditions
  set Displacement x = Tube_x: 0
  set Displacement y = Tube_y: 0
  set Displacement z = Tube_z: 0
  set Pressure       = Tube_Bore: 170
end
subsection Solution
  set Increments = 4
end
subsection Probes
  set Probes = u(100): displacement x, Tube_100; u(200): displacement x, Tube_200; \\
               hoop(100): stress yy, Tube_100; hoop(200): stress yy, Tube_200
  set References = u(100): 0.212276520328095, u(200): 0.106138260164047, \\
                   hoop(100): 107.128129211020, hoop(200): 148.603476722514
  set Tolerances = u(100): 1e-3, u(200): 1e-3, hoop(100): 2e-2, hoop(200): 5e-3
end
""")
run("space_thick_tube", "sector_thick_tube.prm")

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
passed, text = run("passed", tube, *elastic[:-1])
peak = max(i["bodies"]["Tube"]["von_mises"] for i in passed["increments"]
           if "bodies" in i)
check("the check of an earlier increment",
      abs(checked["bodies"]["Tube"]["von_mises"] / peak - 1) < 1e-9 and
      passed["bodies"]["Tube"]["von_mises"] < 1e-6 * peak and
      "at t = 0.5: von Mises' stress up to" in text, text[-800:])

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
place = float(re.search(r"Block.*?up to [^(]* at \([^)]*, -([0-9.]+)\) mm",
                        text).group(1))
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
    for law, c10, c01, options in (
            ("Mooney-Rivlin", C10, C01, ()),
            ("neo-Hookean", C10 + C01, 0, ("Solids/Material=A: neo-Hookean",
                                           "Solids/Mooney-Rivlin constant="))):
        found = probes(run(f"{name}_{law}", f"cube_{name}.prm", *options)[0])
        l = [1 + found[c] for c in "xyz"]
        J = math.prod(l)
        exact = 2 / J * (l[0]**2 - l[2]**2) * (c10 * J**(-2 / 3) +
                                               c01 * J**(-4 / 3) * l[1]**2)
        check(f"{law}, {name} stretch", abs(found["sz"]) < 1e-6 * exact and
              abs((found["sx"] - found["sz"]) / exact - 1) < 1e-9, (found, exact))
# Nearly incompressible: on its way Newton's method meets indefinite tangents.
for name, options in (
        ("stiff", ()),
        ("heated", ("Boundary conditions/Displacement x=A_x0: 0",
                    "Solids/Thermal strain=A: 0.01*t"))):
    summary, _ = run(name, "cube_uniaxial.prm",
                     "Solids/Material=A: neo-Hookean",
                     "Solids/Mooney-Rivlin constant=",
                     "Solids/Poisson's ratio=A: 0.4999999", *options)
    found = probes(summary)
    l = [1 + found[c] for c in "xyz"]
    modulus = (1 + poisson) * (C10 + C01) / 1.4999999  # half of the shear modulus
    exact = 0 if name == "heated" else 2 * modulus * (l[0]**2 - l[2]**2)
    check(f"nearly incompressible, {name}",
          abs(found["sx"] - found["sz"] - exact) < 1e-5 * modulus and
          abs(math.prod(l) - (1.01**3 if name == "heated" else 1)) < 1e-6 and
          all(i["converged"] and i["newton_iterations"] <= 8
              for i in summary["increments"]),
          (found, exact, [i["newton_iterations"] for i in summary["increments"]]))
# Energies near zero are no differences of numbers near one.
run("tiny", "cube_uniaxial.prm", "Boundary conditions/Displacement x=A_x0: 0, "
    "A_x1: 1e-6")
sys.exit(bool(failures))
