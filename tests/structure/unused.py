#!/usr/bin/env python3
"""Programs that draw flat or smooth surfaces alone link no code and no table of textures, fog, dither or text.

Looks at the symbols that finished programs define; a program that draws such things shows that the pattern finds them.
"""

import argparse
import pathlib
import re
import subprocess
import sys

import house

EXTRA = re.compile(r"textur|texel|general_(pixel|surface)|generalshader|fog|dither|local_?(light|flat)|spanline::power|relief|volume|canvas|font|glyph", re.IGNORECASE)


def defined(path):
    done = subprocess.run(["nm", "-C", "--defined-only", path], check=True, capture_output=True, text=True)
    return [line.split(maxsplit=2)[2] for line in done.stdout.splitlines() if line.count(" ") >= 2]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("firmware", type=pathlib.Path, help="folder of finished programs, board by board")
    parser.add_argument("--plain", nargs="+", required=True, help="programs that must not have it")
    parser.add_argument("--rich", nargs="+", required=True, help="programs that must")
    arguments = parser.parse_args()
    faults = []
    for name in arguments.plain + arguments.rich:
        path = arguments.firmware / name
        if not path.is_file():
            faults.append(f"{path}: missing, run script/build first")
            continue
        known = defined(path)
        if not known:
            faults.append(f"{name}: has no symbols to look at")
            continue
        found = [symbol for symbol in known if EXTRA.search(symbol)]
        if name in arguments.plain:
            faults += [f"{name}: {symbol}" for symbol in found]
        elif not found:
            faults.append(f"{name}: has textures or text, and no symbol says so")
    house.report(len(arguments.plain) + len(arguments.rich), "programs", faults)


if __name__ == "__main__":
    sys.exit(main())
