"""Runs the tests of a file, and prints one line for all of them."""

import sys
import unittest


def main(what):
    program = unittest.main(module="__main__", exit=False, verbosity=0, argv=sys.argv)
    result = program.result
    bad = len(result.failures) + len(result.errors)
    for case, _ in result.failures + result.errors:
        print(f"FAIL {what}: {case.id()}")
    for _ in range(result.testsRun - bad):
        print(f"ok   {what}")
    sys.exit(bad > 0)
