"""Generates the reference pages from their sources: reference.py REPOSITORY FROBC OUT.

library.md       the names in the library, with their comments and signatures, from stdlib/
messages.md      the messages, from their pages in compiler/explain/
commands.md      the commands and options, from frobc --help
"""

import re
import subprocess
import sys
from pathlib import Path


def entries(text):
    """Yields (comment, declaration) for each documented declaration of a module, in order.

    The documentation is the comment `-- |` directly above a declaration. The declaration
    includes the indented lines that follow; for a definition, it is the signature."""
    lines = text.splitlines()
    k = 0
    while k < len(lines):
        if not lines[k].startswith("-- |"):
            k += 1
            continue
        comment = [lines[k][4:].strip()]
        k += 1
        while k < len(lines) and lines[k].startswith("--"):
            comment.append(lines[k][2:].strip())
            k += 1
        first = lines[k] if k < len(lines) else ""
        declaration = [first]
        k += 1
        while (
            k < len(lines)
            and lines[k][:1] in (" ", "}", ")")
            or (
                k < len(lines)
                and not lines[k]
                and first.startswith("class ")
                and k + 1 < len(lines)
                and lines[k + 1].startswith(" ")
            )
        ):
            declaration.append(lines[k])
            k += 1
        yield " ".join(comment), declaration


def names_of(declaration):
    """Returns the names that a declaration declares; a signature may declare several."""
    keyword = re.match(
        r"(?:(primitive|foreign type|foreign|type|unit|data|class) )?", declaration[0]
    ).group(1)
    first = declaration[0].removeprefix(f"{keyword} ")
    if keyword == "class":
        first = re.sub(r"^.*=> ", "", first)
    elif keyword in (None, "primitive", "foreign"):
        return [name.strip("()") for name in first.split(" :: ")[0].split(", ")]
    return [re.match(r"\w+", first).group(0)]


def entry(module, comment, declaration, depth):
    """Returns the entry for a declaration and, for a class, the entries for its methods."""
    names = names_of(declaration)
    heading = ", ".join(f"`{name}`" for name in names)
    # callers do not need the name of the C function
    first = re.sub(r'^foreign (.*) = ".*"$', r"\1", declaration[0])
    code = [re.sub(r"^primitive ", "", first), *declaration[1:]]
    body = []
    if code[0].startswith("class "):
        body, code = code[1:], code[:1]
    out = [
        "#" * depth + f" {heading} {{ #{module}-{names[0]} }}",
        "",
        "```haskell",
        "\n".join(code).rstrip(),
        "```",
        "",
        comment,
        "",
    ]
    methods = "\n".join(line[4:] for line in body)
    # a method without its own comment gets the comment of its class
    methods = re.sub(r"(?<!\S\n)^(?=\w+ :: )", lambda _: f"-- | {comment}\n", methods, flags=re.M)
    for inner in entries(methods):
        out += entry(module, *inner, depth + 1)
    return out


def library(repository):
    """The entries for all names, module by module."""
    out = [
        "# The library, name by name",
        "",
        "This page lists every name in the library with its type and documentation. You can "
        "use the names of the prelude without an import. The appendices of the "
        "[language reference](../language.md) list the names by subject.",
        "",
    ]
    paths = (repository / "stdlib").glob("*.frob")
    for path in sorted(paths, key=lambda p: (p.stem != "Prelude", p.stem)):
        out += [f"## {path.stem}", ""]
        for comment, declaration in entries(path.read_text()):
            out += entry(path.stem, comment, declaration, 3)
    return "\n".join(out)


def messages(repository):
    """The pages of frobc explain, sorted by code."""
    out = [
        "# Messages",
        "",
        "This page contains the output of `frobc explain CODE` for every code.",
        "",
    ]
    for path in sorted((repository / "compiler/explain").glob("*/[EW]*.md"), key=lambda p: p.stem):
        text = re.sub(r"^```frob.*$", "```haskell", path.read_text(errors="replace"), flags=re.M)
        code = path.stem
        text = re.sub(r"^# (.*)$", rf"## {code}: \1 {{ #{code} }}", text, count=1, flags=re.M)
        out += [text.strip(), ""]
    return "\n".join(out)


def help_of(frobc, *command):
    return subprocess.run(
        [frobc, *command, "--help=plain"], check=True, text=True, capture_output=True
    ).stdout


def commands(frobc):
    """The help text of frobc and of each command."""
    whole = help_of(frobc)
    listed = whole[whole.index("\nCOMMANDS") : whole.index("\nCOMMON")]
    names = re.findall(r"^       ([a-z0-9]+) ", listed, flags=re.M)
    out = [
        "# The command line",
        "",
        "This page contains the output of `frobc --help` and `frobc COMMAND --help`.",
        "",
        "## frobc",
        "",
        "```text",
        whole.strip("\n"),
        "```",
        "",
    ]
    for name in names:
        out += [f"## frobc {name}", "", "```text", help_of(frobc, name).strip("\n"), "```", ""]
    return "\n".join(out)


def pages(repository, frobc):
    return {
        "library.md": library(repository),
        "messages.md": messages(repository),
        "commands.md": commands(frobc),
    }


if __name__ == "__main__":
    for page, text in pages(Path(sys.argv[1]), sys.argv[2]).items():
        (Path(sys.argv[3]) / page).write_text(text)
