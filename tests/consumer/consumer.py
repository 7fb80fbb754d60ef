#!/usr/bin/env python3
"""Builds the cube of README.md as another project would, in one of the three ways to take Spanline in, and runs it: its
picture must have the CRC that every machine gives."""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "tests/qemu"))
import machine  # noqa: E402

WAYS = ("add_subdirectory", "fetch_content", "find_package")
BOARD = "mps2-an386"


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit(f"failed: {' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def build(source, folder, *options):
    """Configures anew, so that what CMake remembers hides nothing, and builds what has changed."""
    run("cmake", "--fresh", "--no-warn-unused-cli", "-G", "Ninja", "-S", source, "-B", folder, *options)
    run("cmake", "--build", folder, "--parallel", "2")


def install(work, *options):
    """The libraries, installed and then moved: nothing in them may say where they have been. The prefix."""
    build(ROOT, work / "libraries", "-DSPANLINE_LIBRARIES_ONLY=ON", *options)
    for prefix in ("installed", "moved"):
        shutil.rmtree(work / prefix, ignore_errors=True)
    run("cmake", "--install", work / "libraries", "--prefix", work / "installed")
    (work / "installed").rename(work / "moved")
    return work / "moved"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("way", choices=WAYS)
    parser.add_argument("target", choices=("host", "cortex_m4"))
    parser.add_argument("--build-type", default="", help="as for CMake; none by default, as for its newcomers")
    parser.add_argument("--cube", required=True, type=pathlib.Path, help="folder of the cube's readme_example.hpp")
    parser.add_argument("--crc", required=True, help="of the picture")
    parser.add_argument("--work", required=True, type=pathlib.Path, help="folder to build in")
    arguments = parser.parse_args()

    work = arguments.work
    options = [f"-DCMAKE_BUILD_TYPE={arguments.build_type}"]
    options.append(f"-DCMAKE_PROJECT_spanline_INCLUDE={HERE / 'no_searching.cmake'}")
    if arguments.target == "cortex_m4":
        options.append(f"-DCMAKE_TOOLCHAIN_FILE={HERE / 'cortex_m4/toolchain.cmake'}")
    if arguments.way == "find_package":
        taken_from = [f"-DCMAKE_PREFIX_PATH={install(work, *options)}"]
    else:
        taken_from = [f"-DSPANLINE_FOLDER={ROOT}"]
    build(HERE / arguments.way, work / "cube", f"-DCUBE_FOLDER={arguments.cube}", *options, *taken_from)

    program = work / "cube/cube"
    said = run(program) if arguments.target == "host" else machine.run(BOARD, program, 60).console
    print(said, end="")
    if not re.fullmatch(rf"spanline \d+\.\d+\.\d+, the cube: {arguments.crc}\n", said):
        sys.exit(f"expected the cube {arguments.crc}")


if __name__ == "__main__":
    main()
