#!/usr/bin/env python3
"""The top level of the repository holds what design.md names and nothing else."""

import subprocess
import sys

import house

NAMED = set("""CHANGELOG.md CMakeLists.txt CMakePresets.json CONTRIBUTING.md LICENSE README.md core docs firmware hal host_sim script tests .ci
.clang-format .clang-tidy .editorconfig .gitignore""".split())


def main():
    listing = subprocess.run(["git", "ls-files"], cwd=house.ROOT, check=True, capture_output=True, text=True).stdout
    names = {line.split("/")[0] for line in listing.splitlines()}
    house.report(len(names), "names", [f"{name}: not a name of design.md" for name in sorted(names - NAMED)])


if __name__ == "__main__":
    sys.exit(main())
