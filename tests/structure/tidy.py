#!/usr/bin/env python3
"""Runs clang-tidy on the sources of core/ and hal/, with the checks of .clang-tidy as errors."""

import subprocess
import sys

import house


def check(source):
    done = subprocess.run(
        ["clang-tidy", "--quiet", "--warnings-as-errors=*", "-p", sys.argv[1], source], capture_output=True, text=True
    )
    return done.stdout if done.returncode else None


def main():
    sources = [str(path) for path in house.sources("core", "hal") if path.suffix == ".cpp"]
    house.report(len(sources), "sources", [fault for fault in house.in_parallel(check, sources) if fault])


if __name__ == "__main__":
    sys.exit(main())
