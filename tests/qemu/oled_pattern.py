#!/usr/bin/env python3
"""Looks at what firmware/boards/smoke/oled.cpp put on the emulated OLED: grey level (x + 3y) modulo 16."""

import sys

import png
from machine import Failure
from screenshot import require_equal, screenshot


def main():
    image = sys.argv[1]
    levels = ((x + 3 * y) % 16 * 17 for y in range(64) for x in range(128))
    want = png.Picture(128, 64, b"".join(bytes([level] * 3) for level in levels))
    try:
        picture, _ = screenshot("lm3s6965evb", image, "picture complete", timeout=60)
        require_equal(picture.shrunk(4), want)
    except (Failure, ValueError) as failure:
        sys.exit(f"oled_pattern.py: {failure}")


if __name__ == "__main__":
    main()
