# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of peers.py, from its results."""

import subprocess

PROBES = "DY(B)", "SIYY(B)"
TARGETS = 1., .1, .01  # %
OURS = "contact"


def table(head, rows):
    """Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def reference_of(results, friction):
    return next(r for r in results["references"] if r["friction"] == friction)


def witness_of(results, friction):
    """The finest converged run of GetFEM with 8 nodes, or None."""
    runs = [row for row in results["rows"]
            if row["program"] == "GetFEM" and row["element"] == "8 nodes" and
            row["friction"] == friction and row["ok"]]
    return runs[-1] if runs else None


def error(results, row, probe):
    """Relative to the reference [%]."""
    value = reference_of(results, row["friction"])["runs"][0][probe]
    return 100 * (row[probe] / value - 1)


def reference_table(results):
    """Values of the reference, and how far others are from them."""
    rows = []
    for reference in results["references"]:
        best, coarser = reference["runs"]
        witness = witness_of(results, reference["friction"])
        for probe in PROBES:
            cells = [f"{reference['friction']:g}", probe, f"{best[probe]:.7g}",
                     str(best["unknowns"]),
                     f"{error(results, coarser, probe):+.4f} % "
                     f"({coarser['unknowns']} unknowns)"]
            cells.append(f"{error(results, witness, probe):+.4f} % "
                         f"({witness['unknowns']} unknowns, "
                         f"level {witness['label']})" if witness else "-")
            rows.append(cells)
    return table(["mu", "probe", "reference", "unknowns",
                  "the same, 4 levels less", "GetFEM, 8 nodes"], rows)


def run_table(results):
    rows = []
    for row in results["rows"]:
        cells = [row["program"], row["formulation"], row["element"],
                 f"{row['friction']:g}", row["label"]]
        unknowns = row.get("unknowns")
        cells.append(str(unknowns) if unknowns else "-")
        if row["ok"]:
            cells += [f"{error(results, row, 'DY(B)'):+.4f}",
                      f"{error(results, row, 'SIYY(B)'):+.2f}"]
        elif row.get("skipped"):
            cells += [row["reason"], "-"]
        else:
            cells += ["not converged: " + row["reason"].replace("|", "/"), "-"]
        if row.get("skipped"):
            cells += ["-"] * 6
        else:
            cells += [f"{row['wall']:.2f}", f"{row['cpu']:.2f}",
                      f"{row['memory']:.0f}", str(row.get("newton", "-")),
                      str(row.get("increments", "-")),
                      f"{abs(row['force_error']):.0e}" if row["ok"] else "-"]
        rows.append(cells)
    return table(["program", "formulation", "element", "mu", "level",
                  "unknowns", "error of DY(B) [%]", "error of SIYY(B) [%]",
                  "wall [s]", "CPU [s]", "MB", "Newton steps", "increments",
                  "error of the force"], rows)


def sequences(results, program, friction):
    """The runs of a program by formulation and element, without those that
    had no time."""
    found = {}
    for row in results["rows"]:
        if row["program"] == program and row["friction"] == friction:
            key = row["formulation"], row["element"]
            found.setdefault(key, [])
            if not row.get("skipped") and "no end" not in row["reason"]:
                found[key].append(row)
    return found.values()


def cheapest(results, program, friction, target):
    """The run with the least CPU time whose error stays below the target, from
    there on in its sequence; and whether a finer one confirms it."""
    picks = []
    for runs in sequences(results, program, friction):
        for i, row in enumerate(runs):
            if all(later["ok"] and
                   abs(error(results, later, "DY(B)")) <= target
                   for later in runs[i:]):
                picks.append((row, i + 1 < len(runs)))
    return min(picks, key=lambda pick: pick[0]["cpu"], default=(None, False))


def price_table(results):
    """What an error of DY(B) costs with each program."""
    programs = list(dict.fromkeys(row["program"] for row in results["rows"]))
    rows = []
    for reference in results["references"]:
        friction = reference["friction"]
        known = uncertainty(results, friction, "DY(B)")
        for target in TARGETS:
            ours, _ = cheapest(results, OURS, friction, target)
            for program in programs:
                row, confirmed = cheapest(results, program, friction, target)
                cells = [f"{friction:g}",
                         f"{target:g} %" + " ?" * (target < 2 * known),
                         program]
                if row:
                    ratio = f"{row['cpu'] / ours['cpu']:.1f}" if ours else "-"
                    cells += [f"{row['formulation']}, {row['element']}, "
                              f"{row['label']}" + "*" * (not confirmed),
                              str(row["unknowns"]),
                              f"{error(results, row, 'DY(B)'):+.4f}",
                              f"{row['wall']:.2f}", f"{row['cpu']:.2f}", ratio]
                else:
                    cells += ["none of those that were run"] + ["-"] * 5
                rows.append(cells)
    return table(["mu", "error below", "program", "the cheapest run",
                  "unknowns", "error of DY(B) [%]", "wall [s]", "CPU [s]",
                  f"CPU by that of {OURS}"], rows)


def uncertainty(results, friction, probe):
    """Of the reference: the largest difference of another [%]."""
    others = (reference_of(results, friction)["runs"][1],
              witness_of(results, friction))
    return max(abs(error(results, other, probe)) for other in others if other)


def uncertainties(results, probe):
    """All of them, as text."""
    return ", ".join(
        f"{uncertainty(results, r['friction'], probe):.3f} % "
        f"(mu {r['friction']:g})" for r in results["references"])


def versions():
    """Of the packages of the peers."""
    said = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${Version}, ",
                           "python3-getfem", "calculix-ccx"],
                          capture_output=True, text=True, check=False)
    return said.stdout.rstrip(", ")


def report(results):
    before, after = results["load"]
    return f"""`./run study --peers`; {versions()}; load average before \
and after: {before:.2f}, {after:.2f}

## What an error costs

The run with the least CPU time whose error of DY(B) is below the target, there
and on all finer meshes of its sequence; with * no finer one was run. Seconds
include the start of the program. The reference does not decide targets with a
question mark, which are less than twice its uncertainty, for DY(B):
{uncertainties(results, 'DY(B)')}.

{price_table(results)}

## Reference

The contact program on meshes that it refines adaptively (mortar, 9 nodes). The
larger of the two differences is the uncertainty, for SIYY(B):
{uncertainties(results, 'SIYY(B)')}.

{reference_table(results)}

## All runs

{results['increments']} load increments each; those of CalculiX come after one
that presses the cylinder into the block, and its own increments are those of
ccx, from 0.1 on. A run ends after {results['seconds']} s of CPU. Errors smaller
than the uncertainty of the reference mean only that.

{run_table(results)}
"""
