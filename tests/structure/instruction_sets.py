#!/usr/bin/env python3
"""Instruction sets live in core/spanline/cpu and in few small files, which are named here; boards have their own."""

import re
import sys

import house

CPU = house.ROOT / "core/spanline/cpu"
# Arithmetic of a few lines whose forms differ by what the core multiplies; each is at most so many lines long.
SMALL_FILES = ("core/spanline/math/bits.hpp", "core/spanline/math/reciprocal.hpp", "core/spanline/raster/small_triangle.hpp")
LONGEST = 150
# Predefined macros of compilers for a core, intrinsics and assembly.
INSTRUCTION_SET = re.compile(r"__ARM_\w+|__arm__|__thumb\w*|__riscv\w*|__x86\w*|arm_acle\.h|\b(?:__)?asm(?:__)?\s*(?:volatile\s*)?\(")


def main():
    faults, used = [], set()
    files = house.sources("core", "hal")
    for file in files:
        path = str(file.relative_to(house.ROOT))
        text = file.read_text()
        found = INSTRUCTION_SET.search(text)
        if not found or file.is_relative_to(CPU):
            continue
        if path not in SMALL_FILES:
            line = text.count("\n", 0, found.start()) + 1
            faults.append(f"{path}:{line}: {found[0]} belongs below core/spanline/cpu")
            continue
        used.add(path)
        if text.count("\n") > LONGEST:
            faults.append(f"{path}: is longer than {LONGEST} lines, too long for a file outside cpu/ with an instruction set")
    faults += [f"{path}: is named here and has no instruction set in it" for path in SMALL_FILES if path not in used]
    house.report(len(files), "files", faults)


if __name__ == "__main__":
    sys.exit(main())
