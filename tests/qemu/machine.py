"""Runs firmware images under QEMU, and those of the Pico under rp2040js.

firmware/boards/boards.json says which machine a board is, and what QEMU says on its standard error in starting that
machine, whatever the image ("qemu_says").
"""

import json
import pathlib
import subprocess
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]
BOARDS = json.loads((ROOT / "firmware/boards/boards.json").read_text())


class Failure(Exception):
    """What a test says when it fails: one line, or a line and the output that shows it."""


@dataclass
class Run:
    """What an image did: its exit code, its console text, and what QEMU itself complained about."""

    code: int
    console: str
    complaints: str


def command_line(board, image, *more):
    """The emulator's command line: the console (semihosting) goes to stdout, its own complaints to stderr."""
    if board not in BOARDS:
        raise Failure(f"no board {board!r}: boards.json has {', '.join(BOARDS)}")
    if not pathlib.Path(image).is_file():
        raise Failure(f"no image {image}: run script/build first")
    if "rp2040js" in BOARDS[board]:
        return ["node", str(ROOT / "tests/rp2040/run.mjs"), str(image)]
    return [
        *BOARDS[board]["qemu"],
        *("-display", "none", "-monitor", "none", "-serial", "null", "-d", "guest_errors"),
        *("-chardev", "stdio,id=console"),
        *("-semihosting-config", "enable=on,target=native,chardev=console"),
        *more,
        *("-kernel", str(image)),
    ]


def complaints(board, text):
    """QEMU's standard error without the lines that this machine always begins with."""
    known = BOARDS[board].get("qemu_says", [])
    return "".join(line for line in text.splitlines(keepends=True) if line.rstrip() not in known)


def run(board, image, timeout, *more):
    """Runs an image until it exits; `more` are further arguments for the emulator."""
    try:
        done = subprocess.run(
            command_line(board, image, *more),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=timeout,
        )
    except subprocess.TimeoutExpired as late:
        text = (late.stdout or b"").decode(errors="replace")
        raise Failure(f"{image} on {board} did not exit within {timeout} s; it wrote:\n{text}") from None
    return Run(done.returncode, done.stdout, complaints(board, done.stderr))
