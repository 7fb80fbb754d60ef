"""Visibility algorithms side by side: by depth complexity and size of polygons, which `compare.elf` measures, and by the
number of polygons, beside lecture 003's table, of the benchmark's rows."""

import re

import machine
from machine import Failure

BOARDS = {"m0plus": "mps2-an385-m0plus", "m4": "mps2-an386"}
LINE = re.compile(r"^compare (\d+) (\d+) (\S+) (\d+) (\d+)$", re.MULTILINE)

# Lecture 003, "Performance of Four Algorithms for Visible-Surface Determination": cost of 100, 2,500 and 60,000 polygons
# that cover the same area, depth sort of 100 = 1. By our names of the algorithms; its scan line is what `span` is.
SHRINKING = ("T100", "T2500", "T60000")
LECTURE = {
    "depth-sort": (1, 10, 507),
    "zbuffer": (54, 54, 54),
    "span": (5, 21, 100),
    "warnock": (11, 64, 307),
}
# The algorithms whose first figure is our unit: the first of them that was measured.
UNITS = ("depth-sort", "span")


def measure(core, root, timeout):
    board = BOARDS[core]
    result = machine.run(board, root / f"build/firmware/{board}/compare.elf", timeout)
    if result.code != 0 or result.complaints:
        raise Failure(f"compare on {board} ended with {result.code}:\n{result.console}{result.complaints}")
    others = [line for line in result.console.splitlines() if line and not LINE.fullmatch(line)]
    if others:
        raise Failure(f"compare on {board} complains:\n" + "\n".join(others))
    lines = [(int(complexity), int(leg), name, int(count), int(pixels))
             for complexity, leg, name, count, pixels in LINE.findall(result.console)]
    if not lines:
        raise Failure(f"compare on {board} printed no figures:\n{result.console}")
    return lines


def print_cover(core, lines):
    """Instructions a pixel of the picture, a block a depth complexity; the least of each column is starred."""
    cover = {(complexity, leg, name): count / pixels for complexity, leg, name, count, pixels in lines}
    complexities = sorted({key[0] for key in cover})
    legs = sorted({key[1] for key in cover})
    names = list(dict.fromkeys(key[2] for key in cover))
    print(f"\ninstructions a pixel of the picture on {core}; right triangles with legs of")
    print(f"{'':30}" + "".join(f"{leg:>9}" for leg in legs) + "  pixels")
    for complexity in complexities:
        for name in names:
            cells = []
            for leg in legs:
                cost = cover[complexity, leg, name]
                least = min(cover[complexity, leg, other] for other in names if cover[complexity, leg, other] > 0)
                cells.append(f"{'-' if cost == 0 else f'{cost:.1f}' + ('*' if cost == least else ' '):>9}")
            print(f"covered {complexity:>2} times {name:14}" + "".join(cells))


def lecture_table(core, rows):
    """The lines of lecture 003's table for a core: our millions of instructions, the same in our unit, the lecture's."""
    ours = {(row["visibility"], row["scene"]): row["instructions"]
            for row in rows if row["core"] == core and row["scene"] in SHRINKING}
    unit_name = next((name for name in UNITS if (name, SHRINKING[0]) in ours), None)
    if unit_name is None:
        return []
    unit = ours[unit_name, SHRINKING[0]]

    def cells(figures, form):
        return "".join(f"{'-' if figure is None else format(figure, form):>8}" for figure in figures)

    def three(title):
        return f"{title:^24}"

    scenes = "".join(f"{scene:>8}" for scene in SHRINKING)
    lines = [f"{f'lecture 003, {core}':20}" + three("millions") + three(f"{unit_name} T100 = 1") + three("lecture"),
             f"{'':20}" + 3 * scenes]
    for name in dict.fromkeys([*(name for name, _ in ours), *LECTURE]):
        counts = [ours.get((name, scene)) for scene in SHRINKING]
        lines.append(f"{name:20}" + cells([count and count / 1e6 for count in counts], ".3f")
                     + cells([count and count / unit for count in counts], ".1f")
                     + cells(LECTURE.get(name, 3 * (None,)), "d"))
    return lines


def run(root, timeout):
    for core in BOARDS:
        print_cover(core, measure(core, root, timeout))
