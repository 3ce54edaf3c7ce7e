`frobc extras` installs third-party Python packages in an environment that belongs to frobc. In this
test, a script stands in for Python, so that no network is needed.

  $ unset VIRTUAL_ENV FROB_PYTHON; export TOP=$PWD XDG_DATA_HOME=$PWD/data
  $ mkdir bin; cp python.sh bin/python3; chmod +x bin/python3; export PATH=$PWD/bin:$PATH
  $ here() { "$@" 2>&1 | sed "s|$PWD/||g"; }

  $ here frobc extras list
  search    frobc falsify
            not installed: run `frobc extras install search`
  mcap      frobc convert with MCAP files from other programs
            not installed: run `frobc extras install mcap`
  ros       frobc convert with ROS 2 bags in MCAP files
            not installed: run `frobc extras install ros`
  jupyter   notebooks
            not installed: run `frobc extras install jupyter`
  cluster   sweeps on a Dask cluster
            not installed: run `frobc extras install cluster`
  $ here frobc extras install search
  Installing cma, numpy in data/frobc
  ok  search    frobc falsify
  $ here frobc extras list | head -n 4
  search    frobc falsify
            numpy 1.0, cma 1.0
  mcap      frobc convert with MCAP files from other programs
            not installed: run `frobc extras install mcap`

Installing another group keeps the installed ones. The old environment is removed when the new one is complete.

  $ here frobc extras install mcap
  Installing cma, mcap, numpy in data/frobc
  ok  search    frobc falsify
  ok  mcap      frobc convert with MCAP files from other programs
  $ ls data/frobc | sed 's/[0-9-]*$//'; cat data/frobc/python/frobc-groups
  python
  python
  search
  mcap

Without names, the same groups are installed again.

  $ here frobc extras install
  Installing cma, mcap, numpy in data/frobc
  ok  search    frobc falsify
  ok  mcap      frobc convert with MCAP files from other programs

The environment finds the Python package of this frobc.

  $ sed 's|.*/share/frobc/|PREFIX/share/frobc/|' data/frobc/python/lib/frobc.pth
  PREFIX/share/frobc/python

If the installation fails or is interrupted, the old environment stays intact.

  $ touch offline; here frobc extras install jupyter; rm offline
  Installing cma, jupyterlab, matplotlib, mcap, numpy, pandas in data/frobc
  error: cannot install cma, jupyterlab, matplotlib, mcap, numpy, pandas: there is no connection to the Python package index
  $ touch hangs; frobc extras install jupyter > out 2>&1 & installing=$!
  $ for k in $(seq 600); do [ -e started ] && break; sleep 0.05; done; kill $installing; wait $installing 2> /dev/null; rm hangs
  $ cat data/frobc/python/frobc-groups; here frobc extras list | head -n 4
  search
  mcap
  search    frobc falsify
            numpy 1.0, cma 1.0
  mcap      frobc convert with MCAP files from other programs
            mcap 1.0
  $ here frobc extras install search > out; ls data/frobc | sed 's/[0-9-]*$//'
  python
  python

A damaged environment is reported, with the command that replaces it.

  $ rm data/frobc/python/bin/python3
  $ here frobc extras list | head -n 2
  search    frobc falsify
            the environment data/frobc/python is damaged, or its Python was removed: run `frobc extras install search`
  $ here frobc extras install; here frobc extras list | head -n 2
  Installing cma, mcap, numpy in data/frobc
  ok  search    frobc falsify
  ok  mcap      frobc convert with MCAP files from other programs
  search    frobc falsify
            numpy 1.0, cma 1.0

Wrong usage, and systems on which the command cannot work:

  $ here frobc extras install serch
  error: there is no group of extras `serch`; the groups are `search`, `mcap`, `ros`, `jupyter` and `cluster`
  $ here env XDG_DATA_HOME=$PWD/empty "$(command -v frobc)" extras install
  error: name the extras to install: `search`, `mcap`, `ros`, `jupyter` and `cluster`
  $ frobc extras remove search 2>&1 | head -n 1
  frobc: ACTION argument: invalid value 'remove', expected either 'install' or
  $ frobc extras list search
  error: `frobc extras list` takes no groups: remove them
  [2]
  $ touch no-venv; here frobc extras install; rm no-venv
  Installing cma, mcap, numpy in data/frobc
  error: `frobc extras` needs Python with the module venv: on Debian, run `sudo apt-get install python3-venv`
  $ here env PATH= "$(command -v frobc)" extras install
  Installing cma, mcap, numpy in data/frobc
  error: `frobc extras` needs Python with the module venv: on Debian, run `sudo apt-get install python3-venv`
  $ here env XDG_DATA_HOME=/dev/null "$(command -v frobc)" extras install search
  error: cannot create the folder /dev/null/frobc: Not a directory; set XDG_DATA_HOME to a folder of your own
  $ here env -u XDG_DATA_HOME -u HOME "$(command -v frobc)" extras install search
  error: HOME is not set: set XDG_DATA_HOME to a folder for the packages

An active virtual environment is used instead.

  $ mkdir -p mine/bin; cp bin/python3 mine/bin; export VIRTUAL_ENV=$PWD/mine
  $ here frobc extras list | head -n 2
  search    frobc falsify
            not installed in the active virtual environment: run `pip install numpy cma`, or run `deactivate` and then `frobc extras install search`
  $ printf 'numpy\ncma\n' > mine/bin/packages
  $ here frobc extras list | head -n 2
  search    frobc falsify
            numpy 1.0, cma 1.0
  $ rm mine/bin/python3
  $ here frobc extras list | tail -n 1
            the active virtual environment mine is damaged, or its Python was removed: run `deactivate`
