"""Plants faults that a person might make into the text of a Frob program. Finds all possible
faults, each with a description. The modified program may not compile.

Only the controller is changed: the text before the first trial or test, without imports, types,
units and assertions. The code that judges a controller stays unchanged.
"""

import re

TOKEN = re.compile(
    r"""(?P<comment>--(?![-+*/<>=&|]).*)|(?P<text>"(?:[^"\\]|\\.)*")
    |(?P<number>\d+(?:\.\d+)?)(?P<unit>\[[^\]]*\])?|(?P<quoted>`\w+`)|(?P<name>[A-Za-z_][\w']*)
    |(?P<operator>[-+*/<>=&|.$:!^]+)|(?P<other>\S)""",
    re.VERBOSE,
)
KEYWORDS = set("if then else case of do let in where proc returnA param import not".split())
TURNED = {"<": ">", ">": "<", "<=": ">=", ">=": "<=", "==": "/=", "/=": "=="}
CONNECTED = {"&&": "||", "||": "&&"}
SIGNS = {"+": "-", "-": "+"}
OTHER_UNITS = {"m": "cm", "cm": "m", "s": "min", "min": "s", "deg": "rad", "m/s": "cm/s"}
EXCHANGED = [
    ("left", "right"), ("sideSonar", "rightSonar"), ("frontSonar", "sideSonar"),
    ("floorLeft", "floorRight"), ("bumped", "bumpedBehind"), ("here", "there"), ("min", "max"),
    ("x", "y"), ("sin", "cos"), ("True", "False"), ("fst", "snd"),
]  # fmt: skip


class Token:
    """A token of the program: its kind, its text, and its start and end."""

    def __init__(self, match):
        self.kind = match.lastgroup if match.lastgroup != "unit" else "number"
        self.text, self.start, self.end = match.group(), match.start(), match.end()
        self.digits, self.unit = match.group("number"), match.group("unit")


def closing(tokens, opened):
    """Returns the index of the token that closes this parenthesis."""
    depth = 0
    for at in range(opened, len(tokens)):
        depth += {"(": 1, ")": -1}.get(tokens[at].text, 0)
        if depth == 0:
            return at
    return len(tokens) - 1


def definitions(program):
    """Returns the tokens of each definition of the controller."""
    end = re.search(r"^(trial|test) ", program, re.MULTILINE).start()
    starts = [m.start() for m in re.finditer(r"^\S", program[:end], re.MULTILINE)] + [end]
    for start, stop in zip(starts, starts[1:]):
        if re.match(r"(import|unit|data|--)", program[start:stop]):
            continue
        tokens = [Token(m) for m in TOKEN.finditer(program, start, stop)]
        kept = without_what_judges(program, [t for t in tokens if t.kind != "comment"])
        if kept:
            yield kept


def without_what_judges(program, tokens):
    """Removes the tokens of signatures and assertions."""
    kept, at = [], 0
    while at < len(tokens):
        token = tokens[at]
        following = tokens[at + 1].text if at + 1 < len(tokens) else ""
        if token.text in ("assert", "assume") and following.startswith('"'):
            at = closing(tokens, at + 2) + 1
        elif following == "::":
            line_end = program.index("\n", token.start)
            at += 2
            while at < len(tokens) and tokens[at].start < line_end and tokens[at].text != "=":
                at += 1
        else:
            kept.append(token)
            at += 1
    return kept


def faults(program):
    """Maps each kind to its faults: lists of (start, end, replacement)."""
    found = {}

    def add(kind, start, end, instead):
        found.setdefault(kind, []).append((start, end, instead))

    for tokens in definitions(program):
        names = sorted({t.text for t in tokens if t.kind == "name"} - KEYWORDS)
        for at, token in enumerate(tokens):
            text, start, end = token.text, token.start, token.end
            before = tokens[at - 1].text if at else ""
            after = tokens[at + 1].text if at + 1 < len(tokens) else ""
            if token.kind == "number":
                unit = token.unit or ""
                if float(token.digits):
                    for factor in (2, 0.5, -1):
                        value = float(token.digits) * factor
                        written = f"{value:g}" if "." not in token.digits else str(value)
                        instead = f"({written}{unit})" if factor < 0 else written + unit
                        add("a constant scaled", start, end, instead)
                    if unit[1:-1] in OTHER_UNITS:
                        other = f"{token.digits}[{OTHER_UNITS[unit[1:-1]]}]"
                        add("another unit", start, end, other)
            elif text in TURNED:
                add("a comparison turned", start, end, TURNED[text])
            elif text in CONNECTED:
                add("&& and || swapped", start, end, CONNECTED[text])
            elif text in SIGNS:
                unary = before in ("", "(", ",", "=", "then", "else")
                add("a sign flipped", start, end, "" if unary else SIGNS[text])
            elif text == "if":
                then = next(t for t in tokens[at:] if t.text == "then")
                condition = program[end : then.start].strip()
                add("branches swapped", start, then.start, f"if not ({condition}) ")
            elif text in ("when", "edge") and after == "(":
                last = tokens[closing(tokens, at + 1)].end
                condition = program[tokens[at + 1].start : last]
                add("an event never", start, last, f"{text} (False && {condition})")
                add("an event always", start, last, f"{text} (True || {condition})")
            elif token.kind == "name" and text not in KEYWORDS:
                for pair in EXCHANGED:
                    if text in pair:
                        add("left and right exchanged", start, end, pair[pair[0] == text])
                if before != ".":
                    for name in names:
                        if name != text:
                            add("another signal", start, end, name)
            if text == "(" and at + 4 < len(tokens) and tokens[at + 2].text == ",":
                if tokens[at + 4].text == ")":
                    pair = f"({tokens[at + 3].text}, {tokens[at + 1].text})"
                    add("a pair exchanged", start, tokens[at + 4].end, pair)
        for start, end in statements(program, tokens):
            add("a statement left out", start, end, "")
    return found


def statements(program, tokens):
    """Yields the lines of a `do` that can be omitted: plain statements, followed by another
    one.
    """
    lines = list(re.finditer(r"^( +)(.*)\n", program[: tokens[-1].end + 1], re.MULTILINE))
    for line, following in zip(lines, lines[1:]):
        said = line.group(2)
        if line.start() < tokens[0].start or line.end() != following.start():
            continue
        plain = re.match(r"[a-z]", said) and not re.search(r"<-|=|::|\breturn\b", said)
        if plain and len(line.group(1)) == len(following.group(1)):
            yield line.start(), line.end() - 1
