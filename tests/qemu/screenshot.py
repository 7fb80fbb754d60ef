#!/usr/bin/env python3
"""Runs an image on a board with a display, waits for a text on its console, and takes a picture of the display."""

import argparse
import json
import os
import select
import socket
import subprocess
import sys
import tempfile
import time

import machine
import png
from machine import Failure


class Monitor:
    """QEMU's machine protocol (QMP) over a socket."""

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(path)
        self.file = self.socket.makefile("rw")
        self.file.readline()  # the greeting
        self.ask("qmp_capabilities")

    def ask(self, command, **arguments):
        self.file.write(json.dumps({"execute": command, "arguments": arguments}) + "\n")
        self.file.flush()
        for line in self.file:
            answer = json.loads(line)
            if "error" in answer:
                raise Failure(f"QEMU refuses {command}: {answer['error']['desc']}")
            if "return" in answer:
                return answer["return"]
        raise Failure(f"QEMU went away at {command}")


def wait_for_text(process, text, timeout):
    """Returns what the console wrote up to and with the text."""
    console, deadline = b"", time.monotonic() + timeout
    while text.encode() not in console:
        ready, _, _ = select.select([process.stdout], [], [], max(0, deadline - time.monotonic()))
        part = os.read(process.stdout.fileno(), 65536) if ready else b""
        if not part:
            why = "the program ended" if ready else f"{timeout} s went by"
            raise Failure(f"{why} without {text!r}; the console says:\n{console.decode(errors='replace')}")
        console += part
    return console.decode(errors="replace")


def screenshot(board, image, text, timeout):
    """Returns the display's picture and the console text. Fails on any complaint of QEMU or its display."""
    with tempfile.TemporaryDirectory() as folder:
        monitor_path, picture_path = f"{folder}/monitor", f"{folder}/screen.ppm"
        command = machine.command_line(board, image, "-qmp", f"unix:{monitor_path},server=on,wait=off")
        with tempfile.TemporaryFile() as errors:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=errors)
            try:
                console = wait_for_text(process, text, timeout)
                monitor = Monitor(monitor_path)
                monitor.ask("screendump", filename=picture_path)
                monitor.ask("quit")
                process.wait(timeout)
            finally:
                process.kill()
                process.wait()
            errors.seek(0)
            complaints = machine.complaints(board, errors.read().decode(errors="replace"))
        if complaints:
            raise Failure(f"QEMU complained:\n{complaints}")
        return png.read_ppm(picture_path), console


def require_equal(got, want):
    """Fails with the number of differing pixels and the first of them."""
    if (got.width, got.height) != (want.width, want.height):
        raise Failure(f"the display is {got.width}x{got.height}, expected {want.width}x{want.height}")
    different = [
        (x, y) for y in range(got.height) for x in range(got.width) if got.pixel(x, y) != want.pixel(x, y)
    ]
    if different:
        x, y = different[0]
        raise Failure(
            f"{len(different)} pixels differ, the first at {x},{y}: "
            f"{got.pixel(x, y).hex()}, expected {want.pixel(x, y).hex()}"
        )


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("board")
    parser.add_argument("image")
    parser.add_argument("--wait", required=True, metavar="TEXT", help="take the picture once the console says this")
    parser.add_argument("--timeout", type=float, default=60, help="seconds (60)")
    parser.add_argument("-o", "--output", metavar="FILE.png", help="write the picture there, as the display's window shows it")
    parser.add_argument("--scale", type=int, default=4, help="window pixels a display pixel (4)")
    parser.add_argument("--expect", metavar="FILE.png", help="the display's pixels must equal this picture")
    arguments = parser.parse_args()
    try:
        picture, console = screenshot(arguments.board, arguments.image, arguments.wait, arguments.timeout)
        print(console, end="", flush=True)
        if arguments.output:
            png.write_png(arguments.output, picture)
        if arguments.expect:
            require_equal(picture.shrunk(arguments.scale), png.read_png(arguments.expect))
    except (Failure, ValueError, OSError) as failure:
        sys.exit(f"screenshot.py: {failure}")


if __name__ == "__main__":
    main()
