#!/usr/bin/env python3
"""Changes core by a little, many times over, and sees whether the tests notice.

Some sixty mutations are drawn by seed, five at least from every room of core/spanline that has as many places. Each is
built in a copy of the tree under build/mutate, one program of tests after the other, those of its own room first, until
one fails: the mutation is killed. One that none kills survives, and is listed. Those of equivalents.txt are known to
change nothing that anybody could see and do not count; those of named.txt lived once and are tried every time.

Results are kept in build/mutate/results.json: --resume goes on where a run was stopped, and tries survivors again.
"""

import argparse
import hashlib
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import dataclass

import places

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = ROOT / "tests/mutation"
TREE = ROOT / "build/mutate"
BUILD = TREE / "build/host-release"
RESULTS = TREE / "results.json"
BASELINE = TREE / "baseline.json"
RECORD = ROOT / "docs/mutants.md"

# Programs of tests that know core, those that fail most often for their time first, and the program of each room.
PROGRAMS = ("golden", "unit_core_geometry", "unit_core_raster", "unit_core_frame", "unit_core_shade", "unit_core_visibility",
            "contract", "unit_core_model", "unit_core_math", "unit_core_lectures", "selftest", "fuzz_bytes")
OF_ROOM = {"finish": "unit_core_shade", "pixel": "unit_core_shade", "cpu": "unit_core_shade", "memory": "unit_core_frame", "world": "unit_core_frame"}

MOST_MEMORY = 8 << 30
MOST_WALL_SECONDS = 1800  # for threads that wait for one another


copied = False


def the_tree():
    """Where sources are read: from the copy once there is one, since the tree may be edited while a run goes on."""
    return TREE if copied else ROOT


class Failure(Exception):
    """Something that no test can be blamed for."""


def copy_tree():
    """Brings the copy up to date; files that would not change keep their dates, so that little is compiled again."""
    listing = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT, check=True,
                             capture_output=True, text=True).stdout
    wanted = {name for name in listing.split("\0") if name and (ROOT / name).is_file()}
    for folder in ("core", "hal", "host_sim", "firmware", "tests"):
        for path in (TREE / folder).rglob("*"):
            if path.is_file() and path.relative_to(TREE).as_posix() not in wanted:
                path.unlink()
    for name in wanted:
        source, copy = ROOT / name, TREE / name
        if not copy.is_file() or copy.read_bytes() != source.read_bytes():
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, copy)
    global copied
    copied = True
    (TREE / "build").mkdir(exist_ok=True)


def put(path, text):
    """Writes what is not there already: dates tell what must be compiled."""
    if path.read_text() != text:
        path.write_text(text)


def configure():
    done = subprocess.run(["cmake", "--preset", "host-release", "-DSPANLINE_UNIT_TESTS=ON", "-DSPANLINE_CROSS_TESTS=OFF",
                           f"-DSPANLINE_GENERATED={ROOT / 'build/generated'}"], cwd=TREE, capture_output=True, text=True)
    if done.returncode != 0:
        raise Failure(f"the copy cannot be configured:\n{done.stdout}{done.stderr}")


def build(program, jobs):
    """What the compiler says against a program; nothing if it was built."""
    done = subprocess.run(["cmake", "--build", BUILD, "--target", program, "--", "-j", str(jobs)], capture_output=True, text=True)
    return None if done.returncode == 0 else done.stdout + done.stderr


def path_of(program):
    found = [path for path in BUILD.rglob(program) if path.is_file() and os.access(path, os.X_OK)]
    if len(found) != 1:
        raise Failure(f"{program}: {len(found)} programs of that name")
    return found[0]


