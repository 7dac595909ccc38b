#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of ./run plot as a browser shows it, without a screen.

Proves of modeling G and of a run that does not converge that the page is no blank:
the table and the heading are there in black, the picture of the bodies in its own
colours, each in a good part of the window; that without its pictures these are gone;
and that the reason of the second run is there in red.

Usage: plot_page.py CONTACT PARAMETERS MESHES
"""

import pathlib
import re
import shutil
import subprocess
import sys

from plot_scenes import compute, pixels, plot, share

BROWSERS = ("chromium", "chromium-browser", "google-chrome")
# The ends of the colours of stresses; what is wrong.
BODIES, RED = ("440154", "fde725"), "c00020"
WINDOW = (1100, 2400)
PART = 0.002  # of the pixels

failures = []


def check(what, ok, detail=""):
    print(f"{'ok' if ok else 'FAILED'}: {what} {'' if ok else detail}")
    if not ok:
        failures.append(what)


def screenshot(browser, page):
    picture = page.with_suffix(".png").resolve()
    picture.unlink(missing_ok=True)
    profile = pathlib.Path("browser").resolve()
    said = subprocess.run(
        [browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
         f"--user-data-dir={profile}", "--window-size={},{}".format(*WINDOW),
         f"--screenshot={picture}", page.resolve().as_uri()],
        text=True, capture_output=True, timeout=300)
    if not picture.exists():
        sys.exit(f"FAILED: {browser} makes no picture: {said.stderr[-500:]}")
    return picture


def main():
    browser = next((b for b in BROWSERS if shutil.which(b)), None)
    if not browser:
        print("skipped: no browser; apt-get install chromium")
        return
    contact = pathlib.Path(sys.argv[1]).resolve()
    parameters = pathlib.Path(sys.argv[2]).resolve()
    page = compute(contact, parameters / "ssnp154_g.prm") / "report.html"
    check("the command", plot(page.parent)[0] == 0)
    shown = screenshot(browser, page)
    dark = (pixels(shown).max(axis=1) < 64).mean()
    check("there is text", dark > PART, dark)
    for colour in BODIES:
        check(f"there are bodies, {colour}", share(shown, colour) > PART,
              share(shown, colour))
    check("nothing is wrong", share(shown, RED) < PART / 10, share(shown, RED))
    bare = page.with_name("bare.html")
    bare.write_text(re.sub(r"<img [^>]*>", "", page.read_text()))
    shown = screenshot(browser, bare)
    check("without pictures they are gone",
          all(share(shown, colour) < PART / 10 for colour in BODIES))

    failed = compute(contact, parameters / "ssnp154_d.prm", "--set",
                     "Solution/Max Newton iterations=1", "--set",
                     "Solution/Max cut-backs=0", expected=3)
    status, said = plot(failed)
    check("a run that does not converge has a page", status == 0, said)
    shown = screenshot(browser, failed / "report.html")
    check("and says so in red", share(shown, RED) > PART / 10, share(shown, RED))


main()
print(len(failures), "failures")
sys.exit(bool(failures))
