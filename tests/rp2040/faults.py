#!/usr/bin/env python3
"""What the real image does in rp2040js when things go wrong: a Status on the console, a retry that initialises the panel
anew, and right pictures afterwards."""

import argparse
import sys
import tempfile

import board
from board import Failure

PANEL = "st7789"
FRAME = 320 * 240 * 2
# What init sends: about a hundred bytes.
MID_FRAME = 2 * FRAME + FRAME // 2


def require_text(report, *texts):
    for text in texts:
        if text not in report["console"]:
            raise Failure(f"the console does not say {text!r}:\n{report['console']}")


def require_last(tools, panel, folder, frame):
    pictures = board.shown(tools, panel, f"{folder}/trace", f"{folder}/picture")
    board.require_frames(tools, panel, pictures[-1:], [frame], folder)


def transfer_that_never_ends(tools, folder):
    """The serial interface stops in the third frame. Two frames are given up: those that were in the queue."""
    report = board.run("turntable_stops", f"{folder}/trace", "--until", board.SHOWN, "--stick", str(MID_FRAME))
    require_text(report, "display bus_timeout", "display ok", "frame 6 shown")
    require_last(tools, PANEL, folder, 6)


def fill_that_never_ends(tools, folder):
    """The DMA clears no further band in the third frame, which is given up; the next one starts it again."""
    report = board.run("turntable_stops", f"{folder}/trace", "--until", board.SHOWN, "--stick-fill", "25")
    require_text(report, "drawing sink failed", "drawing none", "frame 6 shown")
    require_last(tools, PANEL, folder, 6)


def mute_panel(tools, folder):
    """A module whose line back is not connected works, and the console warns."""
    report = board.run("turntable_ili9341_stops", f"{folder}/trace", "--until", board.SHOWN, "--mute")
    require_text(report, "display panel_unidentified", "frame 1 shown")
    pictures = board.shown(tools, "ili9341", f"{folder}/trace", f"{folder}/picture")
    board.require_frames(tools, "ili9341", pictures, [0, 1], folder)


def reset_in_mid_frame(tools, folder):
    report = board.run("turntable_stops", f"{folder}/trace", "--until", board.SHOWN, "--reset-at", str(MID_FRAME))
    if report["resets"] != 1:
        raise Failure("nobody pressed reset")
    require_text(report, "frame 6 shown")
    require_last(tools, PANEL, folder, 6)


def hang(tools, folder):
    """The program hangs in the third frame: the watchdog resets the chip, and all begins anew."""
    report = board.run("turntable_stops", f"{folder}/trace", "--until", board.SHOWN, "--hang", str(MID_FRAME))
    if report["resets"] != 1:
        raise Failure(f"the watchdog has reset the chip {report['resets']} times, expected once")
    require_text(report, "frame 6 shown")
    require_last(tools, PANEL, folder, 6)


def slow_clock(tools, folder):
    """The divider gives 31.25 MHz where 50 were asked for."""
    report = board.run("turntable_slow_stops", f"{folder}/trace", "--until", board.SHOWN)
    require_text(report, "display bus_clock_too_low, 31250000 Hz", "frame 1 shown")
    pictures = board.shown(tools, PANEL, f"{folder}/trace", f"{folder}/picture")
    board.require_frames(tools, PANEL, pictures, [0, 1], folder)


def slow_bytes(tools, folder):
    """Bytes take twice as long as the clock says: nothing is lost."""
    report = board.run("turntable_stops", f"{folder}/trace", "--until", board.SHOWN, "--slowness", "2")
    require_text(report, "frame 6 shown")
    require_last(tools, PANEL, folder, 6)


CASES = {
    "transfer": transfer_that_never_ends,
    "fill": fill_that_never_ends,
    "mute": mute_panel,
    "hang": hang,
    "reset": reset_in_mid_frame,
    "clock": slow_clock,
    "slow": slow_bytes,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("case", choices=CASES)
    parser.add_argument("--panel-trace", required=True)
    parser.add_argument("--turntable-host", required=True)
    arguments = parser.parse_args()
    try:
        with tempfile.TemporaryDirectory() as folder:
            CASES[arguments.case](board.Tools(arguments.panel_trace, arguments.turntable_host), folder)
    except Failure as failure:
        sys.exit(f"faults.py: {failure}")


if __name__ == "__main__":
    main()
