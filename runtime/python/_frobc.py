"""The wheel's `frobc` command. To start quickly, it does not import the package frob."""

import os
import sys
from pathlib import Path


def main() -> None:
    """Replaces this process with frobc, and tells it which Python it was installed for."""
    frobc = str(Path(__file__).resolve().parent / "frob" / "tools" / "bin" / "frobc")
    os.environ.setdefault("FROB_PYTHON", sys.executable)
    try:
        os.execv(frobc, [frobc, *sys.argv[1:]])
    except OSError as error:
        print(
            f"frobc: cannot start {frobc}: {error.strerror}; install it again: "
            f"{sys.executable} -m pip install --force-reinstall frobc",
            file=sys.stderr,
        )
        sys.exit(2)
