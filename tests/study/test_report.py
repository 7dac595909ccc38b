# SPDX-License-Identifier: LGPL-2.1-or-later
"""Self-checks of the study that need no program: python3 -m unittest."""

import re
import tempfile
import unittest
from pathlib import Path

import analysis
import matrix
import plots
import report
import tables


def sequence(errors, problem="ssnp154"):
    """Rows of one method with these errors of a reference of 1."""
    columns = {"problem": problem, "element": "q9", "rule": "mortar",
               "refinement": "nested", "system": "", "solver": "",
               "friction": "", "role": "", "knob": "", "ok": 1}
    rows = [{**columns, "level": i, "dy": 1 + e, "seconds": float(i + 1)}
            for i, e in enumerate(errors)]
    for role, value in (("reference", 1.0), ("check", 1 + 1e-6)):
        rows.append({**columns, "role": role, "level": 9, "dy": value, "seconds": 9})
    return rows


class Analysis(unittest.TestCase):
    def test_orders(self):
        self.assertEqual(analysis.orders([8, 4, 1]), [1, 2])
        runs = [{"level": i, "e": 3 * 4.0 ** -i} for i in range(5)]
        self.assertAlmostEqual(analysis.fitted_order(runs, "e"), 2)
        self.assertIsNone(analysis.fitted_order(runs[:2], "e"))

    def test_sign_change_is_no_accuracy(self):
        rows = sequence([0.1, 1e-5, -0.01, -1e-3, -1e-4])
        pick = analysis.decision(rows, "ssnp154", "dy", 2e-3)
        self.assertEqual(pick["level"], 3)

    def test_finest_mesh_needs_a_witness(self):
        rows = sequence([0.1, 0.01, 1e-5])
        self.assertIsNone(analysis.decision(rows, "ssnp154", "dy", 1e-3))

    def test_nothing_below_the_uncertainty(self):
        rows = sequence([1e-9, 1e-9])
        runs = next(iter(analysis.sequences(rows, "ssnp154").values()))
        for e in analysis.errors(rows, runs, "dy"):
            self.assertAlmostEqual(e, 2e-6)

    def test_approach(self):
        self.assertAlmostEqual(tables.line_contact.ssnp154(350).approach,
                               5.0923e-3, 6)


class Pictures(unittest.TestCase):
    def test_names_do_not_overlap(self):
        placed = plots.spread([0.5, 0.5, 0.51, 0.02, 0.99, 1.0], 0.05)
        heights = sorted(placed)
        for low, high in zip(heights, heights[1:]):
            self.assertGreaterEqual(high - low, 0.05 - 1e-12)
        self.assertGreaterEqual(heights[0], 0)
        self.assertLessEqual(heights[-1], 1 + 1e-12)
        self.assertEqual(placed[3], 0.02)


class Matrix(unittest.TestCase):
    def test_names_are_unique(self):
        for quick in (False, True):
            names = [run.id for run in matrix.all_runs(quick)]
            self.assertEqual(len(names), len(set(names)))

    def test_adaptive_condensed_only(self):
        for run in matrix.all_runs():
            if run.rule == "Gauss" or run.system == "saddle point":
                self.assertEqual(run.refinement, "uniform", run.id)


class Readme(unittest.TestCase):
    def test_replace(self):
        begin, end = "<!-- study:orders:begin -->", "<!-- study:orders:end -->"
        text = f"a\n{begin}\nold\n{end}\nb\n"
        new = report.replace_tables(text, {"orders": "new"}, Path("x"))
        self.assertEqual(new, f"a\n{begin}\nnew\n{end}\nb\n")
        with self.assertRaises(SystemExit):
            report.replace_tables("nothing", {}, Path("x"))

    def test_pages(self):
        with tempfile.TemporaryDirectory() as directory:
            top = Path(directory)
            with self.assertRaises(SystemExit):
                report.pages(top)
            for folder, text in (("tests", "<!-- study:orders:begin -->"),
                                 ("build", "<!-- study:orders:begin -->"),
                                 ("mesh", "no table")):
                (top / folder).mkdir()
                (top / folder / "README.md").write_text(text)
            self.assertEqual(report.pages(top), [top / "tests/README.md"])

    def test_picture_of_its_table(self):
        """The picture of fine meshes is of the rows beside it, drawn anew by the
        same gnuplot to the same bytes."""
        results = Path(__file__).parent / "results"
        with tempfile.TemporaryDirectory() as directory:
            plots.draw(report.scaling_figures(results), Path(directory))
            drawn = Path(directory, "scaling.svg").read_text()
        kept = (results / "scaling.svg").read_text()
        author = re.compile("Produced by (.*) <")
        if author.search(drawn)[1] != author.search(kept)[1]:
            self.skipTest(f"drawn by {author.search(kept)[1]}")
        self.assertEqual(drawn, kept)

    def test_select(self):
        text = "a command\n\n| x | y |\n|---|---|\n| 1 | b |\n| 2 | c |\n\nend"
        self.assertEqual(report.select_rows(text, r"\| c"),
                         "a command\n\n| x | y |\n|---|---|\n| 2 | c |")
        self.assertEqual(report.select_rows(text, "d"), "a command")
        text = "a command\n\n```\nx | y\n--+--\n1 | a\n2 | c\n```"
        self.assertEqual(report.select_rows(text, r"\| c"),
                         "a command\n\n```\nx | y\n--+--\n2 | c\n```")

    def test_csv_round_trip(self):
        with tempfile.TemporaryDirectory() as directory:
            path = Path(directory) / "study.csv"
            analysis.write_csv(sequence([0.1, 0.01]), path)
            rows = analysis.read_csv(path)
        self.assertAlmostEqual(rows[0]["deviation_dy"], 0.1)
        self.assertEqual(rows[0]["rule"], "mortar")


if __name__ == "__main__":
    unittest.main()
