#!/usr/bin/env python3
"""What an app says about its memory, against what the linker made of it.

The app's pools have exactly the bytes that it stated at compile time, everything else leaves free what the board promises to
programs, and an app that wants more than its board has does not compile.
"""

import argparse
import re
import subprocess
import sys

import board
from board import ROOT, Failure

REGION = re.compile(r"^(\w+)\s+(0x[0-9a-f]+)\s+(0x[0-9a-f]+)", re.MULTILINE)
SECTION = re.compile(r"^(\.\w+)\s+(0x[0-9a-f]+)\s+(0x[0-9a-f]+)", re.MULTILINE)


def picture_memory(board_folder):
    text = (ROOT / f"firmware/boards/{board_folder}/picture_memory.hpp").read_text()
    factors = re.search(r"picture_memory = ([\d' *]+);", text)[1].replace("'", "").split("*")
    product = 1
    for factor in factors:
        product *= int(factor)
    return product


def check_map(board_name, image):
    link_map = (ROOT / f"build/firmware/{board_name}/{image}.map").read_text()
    ram_start, ram_size = next((int(r[2], 16), int(r[3], 16)) for r in REGION.finditer(link_map) if r[1] == "RAM")
    sections = [(s[1], int(s[2], 16), int(s[3], 16)) for s in SECTION.finditer(link_map)]
    end = max(address + size for _, address, size in sections if ram_start <= address < ram_start + ram_size)
    listing = subprocess.run(["nm", "-S", ROOT / f"build/firmware/{board_name}/{image}.elf"], check=True, capture_output=True, text=True)
    pools = next(int(line.split()[1], 16) for line in listing.stdout.splitlines() if re.search(r"_GLOBAL__N_1L?6memoryE$", line))
    promised = picture_memory(board_name)
    others = end - ram_start - pools
    print(f"{board_name}, {image}: pools {pools:,} bytes of {promised:,} promised; all else {others:,} of RAM's {ram_size:,}")
    if pools > promised:
        raise Failure("the pools are larger than what the board promises")
    if others + promised > ram_size:
        raise Failure("the board promises more than it has")


def check_refusal(compiler):
    """The Pico's app over the memory that a micro:bit promises: a static_assert says no."""
    folders = ["firmware/boards/microbit", "firmware/boards/pico", "firmware/boards/common", "firmware", "firmware/apps", "core", "hal", "build/generated"]
    command = [
        compiler, "-mcpu=cortex-m0plus", "-mthumb", "-std=c++20", "-ffreestanding", "-fno-exceptions", "-fsyntax-only",
        "-DSPANLINE_TURNTABLE_FRAMES=0", "-DSPANLINE_TURNTABLE_MODEL=bunny", "-DSPANLINE_TURNTABLE_SHADING=flat",
        *(f"-I{ROOT / folder}" for folder in folders), ROOT / "firmware/apps/turntable.cpp",
    ]  # fmt: skip
    refused = subprocess.run(command, capture_output=True, text=True)
    if refused.returncode == 0 or "static assertion failed" not in refused.stderr:
        raise Failure(f"an app that is too large compiles:\n{refused.stderr}")
    command.remove(f"-I{ROOT / folders[0]}")
    accepted = subprocess.run(command, capture_output=True, text=True)
    if accepted.returncode != 0:
        raise Failure(f"the app does not compile for its own board:\n{accepted.stderr}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--compiler", default="arm-none-eabi-g++")
    arguments = parser.parse_args()
    try:
        for image in ("turntable", "turntable_flat_stops", "turntable_ili9341", "gauges"):
            check_map("pico", image)
        check_map("lm3s6965evb", "turntable")
        check_refusal(arguments.compiler)
    except Failure as failure:
        sys.exit(f"memory_contract.py: {failure}")


if __name__ == "__main__":
    main()
