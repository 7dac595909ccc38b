"""Runs the program on a case of its own directory and says how it ended."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import concurrent.futures
import json
import os
import pathlib
import re
import resource
import subprocess
import time

# The memory limit of a small case: a wrong count must not take that of all
# other processes.
MEMORY = 3 << 30
OUTCOMES = ("converged", "other values", "violated", "refused",
            "not converged", "crashed", "hung")


class Result:
    def __init__(self, outcome, status, message, output, seconds):
        self.outcome = outcome
        self.status = status
        self.message = message
        self.output = output
        self.seconds = seconds


def environment():
    env = dict(os.environ)
    env["OPENBLAS_NUM_THREADS"] = "1"
    # Libraries keep what they allocate at their start until the end. A report
    # has an exit status which the program itself has not.
    env.setdefault("ASAN_OPTIONS", "detect_leaks=0:exitcode=99")
    env.setdefault("UBSAN_OPTIONS", "print_stacktrace=1:exitcode=99")
    return env


def is_sanitized(binary):
    with open(binary, "rb") as file:
        return b"__asan_init" in file.read()


def run(binary, directory, file, limit, sanitized=False, options=()):
    """Run the program in `directory`; `limit` is in seconds."""

    def limits():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        # The address sanitizer reserves terabytes of addresses.
        if not sanitized:
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    start = time.monotonic()
    try:
        done = subprocess.run(
            [str(pathlib.Path(binary).resolve()), file, *options],
            cwd=directory, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            timeout=limit, preexec_fn=limits, env=environment())
        status, output = done.returncode, done.stdout
    except subprocess.TimeoutExpired as expired:
        status, output = None, expired.stdout or b""
    text = output.decode("utf-8", "replace")
    outcome = {0: "converged",
               1: "violated" if "violated:" in text else "other values", 2: "refused",
               3: "not converged", None: "hung"}.get(status, "crashed")
    if "Sanitizer" in text or "runtime error:" in text:
        outcome = "crashed"
    return Result(outcome, status, message(outcome, text, directory, file),
                  text, time.monotonic() - start)


def message(outcome, text, directory, file):
    """The sentence that tells most."""
    if outcome == "not converged":
        summary = read_summary(directory, file)
        return summary.get("message", "") if summary else ""
    if outcome == "refused":
        return text.strip()
    if outcome == "violated":
        return next((line.strip() for line in text.splitlines()
                     if "violated:" in line), "")
    if outcome == "crashed":
        for line in text.splitlines():
            if re.search("Sanitizer|runtime error:|what\\(\\)|Assertion", line):
                return line.strip()
        return text.strip()[-600:]
    return ""


def read_summary(directory, file):
    path = pathlib.Path(directory, "output", pathlib.Path(file).stem,
                        "summary.json")
    try:
        return json.loads(path.read_text())
    except (OSError, ValueError):
        return None


def kind(message):
    """A message without its numbers: messages of one kind are equal."""
    lines = message.strip().splitlines()
    text = lines[0] if lines else ""
    text = re.sub(r"^increment \d+: ", "", text)
    if len(lines) > 1 and "still changes" in message:
        text += ", points still change"
    text = re.sub(r"'[^']*'", "'...'", text)
    text = re.sub(r"-?(\d+\.?\d*(e[-+]?\d+)?|nan|inf)\b", "N", text)
    return text[:110]


def in_parallel(function, items, processes):
    """The results in the order of the items, whoever is done first."""
    with concurrent.futures.ThreadPoolExecutor(processes) as pool:
        return list(pool.map(function, items))


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |",
             "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |"
              for row in rows]
    return "\n".join(lines)
