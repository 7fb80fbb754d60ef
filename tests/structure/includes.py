#!/usr/bin/env python3
"""Who includes whom: the table of design.md, section 2, held against every #include."""

import re
import sys

import house

FREESTANDING = """algorithm array bit climits compare concepts cstddef cstdint initializer_list iterator limits new span
string_view
tuple type_traits utility arm_acle.h""".split()  # the last is gcc's own

CORE = "core/spanline/"
WAIST = [CORE + f"raster/{name}.hpp" for name in ("span", "surface_blocks", "link", "polygon_corners", "screen_vertex")]
CORE_ROOMS = [CORE + room for room in ("memory", "math", "model", "pixel", "raster", "cpu", "world", "geometry", "visibility", "shade",
                                       "finish", "frame")]

# Room, and what it may include beside itself: rooms (folders) or single headers. First match wins.
RULES = {
    CORE + "version.hpp": [],
    CORE + "memory": [],
    CORE + "math": [],
    CORE + "model": [CORE + "memory", CORE + "math"],
    CORE + "pixel": [CORE + "math", CORE + "model/colour.hpp"],
    CORE + "raster": [CORE + "memory", CORE + "math"],
    CORE + "cpu": [CORE + "math", CORE + "raster", CORE + "pixel"],
    CORE + "world": [CORE + "memory", CORE + "math", CORE + "model", CORE + "raster"],
    CORE + "geometry": [CORE + "memory", CORE + "math", CORE + "model", CORE + "raster", CORE + "cpu"],
    CORE + "visibility": [CORE + "memory", CORE + "math", CORE + "raster", CORE + "pixel", CORE + "cpu", CORE + "world"],
    # Shaders fill linear functions of (x, y), read the words that a vertex carries, and tell the triangles of a polygon's fan
    # apart for ids: raster lends all three beside the waist.
    CORE + "shade": [*WAIST, CORE + "raster/linear_function.hpp", CORE + "raster/vertex_shade.hpp",
                     CORE + "raster/texture_vertex.hpp", CORE + "raster/make_surface.hpp", CORE + "raster/fan_diagonals.hpp", CORE + "math",
                     CORE + "model", CORE + "pixel", CORE + "cpu"],
    CORE + "finish": [CORE + "math", CORE + "model", CORE + "pixel"],
    CORE + "frame": CORE_ROOMS,
    "hal": [],
    "firmware/boards": ["hal"],
    "firmware/scenes": ["core"],
    "firmware/apps": ["core", "hal", "firmware/scenes", "firmware/boards", "build/generated"],
    "firmware/toolchains": [],
    "host_sim": ["core", "hal", "firmware/scenes"],
}
# The rooms that get along with the freestanding part of the standard library, and nothing else in angle brackets.
FREESTANDING_ROOMS = ("core", "hal", "firmware")
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)


def inside(path, folder):
    return path == folder or path.startswith(folder + "/")


def room_of(path):
    return next((room for room in RULES if inside(path, room)), None)


def include_roots():
    """Folders that an #include may start from."""
    boards = [f"firmware/boards/{path.name}" for path in (house.ROOT / "firmware/boards").glob("*") if path.is_dir()]
    return ["core", "hal", "host_sim", "firmware", "firmware/scenes", "firmware/apps", *boards]


def resolve(including, name, roots):
    """The file of this repository that an #include means, or None."""
    folders = [str(including.parent.relative_to(house.ROOT)), *roots]
    return next((f"{folder}/{name}" for folder in folders if (house.ROOT / folder / name).is_file()), None)


def fault_of(path, name, target):
    """What is wrong with this #include, or None."""
    room = room_of(path)
    if target is None:
        generated = room == "firmware/apps" and name in ("bunny.hpp", "teapot.hpp", "sans_14.hpp")
        allowed = not path.startswith(FREESTANDING_ROOMS) or name in FREESTANDING or generated
        return None if allowed else "is neither in the repository nor in the freestanding library"
    if inside(target, room) or any(inside(target, allowed) for allowed in RULES[room]):
        return None
    return f"is {target}, which {room} may not include"


def main():
    roots, checked, faults = include_roots(), 0, []
    for file in house.sources("core", "hal", "firmware", "host_sim"):
        path = str(file.relative_to(house.ROOT))
        if room_of(path) is None:
            faults.append(f"{path}: lies in no room of design.md")
            continue
        for found in INCLUDE.finditer(file.read_text()):
            checked += 1
            name = found[2]
            fault = fault_of(path, name, resolve(file, name, roots))
            if fault:
                faults.append(f"{path}: <{name}> {fault}")
    house.report(checked, "includes", faults)


if __name__ == "__main__":
    sys.exit(main())
