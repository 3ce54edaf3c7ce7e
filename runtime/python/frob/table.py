"""The C description of a compiled program, as declared in frob/program.h."""

from __future__ import annotations

import ctypes as c

ABI = 14
SYMBOL = "frob_program"

BOOL, INT, FLOAT, SINGLE, ROUNDED, PRODUCT, SUM, ARRAY, IMAGE = range(9)
"""Kinds of values."""

BUTTON, HOLD, KNOB, TOGGLE, MAP, CAMERA = range(6)
"""Kinds of controls on an operator's console."""


class Value(c.Structure):
    pass


class Field(c.Structure):
    _fields_ = [("name", c.c_char_p), ("value", c.POINTER(Value))]


class Constructor(c.Structure):
    _fields_ = [
        ("name", c.c_char_p),
        ("is_record", c.c_int),
        ("count", c.c_size_t),
        ("fields", c.POINTER(Field)),
    ]


Value._fields_ = [
    ("kind", c.c_int),
    ("offset", c.c_size_t),
    ("is_event", c.c_int),
    ("count", c.c_size_t),
    ("constructors", c.POINTER(Constructor)),
]


class Control(c.Structure):
    _fields_ = [
        ("kind", c.c_int),
        ("label", c.c_char_p),
        ("unit", c.c_char_p),
        ("least", c.c_double),
        ("most", c.c_double),
        ("first", c.c_double),
        ("value", c.POINTER(Value)),
        ("place", c.c_char_p),
    ]


class Param(c.Structure):
    _fields_ = [("name", c.c_char_p), ("unit", c.c_char_p), ("value", c.POINTER(Value))]


class Claim(c.Structure):
    _fields_ = [
        ("label", c.c_char_p),
        ("column", c.c_char_p),
        ("place", c.c_char_p),
        ("is_assumption", c.c_int),
        ("value", c.POINTER(Value)),
    ]


class Program(c.Structure):
    _fields_ = [
        ("abi", c.c_uint),
        ("name", c.c_char_p),
        ("robot", c.c_char_p),
        ("state_size", c.c_size_t),
        ("input_size", c.c_size_t),
        ("output_size", c.c_size_t),
        ("input", c.POINTER(Value)),
        ("output", c.POINTER(Value)),
        ("reset", c.CFUNCTYPE(None, c.c_void_p, c.c_void_p)),
        ("step", c.CFUNCTYPE(None, *[c.c_void_p] * 2, c.c_int64, c.c_double, *[c.c_void_p] * 2)),
        ("is_valid", c.CFUNCTYPE(c.c_bool, c.c_void_p)),
        ("arithmetic", c.CFUNCTYPE(c.c_uint)),
        ("result", c.POINTER(Value)),
        ("machines", c.c_void_p),
        ("machine_count", c.c_size_t),
        ("probes", c.POINTER(Value)),
        ("console", c.POINTER(Control)),
        ("control_count", c.c_size_t),
        ("default_params", c.c_void_p),
        ("params_size", c.c_size_t),
        ("params", c.POINTER(Param)),
        ("param_count", c.c_size_t),
        ("claims", c.POINTER(Claim)),
        ("claim_count", c.c_size_t),
        ("node", c.c_void_p),
    ]
