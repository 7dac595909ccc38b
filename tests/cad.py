#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases whose mesh gmsh makes of a CAD file or of a .geo.

Proves that

- of a STEP file labels name bodies and boundaries, without them bodies have
  numbers by volume and points name boundaries: two blocks under pressure have
  the stress of that, whoever names them, on two processes as well;
- a .geo is meshed as gmsh's program does, to the last bit, also one that sets
  sizes and maps, and the case has the same values;
- plane parts are of quadrangles, with the circle that the file has;
- sizes are those of the entries, on surfaces of contact half of them;
- the mesh is made anew if file, included file or entry have changed, and else
  not;
- points beside all boundaries or on two, unknown names, files that are missing,
  broken or cross themselves, and absurd sizes are refused, with the remedy.

Usage: cad.py CONTACT PARAMETERS MESHES
"""

import math
import pathlib
import shutil
import subprocess
import sys

meshes = pathlib.Path(sys.argv[3]).resolve()
sys.dont_write_bytecode = True
sys.path.insert(0, str(meshes))
from block_scenes import check, failures, run  # noqa: E402
from named_step import write_step  # noqa: E402

BLOCKS = """
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 4, 4, 2};
Box(2) = {1, 1, 2, 2, 2, 1};
"""
PLANE = """
SetFactory("OpenCASCADE");
Rectangle(1) = {-4, -4, 0, 8, 4};
Disk(2) = {0, 2, 0, 2};
"""
P = 3.  # on the head of the upper block
GROUND, SOLE = "Ground", "Sole"
CASE = {
    "Solids/Kinematics": "small strain",
    "Boundary conditions/Displacement z": "Base: 0",
    "Boundary conditions/Displacement x": "Sides x: 0",
    "Boundary conditions/Displacement y": "Sides y: 0",
    "Boundary conditions/Pressure": f"Head: {P}",
    "Contact/Slave": SOLE, "Contact/Master": GROUND}
SIDES = {"Sides x": "1, 2, 2.5; 3, 2, 2.5"}
POINTS = ("Base: 1, 1, 0; Head: 2, 2, 3; Ground in Body 1: 0.5, 2, 2; "
          "Sole in Body 2: 2, 2, 2; Sides x: 0, 2, 1, 1, 2, 2.5; "
          "Sides y: 2, 0, 1, 2, 1, 2.5")


def case(file, lower, upper, **more):
    return {**CASE, "Mesh/File": file,
            "Solids/Young's modulus": f"{lower}: 1000, {upper}: 1000",
            "Solids/Poisson's ratio": f"{lower}: 0, {upper}: 0",
            "Probes/Probes": "force: contact force z, Sole; "
                             "head: displacement z, Top",
            "Mesh/Points": "Top: 1, 1, 3", "Mesh/Size": "1.6",
            **{key.replace("_", "/"): value for key, value in more.items()}}


def values(summary):
    return {p["name"]: p["value"] for p in summary.get("probes", [])}


def note(summary):
    return " ".join(f["text"] for f in summary.get("findings", []))


def elements(file):
    """Number by gmsh's type, and the nodes by number."""
    lines = iter(pathlib.Path(file).read_text().splitlines())
    count, nodes = {}, {}
    for line in lines:
        if line == "$Nodes":
            for _ in range(int(next(lines).split()[0])):
                n = int(next(lines).split()[3])
                numbers = [int(next(lines)) for _ in range(n)]
                nodes.update((k, [float(x) for x in next(lines).split()])
                             for k in numbers)
        elif line == "$Elements":
            for _ in range(int(next(lines).split()[0])):
                _, _, kind, n = map(int, next(lines).split())
                count[kind] = count.get(kind, 0) + n
                for _ in range(n):
                    next(lines)
    return count, nodes


def step_files():
    write_step(BLOCKS, "labelled.step", ("Lower", "Upper"),
               {5: "Base", 6: GROUND, 1: "Sides x", 3: "Sides y",
                7: "Sides x", 9: "Sides y", 11: SOLE, 12: "Head"})
    write_step(BLOCKS, "bare.step")
    found = []
    for name, entries in (
            ("labels", case("labelled.step", "Lower", "Upper")),
            ("points", case("bare.step", "Body 1", "Body 2",
                            Mesh_Boundaries=POINTS))):
        for ranks in (1, 2):
            status, said, summary = run(name, entries, ranks)
            found.append(values(summary))
            check(f"{name}: two blocks in contact, {ranks} processes",
                  status == 0 and
                  abs(found[-1]["force"] - 4 * P) < 1e-6,
                  said[-900:] if status else "")
        check(f"{name}: the second run has the mesh of the first",
              "nothing has changed" in note(summary), note(summary))
    check("labels and points are the same case", len(found) == 4 and all(
        math.isclose(found[0].get("head", 0), other.get("head", 1), rel_tol=1e-6)
        for other in found), found)
    check("tetrahedra of second order", set(
        elements("output/labels/labelled.msh")[0]) == {9, 11})
    return case("bare.step", "Body 1", "Body 2", Mesh_Boundaries=POINTS)


