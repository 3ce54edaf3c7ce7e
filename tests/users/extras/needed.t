Each command that lacks a Python package names the command that installs it.
Here, Python has no third-party packages.

  $ unset VIRTUAL_ENV FROB_PYTHON; export XDG_DATA_HOME=$PWD/data
  $ mkdir bin; printf '#!/bin/sh\nexec /usr/bin/python3 -S "$@"\n' > bin/python3; chmod +x bin/python3
  $ export PATH=$PWD/bin:$PATH
  $ cat > cruise.frob <<END
  > main :: SF Float Float
  > main = proc x -> x where
  >     assert "small" (x < 2)
  > END
  $ frobc falsify cruise.frob --input "in=0 to 3"
  error: falsify needs numpy and cma, which are not installed: run `frobc extras install search`; or search at random (`--method random`), which takes more runs and needs only numpy
  [2]
  $ frobc falsify cruise.frob --input "in=0 to 3" --method random
  error: falsify needs numpy, which is not installed: run `frobc extras install search`
  [2]

An MCAP file of another program:

  $ printf '\211MCAP0\r\n\001\020\0\0\0\0\0\0\0\004\0\0\0ros2\004\0\0\0test' > other.mcap
  $ frobc convert other.mcap other.csv
  error: cannot read other.mcap: it was written by another program, and reading it needs Python packages: run `frobc extras install mcap`
  [2]

Without Python:

  $ PATH= "$(command -v frobc)" falsify cruise.frob
  error: frobc falsify needs Python 3: on Debian, run `sudo apt-get install python3-venv`, then `frobc extras install search`
  [2]
  $ PATH= "$(command -v frobc)" convert other.mcap other.csv
  error: cannot read other.mcap: it was written by another program, and reading it needs Python: on Debian, run `sudo apt-get install python3-venv`, then `frobc extras install mcap`
  [2]
