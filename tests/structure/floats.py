#!/usr/bin/env python3
"""No floating-point type or literal is named in the code of core/ and hal/."""

import re
import sys

import house

# Comments and strings go first; what is left must not match FLOAT.
NOT_CODE = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"", re.DOTALL)
FLOAT = re.compile(r"\b(?:float|double)\b|(?<![\w.'])\d[\d']*\.\d|(?<![\w.'])\d[\d']*[eE][+-]?\d|(?<![\w.)\]])\.\d")


def blanked(found):
    """As many line ends as the comment had, so that line numbers stay."""
    return " " + "\n" * found[0].count("\n")


def main():
    files, faults = house.sources("core", "hal"), []
    for file in files:
        code = NOT_CODE.sub(blanked, file.read_text())
        for number, line in enumerate(code.splitlines(), 1):
            if FLOAT.search(line):
                faults.append(f"{file.relative_to(house.ROOT)}:{number}: {line.strip()}")
    house.report(len(files), "files", faults)


if __name__ == "__main__":
    sys.exit(main())
