#!/usr/bin/env python3
"""The code built for a target calls no floating-point helper, no heap and no exception machinery.

Looks at the undefined symbols of the libraries and of every object of the firmware, as a cross preset built them.
"""

import argparse
import pathlib
import re
import subprocess
import sys

import house

FORBIDDEN = {
    "floating point": r"__aeabi_(c?[fd]|u?[il]2[fd]|h2[fd])\w*"
    r"|__(add|sub|mul|div|neg|pow|eq|ne|lt|le|gt|ge|unord|cmp)[shdtx]f[2346i]\w*"
    r"|__(fix(uns)?[shdtx]f|float(un)?)[sdt]i([shdtx]f)?|__(extend|trunc)[shdtx]f[shdtx]f2"
    r"|(sin|cos|tan|sqrt|pow|exp|log|floor|ceil|round|fabs|fmod)[fl]?",
    "heap": r"malloc|calloc|realloc|free|aligned_alloc|_sbrk|sbrk|_Zn[wa]\w*|_Zd[la]\w*",
    "exceptions, RTTI or guarded statics": r"__cxa_\w*|_Unwind_\w*|__gxx_personality\w*|_ZSt\d+__throw\w*|_ZT[IS]N\w*"
    r"|_ZTVN10__cxxabi\w*",
}


def symbols(path):
    """The lines of nm for an object or for a library's members: an address or spaces, a letter, a name."""
    done = subprocess.run(["nm", path], check=True, capture_output=True, text=True)
    return [line for line in done.stdout.splitlines() if line and not line.endswith(":")]


def undefined(lines):
    """The names that others must define."""
    return [line.split()[-1] for line in lines if line.startswith(" ")]


def fault_of(symbol):
    return next((why for why, pattern in FORBIDDEN.items() if re.fullmatch(pattern, symbol)), None)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=pathlib.Path, help="binary folder of a cross preset")
    build = parser.parse_args().build
    libraries = [build / "core/libspanline_core.a", build / "hal/libspanline_hal.a"]
    objects = sorted((build / "firmware").rglob("*.obj"))
    faults = [f"{library}: missing, run script/build first" for library in libraries if not library.is_file()]
    if not objects:
        faults.append(f"{build / 'firmware'}: no objects, run script/build first")
    files = [*(library for library in libraries if library.is_file()), *objects]
    for path in files:
        lines = symbols(path)
        if not lines and path in libraries:
            faults.append(f"{path.relative_to(build)}: an empty library")
        faults += [
            f"{path.relative_to(build)}: {symbol} ({why})" for symbol in undefined(lines) if (why := fault_of(symbol))
        ]
    house.report(len(files), "libraries and objects", faults)


if __name__ == "__main__":
    sys.exit(main())
