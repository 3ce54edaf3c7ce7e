"""Runs Frob programs from Python: compiles, steps, runs, simulates and sweeps them, and reads
recordings."""

from .data import Data
from .errors import CompileError, Error, FrobWarning, InputError
from .falsification import Counterexample, falsify
from .program import Program, compile
from .recording import Assertion, Columns, read
from .simulation import Picture, simulate
from .sweeps import sweep

__all__ = [
    "Assertion",
    "Columns",
    "CompileError",
    "Counterexample",
    "Data",
    "Error",
    "FrobWarning",
    "InputError",
    "Picture",
    "Program",
    "compile",
    "falsify",
    "read",
    "simulate",
    "sweep",
]