def run(program, most_seconds):
    """Why a program of tests failed, nothing if it did not; and the processor time that it took. Processor time bounds
    it, which does not depend on what else the machine does."""
    def limited():
        resource.setrlimit(resource.RLIMIT_CPU, (most_seconds, most_seconds))
        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [path_of(program), "--gtest_fail_fast", "--gtest_brief=1"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                          cwd=BUILD, preexec_fn=limited, start_new_session=True) as child:
        try:
            output = child.communicate(timeout=MOST_WALL_SECONDS)[0]
            code = child.returncode
        except subprocess.TimeoutExpired:
            os.killpg(child.pid, signal.SIGKILL)
            return "does not come to an end", 0
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = used.ru_utime + used.ru_stime - before.ru_utime - before.ru_stime
    if code == 0:
        return None, seconds
    failed = [line.split("]")[1].split("(")[0].split(", where")[0].strip() for line in output.splitlines() if "[  FAILED  ]" in line]
    if failed:
        return failed[0], seconds
    return "does not come to an end" if -code in (signal.SIGXCPU, signal.SIGKILL) else f"ends with {code}", seconds


def programs_for(room):
    own = OF_ROOM.get(room, f"unit_core_{room}")
    return [own, *(program for program in PROGRAMS if program != own)]


@dataclass
class Verdict:
    state: str  # killed, survived or stillborn
    by: str = ""


def judge(mutation, programs, baseline):
    """Tries one mutation in the copy with these programs of tests, and takes it back. A program is tried as it is before
    its first mutant."""
    path = TREE / mutation.path
    source = path.read_text()
    try:
        for program in programs:
            if program not in baseline.seconds:
                put(path, source)
                baseline.measure(program)
            put(path, mutation.applied_to(source))
            errors = build(program, baseline.jobs)
            if errors is not None:
                if "static assertion failed" in errors:
                    return Verdict("killed", "a static assertion")
                return Verdict("stillborn")
            reason, _ = run(program, baseline.seconds[program])
            if reason is not None:
                return Verdict("killed", f"{program}: {reason}")
        return Verdict("survived")
    finally:
        put(path, source)


class Baseline:
    """How much processor time a program of mutated tests may take: five times what it takes as it is, where it must
    pass. Kept on disk while the tree stays the same."""

    def __init__(self, jobs):
        self.jobs = jobs
        digest = hashlib.sha256()
        for path in sorted(path for folder in ("core", "firmware", "host_sim", "tests") for path in (ROOT / folder).rglob("*.[hc]pp")):
            digest.update(path.read_bytes())
        self.digest = digest.hexdigest()
        kept = json.loads(BASELINE.read_text()) if BASELINE.is_file() else {}
        self.seconds = kept["seconds"] if kept.get("digest") == self.digest else {}

    def measure(self, program):
        errors = build(program, self.jobs)
        if errors is not None:
            raise Failure(f"{program} cannot be built as it is:\n{errors}")
        reason, taken = run(program, 3600)
        if reason is not None:
            raise Failure(f"{program} fails as it is: {reason}")
        self.seconds[program] = int(20 + 5 * taken)
        BASELINE.write_text(json.dumps({"digest": self.digest, "seconds": self.seconds}) + "\n")
        print(f"{program}: passes in {taken:.1f} s of processor time", flush=True)


def read_table(name, stale=None):
    """The mutations of a table, each with its reason. An entry is `path`, `line`, `changed line`, `reason`, one a line,
    with a blank line behind. What is about lines that are gone is left out, and goes to `stale`."""
    listed, stale = {}, [] if stale is None else stale
    entries = "\n".join(line for line in (HERE / name).read_text().splitlines() if not line.startswith("#")).split("\n\n")
    tree = the_tree()
    for entry in filter(None, (entry.strip("\n") for entry in entries)):
        path, text, changed, *reason = entry.split("\n")
        if not reason:
            raise Failure(f"{name}: an entry without a reason: {text}")
        source = (tree / path).read_text() if (tree / path).is_file() else ""
        if text not in places.texts(source):
            stale.append(f"{name}: {path} has no line {text!r} any more")
            continue
        listed[path, text, changed] = " ".join(reason)
    return listed


def stale_entries():
    """Entries of the tables about lines that are gone."""
    stale = []
    for name in ("named.txt", "equivalents.txt"):
        read_table(name, stale)
    return stale


def key(mutation):
    return mutation.path, mutation.text, mutation.changed


