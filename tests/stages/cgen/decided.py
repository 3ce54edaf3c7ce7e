"""Reports conditions whose value an enclosing branch has decided: `if (t1)` or
`t1 ?` inside `if (t1)`.

Usage: decided.py FILE.c...
"""

import re
import sys


def variable(condition):
    """The variable that a condition consists of, and its value in the first branch."""
    found = re.fullmatch(r"(?:FROB_BRANCH\()?(!?)(\w+)\)?", condition)
    return (found[2], found[1] == "") if found else (None, True)


for path in sys.argv[1:]:
    decided = []  # for each open brace: the decided variable or None
    with open(path) as file:
        for number, line in enumerate(file, 1):
            code = re.sub(r"/\*.*?\*/", "", line)
            for word in re.findall(r"\b(\w+) \?|if \(!?(\w+)\)", code):
                name = word[0] or word[1]
                if name in decided:
                    print(f"{path}:{number}: `{name}` is decided here")
            for brace in re.finditer(r"[{}]", code):
                if brace[0] == "}":
                    last = decided.pop() if decided else None
                else:
                    start = code[: brace.start()]
                    opened = re.search(r"\bif \((.*)\) $", start)
                    if opened:
                        decided.append(variable(opened[1])[0])
                    else:
                        decided.append(last if start.strip().endswith("else") else None)
