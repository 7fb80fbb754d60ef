"""What the structure tests share: where things are, and the rooms of the house (design.md, section 2)."""

import pathlib
import sys
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE_ENDINGS = {".hpp", ".cpp", ".h"}


def sources(*folders):
    """Every C++ file under these folders, sorted."""
    return sorted(
        path for folder in folders for path in (ROOT / folder).rglob("*") if path.suffix in SOURCE_ENDINGS
    )


def headers(*folders):
    return [path for path in sources(*folders) if path.suffix != ".cpp"]


def in_parallel(function, items):
    """The results of a function that waits for another program, two at a time, in order."""
    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(function, items))


def report(checked, what, faults):
    """Ends the test: a line for each fault, or one that says what was looked at."""
    for fault in faults:
        print(fault)
    if not checked:
        sys.exit(f"nothing to check: no {what}")
    if faults:
        sys.exit(f"{len(faults)} faults in {checked} {what}")
    print(f"{checked} {what}, no fault")
