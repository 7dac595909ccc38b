# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a case as tables of pandas.

    from contact_results import Results

    case = Results("output/ssnp154_g")
    case.probes                     values, units, estimated errors
    case.history["DY(B)"]           an increment a row, over the load factor
    case.profile("slave")           pressure, shear, gap over the surface
    case.points("bodies")           displacement and stresses at the nodes
    case.grid("contact", time=0.5)  the same as a grid of VTK
    case.summary, case.parameters   all the rest

Units are in `attrs["units"]` of each table. Grids need VTK: Debian's
python3-vtk9, or ParaView's.
"""

from __future__ import annotations

import functools
import json
import re
import xml.etree.ElementTree as xml
from pathlib import Path

import pandas

# The units at the ends of the columns of profile.csv and nodes.csv.
UNITS = {"_N_per_mm": "N/mm", "_MPa": "MPa", "_mm": "mm", "_N": "N",
         "_0_open_1_slip_2_stick": "0 open, 1 slip, 2 stick"}

# Of vectors, and of symmetric tensors, which have all nine: where each is.
COMPONENTS = {3: {"x": 0, "y": 1, "z": 2},
              9: {"xx": 0, "yy": 4, "zz": 8, "xy": 1, "yz": 5, "xz": 2}}


class Results:
    """A folder of results, each file of which is read when it is asked for."""

    def __init__(self, folder):
        self.folder = Path(folder)
        if not self.folder.is_dir():
            raise FileNotFoundError(f"no folder {folder}: run the case first")
        if not (self.folder / "summary.json").exists():
            raise FileNotFoundError(
                f"{folder} has no summary.json: it has no results of the program, "
                "or the run is not at its end")

    @property
    def name(self) -> str:
        return self.folder.resolve().name

    @functools.cached_property
    def summary(self) -> dict:
        """All of summary.json."""
        try:
            return json.loads(self._file("summary.json").read_text("utf-8"))
        except ValueError as error:
            raise ValueError(f"{self.folder}/summary.json is damaged: {error}")

    @functools.cached_property
    def parameters(self) -> dict[str, str]:
        """The text of each entry by its name, "Contact/Friction coefficient"."""
        entries, sections = {}, []
        text = self._file("parameters.prm").read_text("utf-8", "replace")
        for line in text.splitlines():
            word, _, more = line.strip().partition(" ")
            if word == "subsection":
                sections.append(more)
            elif word == "end":
                sections.pop()
            elif word == "set":
                name, _, value = more.partition("=")
                entries["/".join([*sections, name.strip()])] = value.strip()
        return entries

    @functools.cached_property
    def probes(self) -> pandas.DataFrame:
        """The probes at the end by their names: value, unit, errors."""
        columns = ["name", "value", "unit", "estimated_error", "reference",
                   "relative_deviation", "tolerance"]
        rows = self.summary["probes"]
        table = pandas.DataFrame(rows, columns=[*columns, *(
            c for c in (rows[0] if rows else ()) if c not in columns)])
        return table.set_index("name")

    @functools.cached_property
    def history(self) -> pandas.DataFrame:
        """history.csv, a row an increment, over the load factor t."""
        return self._with_units(
            self._csv("history.csv"),
            lambda column: re.fullmatch(r"(.*) \[(.*)\]", column)).set_index("t")

    def profile(self, surface: str | None = None) -> pandas.DataFrame:
        """profile.csv, or the rows of a surface of it: "slave", "master", and of
        a section `Contact NAME` "slave NAME"."""
        rows = self._of_columns("profile.csv", "Output/Profile")
        if surface is None:
            return rows
        if surface not in set(rows["surface"]):
            raise KeyError(f"no surface '{surface}' in {self.folder}/profile.csv: "
                           + ", ".join(rows["surface"].unique()))
        return rows[rows["surface"] == surface].reset_index(drop=True)

    @functools.cached_property
    def nodes(self) -> pandas.DataFrame:
        """nodes.csv: displacement and force of contact of each node."""
        return self._of_columns("nodes.csv", "Output/Nodes")

    def times(self, series: str = "bodies") -> list[float]:
        """The load factors of a series of VTU, "bodies" or "contact"."""
        return [time for time, _ in self._increments(series)]

    def grid(self, series: str = "bodies", time: float = float("inf")):
        """The vtkUnstructuredGrid of a series at the load factor that is nearest
        to time, undeformed: all bodies, or contact pairs, in one grid."""
        from vtkmodules.vtkFiltersCore import vtkAppendFilter
        together = vtkAppendFilter()
        for _, file in self._parts(series, time):
            together.AddInputData(self._read(series, file))
        together.Update()
        return together.GetOutput()

    def points(self, series: str = "bodies",
               time: float = float("inf")) -> pandas.DataFrame:
        """The fields of a grid at its points, whose places are x, y, z: undeformed,
        with the name of the body, or of the contact pair. A node of hanging faces
        may be there twice, and of several processes once for each."""
        return pandas.concat(
            [self._table(self._read(series, file)).assign(
                **{"body" if series == "bodies" else "pair": name})
             for name, file in self._parts(series, time)], ignore_index=True)

    @staticmethod
    def _table(grid) -> pandas.DataFrame:
        from vtkmodules.util.numpy_support import vtk_to_numpy
        columns = dict(zip("xyz", vtk_to_numpy(grid.GetPoints().GetData()).T))
        data = grid.GetPointData()
        for i in range(data.GetNumberOfArrays()):
            values, name = vtk_to_numpy(data.GetArray(i)), data.GetArrayName(i)
            columns |= ({name: values} if values.ndim == 1 else
                        {f"{name}_{d}": values[:, c] for d, c in
                         COMPONENTS[values.shape[1]].items()})
        return pandas.DataFrame(columns)

    def _read(self, series: str, file: Path):
        from vtkmodules.vtkIOXML import (vtkXMLPUnstructuredGridReader,
                                         vtkXMLUnstructuredGridReader)
        for piece in [file, *self._pieces(file)]:
            if not piece.exists():
                raise FileNotFoundError(f"{piece} is missing: {series}.pvd names it")
        reader = (vtkXMLPUnstructuredGridReader() if file.suffix == ".pvtu"
                  else vtkXMLUnstructuredGridReader())
        reader.SetFileName(str(file))
        reader.Update()
        if reader.GetOutput().GetNumberOfPoints() == 0:
            raise ValueError(f"{file} has no points: it is damaged")
        return reader.GetOutput()

    def _parts(self, series: str, time: float) -> list[tuple[str, Path]]:
        increments = self._increments(series)
        # The last one of those as near: the finest level.
        return (increments[-1] if time == float("inf") else
                min(reversed(increments), key=lambda i: abs(i[0] - time)))[1]

    def _file(self, name: str, entry: str = "") -> Path:
        path = self.folder / name
        if not path.exists():
            raise FileNotFoundError(
                f"{self.folder} has no {name}"
                + (f": the case asks for it by {entry} = true; there is none without "
                   "contact, or before an increment has converged" if entry else ""))
        return path

    def _increments(self, series: str) -> list[tuple[float,
                                                     list[tuple[str, Path]]]]:
        """Load factor, and names and files of the parts."""
        root = xml.parse(self._file(f"{series}.pvd", "Output/VTU")).getroot()
        found: list[tuple[float, list[tuple[str, Path]]]] = []
        for s in root.iter("DataSet"):
            if s.get("part") == "0":
                found.append((float(s.get("timestep")), []))
            found[-1][1].append((s.get("name"), self.folder / s.get("file")))
        return found

    @staticmethod
    def _pieces(file: Path) -> list[Path]:
        if file.suffix != ".pvtu" or not file.exists():
            return []
        return [file.parent / piece.get("Source")
                for piece in xml.parse(file).getroot().iter("Piece")]

    def _csv(self, file: str, entry: str = "") -> pandas.DataFrame:
        path = self._file(file, entry)
        try:
            return pandas.read_csv(path, encoding_errors="replace",
                                   float_precision="round_trip")
        except pandas.errors.EmptyDataError:
            raise ValueError(f"{path} is empty: no increment has converged")

    def _of_columns(self, file: str, entry: str) -> pandas.DataFrame:
        endings = "|".join(UNITS)
        return self._with_units(
            self._csv(file, entry),
            lambda column: re.fullmatch(f"(.*?)({endings})", column))

    @staticmethod
    def _with_units(table: pandas.DataFrame, split) -> pandas.DataFrame:
        """The table with units in its attributes instead of its names."""
        found = {column: split(column) for column in table.columns}
        table = table.rename(columns={c: m[1] for c, m in found.items() if m})
        table.attrs["units"] = {m[1]: UNITS.get(m[2], m[2])
                                for m in found.values() if m}
        return table
