# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps of an Abaqus deck as histories over the load factor t: each step is
an equal part of 0 to 1, loads go on from one step to the next."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from .deck import Block, Row

MOST_INCREMENTS = 20  # of a step whose increments are Abaqus' own choice
JUMP = 1e-6  # of a step: far below an increment


@dataclass
class Step:
    period: float = 1.0
    n_increments: int = 1
    at_once: bool = False  # *STEP, AMPLITUDE=STEP
    start: float = 0.0     # total time

    def read_static(self, block: Block) -> None:
        row = block.rows[0] if block.rows else Row(block.where, [])
        self.period = row.number(1, 1.0) or 1.0
        first = row.number(0, self.period) or self.period
        longest = row.number(3, self.period) or self.period
        if min(self.period, first, longest) < 0:
            row.fault("times are negative", "write times above zero")
        n = math.ceil(self.period / first * (1 - 1e-9))
        if "DIRECT" not in block.options:
            n = min(n, max(MOST_INCREMENTS,
                           math.ceil(self.period / longest * (1 - 1e-9))))
        self.n_increments = n


@dataclass
class Amplitude:
    times: list[float]
    values: list[float]
    in_total_time: bool

    @classmethod
    def read(cls, block: Block) -> Amplitude:
        numbers = [row.number(i) for row in block.rows
                   for i in range(len(row.fields))]
        if len(numbers) < 2 or len(numbers) % 2 or \
                numbers[::2] != sorted(set(numbers[::2])):
            block.fault("an amplitude needs pairs of a time and a value, with "
                        "growing times", "write time, value, time, value, ...")
        return cls(numbers[::2], numbers[1::2],
                   block.has("TIME", "TOTALTIME"))

    def at(self, time: float) -> float:
        ends = list(zip(self.times, self.values))
        if time <= self.times[0] or len(ends) == 1:
            return self.values[0]
        for (a, x), (b, y) in zip(ends, ends[1:]):
            if time <= b:
                return x + (y - x) * (time - a) / (b - a)
        return self.values[-1]


@dataclass
class Load:
    """A value over time, linear between its points (step + part of it, value)."""
    entry: str
    group: str
    row: Row
    kind: str  # the keyword, whose OP=NEW ends it
    step: int  # the last one that says what it is
    points: list[tuple[float, float]] = field(default_factory=lambda: [(0., 0.)])

    def go_on(self, n: int, step: Step, value: float,
              amplitude: Amplitude | None) -> None:
        """What it is in step number n: from its last value to this one, or this
        times the amplitude."""
        self.step = n
        self.points = [p for p in self.points if p[0] <= n]  # said once more
        last = self.points[-1][1]
        if self.points[-1][0] < n:
            self.points.append((n, last))
        if amplitude is None:
            if step.at_once:
                self.points.append((n + JUMP, value))
            self.points.append((n + 1, value))
            return
        shift = step.start if amplitude.in_total_time else 0.0
        times = sorted({0.0, step.period, *(
            t - shift for t in amplitude.times if 0 < t - shift < step.period)})
        self.points += [(n + max(JUMP, t / step.period),
                         value * amplitude.at(t + shift)) for t in times
                        if t > 0 or amplitude.at(shift) * value != last]

    def table(self, n_steps: int) -> tuple[tuple[float, float], ...]:
        """Its corners over t from 0 to 1."""
        points = dict((round(time / n_steps, 12), value)
                      for time, value in self.points)
        points.setdefault(1.0, self.points[-1][1])
        corners = sorted(points.items())
        kept = corners[:1]
        for here, after in zip(corners[1:], corners[2:]):
            t, value = kept[-1]
            expected = value + (after[1] - value) * (here[0] - t) / (after[0] - t)
            if abs(here[1] - expected) > 1e-12 * max(abs(v) for _, v in corners):
                kept.append(here)
        return tuple([*kept, corners[-1]])

    def peak(self) -> float:
        return max((value for _, value in self.points), key=abs)


def text(value: float) -> str:
    return f"{value + 0.0:.12g}"  # no -0


def as_table(corners) -> str:
    return "table(" + ", ".join(f"{text(t)} {text(v)}" for t, v in corners) + ")"


def as_formula(corners) -> str:
    """The same as a sum of ramps, for entries that know no tables."""
    terms, slope = [], 0.0
    if corners[0][1]:
        terms.append(text(corners[0][1]))
    for (a, x), (b, y) in zip(corners, corners[1:]):
        change, slope = (y - x) / (b - a) - slope, (y - x) / (b - a)
        if change:
            terms.append(f"{text(change)}*max(0, t - {text(a)})")
    return " + ".join(terms) or "0"


def share_histories(loads: list[Load], n_steps: int):
    """Of the loads of one entry the values, the history that most of them have,
    if it is not t, and those that have another one."""
    corners = {id(load): load.table(n_steps) for load in loads}
    shapes: dict[tuple, list[Load]] = {}
    still = [load for load in loads if load.peak() == 0]
    for load in loads:
        if load.peak():
            shape = tuple((t, round(value / load.peak(), 12))
                          for t, value in corners[id(load)])
            shapes.setdefault(shape, []).append(load)
    if not shapes:
        return still, None, []
    common = max(shapes, key=lambda shape: len(shapes[shape]))
    others = [load for shape in shapes if shape != common
              for load in shapes[shape]]
    history = None if common == ((0.0, 0.0), (1.0, 1.0)) else as_table(common)
    return still + shapes[common], history, others