def repeated_labels():
    write_step(BLOCKS + "Box(3) = {0, 0, 5, 1, 1, 1};\n", "repeated.step",
               ("Part", "Part", "Part 1"))
    said = run("repeated", case("repeated.step", "Part 1", "Part 2"))[1]
    check("numbers of equal labels go past those that are taken",
          all(f"Part {k} " in said for k in (1, 2, 3)), said[-900:])


def geo_files(parameters):
    for name in ("ssnp154", "sphere_on_block"):
        subprocess.run(["gmsh", "-3", "-format", "msh41", "-o", f"{name}.msh",
                        meshes / f"{name}.geo"], check=True,
                       stdout=subprocess.DEVNULL)
    contact = sys.argv[1]
    table = {}
    for kind in ("geo", "msh"):
        file = meshes / "ssnp154.geo" if kind == "geo" else "ssnp154.msh"
        result = subprocess.run(
            [contact, parameters / "ssnp154_g.prm", "--quiet", "--set",
             f"Mesh/File={file}"], capture_output=True, text=True)
        table[kind] = result.stdout
    check("modeling G from its .geo has all digits of that from the mesh",
          table["geo"] == table["msh"] and "SIYY" in table["geo"], table)
    made = pathlib.Path("output/ssnp154_g/ssnp154.msh")
    # The mesh alone: there is no such surface.
    subprocess.run([contact, parameters / "sphere_on_block.prm", "--quiet",
                    "--set", f"Mesh/File={meshes / 'sphere_on_block.geo'}",
                    "--set", "Contact/Slave=None"], capture_output=True)
    space = pathlib.Path("output/sphere_on_block/sphere_on_block.msh")
    for file in (made, space):
        text = file.read_text()
        check(f"{file.name} is that of gmsh's program, but for its last lines",
              text[:text.index("$Comments")] ==
              pathlib.Path(file.name).read_text())


def plane_parts():
    pathlib.Path("plane.geo").write_text(PLANE + 'Save "plane.brep";\n')
    subprocess.run(["gmsh", "-", "plane.geo"], check=True,
                   stdout=subprocess.DEVNULL)
    status, said, summary = run("plane", {
        "Mesh/File": "plane.brep", "Mesh/Size": "0.8",
        "Mesh/Boundaries": "Base: 0, -4; Ground: -2, 0; Round: 0, 4",
        "Mesh/Points": "Top: 0, 4",
        "Solids/Young's modulus": "Body 1: 1000, Body 2: 1000",
        "Solids/Poisson's ratio": "Body 1: 0.3, Body 2: 0.3",
        "Boundary conditions/Displacement x": "Base: 0, Top: 0",
        "Boundary conditions/Displacement y": "Base: 0",
        "Boundary conditions/Body force y": "Body 2: -0.1",
        "Contact/Slave": "Round", "Contact/Master": "Ground",
        "Contact/Friction coefficient": "0.5"})
    check("a disc on a block, of a plane CAD file", status == 0, said[-900:])
    if status == 0:
        count, nodes = elements("output/plane/plane.msh")
        check("of quadrangles of second order alone", set(count) == {8, 10},
              count)
        rims = [abs(math.hypot(x, y - 2) - 2) for x, y, _ in nodes.values()
                if math.hypot(x, y - 2) > 1.99 and y > 1e-9]
        check("its rim is the circle of the file",
              len(rims) > 20 and max(rims) < 1e-9, max(rims, default=None))
    return status


