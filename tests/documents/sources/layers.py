"""usage: layers.py COMPILER

Prints the dependency cycles between the folders inside each library of the compiler, one line for
each group of folders that reach each other. Modules at the top of a library (its `ir.mli`, the
module that runs its passes) may use every folder and be used by every folder, so they do not count.
"""

import collections
import os
import subprocess
import sys


def modules_of(library):
    """Maps each module of the library to its folder, and lists the source files."""
    folder_of, files = {}, []
    for place, _, names in os.walk(library):
        for name in sorted(names):
            module, extension = os.path.splitext(name)
            if extension in (".ml", ".mli"):
                folder = os.path.relpath(place, library).split(os.sep)[0]
                folder_of[module.capitalize()] = folder
                files.append(os.path.join(place, name))
    return folder_of, files


def uses_of(library):
    """Maps each folder to the folders that it uses, and each such pair to the files that do."""
    folder_of, files = modules_of(library)
    if not files:
        return {}, {}
    listing = subprocess.run(
        ["ocamldep", "-modules", *files], check=True, stdout=subprocess.PIPE, text=True
    ).stdout
    uses, because = collections.defaultdict(set), collections.defaultdict(list)
    for line in listing.splitlines():
        file, _, used = line.partition(":")
        here = folder_of[os.path.splitext(os.path.basename(file))[0].capitalize()]
        for module in used.split():
            there = folder_of.get(module, here)
            if "." not in (here, there) and here != there:
                uses[here].add(there)
                because[here, there].append(os.path.basename(file))
    return uses, because


def reachable(uses, start):
    seen, waiting = set(), [start]
    while waiting:
        for folder in uses.get(waiting.pop(), ()):
            if folder not in seen:
                seen.add(folder)
                waiting.append(folder)
    return seen


def main():
    compiler = sys.argv[1]
    for name in sorted(os.listdir(compiler)):
        library = os.path.join(compiler, name)
        if not os.path.isdir(library):
            continue
        uses, because = uses_of(library)
        reach = {folder: reachable(uses, folder) for folder in list(uses)}
        groups = {
            tuple(sorted(other for other in reach[f] if f in reach.get(other, ())))
            for f in reach
            if f in reach[f]
        }
        for group in sorted(groups):
            print(f"{name}: {', '.join(group)}")
            if "--files" in sys.argv:
                for pair in sorted(because):
                    if pair[0] in group and pair[1] in group:
                        print(f"    {pair[0]} -> {pair[1]}: {' '.join(sorted(set(because[pair])))}")


if __name__ == "__main__":
    main()
