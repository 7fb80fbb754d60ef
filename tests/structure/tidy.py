#!/usr/bin/env python3
"""Runs clang-tidy on the sources of core/ and hal/, with the checks of .clang-tidy as errors."""

import subprocess
import sys

import house


def check(source):
    """What clang-tidy says against a source, or that it failed without a word; nothing if it is content."""
    command = ["clang-tidy", "--quiet", "--warnings-as-errors=*", "-p", sys.argv[1], source]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode == 0:
        return None
    return done.stdout or f"{source}: clang-tidy ended with {done.returncode}:\n{done.stderr}"


def main():
    sources = [str(path) for path in house.sources("core", "hal") if path.suffix == ".cpp"]
    house.report(len(sources), "sources", [fault for fault in house.in_parallel(check, sources) if fault])


if __name__ == "__main__":
    sys.exit(main())
