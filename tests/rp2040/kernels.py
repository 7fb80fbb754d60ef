#!/usr/bin/env python3
"""The cycle model against rp2040js: kernels of different kinds, whose cycles by QEMU's plugin and by rp2040js differ by at
most 2 %."""

import subprocess
import sys
import tempfile

import board
import cycles
import machine
from board import Failure

BOARD = "mps2-an385-m0plus"
TOLERANCE = 0.02


def modelled():
    """Names and (instructions, cycles) by the model."""
    with tempfile.TemporaryDirectory() as folder:
        out = f"{folder}/cycles"
        image = board.ROOT / f"build/firmware/{BOARD}/kernels.elf"
        result = machine.run(BOARD, image, 100, *cycles.arguments("m0plus", out))
        if result.code != 0:
            raise Failure(f"the kernels ended with {result.code}:\n{result.console}{result.complaints}")
        return result.console.split(), [(r.instructions, r.cycles) for r in cycles.read_reports(out)]


def emulated():
    """(instructions, cycles) by rp2040js."""
    command = ["node", board.ROOT / "tests/rp2040/kernels.mjs", board.IMAGES / "kernels.elf"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=100)
    if done.returncode != 0:
        raise Failure(f"the kernels ended with {done.returncode} in rp2040js:\n{done.stdout}{done.stderr}")
    return [tuple(map(int, line.split()[1:])) for line in done.stdout.splitlines() if line.startswith("report ")]


def main():
    try:
        names, model = modelled()
        emulator = emulated()
        if not len(names) == len(model) == len(emulator) >= 5:
            raise Failure(f"{len(names)} kernels, {len(model)} reports by the model, {len(emulator)} by rp2040js")
        print("kernel        instructions      cycles    rp2040js")
        far = []
        for name, (instructions, counted), (_, other) in zip(names, model, emulator):
            difference = counted / other - 1
            print(f"{name:12} {instructions:13,} {counted:11,} {other:11,} {100 * difference:+.2f} %")
            if abs(difference) > TOLERANCE:
                far.append(name)
        if far:
            raise Failure(f"more than {100 * TOLERANCE:.0f} % apart: {', '.join(far)}")
    except Failure as failure:
        sys.exit(f"kernels.py: {failure}")


if __name__ == "__main__":
    main()
