#!/usr/bin/env python3
"""Runs a board's self-test under QEMU and holds each of its lines against what this host draws."""

import argparse
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "qemu"))
import machine  # noqa: E402
from machine import Failure  # noqa: E402


def number_after(text, console):
    found = re.search(rf"^{text} (\d+)", console, re.MULTILINE)
    if not found:
        raise Failure(f"the console does not say {text!r}")
    return int(found[1])


def require_equal(got, want):
    """The same lines in the same order; names the first that is not."""
    for here, there in zip(got, want):
        if here != there:
            raise Failure(f"the board says {here!r}, this host {there!r}")
    if len(got) != len(want):
        raise Failure(f"the board draws {len(got)} pictures, expected {len(want)}")


def check(arguments):
    result = machine.run(arguments.board, arguments.image, arguments.timeout)
    print(result.console, end="", flush=True)
    if result.complaints:
        raise Failure(f"QEMU complained:\n{result.complaints}")
    if result.code != 0:
        raise Failure(f"exit code {result.code}")
    memory, stack = (number_after(f"selftest {what}", result.console) for what in ("memory", "stack"))
    host = subprocess.run([arguments.host, "--memory", str(memory)], check=True, capture_output=True, text=True)
    want = host.stdout.splitlines()
    got = [line for line in result.console.splitlines() if not re.match(r"selftest (memory|stack) ", line)]
    require_equal(got, want)
    if len(got) < arguments.pictures:
        raise Failure(f"{len(got)} pictures, expected at least {arguments.pictures}")
    if stack > arguments.stack:
        raise Failure(f"{stack} bytes of stack, expected at most {arguments.stack}")
    print(f"{len(got)} pictures as on this host")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("board")
    parser.add_argument("image")
    parser.add_argument("host", help="the program that draws the same scenes here")
    parser.add_argument("--pictures", type=int, required=True, help="how many there must be at least")
    parser.add_argument("--stack", type=int, required=True, help="how many bytes of it may have been in use")
    parser.add_argument("--timeout", type=float, default=120, help="seconds (120)")
    try:
        check(parser.parse_args())
    except Failure as failure:
        sys.exit(f"selftest.py: {failure}")


if __name__ == "__main__":
    main()
