#!/usr/bin/env python3
"""Runs build/firmware/<board>/bench.elf for each core under QEMU, prints a table and writes build/bench.json.

The image prints a line for each case: bench <scene> <visibility> <depth> <band> <instructions> <crc> <peak bytes>, and
nothing else.
It prints lecture 003's table beside ours, and without --check and --core which visibility algorithm wins where
(compare.py).
Cycles are those of the model in tests/qemu/cycles, for the cores that it knows; null for the others.
"""

import argparse
import json
import pathlib
import re
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/qemu"))

import compare  # noqa: E402
import cycles  # noqa: E402
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
# Those whose cycles are modelled.
MODELLED = ("m0plus", "m3", "m4")
# Whatever else an image says is a complaint.
LINE = re.compile(r"^bench (\S+) (\S+) (16|24) (\d+) (\d+) ([0-9a-f]{8}) (\d+)$", re.MULTILINE)
BUDGETS = ROOT / "tests/bench/budgets.json"
# A case that takes less than this share of its budget has either stopped drawing what it drew, or deserves a new budget.
FLOOR = 0.9


def run(core, timeout):
    """What the image printed, and the cycle counter's report of each case's measured frame, where there is a model."""
    board = CORES[core]
    image = ROOT / f"build/firmware/{board}/bench.elf"
    with tempfile.TemporaryDirectory() as folder:
        out = f"{folder}/cycles"
        counter = cycles.arguments(core, out, blocks=True) if core in MODELLED else []
        result = machine.run(board, image, timeout, *counter)
        # Every case is a cold frame and a warm one, which is the one that counts.
        reports = cycles.read_reports(out)[1::2] if counter else []
    if result.code != 0 or result.complaints:
        raise Failure(f"bench on {board} ended with {result.code}:\n{result.console}{result.complaints}")
    return result.console, reports


def measure(core, timeout):
    """The rows of one core, as design.md's list of bench.json describes them, and their cycle reports."""
    console, reports = run(core, timeout)
    rows = rows_of(core, console)
    if reports and len(reports) != len(rows):
        raise Failure(f"bench on {core}: {len(rows)} cases, but {len(reports)} cycle reports")
    for row, report in zip(rows, reports):
        require_same_count(row, report)
        row["cycles"] = report.cycles
    return rows, reports


def rows_of(core, console):
    """The rows that an image printed, which are all that it may print."""
    others = [line for line in console.splitlines() if line and not LINE.fullmatch(line)]
    if others:
        raise Failure(f"bench on {core} complains:\n" + "\n".join(others))
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
        for scene, visibility, depth, band, instructions, crc, peak in LINE.findall(console)
    ]
    if not rows:
        raise Failure(f"bench on {core} printed no figures")
    return rows


def require_same_count(row, report):
    """Timer and plugin count the same instructions, but for a few at the ends of each interval."""
    if abs(row["instructions"] - report.instructions) > 8 * report.intervals:
        raise Failure(
            f"{row['core']}, {case(row)}: the timer counts {row['instructions']} instructions, "
            f"the plugin {report.instructions}"
        )


def case(row):
    """The name of a row in the budget table."""
    return f"{row['scene']} {row['visibility']} {row['depth']} {row['band']}"


def print_table(rows, figure):
    """One line a case, one column a core, in millions."""
    cores = [core for core in CORES if any(row["core"] == core and row[figure] is not None for row in rows)]
    figures = {(case(row), row["core"]): row[figure] for row in rows}
    print(f"{f'millions of {figure}':28}" + "".join(f"{core:>9}" for core in cores))
    for name in dict.fromkeys(case(row) for row in rows):
        cells = (figures.get((name, core)) for core in cores)
        print(f"{name:28}" + "".join(f"{'-' if cell is None else f'{cell / 1e6:.3f}':>9}" for cell in cells))
    print()


def print_hottest(core, name, report):
    """The functions of a frame that take most of it."""
    image = ROOT / f"build/firmware/{CORES[core]}/bench.elf"
    print(f"hottest functions of {name} on {core}: cycles, share, instructions")
    for function, instructions, spent in cycles.hottest(report, cycles.Symbols(image), 8):
        print(f"{spent:10} {100 * spent / report.cycles:5.1f} % {instructions:10}  {function}")
    print()


def pictures_differ(rows):
    """Cases whose picture is not the same on every core."""
    crcs = {}
    for row in rows:
        crcs.setdefault(case(row), set()).add(row["crc"])
    return [f"{name}: the cores drew {len(found)} different pictures" for name, found in crcs.items() if len(found) > 1]


def beside_budget(rows, budgets, cores=CORES):
    """Cases of these cores above their budget or far below it, cases that have none, and budgets that no case answers to."""
    figures = {(row["core"], case(row)): row["instructions"] for row in rows}
    for core, name in figures:
        if name not in budgets.get(core, {}):
            yield f"{core}, {name}: has no budget"
    for core, table in ((core, budgets.get(core, {})) for core in cores):
        for name, most in table.items():
            figure = figures.get((core, name))
            if figure is None:
                yield f"{core}, {name}: has a budget and was not measured"
            elif figure > most:
                yield f"{core}, {name}: {figure} instructions, budget {most}"
            elif figure < FLOOR * most:
                yield f"{core}, {name}: {figure} instructions, less than {FLOOR:.0%} of its budget {most}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="fail where a figure is above tests/bench/budgets.json, or far below")
    parser.add_argument("--core", action="append", choices=CORES, help="this core only; may be given again")
    parser.add_argument("--hottest", default="S4 scanline-z 16 16", metavar="CASE",
                        help="whose functions to list, as the table names it (S4 scanline-z 16 16)")
    parser.add_argument("--timeout", type=float, default=300, help="seconds a core (300)")
    arguments = parser.parse_args()
    rows, listed = [], []
    try:
        for core in arguments.core or CORES:
            measured, reports = measure(core, arguments.timeout)
            rows += measured
            listed += [(core, report) for row, report in zip(measured, reports) if case(row) == arguments.hottest]
    except Failure as failure:
        sys.exit(f"bench.py: {failure}")
    print_table(rows, "instructions")
    print_table(rows, "cycles")
    for core in arguments.core or CORES:
        print("\n".join([*compare.lecture_table(core, rows), ""]))
    for core, report in listed:
        print_hottest(core, arguments.hottest, report)
    if not arguments.core and not arguments.check:
        try:
            compare.run(ROOT, arguments.timeout)
        except Failure as failure:
            sys.exit(f"bench.py: {failure}")
    if not arguments.core:
        (ROOT / "build/bench.json").write_text(json.dumps(rows, indent=1) + "\n")
    faults = pictures_differ(rows)
    if arguments.check:
        faults += beside_budget(rows, json.loads(BUDGETS.read_text()), arguments.core or CORES)
    if faults:
        sys.exit("bench.py: " + "\nbench.py: ".join(faults))


if __name__ == "__main__":
    main()
