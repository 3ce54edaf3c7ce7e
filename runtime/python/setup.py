"""The wheel is for a kind of machine, as it carries frobc, and for no version of Python."""

from setuptools import Distribution, setup
from setuptools.command.bdist_wheel import bdist_wheel


class ForAMachine(Distribution):
    def has_ext_modules(self) -> bool:
        return True


class ForAnyPython(bdist_wheel):
    def get_tag(self) -> "tuple[str, str, str]":
        return "py3", "none", super().get_tag()[2]


setup(distclass=ForAMachine, cmdclass={"bdist_wheel": ForAnyPython})
