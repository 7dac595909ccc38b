# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests/plot.py and plot_page.py share: cases with all files, pictures and
page made of them, and pictures read."""

import os
import pathlib
import shutil
import subprocess
import sys

try:
    import numpy
    import pandas  # noqa: F401
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader
except ImportError as missing:
    print(f"skipped: {missing}; apt-get install python3-pandas python3-vtk9")
    sys.exit(0)
for needed in ("gnuplot", "xvfb-run"):
    if not shutil.which(needed):
        print(f"skipped: no {needed}")
        sys.exit(0)

ROOT = pathlib.Path(__file__).resolve().parents[1]
PLOT = ROOT / "tests/gallery/plot.py"
ALL_FILES = ("--set", "Output/VTU=true", "--set", "Output/Profile=true")


def compute(contact, case, *settings, processes=1, expected=0):
    """The folder of the results."""
    folder = pathlib.Path("output") / pathlib.Path(case).stem
    shutil.rmtree(folder, ignore_errors=True)
    call = [contact, case, "--quiet", *ALL_FILES, *settings]
    if processes > 1:
        call = ["mpirun", "-np", str(processes), *call]
    status = subprocess.run(call, stdout=subprocess.DEVNULL).returncode
    if status != expected:
        sys.exit(f"FAILED: {case} ends with exit status {status}")
    return folder


def plot(*arguments):
    """Exit status and words of the command."""
    done = subprocess.run(["xvfb-run", "-a", PLOT, *arguments], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env=os.environ | {"PYTHONDONTWRITEBYTECODE": "1"})
    return done.returncode, done.stdout


def pixels(picture):
    """Rows of red, green, blue."""
    reader = vtkPNGReader()
    reader.SetFileName(str(picture))
    reader.Update()
    image = reader.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(-1, values.shape[-1])[:, :3].astype(int)


def share(picture, colour):
    """Of the pixels that have exactly this colour."""
    wanted = [int(colour[i:i + 2], 16) for i in (0, 2, 4)]
    return (pixels(picture) == wanted).all(axis=1).mean()


def colours_in(picture):
    """How many colours at least a thousandth of the pixels have."""
    found = pixels(picture) @ (65536, 256, 1)
    _, counts = numpy.unique(found, return_counts=True)
    return int((counts > 1e-3 * len(found)).sum())
