"""The comparison of visibility algorithms by depth complexity, size and number of polygons: what `compare.elf` prints, as
tables."""

import re

import machine
from machine import Failure

BOARDS = {"m0plus": "mps2-an385-m0plus", "m4": "mps2-an386"}
LINE = re.compile(r"^compare (\w+) (\d+) (\d+) (\S+) (\d+) (\d+)$", re.MULTILINE)

# Lecture 003, "Performance of Four Algorithms for Visible-Surface Determination": cost by number of polygons, depth
# sort at 100 polygons = 1.
LECTURE = {
    "depth sort": (1, 10, 507),
    "z-buffer": (54, 54, 54),
    "scan line": (5, 21, 100),
    "Warnock": (11, 64, 307),
}


def measure(core, root, timeout):
    board = BOARDS[core]
    result = machine.run(board, root / f"build/firmware/{board}/compare.elf", timeout)
    if result.code != 0 or result.complaints:
        raise Failure(f"compare on {board} ended with {result.code}:\n{result.console}{result.complaints}")
    others = [line for line in result.console.splitlines() if line and not LINE.fullmatch(line)]
    if others:
        raise Failure(f"compare on {board} complains:\n" + "\n".join(others))
    lines = [(table, int(number), int(leg), name, int(count), int(pixels))
             for table, number, leg, name, count, pixels in LINE.findall(result.console)]
    if not lines:
        raise Failure(f"compare on {board} printed no figures:\n{result.console}")
    return lines


def print_cover(core, lines):
    """Instructions a pixel of the picture, a block a depth complexity; the least of each column is starred."""
    cover = {(number, leg, name): count / pixels for table, number, leg, name, count, pixels in lines if table == "cover"}
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


def print_shrink(core, lines):
    """The lecture's table and ours, scaled so that the z-buffer at 100 polygons has the lecture's figure."""
    shrink = {(name, number): count for table, number, _, name, count, _ in lines if table == "shrink"}
    numbers = sorted({key[1] for key in shrink})
    unit = shrink["zbuffer", numbers[0]] / LECTURE["z-buffer"][0]
    print(f"\nrelative cost, total area of polygons constant, on {core}: lecture 003, and ours in its unit (z-buffer at "
          f"{numbers[0]} polygons)")
    print(f"{'polygons':20}" + "".join(f"{number:>9}" for number in numbers))
    for name, costs in LECTURE.items():
        print(f"{name + ' (lecture)':20}" + "".join(f"{cost:>9}" for cost in costs))
    for name in dict.fromkeys(key[0] for key in shrink):
        print(f"{name:20}" + "".join(f"{shrink[name, number] / unit:>9.0f}" for number in numbers))


def run(root, timeout):
    for core in BOARDS:
        lines = measure(core, root, timeout)
        print_cover(core, lines)
        print_shrink(core, lines)
