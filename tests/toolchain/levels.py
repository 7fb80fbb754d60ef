#!/usr/bin/env python3
"""What of core depends on the instruction set compiles without a warning by gcc and clang, for every core, at every
level of optimisation, with a frame pointer and without; and for two cores a renderer with textures, and hal."""

import glob
import itertools
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/structure"))
import house  # noqa: E402

# The C++ headers of the newest version; clang has none of its own for this target.
HEADERS = sorted(glob.glob("/usr/include/newlib/c++/*"))[-1:]
FOLDERS = [folder for header in HEADERS for folder in (header, f"{header}/arm-none-eabi")] + ["/usr/include/newlib"]
COMPILERS = {
    "gcc": ["arm-none-eabi-g++"],
    "clang": ["clang++", "--target=arm-none-eabi", *(f"-isystem{folder}" for folder in FOLDERS)],
}
COMMON = ["-std=c++20", "-mthumb", "-mfloat-abi=soft", "-ffreestanding", "-fno-exceptions", "-fno-rtti"]
COMMON += ["-fno-threadsafe-statics", "-Wall", "-Wextra", "-Wconversion", "-Wsign-conversion", "-Wshadow"]
COMMON += ["-Wdouble-promotion", "-Werror", "-Icore", "-Ihal", "-Ifirmware", "-Ifirmware/boards/common"]
COMMON += ["-Ifirmware/boards/cortex_m", "-Ifirmware/boards/mps2", "-c", "-o", "/dev/null"]
LEVELS = ("-O0", "-Og", "-O1", "-O2", "-O3", "-Os")
# Every level with a frame pointer, which takes a register away; those that differ most without.
WAYS = [(level, "-fno-omit-frame-pointer") for level in LEVELS]
BOTH_WAYS = WAYS + [(level, "-fomit-frame-pointer") for level in ("-O0", "-O2", "-Os")]
KERNELS, RENDERER, HAL = "firmware/apps/kernel_twins.cpp", "tests/toolchain/renderer.cpp", "hal/src/instantiate.cpp"
# One core of each instruction set; a Cortex-M7 has that of an M4, and its own schedule.
CORES = ("cortex-m0plus", "cortex-m3", "cortex-m4", "cortex-m33")


def tasks():
    yield from itertools.product(COMPILERS, CORES, BOTH_WAYS, [KERNELS])
    yield from itertools.product(COMPILERS, ["cortex-m7"], WAYS[:1], [KERNELS])
    yield from itertools.product(COMPILERS, ["cortex-m0plus", "cortex-m4"], WAYS, [RENDERER, HAL])


def compile_one(task):
    """What the compiler says against it, or nothing."""
    compiler, core, way, source = task
    command = [*COMPILERS[compiler], *COMMON, f"-mcpu={core}", *way, source]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    return f"{' '.join(command)}:\n{done.stderr}" if done.returncode or done.stderr else None


def main():
    if not HEADERS:
        sys.exit("the C++ headers are missing: install libstdc++-arm-none-eabi-dev")
    every = list(tasks())
    house.report(len(every), "compilations", [fault for fault in house.in_parallel(compile_one, every) if fault])


if __name__ == "__main__":
    sys.exit(main())
