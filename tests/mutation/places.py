"""Where core can be changed by a little: every comparison, constant and shift that a host build compiles.

Comparisons take in their bound or leave it out, or turn into their contrary; constants are off by one; shifts go one bit
further. A mutation is known by what it changes, not by a line number, so that it stays the same while lines move.
"""

import hashlib
import pathlib
import re
from dataclasses import dataclass

COMPARISONS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
TOKEN = re.compile(
    r"""(?<=\s)(?P<comparison><=|>=|==|!=|<|>)(?=\s)
      | (?<=\s)(?P<shift><<=|>>=|<<|>>)(?=\s)
      | (?<![\w.'])(?P<constant>0[xX][0-9a-fA-F']+|[0-9][0-9']*)(?P<suffix>[uUlL]*)(?![\w.'])""",
    re.VERBOSE,
)
# Texts and comments; what they hold is not code.
QUIET = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])+\'|//[^\n]*|/\*.*?\*/|\[\[.*?\]\]', re.DOTALL)
SKIPPED_LINES = re.compile(r"^\s*(#|static_assert|template|requires|using namespace)")
MOST_A_LINE = 3  # of constants: tables are not the whole of core


@dataclass(frozen=True)
class Mutation:
    path: str  # from the repository's root
    text: str  # the line, without blanks around it and without a comment behind it
    nth: int  # of the lines of the file that read so, counted from 0
    column: int  # in `text`
    before: str
    after: str

    @property
    def room(self):
        return pathlib.PurePath(self.path).parts[2]

    @property
    def changed(self):
        return self.text[: self.column] + self.after + self.text[self.column + len(self.before) :]

    def rank(self, seed):
        """Its place in the draw: a number that depends on nothing but the seed and the mutation."""
        return hashlib.sha256(f"{seed}|{self.path}|{self.text}|{self.nth}|{self.column}|{self.after}".encode()).digest()

    def line_in(self, source):
        """The number of its line in a source, counted from 1; None if it is not there."""
        found = [i for i, text in enumerate(texts(source), 1) if text == self.text]
        return found[self.nth] if self.nth < len(found) else None

    def applied_to(self, source):
        lines = source.splitlines(keepends=True)
        at = self.line_in(source) - 1
        lines[at] = lines[at].replace(self.text, self.changed, 1)
        return "".join(lines)


def blanked(source):
    """The source with blanks in the place of texts, comments and attributes."""
    return QUIET.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), source)


def texts(source):
    """The lines of a source without blanks around them and without comments behind them."""
    return [line[: len(code.rstrip())].strip() if code.strip() else ""
            for line, code in zip(source.splitlines(), blanked(source).splitlines())]


def compiled_lines(source):
    """For each line whether a host compiles it: what is for a core of its own is not."""
    alive, lines = [True], []
    taken = [True]  # whether a branch of the condition has been compiled
    for line in source.splitlines():
        directive = re.match(r"\s*#\s*(if|ifdef|ifndef|elif|else|endif)\b(.*)", line)
        if directive:
            word, condition = directive[1], directive[2]
            true = holds(condition)
            if word in ("if", "ifdef", "ifndef"):
                alive.append(alive[-1] and true)
                taken.append(true)
            elif word == "elif":
                alive[-1] = alive[-2] and not taken[-1] and true
                taken[-1] = taken[-1] or true
            elif word == "else":
                alive[-1] = alive[-2] and not taken[-1]
            else:
                alive.pop()
                taken.pop()
        lines.append(alive[-1] and not directive)
    return lines


def holds(condition):
    """Whether a condition is met on a host: macros of Arm and RISC-V are not defined there; any other may be."""
    text = re.sub(r"defined\s*\(?\s*(__(?:ARM|arm|thumb|riscv)\w*)\s*\)?", "False", condition)
    if text == condition:
        return True
    text = re.sub(r"defined\s*\(?\s*\w+\s*\)?", "True", text)
    text = text.replace("&&", " and ").replace("||", " or ").replace("!", " not ")
    return bool(eval(text, {"__builtins__": {}}))  # nothing but these words is left of the project's own conditions


def after(kind, token, suffix, odd):
    """What a token becomes; `odd` chooses where there are two ways."""
    if kind == "comparison":
        return COMPARISONS[token]
    if kind == "shift":
        return f"{token} 1 +" if token.endswith("=") else f"{token} 1 {token}"
    number = int(token.replace("'", ""), 0)
    changed = number + 1 if number == 0 or odd else number - 1
    return (hex(changed) if token[:2].lower() == "0x" else str(changed)) + suffix


def places_in(path, source):
    """Every mutation of one source."""
    found, seen = [], {}
    lines = zip(source.splitlines(), texts(source), blanked(source).splitlines(), compiled_lines(source))
    for line, text, code, compiled in lines:
        nth = seen.get(text, 0)
        seen[text] = nth + 1
        if not compiled or SKIPPED_LINES.match(code):
            continue
        indent = len(line) - len(line.lstrip())
        constants = 0
        for token in TOKEN.finditer(code):
            kind = token.lastgroup if token.lastgroup != "suffix" else "constant"
            if kind == "constant":
                constants += 1
                if constants > MOST_A_LINE or re.match(r"0\d", token["constant"]):
                    continue
            digest = hashlib.sha256(f"{path}|{text}|{token.start()}".encode()).digest()
            change = after(kind, token[kind], token["suffix"] or "", digest[0] & 1)
            found.append(Mutation(path, text, nth, token.start() - indent, token[0], change))
    return found


def places(root):
    """Every mutation of core."""
    return [
        mutation
        for path in sorted((root / "core/spanline").rglob("*"))
        if path.suffix in (".hpp", ".cpp")
        for mutation in places_in(path.relative_to(root).as_posix(), path.read_text())
    ]


def in_order(mutations, seed, a_room):
    """The order of the draw: first `a_room` of every room that has as many, then the rest, each by its rank."""
    ranked = sorted(mutations, key=lambda mutation: mutation.rank(seed))
    rooms = {}
    for mutation in ranked:
        rooms.setdefault(mutation.room, []).append(mutation)
    return {room: listed for room, listed in sorted(rooms.items()) if len(listed) >= a_room}, ranked