def changes(entries):
    made, kept = "made by gmsh", "nothing has changed"

    # A probe at a place that is not there ends the run behind the meshing.
    def run_up_to_mesh(name, changed):
        return run(name, {**changed,
                          "Probes/Probes": "x: displacement x, Nowhere"})[1]

    def expect(what, changed, word):
        said = run_up_to_mesh("points", changed)
        check(what, word in said and "no point 'Nowhere'" in said, said[-600:])
        return elements("output/points/bare.msh")

    coarse = expect("the same entries keep the mesh", entries, kept)[1]
    fine = expect("another size makes it anew",
                  {**entries, "Mesh/Size": "0.9"}, made)[1]
    check("with smaller cells", len(fine) > 1.3 * len(coarse),
          (len(fine), len(coarse)))
    coarsest = expect("also one beyond a tenth of the scene", {
        **entries, "Mesh/Size": "4"}, made)[1]
    check("with larger cells", 1.3 * len(coarsest) < len(coarse),
          (len(coarsest), len(coarse)))
    finest = expect("as a size of its own does", {
        **entries, "Mesh/Size": "0.9", "Mesh/Sizes": "Sole: 0.25"}, made)[1]
    on_sole = [sum(abs(z - 2) < 1e-9 and 1 <= x <= 3 and 1 <= y <= 3
                   for x, y, z in nodes.values()) for nodes in (fine, finest)]
    check("which is that of the sole", on_sole[1] > 1.5 * on_sole[0], on_sole)
    expect("another load keeps it", {
        **entries, "Mesh/Size": "0.9", "Mesh/Sizes": "Sole: 0.25",
        "Boundary conditions/Pressure": "Head: 1"}, kept)
    write_step(BLOCKS.replace("2, 2, 1}", "2, 2, 1.5}"), "bare.step")
    expect("another part makes it anew", {
        **entries, "Mesh/Points": "Top: 1, 1, 3.5",
        "Mesh/Boundaries": POINTS.replace("2, 2, 3", "2, 2, 3.5")}, made)
    write_step(BLOCKS, "bare.step")

    # A description that reads another file depends on that, too.
    pathlib.Path("reads.geo").write_text(
        'Merge "bare.step";\nMesh.MeshSizeMax = 1;\n'
        'Physical Volume("Body 1") = {1};\nPhysical Volume("Body 2") = {2};\n')
    reads = {**entries, "Mesh/File": "reads.geo", "Mesh/Size": "0",
             "Mesh/Order": "1"}
    for word in (made, kept):
        said = run_up_to_mesh("reads", reads)
        check(f"a .geo that reads a part: {word}", word in said, said[-600:])
    with open("bare.step", "a", encoding="utf-8") as file:
        file.write("\n")
    said = run_up_to_mesh("reads", reads)
    check("and its mesh is made anew if that has changed", made in said,
          said[-600:])


def refusals(entries):
    def refuse(what, changed, *words):
        shutil.rmtree("output/refused", ignore_errors=True)
        status, said, _ = run("refused", {**entries, **changed})
        check(f"refused: {what}", status == 2 and "remedy: " in said and
              all(word in said for word in words), said[-700:])

    refuse("a point beside all boundaries",
           {"Mesh/Boundaries": POINTS.replace("2, 2, 3;", "2, 2, 3.2;")},
           "lies on no boundary", "'Body 2', is 0.2 mm away, at (2, 2, 3)")
    refuse("a point on two bodies",
           {"Mesh/Boundaries": POINTS.replace(" in Body 2", "")},
           "lies on 2 boundaries", "Sole in BODY")
    refuse("a point in an unknown body",
           {"Mesh/Boundaries": POINTS.replace("Sole in Body 2", "Sole in B")},
           "no body 'B'", "'Body 1', 'Body 2'")
    refuse("half a point", {"Mesh/Boundaries": POINTS + "; Half: 1, 2"},
           "no points", "x, y, z")
    refuse("a name that the file has", {
        "Mesh/File": "labelled.step",
        "Mesh/Boundaries": "Base: 1, 1, 0"}, "'Base' of its own")
    refuse("an unknown label", {"Contact/Slave": "Shoe"},
           "no boundary 'Shoe'", "'Ground', 'Head', 'Sides x'")
    refuse("the size of nothing", {"Mesh/Sizes": "Shoe: 1"}, "'Shoe'", "'Sole'")
    refuse("a negative size", {"Mesh/Sizes": "Sole: -1"}, "has to be positive")
    refuse("more cells than there is memory for", {"Mesh/Size": "1e-3"},
           "there would be")
    refuse("no file", {"Mesh/File": "none.step"}, "none.step")
    pathlib.Path("broken.step").write_text("ISO-10303-21;\nHEADER;\n")
    refuse("a broken file", {"Mesh/File": "broken.step"},
           "gmsh cannot read the file")
    pathlib.Path("broken.geo").write_text("Box(1) = {0;\n")
    refuse("a broken description", {"Mesh/File": "broken.geo"},
           "line 1", "broken.geo")
    crossed = BLOCKS.replace("{1, 1, 2,", "{1, 1, 1.5,") + """
Delete { Volume{1, 2}; }
Surface Loop(9) = {1 : 12};
Volume(9) = {9};
"""
    write_step(crossed, "crossed.step")
    refuse("a part that crosses itself",
           {"Mesh/File": "crossed.step", "Mesh/Boundaries": "Base: 1, 1, 0"},
           "gmsh cannot mesh the bodies", "mend the geometry")
    status, said, _ = run("idle", {**entries, "Mesh/File":
                                   "output/points/bare.msh"})
    check("entries of CAD files with a mesh have a note",
          "Mesh/Size" in said and "the file is a mesh" in said, said[-600:])


blocks = step_files()
changes(blocks)
repeated_labels()
refusals(blocks)
plane_parts()
geo_files(pathlib.Path(sys.argv[2]).resolve())
sys.exit(bool(failures))
