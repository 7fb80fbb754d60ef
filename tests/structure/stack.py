#!/usr/bin/env python3
"""Bounds the stack of a program: the deepest path of calls from a function, from what gcc's -fcallgraph-info=su says.

Fails above the limit, on recursion, on frames without a fixed size, on calls through pointers that --indirect does not
explain, and on functions whose frame nobody knows.
"""

import argparse
import pathlib
import re
import subprocess
import sys
from dataclasses import dataclass, field

# libgcc's routines come without call graph. Their stack in bytes, their own calls counted in, read off the disassembly
# of the Armv6-M ones (gcc 12.2), which take more than the Armv7-M ones.
LIBGCC = {
    **{"__aeabi_ldivmod": 96, "__aeabi_uldivmod": 72, "__divdi3": 48, "__udivdi3": 56, "__udivmoddi4": 56},
    **dict.fromkeys(["__aeabi_lmul", "__muldi3"], 28),
    **dict.fromkeys(["__aeabi_uidiv", "__aeabi_idiv", "__aeabi_uidivmod", "__aeabi_idivmod"], 8),
    **dict.fromkeys(["__clzsi2", "__clzdi2", "__aeabi_llsl", "__aeabi_llsr", "__aeabi_lasr"], 8),
}
# Functions that are assembly alone, of whose frames gcc knows nothing: nine registers and what they keep besides
# (core/spanline/cpu/armv6m/flat_rows.hpp, ramp_rows.hpp, transform_vertices.hpp).
NAKED = {
    **{"armv6m9ramp_rows": 9 * 4 + 32, "armv6m15flat_rows_short": 9 * 4 + 24, "armv6m14flat_rows_long": 9 * 4 + 24},
    "armv6m18transform_by_words": 10 * 4,
}
INDIRECT = "__indirect_call"

NODE = re.compile(r'^node: \{ title: "(?P<title>[^"]+)" label: "(?P<label>[^"]*)"')
EDGE = re.compile(r'^edge: \{ sourcename: "(?P<source>[^"]+)" targetname: "(?P<target>[^"]+)"')
FRAME = re.compile(r"\\n(\d+) bytes \((static|dynamic|dynamic,bounded)\)")


class Failure(Exception):
    pass


@dataclass
class Function:
    name: str
    frame: int | None = None
    dynamic: bool = False
    calls: set = field(default_factory=set)


def read_graph(files):
    """All functions of these call graphs by gcc's name for them."""
    functions = {}
    for file in files:
        for line in file.read_text(errors="replace").splitlines():
            if node := NODE.match(line):
                function = functions.setdefault(node["title"], Function(node["title"]))
                naked = next((size for name, size in NAKED.items() if name in node["title"]), None)
                if naked is not None:
                    function.frame = naked
                elif frame := FRAME.search(node["label"]):
                    function.name = node["label"].split("\\n")[0]
                    function.frame = max(int(frame[1]), function.frame or 0)
                    function.dynamic |= frame[2] == "dynamic"
            elif edge := EDGE.match(line):
                for title in (edge["source"], edge["target"]):
                    functions.setdefault(title, Function(title))
                functions[edge["source"]].calls.add(edge["target"])
    return functions


def one_constructor(functions):
    """gcc emits one body for a class's two forms of a constructor (C1 and C2) and calls it by either name."""
    for title in [t for t, f in functions.items() if f.frame is None]:
        twin = re.sub(r"(C1|D1)(?=E)", lambda found: found[0][0] + "2", title)
        if twin != title and twin in functions:
            functions[title] = functions[twin]
    return functions


def explicit_instances(functions):
    """Where gcc instantiates a template explicitly, it puts the file before the name of the function; a call from another
    file names the function alone."""
    with_file = {title.rpartition(":")[2]: function for title, function in functions.items() if ":" in title and function.frame is not None}
    for title in [t for t, f in functions.items() if f.frame is None and t in with_file]:
        functions[title] = with_file[title]
    return functions


