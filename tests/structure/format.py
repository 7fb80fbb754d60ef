#!/usr/bin/env python3
"""Every C++ file is laid out as clang-format lays it out."""

import subprocess
import sys

import house


def main():
    files = house.sources("core", "hal", "firmware", "host_sim", "tests")
    done = subprocess.run(["clang-format", "--dry-run", "-Werror", *files], capture_output=True, text=True)
    faults = sorted({line.split(":")[0] for line in done.stderr.splitlines() if ": error:" in line})
    house.report(len(files), "files", [f"{fault}: run clang-format -i on it" for fault in faults])


if __name__ == "__main__":
    sys.exit(main())
