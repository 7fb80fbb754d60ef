#!/usr/bin/env python3
"""The version is the same wherever it is told: version.hpp, CMake, the command, and the newest entry of CHANGELOG.md."""

import re
import subprocess
import sys

import house

COMMAND, CMAKE_VERSION = sys.argv[1:3]


def in_header():
    text = (house.ROOT / "core/spanline/version.hpp").read_text()
    return ".".join(re.search(rf"^#define SPANLINE_VERSION_{part} (\d+)$", text, re.M)[1] for part in ("MAJOR", "MINOR", "PATCH"))


def in_change_log():
    """The newest version that has an entry; one called Unreleased may stand above it."""
    return re.search(r"^## \[(\d+\.\d+\.\d+)\]", (house.ROOT / "CHANGELOG.md").read_text(), re.M)[1]


def main():
    said = subprocess.run([COMMAND, "--version"], check=True, capture_output=True, text=True).stdout
    told = {"CMake": CMAKE_VERSION, "spanline --version": said.removeprefix("spanline ").rstrip("\n"), "CHANGELOG.md": in_change_log()}
    wanted = in_header()
    house.report(len(told), "places", [f"{place} says {version}, version.hpp {wanted}" for place, version in told.items() if version != wanted])


if __name__ == "__main__":
    sys.exit(main())
