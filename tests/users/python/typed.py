"""A user's script for mypy: the type of `run`'s result depends on its inputs, and each line marked
`# wrong` must be an error."""

from typing import Any, Dict, List

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from typing_extensions import assert_type

import frob

p = frob.compile("cruise.frob", params={"most": 1})
assert_type(p.run(np.zeros(3), dt=0.1), NDArray[Any])
assert_type(p.run({"in": [1.0]}, dt=0.1), Dict[str, NDArray[Any]])
assert_type(p.run(pd.DataFrame({"in": [1.0]}), dt=0.1), pd.DataFrame)
assert_type(p.run([1.0], dt=0.1), List[Any])
assert_type(frob.simulate("go.frob", duration=3.5), pd.DataFrame)
assert_type(frob.read("log.csv"), pd.DataFrame)
assert_type(frob.sweep("gaps.toml", picture=True), pd.DataFrame)
p.step("soon", 1)  # wrong
frob.compile("cruise.frob", {})  # wrong
p.run("text", dt=1)  # wrong
frob.sweep("gaps.toml", jobs="two")  # wrong
