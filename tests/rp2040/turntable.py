#!/usr/bin/env python3
"""The real image in rp2040js: every picture that its display shows equals the simulator's, and a frame takes no more
cycles than it may. Prints what the time went into."""

import argparse
import re
import statistics
import subprocess
import sys
import tempfile

import board
from board import Failure

CYCLES_A_MICROSECOND = 125
TIMES = re.compile(r"the one before took (\d+) us, (\d+) of them waiting")


def report_times(report, pictures):
    """Prints a frame's cycles while frames follow one another, and how much of the transfer hid behind drawing. Returns
    the cycles of the longest; None where there are too few frames, or where the image does not tell its times."""
    steady = report["frames"][2:-1]  # the queue has filled, and nobody waits for the end
    times = TIMES.search(report["console"])
    if len(steady) < 2 or times is None:
        return None
    frame = statistics.mean(steady)
    wire = report["wireCycles"] / pictures
    waiting = CYCLES_A_MICROSECOND * int(times[2])
    print(f"cycles a frame {frame:,.0f}, at most {max(steady):,}; the wire {wire:,.0f}; waiting for it {waiting:,}")
    print(f"hidden behind drawing: {100 * (1 - waiting / wire):.1f} % of the transfer")
    return max(steady)


def require_cycles(worst, most):
    """A limit that nothing was measured against is not kept."""
    if worst is None:
        raise Failure("no frame's time was measured: too few frames, or the console does not tell them")
    if worst > most:
        raise Failure(f"a frame takes {worst:,} cycles, {most:,} are allowed")


def address_of(image, pattern):
    """Of the function whose mangled name matches."""
    listing = subprocess.run(["nm", board.IMAGES / f"{image}.elf"], check=True, capture_output=True, text=True).stdout
    found = [line.split() for line in listing.splitlines()]
    return next(int(f[0], 16) & ~1 for f in found if len(f) == 3 and f[1] in "tTW" and re.fullmatch(pattern, f[2]))


def check_handover(report, most):
    """What a band costs the core when it goes to the DMA, the bus's whole share."""
    print(f"handing a band to DMA takes {min(report['calls'])} to {max(report['calls'])} cycles")
    if max(report["calls"]) > most:
        raise Failure(f"at most {most} are allowed")


def check(arguments):
    tools = board.Tools(arguments.panel_trace, arguments.turntable_host)
    with tempfile.TemporaryDirectory() as folder:
        options = ["--until", board.SHOWN, *(["--ili9341"] if arguments.panel.startswith("ili9341") else [])]
        if arguments.handover:
            options += ["--time", str(address_of(arguments.image, r"_ZN8spanline5board6SpiBus6pixelsE.*"))]
        report = board.run(arguments.image, f"{folder}/trace", *options)
        print(report["console"], end="")
        for text in arguments.expect:
            if text not in report["console"]:
                raise Failure(f"the console does not say {text!r}")
        pictures = board.shown(tools, arguments.panel, f"{folder}/trace", f"{folder}/picture")
        frames = range(arguments.frames)
        board.require_frames(tools, arguments.panel, pictures, frames, folder, arguments.model, arguments.shading)
        print(f"{len(pictures)} pictures as in the simulator")
        if arguments.handover:
            check_handover(report, arguments.handover)
        worst = report_times(report, len(pictures))
        if arguments.most_cycles:
            require_cycles(worst, arguments.most_cycles)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("image")
    parser.add_argument("panel")
    parser.add_argument("frames", type=int, help="how many it shows")
    parser.add_argument("--panel-trace", required=True)
    parser.add_argument("--turntable-host", required=True)
    parser.add_argument("--model", default="bunny")
    parser.add_argument("--shading", default="gouraud")
    parser.add_argument("--expect", action="append", default=[], metavar="TEXT", help="the console says this")
    parser.add_argument("--handover", type=int, metavar="CYCLES", help="for handing a band to DMA, at most")
    parser.add_argument("--most-cycles", type=int, help="for a frame while frames follow one another")
    try:
        check(parser.parse_args())
    except Failure as failure:
        sys.exit(f"turntable.py: {failure}")


if __name__ == "__main__":
    main()
