#!/usr/bin/env python3
"""Runs build/firmware/<board>/bench.elf for each core under QEMU, prints a table and writes build/bench.json.

The image prints a line for each case: bench <scene> <visibility> <depth> <band> <instructions> <crc> <peak bytes>.
"""

import argparse
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/qemu"))

import machine  # noqa: E402
from machine import Failure  # noqa: E402

# Core in the tables, and the board that stands for it.
CORES = {
    "m0plus": "mps2-an385-m0plus",
    "m3": "mps2-an385",
    "m4": "mps2-an386",
    "m7": "mps2-an500",
    "rv32": "virt-rv32",
}
LINE = re.compile(r"^bench (\S+) (\S+) (16|24) (\d+) (\d+) ([0-9a-f]{8}) (\d+)$", re.MULTILINE)
BUDGETS = ROOT / "tests/bench/budgets.json"


def measure(core, timeout):
    """The rows of one core, as design.md's list of bench.json describes them."""
    board = CORES[core]
    result = machine.run(board, ROOT / f"build/firmware/{board}/bench.elf", timeout)
    if result.code != 0 or result.complaints:
        raise Failure(f"bench on {board} ended with {result.code}:\n{result.console}{result.complaints}")
    rows = [
        {
            "scene": scene,
            "core": core,
            "visibility": visibility,
            "depth": int(depth),
            "band": int(band),
            "instructions": int(instructions),
            "cycles": None,
            "crc": crc,
            "peak_bytes": int(peak),
        }
        for scene, visibility, depth, band, instructions, crc, peak in LINE.findall(result.console)
    ]
    if not rows:
        raise Failure(f"bench on {board} printed no figures:\n{result.console}")
    return rows


def case(row):
    """The name of a row in the budget table."""
    return f"{row['scene']} {row['visibility']} {row['depth']} {row['band']}"


def print_table(rows):
    """One line a case, one column a core, in millions of instructions."""
    cores = [core for core in CORES if any(row["core"] == core for row in rows)]
    figures = {(case(row), row["core"]): row["instructions"] for row in rows}
    print(f"{'millions of instructions':28}" + "".join(f"{core:>9}" for core in cores))
    for name in dict.fromkeys(case(row) for row in rows):
        cells = (figures.get((name, core)) for core in cores)
        print(f"{name:28}" + "".join(f"{'-' if cell is None else f'{cell / 1e6:.3f}':>9}" for cell in cells))


def pictures_differ(rows):
    """Cases whose picture is not the same on every core."""
    crcs = {}
    for row in rows:
        crcs.setdefault(case(row), set()).add(row["crc"])
    return [f"{name}: the cores drew {len(found)} different pictures" for name, found in crcs.items() if len(found) > 1]


def over_budget(rows):
    """Cases above their budget, and budgets that no case answers to."""
    budgets = json.loads(BUDGETS.read_text())
    figures = {(row["core"], case(row)): row["instructions"] for row in rows}
    for core, table in budgets.items():
        for name, most in table.items():
            figure = figures.get((core, name))
            if figure is None:
                yield f"{core}, {name}: has a budget and was not measured"
            elif figure > most:
                yield f"{core}, {name}: {figure} instructions, budget {most}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="fail where a figure is above tests/bench/budgets.json")
    parser.add_argument("--core", action="append", choices=CORES, help="this core only; may be given again")
    parser.add_argument("--timeout", type=float, default=300, help="seconds a core (300)")
    arguments = parser.parse_args()
    if arguments.check and arguments.core:
        parser.error("--check wants all cores")
    try:
        rows = [row for core in arguments.core or CORES for row in measure(core, arguments.timeout)]
    except Failure as failure:
        sys.exit(f"bench.py: {failure}")
    print_table(rows)
    if not arguments.core:
        (ROOT / "build/bench.json").write_text(json.dumps(rows, indent=1) + "\n")
    faults = pictures_differ(rows) + (list(over_budget(rows)) if arguments.check else [])
    if faults:
        sys.exit("bench.py: " + "\nbench.py: ".join(faults))


if __name__ == "__main__":
    main()
