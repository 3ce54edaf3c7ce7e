"""Makes random edits to programs, by incremental changes: python3 random_edits.py SEED N FILE...

After each edit it sends requests to the server. The server must survive, and the positions in its
answers must be correct: symbols, tokens and definitions must be where their names are. Sometimes it
also compares the diagnostics with those of `frobc check` on the same text."""

import bisect
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import time

from client import Client

seed, count, files = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3:]
rng = random.Random(seed)
folder = tempfile.mkdtemp()
client = Client(folder, options={"inlayHints": True})

PIECES = [
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    "\n",
    "\n    ",
    " ",
    "=",
    "->",
    "<-",
    "-<",
    "::",
    ",",
    "[m/s]",
    "where",
    "proc x -> ",
    "if ",
    "then ",
    "let ",
    "in ",
    "do\n    ",
    "case x of\n    ",
    "0.3",
    "x",
    "foo",
    "integral ",
    "main",
    "Float",
    "import Control\n",
    "--",
    "{-",
    "-}",
    '"',
    "`",
    "\u00e4",
    "\U0001f916",
    "\u2192",
    "\t",
    "\r\n",
    "\r",
    "\x00",
    "$",
    "delay 0 ",
    "\\x -> ",
]


class Mirror:
    """The text as an editor has it, with positions in UTF-16 units."""

    def __init__(self, text):
        self.text = text
        self.starts = [0] + [m.end() for m in re.finditer("\r\n|\n|\r", text)]

    def position(self, i):
        line = bisect.bisect_right(self.starts, i) - 1
        before = self.text[self.starts[line] : i]
        return {"line": line, "character": len(before.encode("utf-16-le")) // 2}

    def offset(self, p):
        start = self.starts[p["line"]]
        stop = self.starts[p["line"] + 1] if p["line"] + 1 < len(self.starts) else len(self.text)
        units = self.text[start:stop].encode("utf-16-le")[: 2 * p["character"]]
        return start + len(units.decode("utf-16-le"))

    def at(self, range):
        return self.text[self.offset(range["start"]) : self.offset(range["end"])]

    def boundary(self, i):
        """Whether the position is not between the two characters of a line ending."""
        return i + 1 if self.text[i - 1 : i + 1] == "\r\n" else i


def edited(mirror):
    text = mirror.text
    kind = rng.random()
    i = mirror.boundary(rng.randrange(len(text) + 1))
    if kind < 0.4:
        return i, i, rng.choice(PIECES)
    if kind < 0.7:
        return i, mirror.boundary(min(len(text), i + rng.choice([1, 1, 1, 2, 5, 20]))), ""
    if kind < 0.85:
        word = rng.choice(re.findall(r"\w+", text) or ["x"])
        return i, i, word
    j = mirror.boundary(min(len(text), i + rng.randrange(40)))
    return j, j, text[i:j]


def flat(symbols):
    for s in symbols:
        yield s
        yield from flat(s["children"])


def fail(what, mirror, *more):
    path = "failed-%d.frob" % seed
    with open(path, "w", newline="") as file:
        file.write(mirror.text)
    sys.exit("%s; the text is in %s: %s" % (what, path, more))


def check_symbols(uri, mirror):
    for s in flat(client.ask_all("documentSymbol", uri)):
        found = mirror.at(s["selectionRange"])
        # a trial is named by a string
        if found.strip('"') != s["name"] and not s["name"].startswith("instance "):
            fail("a symbol is elsewhere", mirror, s, found)


def check_tokens(uri, mirror):
    data = client.ask_all("semanticTokens/full", uri)["data"]
    line = column = 0
    for i in range(0, len(data), 5):
        column = data[i + 1] + (column if data[i] == 0 else 0)
        line += data[i]
        word = mirror.at(
            {
                "start": {"line": line, "character": column},
                "end": {"line": line, "character": column + data[i + 2]},
            }
        )
        if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_']*|[!#$%&*+./<=>?@\\^|~:-]+", word):
            fail("a token is no word", mirror, line, column, word)


def check_place(uri, mirror):
    """Checks definition and hover of a name."""
    words = list(re.finditer(r"[A-Za-z_][A-Za-z0-9_']*", mirror.text))
    if not words:
        return
    word = rng.choice(words)
    params = {"position": mirror.position(word.start())}
    found = client.ask_all("definition", uri, **params)
    if found and found["uri"] == uri and found["range"]["start"] != found["range"]["end"]:
        if mirror.at(found["range"]) != word.group():
            fail("a definition is elsewhere", mirror, word, found)
    found = client.ask_all("hover", uri, **params)
    if found and found["range"]:
        start, stop = (mirror.offset(found["range"][k]) for k in ("start", "end"))
        if not start <= word.start() <= stop:
            fail("a hover is elsewhere", mirror, word, found)


def others(uri, mirror):
    """Sends requests that only have to be answered."""
    i = rng.randrange(len(mirror.text) + 1)
    params = {"position": mirror.position(i)}
    range = {"start": mirror.position(i), "end": mirror.position(len(mirror.text))}
    rng.choice(
        [
            lambda: client.ask_all("completion", uri, **params),
            lambda: client.ask_all("signatureHelp", uri, **params),
            lambda: client.ask_all("codeAction", uri, range=range, context={"diagnostics": []}),
            lambda: client.ask_all("inlayHint", uri, range=range),
            lambda: client.ask_all("foldingRange", uri),
            lambda: client.ask_all("selectionRange", uri, positions=[params["position"]]),
            lambda: client.ask_all("documentHighlight", uri, **params),
            lambda: client.ask_all(
                "references", uri, **params, context={"includeDeclaration": True}
            ),
            lambda: client.ask_all("formatting", uri, options={}),
            lambda: client.ask_all("codeLens", uri),
        ]
    )()


def check_messages(uri, mirror):
    path = os.path.join(folder, os.path.basename(uri))
    with open(path, "w", newline="") as file:
        file.write(mirror.text)
    said = subprocess.run(["frobc", "check", "--format=json", path], capture_output=True, text=True)
    wanted = []
    for line in said.stderr.splitlines():
        d = json.loads(line)
        start = d["spans"][0]["byte_start"]
        if d["spans"][0]["file_name"] == path:
            before = mirror.text.encode()[:start].decode(errors="ignore")
            wanted.append((d["code"]["code"], mirror.position(len(before))))
    found = [
        (d["code"], d["range"]["start"])
        for d in client.told(uri)
        if not re.match(r"in \w+\.frob: ", d["message"])
    ]
    if sorted(found, key=str) != sorted(wanted, key=str):
        fail("messages differ", mirror, found, wanted)
    os.remove(path)


done = 0
while done < count:
    source = rng.choice(files)
    with open(source, newline="") as file:
        original = file.read()
    uri = client.open(os.path.basename(source), original)
    mirror = Mirror(original)
    for step in range(min(200, count - done)):
        start, stop, text = edited(mirror)
        if rng.random() < 0.1 and mirror.text != original:
            # like a user who notices a mistake
            start, stop, text = 0, len(mirror.text), original
        range_ = {"start": mirror.position(start), "end": mirror.position(stop)}
        client.edit(uri, range_, text)
        mirror = Mirror(mirror.text[:start] + text + mirror.text[stop:])
        done += 1
        rng.choice([check_symbols, check_tokens, check_place, check_place, others, others])(
            uri, mirror
        )
        if done % 50 == 0:
            check_messages(uri, mirror)
    client.notify("textDocument/didClose", {"textDocument": {"uri": uri}})
    for n in client.notifications:
        if n.get("method") == "window/logMessage":
            sys.exit("the server says: %s" % n["params"]["message"])
if client.end() != 0:
    sys.exit("the server ended badly")
print("%d edits" % done)
