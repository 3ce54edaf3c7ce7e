"""Sets the version and the tag of the wheel, which pyproject.toml cannot set.

The wheel contains frobc, so it is specific to one kind of machine, but works with any version of
Python.
"""

import re
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.bdist_wheel import bdist_wheel


def version() -> str:
    """Returns the version in dune-project. In a checkout, that file is two folders up; wheel.sh
    copies it next to this file.
    """
    here = Path(__file__).resolve().parent
    for folder in (here, here.parent.parent):
        project = folder / "dune-project"
        if project.is_file():
            found = re.search(r"^\(version (.+)\)$", project.read_text(), re.MULTILINE)
            if found:
                return found[1]
    raise SystemExit("setup.py: no dune-project with a (version ...) here or two folders up")


class ForAMachine(Distribution):
    def has_ext_modules(self) -> bool:
        return True


class ForAnyPython(bdist_wheel):
    def get_tag(self) -> "tuple[str, str, str]":
        return "py3", "none", super().get_tag()[2]


setup(version=version(), distclass=ForAMachine, cmdclass={"bdist_wheel": ForAnyPython})