def plain_name(title):
    """A function's name without its class, templates and parameters, from its mangled one."""
    mangled = re.sub(r"\.part\.\d+$", "", title.rpartition(":")[2])
    text = subprocess.run(["c++filt", mangled], check=True, capture_output=True, text=True).stdout.strip()
    depth, name = 0, ""
    for letter in text:
        if letter == "(" and depth == 0:
            break
        depth += (letter == "<") - (letter == ">")
        name = name + letter if depth == 0 and (letter.isalnum() or letter == "_") else ""
    return name


def folded_parts(functions):
    """gcc splits functions (`.part.0`), emits identical parts of a template's instances once, and names any of them where
    it calls one: such a part is at most the deepest of its name in its file. The known ones for each that is unknown."""
    parts = [title for title in functions if re.search(r"\.part\.\d+$", title)]
    unknown = [title for title in parts if functions[title].frame is None]
    if not unknown:
        return {}
    keys = {title: (title.rpartition(":")[0], plain_name(title)) for title in parts}
    known = [title for title in parts if functions[title].frame is not None]
    found = {title: [other for other in known if keys[other] == keys[title]] for title in unknown}
    return {title: others for title, others in found.items() if others}


class Bound:
    def __init__(self, functions, indirect):
        self.functions = functions
        self.indirect = indirect
        self.folded = folded_parts(functions)
        self.known = {}
        self.path = []

    def callees(self, title):
        """The titles that a function may call, calls through pointers replaced by what --indirect says."""
        for target in sorted(self.functions[title].calls):
            if target != INDIRECT:
                yield target
                continue
            name = self.functions[title].name
            patterns = [callee for caller, callee in self.indirect if re.search(caller, name)]
            if not patterns:
                raise Failure(f"{name} calls through a pointer that --indirect does not explain")
            for other, function in self.functions.items():
                if any(re.search(pattern, function.name) for pattern in patterns):
                    yield other

    def deepest(self, title):
        """Bytes below a function's caller, and the path that takes them as (name, frame) pairs."""
        if title in self.known:
            return self.known[title]
        if title in self.path:
            raise Failure(f"recursion: {' > '.join(self.functions[t].name for t in [*self.path, title])}")
        function = self.functions[title]
        if function.frame is None:
            if title in self.folded:
                return max((self.deepest(twin) for twin in self.folded[title]), key=lambda b: b[0])
            if title not in LIBGCC:
                raise Failure(f"nobody knows the frame of {title}, called by {self.functions[self.path[-1]].name}")
            return LIBGCC[title], [(title, LIBGCC[title])]
        if function.dynamic:
            raise Failure(f"the frame of {function.name} has no fixed size")
        self.path.append(title)
        below = max((self.deepest(callee) for callee in self.callees(title)), default=(0, []), key=lambda b: b[0])
        self.path.pop()
        self.known[title] = function.frame + below[0], [(function.name, function.frame), *below[1]]
        return self.known[title]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path, help="folders with gcc's .ci files")
    parser.add_argument("--entry", required=True, metavar="REGEX", help="the functions to bound, by their signature")
    parser.add_argument("--limit", required=True, type=int, metavar="BYTES")
    parser.add_argument("--indirect", action="append", nargs=2, default=[], metavar=("CALLER", "CALLEE"))
    arguments = parser.parse_args()

    files = [file for folder in arguments.folders for file in sorted(folder.rglob("*.ci"))]
    functions = explicit_instances(one_constructor(read_graph(files)))
    entries = [t for t, f in functions.items() if f.frame is not None and re.search(arguments.entry, f.name)]
    if not entries:
        sys.exit(f"stack.py: no function matches {arguments.entry!r} in {len(files)} call graphs")
    bound = Bound(functions, arguments.indirect)
    try:
        total, path = max((bound.deepest(entry) for entry in entries), key=lambda b: b[0])
    except Failure as failure:
        sys.exit(f"stack.py: {failure}")
    for name, frame in path:
        print(f"{frame:6}  {name}")
    print(f"{total:6}  bytes in all, at most {arguments.limit}")
    if total > arguments.limit:
        sys.exit(1)


if __name__ == "__main__":
    main()
