"""What the cycle counter (cycles/plugin.cpp) wrote: reports, and the functions that the counted blocks belong to."""

import bisect
import pathlib
import re
import subprocess
from dataclasses import dataclass, field

from machine import ROOT, Failure

PLUGIN = ROOT / "build/host-release/tests/qemu/cycles/libspanline_cycles.so"


@dataclass
class Report:
    """Sums of the intervals between two reports; `blocks` are (address, instructions, cycles)."""

    instructions: int
    cycles: int
    loads: int
    stores: int
    branches: int
    taken: int
    intervals: int
    blocks: list = field(default_factory=list)


def arguments(core, out, blocks=False):
    """QEMU's arguments that load the counter. `core` is m0plus, m3 or m4; the reports go to the file `out`."""
    if not PLUGIN.is_file():
        raise Failure(f"no {PLUGIN.relative_to(ROOT)}: run script/build first")
    return ["-plugin", f"{PLUGIN},core={core},out={out}" + (",blocks=on" if blocks else "")]


def read_reports(path):
    reports, blocks = [], []
    for line in pathlib.Path(path).read_text().splitlines():
        kind, *fields = line.split()
        if kind == "block":
            blocks.append((int(fields[0], 16), int(fields[1]), int(fields[2])))
        else:
            reports.append(Report(*map(int, fields), blocks))
            blocks = []
    return reports


class Symbols:
    """The functions of an image, by address."""

    def __init__(self, image):
        listing = subprocess.run(["nm", "-nC", image], check=True, capture_output=True, text=True).stdout
        found = [line.split(maxsplit=2) for line in listing.splitlines()]
        code = [(int(f[0], 16) & ~1, plain_name(f[2])) for f in found if len(f) == 3 and f[1] in "tTwW" and f[2][0] != "$"]
        self.addresses = [address for address, _ in code]
        self.names = [name for _, name in code]

    def function(self, address):
        at = bisect.bisect_right(self.addresses, address) - 1
        return self.names[at] if at >= 0 else "?"


def plain_name(name):
    """A demangled name without template arguments, parameters, return type and anonymous namespaces."""
    name = name.replace("(anonymous namespace)::", "")
    while (shorter := re.sub(r"<[^<>]*>", "", name)) != name:
        name = shorter
    while (shorter := re.sub(r"\([^()]*\)(?=.*::)", "", name)) != name:
        name = shorter
    return name.split("(")[0].split(" ")[-1] or name


def hottest(report, symbols, count):
    """The functions with most cycles as (name, instructions, cycles), the hottest first."""
    sums = {}
    for address, instructions, cycles in report.blocks:
        known = sums.setdefault(symbols.function(address), [0, 0])
        known[0] += instructions
        known[1] += cycles
    ranked = sorted(((name, *both) for name, both in sums.items()), key=lambda entry: -entry[2])
    return ranked[:count]