def named_mutations():
    """The mutations of named.txt, each with the program of tests that kills it: the first word of its reason."""
    return [(places.Mutation(path, text, 0, 0, text, changed), reason.split()[0])
            for (path, text, changed), reason in read_table("named.txt").items()]


def place_of(mutation):
    return f"{mutation.path}:{mutation.line_in((the_tree() / mutation.path).read_text())}"


class Results:
    """What was found out so far, on disk."""

    def __init__(self, resumed):
        self.known = json.loads(RESULTS.read_text()) if resumed and RESULTS.is_file() else {}

    def of(self, mutation):
        """Survivors are tried again: there may be a test for them by now."""
        state, by = self.known.get(self._name(mutation), ("survived", ""))
        return None if state == "survived" else Verdict(state, by)

    def note(self, mutation, verdict):
        self.known[self._name(mutation)] = (verdict.state, verdict.by)
        RESULTS.write_text(json.dumps(self.known, indent=1) + "\n")

    @staticmethod
    def _name(mutation):
        return "\n".join((*key(mutation), str(mutation.nth)))


class Run:
    """One draw and what became of it."""

    def __init__(self, arguments, results, baseline):
        self.arguments, self.results, self.baseline = arguments, results, baseline
        self.equivalents = read_table("equivalents.txt")
        self.judged, self.equivalent, self.stillborn, self.skipped = [], [], 0, []
        self.tried = set()
        self.started = time.monotonic()

    def take(self, mutation, programs=None):
        """Judges a mutation; whether it counts. All programs that know its room try it, or those that are given."""
        if (key(mutation), mutation.nth) in self.tried:
            return False
        self.tried.add((key(mutation), mutation.nth))
        if key(mutation) in self.equivalents:
            self.equivalent.append(mutation)
            return False
        verdict = self.results.of(mutation)
        if verdict is None:
            started = time.monotonic()
            verdict = judge(mutation, programs or programs_for(mutation.room)[: self.arguments.programs], self.baseline)
            self.results.note(mutation, verdict)
            print(f"{verdict.state}{f' by {verdict.by}' if verdict.by else ''}, {time.monotonic() - started:.0f} s: "
                  f"{place_of(mutation)}\n  {mutation.text}\n  {mutation.changed}", flush=True)
        if verdict.state == "stillborn":
            self.stillborn += 1
            return False
        self.judged.append((mutation, verdict))
        return True

    def take_draw(self):
        every = places.places(the_tree())
        rooms, ranked = places.in_order(every, self.arguments.seed, self.arguments.a_room)
        self.skipped = sorted({mutation.room for mutation in every} - set(rooms))
        # One of each room in turn, so that a run that is stopped has seen every room.
        queues, counted = {room: iter(listing) for room, listing in rooms.items()}, dict.fromkeys(rooms, 0)
        while queues and not self.is_late():
            for room in list(queues):
                mutation = next(queues[room], None)
                if mutation is None or counted[room] == self.arguments.a_room:
                    del queues[room]
                elif not self.is_late():
                    counted[room] += self.take(mutation)
        for mutation in ranked:
            if len(self.judged) >= self.arguments.count or self.is_late():
                break
            self.take(mutation)

    def is_late(self):
        return self.arguments.minutes is not None and time.monotonic() - self.started > 60 * self.arguments.minutes

    def survivors(self):
        return [mutation for mutation, verdict in self.judged if verdict.state == "survived"]

    def share(self):
        return 1 - len(self.survivors()) / max(1, len(self.judged))


def listed(mutations, reason=None):
    for mutation in mutations:
        yield f"- `{place_of(mutation)}`: `{mutation.text}` → `{mutation.changed}`" + (f" — {reason(mutation)}" if reason else "")


