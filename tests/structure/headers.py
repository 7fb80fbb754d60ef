#!/usr/bin/env python3
"""Every header of core/ and hal/ compiles alone, without a warning, for the host and for a Cortex-M0+."""

import subprocess
import sys

import house

COMMON = ["-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Wconversion", "-Wsign-conversion", "-Wshadow"]
COMMON += ["-Wdouble-promotion", "-Werror", "-fno-exceptions", "-fno-rtti", "-Icore", "-Ihal", "-xc++", "-"]
COMPILERS = {
    "host": ["g++", *COMMON],
    "Cortex-M0+": ["arm-none-eabi-g++", "-mthumb", "-mcpu=cortex-m0plus", "-ffreestanding", *COMMON],
}


def compile_alone(task):
    """A line on what is wrong with a header, or nothing. Included twice: a header guards itself."""
    header, target = task
    name = header.relative_to(house.ROOT)
    text = f'#include "{name}"\n' * 2
    done = subprocess.run(
        [*COMPILERS[target], f"-I{house.ROOT}"], cwd=house.ROOT, input=text, capture_output=True, text=True
    )
    return f"{name} does not compile alone ({target}):\n{done.stderr}" if done.returncode else None


def main():
    tasks = [(header, target) for header in house.headers("core", "hal") for target in COMPILERS]
    faults = [fault for fault in house.in_parallel(compile_alone, tasks) if fault]
    house.report(len(tasks), "compilations", faults)


if __name__ == "__main__":
    sys.exit(main())
