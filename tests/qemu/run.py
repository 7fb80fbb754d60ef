#!/usr/bin/env python3
"""Runs an image on its board under QEMU, prints its console and checks how it ended."""

import argparse
import re
import subprocess
import sys

import machine
from machine import Failure


def address_range(image, symbol):
    """First and last address of a function, from the image's symbol table."""
    listing = subprocess.run(["nm", "-S", image], check=True, capture_output=True, text=True).stdout
    for line in listing.splitlines():
        fields = line.split()
        if len(fields) == 4 and fields[3] == symbol:
            first = int(fields[0], 16) & ~1
            return first, first + int(fields[1], 16) - 1
    raise Failure(f"{image} has no function {symbol}")


def check(arguments, result):
    if result.complaints and arguments.exit == 0:
        raise Failure(f"QEMU complained:\n{result.complaints}")
    if result.code != arguments.exit:
        raise Failure(f"exit code {result.code}, expected {arguments.exit}")
    for pattern in arguments.expect:
        if not re.search(pattern, result.console, re.MULTILINE):
            raise Failure(f"nothing in the console matches {pattern!r}")
    if arguments.fault_in:
        found = re.search(r"^fault: .* at pc 0x([0-9a-f]{8})", result.console, re.MULTILINE)
        if not found:
            raise Failure("no fault was reported")
        first, last = address_range(arguments.image, arguments.fault_in)
        if not first <= int(found[1], 16) <= last:
            raise Failure(f"the fault is not in {arguments.fault_in} ({first:#x} to {last:#x})")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("board")
    parser.add_argument("image")
    parser.add_argument("--timeout", type=float, default=60, help="seconds (60)")
    parser.add_argument("--exit", type=int, default=0, help="the exit code to expect (0)")
    parser.add_argument("--expect", action="append", default=[], metavar="REGEX", help="must match in the console text")
    parser.add_argument("--fault-in", metavar="FUNCTION", help="a fault must be reported whose pc lies in this function")
    parser.add_argument("--save", metavar="FILE", help="also writes the console text there")
    arguments = parser.parse_args()
    try:
        result = machine.run(arguments.board, arguments.image, arguments.timeout)
        print(result.console, end="", flush=True)
        check(arguments, result)
    except Failure as failure:
        sys.exit(f"run.py: {failure}")
    if arguments.save:
        with open(arguments.save, "w", encoding="utf-8") as file:
            file.write(result.console)


if __name__ == "__main__":
    main()