def report(draw, named):
    """The result as a page of the documentation."""
    rooms = {}
    for mutation, verdict in draw.judged:
        killed, drawn = rooms.get(mutation.room, (0, 0))
        rooms[mutation.room] = (killed + (verdict.state == "killed"), drawn + 1)
    killed = len(draw.judged) - len(draw.survivors())
    arguments = draw.arguments
    quicker = f" --programs {arguments.programs}" if arguments.programs < len(PROGRAMS) else ""
    lines = [
        "# Mutants",
        "",
        "Core is changed by a little, one place at a time, and the tests have to notice. Written by",
        f"`script/mutate --seed {arguments.seed} --count {arguments.count}{quicker} --record`, which repeats it; `tests/mutation/mutate.py` says how.",
        "",
        f"**{killed} of {len(draw.judged)} mutants are killed ({100 * draw.share():.1f} %)**, of {len(places.places(the_tree()))} places; "
        f"{len(draw.equivalent)} more that were drawn change nothing that anybody could see, and {draw.stillborn} do not compile.",
        *([f"No more than {arguments.programs} programs of tests were tried on each: others may kill survivors too."]
          if arguments.programs < len(PROGRAMS) else []),
        *([f"The run was stopped: {arguments.count} were asked for."] if len(draw.judged) < arguments.count else []),
        *([f"Rooms with too few places: {', '.join(draw.skipped)}."] if draw.skipped else []),
        f"Of {len(named)} that lived once (`tests/mutation/named.txt`), {sum(v.state == 'killed' for _, v in named)} are killed.",
        "",
        "| room | killed | drawn |",
        "|---|---|---|",
        *(f"| {room} | {k} | {n} |" for room, (k, n) in sorted(rooms.items())),
        "",
        "## Survivors",
        "",
        *(list(listed(draw.survivors())) or ["None."]),
        "",
        "## Equivalents",
        "",
        *(list(listed(draw.equivalent, lambda mutation: draw.equivalents[key(mutation)])) or ["None."]),
        "",
        "## Killed",
        "",
        *(f"- `{place_of(m)}`: `{m.before}` → `{m.after}` by {v.by}" for m, v in draw.judged if v.state == "killed"),
        "",
    ]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=15, help="of the draw (15)")
    parser.add_argument("--count", type=int, default=60, help="mutants that are judged (60)")
    parser.add_argument("--a-room", type=int, default=5, help="of these, from every room at least (5)")
    parser.add_argument("--minutes", type=float, help="begin no other mutant after so many, and report what there is")
    parser.add_argument("--programs", type=int, default=len(PROGRAMS), metavar="N",
                        help="try the first N programs of tests alone, which is quicker and finds more survivors (all)")
    parser.add_argument("--least", type=float, default=90, help="per cent that must be killed (90)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="compilers at a time")
    parser.add_argument("--resume", action="store_true", help="keep what the last run killed")
    parser.add_argument("--named", action="store_true", help="those of named.txt alone")
    parser.add_argument("--list", action="store_true", help="print the draw and do nothing")
    parser.add_argument("--record", action="store_true", help=f"write the result to {RECORD.relative_to(ROOT)}")
    arguments = parser.parse_args()
    if arguments.list:
        rooms, ranked = places.in_order(places.places(the_tree()), arguments.seed, arguments.a_room)
        for mutation in dict.fromkeys([m for listing in rooms.values() for m in listing[: arguments.a_room]] + ranked[: arguments.count]):
            print(f"{place_of(mutation)}\n  {mutation.text}\n  {mutation.changed}")
        return
    try:
        copy_tree()
        named = named_mutations()
        configure()
        draw = Run(arguments, Results(arguments.resume), Baseline(arguments.jobs))
        for mutation, program in named:
            draw.take(mutation, [program])
        named, draw.judged = draw.judged, []
        if not arguments.named:
            draw.take_draw()
    except Failure as failure:
        sys.exit(f"mutate.py: {failure}")
    text = report(draw, named)
    print(text)
    if arguments.record:
        RECORD.write_text(text)
    alive = [mutation for mutation, verdict in named if verdict.state != "killed"]
    if stale := stale_entries():
        sys.exit("mutate.py: " + "\nmutate.py: ".join(stale))
    if alive:
        sys.exit("mutate.py: named mutants live:\n" + "\n".join(listed(alive)))
    if 100 * draw.share() < arguments.least:
        sys.exit(f"mutate.py: less than {arguments.least:g} % are killed")


if __name__ == "__main__":
    main()
