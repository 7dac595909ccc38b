#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Good parameter and mesh files, damaged in every way a file can be.

    damaged.py [--number N] [--first SEED] [--only SEED,...] [--output DIR]
               [--processes P] [--limit SECONDS] [--json] CONTACT

The number of a case is its seed. What is damaged is random, but always the same
for a seed. The program has to answer with exit status 2 and one message that
says what is wrong, in which file or entry, and the remedy; or the file still means
something, then it may run: exit status 0, 1 or 3, and no result of status 0
that is no number. With --json the parameter files are JSON, and all damage is in
them. Writes damaged.csv and damaged.md. Exit status: 0, 1 if one crashed, hung,
or was answered badly.
"""
import argparse
import collections
import csv
import json
import math
import pathlib
import random
import re
import sys

import runner
import scenes
import verify

# Good scenes, small, of all rules and both formats.
GOOD = (9, 16, 17, 18, 20, 31, 42, 50, 54)
NUMBERS = ("0", "-1", "1e308", "-1e308", "1e999", "1e-320", "nan", "NaN", "inf",
           "-inf", "", "99999999999", "-2147483648", "2147483647", "4294967296",
           "9223372036854775808", "1,5", "0x10", "1e", "--1", "1.5.2", "3 4",
           "\u00b5", "1e-30", "1e30")
WORDS = ("subsection", "end", "set", "include", "=", ":", ";", ",", "#", "\\",
         '"', "'", "$", "$End", "$Nodes", "$Elements", "$PhysicalNames",
         "$EndMeshFormat", "*", "|", "%s%n", "{}", "()", "<>", "\t")
# Entries that ask for work: a huge value is no error.
EXPENSIVE = re.compile(
    rb"(Increments|Refinements|Levels|Max \w+ iterations|Gauss points)"
    rb"\W*[=:]\W*\d\d|tolerance\W*[=:]", re.IGNORECASE)


def numbers_of(data):
    return list(re.finditer(rb"(?<![\w.])[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?", data))


class Damage:
    """Ways to damage a file. Each takes and gives bytes."""

    def __init__(self, rng):
        self.rng = rng

    def flip(self, data):
        data = bytearray(data)
        for _ in range(self.rng.choice([1, 1, 3, 20])):
            data[self.rng.randrange(len(data))] ^= 1 << self.rng.randrange(8)
        return bytes(data)

    def delete(self, data):
        at = self.rng.randrange(len(data))
        return data[:at] + data[at + self.rng.choice([1, 2, 10, 100]):]

    def insert(self, data):
        at = self.rng.randrange(len(data) + 1)
        new = bytes(self.rng.randrange(256)
                    for _ in range(self.rng.choice([1, 1, 4, 50])))
        return data[:at] + new + data[at:]

    def cut(self, data):
        return data[:self.rng.randrange(len(data))]

    def lines(self, data, change):
        lines = data.split(b"\n")
        at = self.rng.randrange(len(lines))
        change(lines, at)
        return b"\n".join(lines)

    def duplicate_line(self, data):
        return self.lines(data, lambda l, i: l.insert(i, l[i]))

    def drop_line(self, data):
        return self.lines(data, lambda l, i: l.pop(i))

    def swap_lines(self, data):
        def swap(lines, i):
            j = self.rng.randrange(len(lines))
            lines[i], lines[j] = lines[j], lines[i]
        return self.lines(data, swap)

    def long_line(self, data):
        def grow(lines, i):
            lines[i] += self.rng.choice([b"x", b" ", b"1 ", b"\\", b"9"]) * \
                self.rng.choice([1000, 300000])
        return self.lines(data, grow)

    def blank_line(self, data):
        return self.lines(data, lambda l, i: l.__setitem__(i, b""))

    def number(self, data):
        for _ in range(self.rng.choice([1, 1, 2])):
            found = numbers_of(data)
            if not found:
                return data
            match = self.rng.choice(found)
            new = self.rng.choice(NUMBERS).encode()
            data = data[:match.start()] + new + data[match.end():]
        return data

    def small_change(self, data):
        """A count, a tag or a type next to the right one."""
        found = [m for m in numbers_of(data) if m.group().isdigit()]
        if not found:
            return data
        match = self.rng.choice(found)
        new = int(match.group()) + self.rng.choice([-2, -1, 1, 2, 10])
        return data[:match.start()] + b"%d" % new + data[match.end():]

    def header(self, data):
        """The lines after a keyword are counts, where most can go wrong."""
        marks = list(re.finditer(rb"\$[A-Z]\w+\n", data))
        if not marks:
            return self.number(data)
        at = self.rng.choice(marks).end()
        end = data.find(b"\n", at)
        line = data[at:end].split()
        if not line:
            return data
        i = self.rng.randrange(len(line))
        line[i] = self.rng.choice(NUMBERS).encode()
        return data[:at] + b" ".join(line) + data[end:]

    def word(self, data):
        found = list(re.finditer(rb"[A-Za-z$_]+", data))
        match = self.rng.choice(found) if found else None
        new = self.rng.choice(WORDS).encode()
        if match is None:
            return data + new
        return data[:match.start()] + new + data[match.end():]

    def value(self, data):
        """What stands behind a '=' or a ':'."""
        found = list(re.finditer(rb"[=:][^=:,;\n]*", data))
        if not found:
            return self.number(data)
        match = self.rng.choice(found)
        new = self.rng.choice(NUMBERS + WORDS).encode()
        return (data[:match.start() + 1] + b" " + new + data[match.end():])

    def encoding(self, data):
        kind = self.rng.randrange(4)
        if kind == 0:
            return data.replace(b"\n", b"\r\n")
        if kind == 1:
            return b"\xef\xbb\xbf" + data
        if kind == 2:
            return data.decode("latin-1").encode("utf-16")
        return data.replace(b"e", b"\xe9", 3)

    def ends(self, data):
        return self.rng.choice([b"", b"\n", b"\0" * 100, data + data,
                                data[::-1], data.rstrip(b"\n"),
                                data.replace(b"\n", b"\r")])

    def apply(self, data):
        ways = [self.flip, self.delete, self.insert, self.cut,
                self.duplicate_line, self.drop_line, self.swap_lines,
                self.long_line, self.blank_line, self.number, self.number,
                self.number, self.small_change, self.small_change, self.header,
                self.header, self.word, self.value, self.value, self.encoding,
                self.ends]
        way = self.rng.choice(ways)
        return way.__name__, way(data)


def in_json(scene):
    """The parameters of a scene, maps of numbers as objects."""
    sections = {}
    for path, value in scene.entries.items():
        section, entry = path.split("/", 1)
        pairs = [re.fullmatch(r" ?(\w+): (-?\d+\.?\d*)", pair)
                 for pair in str(value).split(",")]
        if all(pairs):
            value = {pair[1]: float(pair[2]) for pair in pairs}
        sections.setdefault(section, {})[entry] = value
    return json.dumps(sections, indent=1)


class Case:
    PREFIX = "damaged"
    GOOD = GOOD
    SCENE = scenes.Scene

    def __init__(self, seed, as_json):
        self.seed = seed
        self.name = "%s_%d" % (self.PREFIX, seed)
        rng = random.Random("%s %d" % (self.PREFIX, seed))
        self.scene = self.SCENE(rng.choice(self.GOOD))
        self.scene.name = self.name
        self.scene.set("Mesh/File", self.name + ".msh")
        self.files = {".msh": self.scene.mesh().encode()}
        if as_json:
            self.ending = self.part = ".json"
            self.files[self.ending] = in_json(self.scene).encode()
        else:
            self.ending = ".prm"
            self.files[self.ending] = self.scene.parameters().encode()
            self.part = rng.choice([".prm", ".msh", ".msh"])
        self.way = self.damage(rng)

    def damage(self, rng):
        """Damages a file; returns how."""
        way, self.files[self.part] = Damage(rng).apply(self.files[self.part])
        return way

    def faults(self, result):
        """What is wrong with the answer to just this damage."""
        return []

    def write(self, directory):
        directory.mkdir(parents=True, exist_ok=True)
        for ending, data in self.files.items():
            (directory / (self.name + ending)).write_bytes(data)


def names_file(case, text):
    return case.name in text


def names_entry(text):
    """Entry and mesh can be right each, but not go together."""
    return re.search("^where:  .*(entry '|Boundary conditions|/)", text,
                     re.MULTILINE) is not None


def faults(case, directory, result):
    """What is wrong with the answer."""
    if result.outcome == "hung":
        if EXPENSIVE.search(case.files[case.ending]) and case.part == case.ending:
            return []
        return ["no answer within the time limit"]
    if result.outcome == "crashed":
        return ["exit status %s: %s" % (result.status, result.message)]
    if result.outcome == "refused":
        text, found = result.output, []
        for word in ("error:  ", "where:  ", "remedy: "):
            if len(re.findall("^" + word, text, re.MULTILINE)) != 1:
                found.append("the message has not one '%s'" % word.strip())
        if not names_file(case, text) and not names_entry(text):
            found.append("the message names no file and no entry")
        if len(text) > 3000:
            found.append("the message has %d characters" % len(text))
        return found
    if result.outcome == "converged":
        summary = runner.read_summary(directory, case.name)
        if summary is None:
            return ["exit status 0 without a summary"]
        found = ["exit status 0, not a number: " + path
                 for path in verify.not_numbers(summary, [])]
        # JSON knows no such numbers: they are written as null.
        found += ["exit status 0, no value: probe " + probe["name"]
                  for probe in summary["probes"]
                  if not isinstance(probe["value"], (int, float))]
        try:
            rows = verify.rows_of(directory, case)
        except (OSError, ValueError):
            return found
        if any(not math.isfinite(v) for part in rows for r in part
               for v in r.values()):
            found.append("exit status 0, not a number in profile.csv")
        return found
    return []


def answer(kind, seed, binary, output, limit, sanitized, as_json):
    case = kind(seed, as_json)
    directory = output / case.name
    case.write(directory)
    result = runner.run(binary, directory, case.name + case.ending, limit,
                        sanitized, ["--quiet"])
    return (case, result,
            faults(case, directory, result) + case.faults(result))


def report(kind, answered, output):
    rows = []
    for part, name in ((".prm", "parameter file"), (".json", "parameter file"),
                       (".msh", "mesh file")):
        ways = collections.defaultdict(list)
        for case, result, found in answered:
            if case.part == part:
                ways[case.way].append((result, found))
        for way in sorted(ways):
            rows.append([name, way.replace("_", " "), len(ways[way])] +
                        [sum(1 for r, _ in ways[way] if r.outcome == o)
                         for o in runner.OUTCOMES] +
                        [sum(1 for _, f in ways[way] if f)])
    total = ["all", "", len(answered)]
    total += [sum(row[i] for row in rows) for i in range(3, 10)]
    text = ["# Damaged files\n",
            runner.table(["file", "damage", "files", *runner.OUTCOMES,
                          "answered badly"], rows + [total])]
    entries = [case.seed for case, result, _ in answered
               if result.outcome == "refused" and
               not names_file(case, result.output)]
    text.append("\n%d messages name an entry, but no file: %s" % (
        len(entries), " ".join(map(str, entries[:15]))))
    messages = collections.defaultdict(list)
    for case, result, found in answered:
        for fault in found:
            messages[runner.kind(fault)].append(case.seed)
    if messages:
        text += ["\n## Answered badly\n",
                 runner.table(["fault", "files", "seeds"],
                              [[k, len(s), " ".join(map(str, s[:15]))]
                               for k, s in sorted(messages.items(),
                                                  key=lambda k: -len(k[1]))])]
    text = "\n".join(text) + "\n"
    (output / (kind.PREFIX + ".md")).write_text(text)
    with open(output / (kind.PREFIX + ".csv"), "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["seed", "file", "damage", "outcome", "status",
                         "seconds", "faults", "message"])
        for case, result, found in answered:
            writer.writerow([case.seed, case.part, case.way, result.outcome,
                             result.status, "%.2f" % result.seconds,
                             "; ".join(found),
                             result.message.replace("\n", " | ")[:300]])
    return text


def run_damaged(kind, binary, seeds, output, processes=2, limit=20,
                as_json=False):
    sanitized = runner.is_sanitized(binary)
    output.mkdir(parents=True, exist_ok=True)
    answered = runner.in_parallel(
        lambda seed: answer(kind, seed, binary, output, limit, sanitized,
                            as_json),
        seeds, processes)
    return answered, report(kind, answered, output)


def failures(answered):
    return ["%s (%s of the %s file): %s" % (case.name, case.way,
                                           case.part[1:], fault)
            for case, _, found in answered for fault in found]


def main(kind, purpose):
    parser = argparse.ArgumentParser(description=purpose.split("\n")[0])
    parser.add_argument("contact")
    parser.add_argument("--number", type=int, default=500)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--only", help="seeds, separated by ','")
    parser.add_argument("--output", default="output/fuzz")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--limit", type=float, default=20)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    seeds = ([int(s) for s in options.only.split(",")] if options.only else
             range(options.first, options.first + options.number))
    answered, text = run_damaged(kind, options.contact, seeds,
                                 pathlib.Path(options.output),
                                 options.processes, options.limit,
                                 options.json)
    print(text)
    if options.only:
        for case, result, found in answered:
            print(case.name, case.part, case.way, result.outcome, *found)
            print(result.output[-2000:])
    bad = failures(answered)
    for line in bad:
        print("FAILED:", line[:600])
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(Case, __doc__))
