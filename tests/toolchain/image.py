#!/usr/bin/env python3
"""Builds core, hal and firmware as CMake does without a build type, not optimised and with a frame pointer, by gcc or
clang; runs the kernels against their twins and the self-test on its board; each must do what it does optimised."""

import argparse
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/qemu"))
import machine  # noqa: E402

# At -O0 every variable has a place of its own on the stack, of which these boards have 8,192 bytes.
STACK = 6000


def run(*command):
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit(f"failed: {' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def build(compiler, board, work):
    """The folder of the images."""
    preset = machine.BOARDS[board]["preset"]
    by = {
        "gcc": ["--preset", preset],
        "clang": ["-G", "Ninja", f"--toolchain={ROOT}/tests/toolchain/clang.cmake", f"-DSPANLINE_PRESET={preset}"],
    }
    images = work / "firmware"
    options = ["-DCMAKE_BUILD_TYPE=", "-DSPANLINE_WERROR=ON", f"-DSPANLINE_FIRMWARE_DIR={images}"]
    run("cmake", *by[compiler], "-S", ROOT, "-B", work, *options)
    run("cmake", "--build", work, "--parallel", "2", "--target", f"kernel_twins-{board}", f"selftest-{board}", "spanline_hal")
    return images / board


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("compiler", choices=("gcc", "clang"))
    parser.add_argument("board")
    parser.add_argument("host", help="the program that draws the self-test's scenes here")
    parser.add_argument("--work", required=True, type=pathlib.Path, help="folder to build in")
    arguments = parser.parse_args()

    board = arguments.board
    images = build(arguments.compiler, board, arguments.work)
    python = [sys.executable, "-B"]
    print(run(*python, "tests/qemu/run.py", board, images / "kernel_twins.elf", "--timeout", "200"), end="")
    limits = ["--pictures", "100", "--stack", str(STACK), "--timeout", "400"]
    print(run(*python, "tests/firmware/selftest.py", board, images / "selftest.elf", arguments.host, *limits), end="")


if __name__ == "__main__":
    main()
