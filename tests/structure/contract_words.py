#!/usr/bin/env python3
"""A visibility algorithm that lacks a function is refused in the words of the contract: both compilers name the part of the concept
(core/spanline/visibility/algorithm.hpp) and the function."""

import subprocess
import sys

import house

SOURCE = "tests/structure/incomplete_algorithm.cpp"
# What is left out, the part of the concept that says so, and the function that its message must name.
LACKS = [
    ("WITHOUT_BEGIN_FRAME", "BeginsFrames", "begin_frame"),
    ("WITHOUT_DRAW_BAND", "DrawsBands", "draw_band"),
    ("WITHOUT_SKIP_BAND", "SkipsBands", "skip_band"),
    ("WITHOUT_SHORTAGE", "ReportsPools", "shortage"),
]
OPTIONS = ["-std=c++20", "-fno-exceptions", "-fno-rtti", "-fsyntax-only", "-Icore"]
PROMISE = "lacks what visibility/algorithm.hpp asks for"


def errors_of(task):
    """What the compiler says, or nothing where it takes the file."""
    compiler, define = task
    command = [compiler, *OPTIONS, *([f"-D{define}"] if define else []), SOURCE]
    done = subprocess.run(command, cwd=house.ROOT, capture_output=True, text=True)
    return done.stderr if done.returncode else None


def main():
    compilers = ["g++", "clang++"]
    tasks = [(compiler, define) for compiler in compilers for define in ["", *(lack[0] for lack in LACKS)]]
    said = dict(zip(tasks, house.in_parallel(errors_of, tasks)))
    faults = []
    for compiler in compilers:
        if said[compiler, ""]:
            faults.append(f"{compiler} does not take the whole algorithm:\n{said[compiler, '']}")
        for define, part, function in LACKS:
            errors = said[compiler, define]
            missing = [word for word in (PROMISE, part, function) if word not in (errors or "")]
            if missing:
                faults.append(f"{compiler}, {define}: the errors do not say {', '.join(missing)}:\n{errors}")
    house.report(len(tasks), "compilations", faults)


if __name__ == "__main__":
    sys.exit(main())
