#!/usr/bin/env python3
"""Every C++ file is laid out as clang-format lays it out."""

import subprocess
import sys

import house


def main():
    files = house.sources("core", "hal", "firmware", "host_sim", "tests")
    done = subprocess.run(["clang-format", "--dry-run", "-Werror", *files], capture_output=True, text=True)
    named = sorted({line.split(":")[0] for line in done.stderr.splitlines() if ": error:" in line})
    faults = [f"{name}: run clang-format -i on it" for name in named]
    # A tool that fails and names no file has not looked at them.
    if done.returncode != 0 and not faults:
        faults = [f"clang-format ended with {done.returncode}:\n{done.stdout}{done.stderr}"]
    house.report(len(files), "files", faults)


if __name__ == "__main__":
    sys.exit(main())
