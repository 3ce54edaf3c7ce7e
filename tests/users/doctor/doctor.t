`frobc doctor` checks everything that a command may need. Its last lines depend on the computer,
so this test selects lines.

  $ unset CC VIRTUAL_ENV FROB_PYTHON; export HOME=$PWD/home XDG_CACHE_HOME=$PWD/cache XDG_DATA_HOME=$PWD/data
  $ frobc=$(command -v frobc); prefix=$(dirname "$(dirname "$frobc")"); mkdir none
  $ look() { # NAMES, COMMAND...
  >   names=$1; shift
  >   "$@" > found 2>&1; echo "status $?"
  >   grep -E "^(ok  |note|FAIL)  ($names)  " found | sed "s|$PWD/||g; s|$prefix|PREFIX|g; s|[^ ]*/compiler/frobc/main.exe|FROBC|g; s|$(frobc --version)|VERSION|g"
  > }
  $ look 'frobc|installation|C compiler|cache' frobc doctor
  status 0
  ok    frobc            VERSION, FROBC
  ok    installation     PREFIX
  ok    C compiler       cc handles generated code correctly
  ok    cache            cache/frobc
  $ cut -c 1-22 found | sed 's/^\(ok  \|note\)/....  /' | tail -n +6 | tr -s ' ' | xargs -n 8
  .... extras search .... extras mcap .... extras
  ros .... extras jupyter .... extras cluster ....
  browser .... fonts .... AprilTags .... JPEG ....
  gzip .... zstd .... serial ports .... aarch64
  .... Cortex-M .... boot loader .... ROS

Without a C compiler and without Python, frobc still works.

  $ look 'C compiler|Python|extras search|gzip|zstd' env PATH=$PWD/none "$frobc" doctor
  status 0
  ok    C compiler       PREFIX/lib/frobc/frob-tcc, which comes with frobc, handles generated code correctly; programs with C files need another one: run `sudo apt-get install gcc libc6-dev`
  note  Python           for `frobc falsify` and notebooks: run `sudo apt-get install python3-venv`
  note  extras search    for frobc falsify: not installed: run `frobc extras install search`
  note  gzip             for recordings named .gz: run `sudo apt-get install gzip`
  note  zstd             for recordings named .zst: run `sudo apt-get install zstd`

A C compiler that does not work:

  $ look 'C compiler' env CC=false frobc doctor
  status 1
  FAIL  C compiler       false does not handle generated code correctly (the C compiler cannot compile a one-line program: `false -std=c99 -O2 -ffp-contract=off` failed with status 1): set the environment variable CC to another compiler; `frobc selftest` shows the details

Another frobc on the PATH:

  $ mkdir other; printf '#!/bin/sh\necho 9.9.9\n' > other/frobc; chmod +x other/frobc
  $ look 'frobc' env PATH="$PATH:$PWD/other" "$frobc" doctor
  status 0
  note  frobc            this is frobc VERSION at FROBC, but the PATH has another version: other/frobc is 9.9.9; remove one of them, or put the folder of the one that you want first in the PATH

A home folder that cannot be written:

  $ look 'cache' env XDG_CACHE_HOME=/dev/null "$frobc" doctor
  status 0
  note  cache            cannot write to /dev/null/frobc, so every command compiles from scratch: set XDG_CACHE_HOME to a folder of your own
  $ XDG_DATA_HOME=/dev/null frobc extras install search
  error: cannot create the folder /dev/null/frobc: Not a directory; set XDG_DATA_HOME to a folder of your own
  [2]

A host that is missing, damaged, for another architecture, or for a newer C library:

  $ mkdir -p home/lib/frobc; ln -s "$prefix/share" home/share; ln -s "$prefix"/lib/frobc/* home/lib/frobc
  $ with_simulator() { look 'installation' env FROB_HOME=$PWD/home frobc doctor; }
  $ rm home/lib/frobc/frob-sim; with_simulator
  status 1
  FAIL  installation     home/lib/frobc/frob-sim is missing: reinstall frobc
  $ printf '\177ELF' > home/lib/frobc/frob-sim; chmod +x home/lib/frobc/frob-sim; with_simulator
  status 1
  FAIL  installation     home/lib/frobc/frob-sim is for another processor architecture: build frobc from its sources with `make`
  $ cat > home/lib/frobc/frob-sim <<'END'
  > #!/bin/sh
  > echo "frob-sim: /lib/libc.so.6: version \`GLIBC_2.99' not found (required by frob-sim)" >&2
  > exit 1
  > END
  $ with_simulator
  status 1
  FAIL  installation     the C library of this system is older than the one that frobc was built with (frob-sim: /lib/libc.so.6: version `GLIBC_2.99' not found (required by frob-sim)): use a newer system, or build frobc from its sources with `make`
  $ cat > home/lib/frobc/frob-sim <<'END'
  > #!/bin/sh
  > echo "frob-sim: error while loading shared libraries: libbox2d.so: cannot open shared object file" >&2
  > exit 127
  > END
  $ with_simulator
  status 1
  FAIL  installation     frob-sim: error while loading shared libraries: libbox2d.so: cannot open shared object file: reinstall frobc

A virtual environment whose Python was removed:

  $ look 'extras search' env VIRTUAL_ENV=$PWD/gone frobc doctor
  status 0
  note  extras search    for frobc falsify: the active virtual environment gone is damaged, or its Python was removed: run `deactivate`

A desktop without a program that opens the browser:

  $ look 'browser' env PATH=$PWD/none DISPLAY=:9 "$frobc" doctor
  status 0
  note  browser          for opening the page of `frobc view`: run `sudo apt-get install xdg-utils`
  $ look 'browser' env -u DISPLAY -u WAYLAND_DISPLAY "$frobc" doctor
  status 0
  note  browser          there is no desktop: `frobc view` prints the address of the page; on another computer, type `ssh -L PORT:127.0.0.1:PORT THIS_COMPUTER` and open that address

ROS in this terminal:

  $ look 'ROS' env ROS_DISTRO=jazzy "$frobc" doctor
  status 0
  ok    ROS              jazzy
  $ look 'ROS' env -u ROS_DISTRO AMENT_PREFIX_PATH=/opt/mine "$frobc" doctor
  status 0
  ok    ROS              an unnamed distribution (AMENT_PREFIX_PATH)
