#!/usr/bin/env python3
"""Every header that programs include opens with an example, and each example compiles for the host without a warning.

An example stands in the comment at the head of its header, between ```cpp and ```. It is compiled behind an #include of that header
and what of example_context.hpp it names: as the body of a function, or as a file where it has functions or templates of its own.
"""

import re
import subprocess
import sys

import house

# Folders whose headers programs include, and the headers there that only others of Spanline include.
PUBLIC = ("core/spanline/frame", "core/spanline/model", "hal/spanline/hal")
INTERNAL = {f"core/spanline/frame/{name}.hpp" for name in ("band_drawer", "frame_pools", "instance_plan", "shader_choice", "shader_set",
                                                                "submissions", "surface_maker")}

EXAMPLE = re.compile(r"^ *///? ?```cpp\n(.*?)^ *///? ?```$", re.MULTILINE | re.DOTALL)
COMMENT_MARK = re.compile(r"^ *///? ?", re.MULTILINE)
# The head of a file ends where its code begins.
CODE = re.compile(r"^(?!\s*//|\s*#|\s*namespace\b|\s*$)", re.MULTILINE)
# A function or a template at the margin.
FILE_SCOPE = re.compile(r"^(template\b|[\w:]+[^;={}]*\)( const)?( noexcept)? \{$)", re.MULTILINE)
CONTEXT = re.compile(r"\b(renderer|send)\b")

COMPILER = ["g++", "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Wno-unused", "-Werror", "-Icore", "-Ihal"]
COMPILER += ["-Itests/structure", "-xc++", "-"]


def examples(header):
    """The examples of a header's head, and their lines there."""
    text = header.read_text()
    head = text[: CODE.search(text).start()]
    for found in EXAMPLE.finditer(head):
        yield head[: found.start(1)].count("\n") + 1, COMMENT_MARK.sub("", found[1])


def program(header, line, example):
    """A source file around an example, whose errors name the header's lines."""
    name = header.relative_to(house.ROOT)
    includes = re.findall(r"^#include .*$", example, re.MULTILINE)
    body = f'#line {line} "{name}"\n' + re.sub(r"^#include .*$", "", example, flags=re.MULTILINE)
    text = f'#include "{header}"\n' + "".join(f"{include}\n" for include in includes)
    if CONTEXT.search(example):
        text += '#include "example_context.hpp"\n'
    text += "namespace spanline::literals {}\nusing namespace spanline;\nusing namespace spanline::literals;\n"
    if FILE_SCOPE.search(example):
        return text + body
    return text + f"void example() {{\n{body}\n}}\n"


def fault_of(task):
    done = subprocess.run(COMPILER, cwd=house.ROOT, input=program(*task), capture_output=True, text=True)
    return done.stderr if done.returncode else None


def main():
    headers = house.headers(*PUBLIC) + [house.ROOT / path for path in ("core/spanline/memory/capacity.hpp", "core/spanline/version.hpp")]
    tasks = [(header, line, example) for header in headers for line, example in examples(header)]
    with_example = {header for header, _, _ in tasks}
    names = [str(header.relative_to(house.ROOT)) for header in headers if header not in with_example]
    faults = [f"{name}: opens without an example" for name in names if name not in INTERNAL]
    faults += [f"{name}: is no header here" for name in INTERNAL if not (house.ROOT / name).is_file()]
    faults += [fault for fault in house.in_parallel(fault_of, tasks) if fault]
    house.report(len(tasks), "examples", faults)


if __name__ == "__main__":
    sys.exit(main())
