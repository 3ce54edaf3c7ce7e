"""usage: repair.py AUDITWHEEL_ARGUMENTS...

Runs auditwheel, but assumes that users' computers have only the libraries of glibc and gcc. The
standard policies also assume some desktop libraries, which small systems do not have.
"""

import json
import sys
import tempfile
from pathlib import Path

import auditwheel.policy
from auditwheel.libc import Libc
from auditwheel.main import main

DESKTOP = "libatomic libX libICE libSM libGL libgobject libgthread libglib libexpat libz".split()

if __name__ == "__main__":
    policies = auditwheel.policy._POLICY_JSON_MAP
    rules = json.loads(policies[Libc.GLIBC].read_text())
    for rule in rules:
        rule["lib_whitelist"] = [
            name for name in rule["lib_whitelist"] if not name.startswith(tuple(DESKTOP))
        ]
    with tempfile.TemporaryDirectory() as folder:
        policies[Libc.GLIBC] = Path(folder) / "policy.json"
        policies[Libc.GLIBC].write_text(json.dumps(rules))
        sys.exit(main())
