The exit status tells scripts what happened; each message names the cause and
the fix.

A correct program:

  $ cat > good.frob <<EOF
  > main :: SF Float Float
  > main = proc x -> 2 * x
  > EOF
  $ frobc check good.frob

A rejected program:

  $ cat > bad.frob <<EOF
  > main :: SF Float Float
  > main = proc x -> 2 * y
  > EOF
  $ frobc check bad.frob
  error[E0205]: unknown name `y`
   --> bad.frob:2:22
    |
  2 | main = proc x -> 2 * y
    |                      ^
  
  1 error
  [1]
  $ frobc check good.frob bad.frob > /dev/null 2>&1
  [1]

A missing file, a folder instead of a file, a file that is not text:

  $ frobc check missing.frob
  error: there is no file missing.frob
  [2]
  $ mkdir folder.frob
  $ frobc check folder.frob
  error: cannot read folder.frob: it is a directory
  [2]
  $ printf '\377\376' > bytes.frob
  $ frobc check bytes.frob
  error[E0101]: this file is not valid UTF-8: byte 255 is not allowed here
   --> bytes.frob:1:1
    |
  1 | ��
    | ^
    |
    = hint: save the file as UTF-8 text
  
  1 error
  [1]

An empty file is an empty module:

  $ touch empty.frob
  $ frobc check empty.frob
  $ frobc compile empty.frob
  error[E0501]: this module has no `main` to compile
   --> empty.frob:1:1
    |
  1 |
    | ^
    |
    = hint: define `main`, or name a signal function of this module with `--entry NAME`
  
  1 error
  [2]

Wrong use:

  $ frobc
  frobc: required COMMAND name is missing, must be one of 'build', 'check', 'compile', 'convert', 'demo', 'doctor', 'explain', 'export', 'extras', 'falsify', 'fix', 'format', 'header', 'help', 'lsp', 'new', 'report', 'ros2', 'run', 'selftest', 'serve', 'sweep', 'test', 'trace' or 'view'.
  Usage: frobc COMMAND …
  Try 'frobc --help' for more information.
  [2]
  $ frobc teleport good.frob
  frobc: unknown command 'teleport', must be one of 'build', 'check', 'compile', 'convert', 'demo', 'doctor', 'explain', 'export', 'extras', 'falsify', 'fix', 'format', 'header', 'help', 'lsp', 'new', 'report', 'ros2', 'run', 'selftest', 'serve', 'sweep', 'test', 'trace' or 'view'.
  Usage: frobc COMMAND …
  Try 'frobc --help' for more information.
  [2]
  $ frobc check
  frobc: required argument FILE is missing
  Usage: frobc check [OPTION]… FILE…
  Try 'frobc check --help' or 'frobc --help' for more information.
  [2]
  $ frobc compile good.frob --dump=everything
  frobc: option '--dump': `everything` is not a stage; the stages are parse,
         resolve, types, core, specialize, passes, flow, step, c
  Usage: frobc compile [OPTION]… FILE
  Try 'frobc compile --help' or 'frobc --help' for more information.
  [2]

A folder that does not exist is created, if possible:

  $ frobc compile good.frob -o made/on/demand && ls made/on/demand
  good.c
  good.h
  $ frobc compile good.frob -o good.frob
  error: cannot create the folder good.frob: there is a file with this name
  [2]
  $ frobc compile good.frob -o good.frob/below
  error: cannot create the folder good.frob/below: Not a directory
  [2]

A missing tool:

  $ CC=no-such-cc frobc trace good.frob --input in.csv
  error: there is no C compiler `no-such-cc`; install one (on Debian: apt-get install gcc), or set the environment variable CC
  [2]

The variable CC names one program, with any name, without options:

  $ mkdir tools && printf '#!/bin/sh\nexec cc "$@"\n' > 'tools/my cc' && cp 'tools/my cc' tools/plain
  $ chmod +x 'tools/my cc'
  $ for cc in tools ./tools /no/such/cc ./tools/plain 'gcc -O2' 'ccache gcc' ' gcc' './tools/no cc' ' '; do
  >   CC=$cc frobc trace good.frob --input in.csv; done
  error: there is no C compiler `tools`; install one (on Debian: apt-get install gcc), or set the environment variable CC
  error: `./tools` is a folder, not a C compiler; install one (on Debian: apt-get install gcc), or set the environment variable CC
  error: there is no C compiler `/no/such/cc`; install one (on Debian: apt-get install gcc), or set the environment variable CC
  error: the C compiler `./tools/plain` cannot be started: it is not executable; run `chmod +x ./tools/plain`
  error: there is no C compiler `gcc -O2`: frobc takes the whole value of CC as the name of one program; set CC to a program without options, or to a script that adds them
  error: there is no C compiler `ccache gcc`: frobc takes the whole value of CC as the name of one program; set CC to a program without options, or to a script that adds them
  error: there is no C compiler ` gcc`: frobc takes the whole value of CC as the name of one program; set CC to a program without options, or to a script that adds them
  error: there is no C compiler `./tools/no cc`; install one (on Debian: apt-get install gcc), or set the environment variable CC
  error: there is no C compiler ` `; install one (on Debian: apt-get install gcc), or set the environment variable CC
  [2]
  $ printf 'time,in\n0,1\n' > in.csv
  $ CC="$PWD/tools/my cc" frobc trace good.frob --input in.csv
  time,out
  0.000000000,2

An unknown robot, and a program without a robot:

  $ frobc check good.frob --robot pioneer
  $ frobc check good.frob --robot roomba
  error: there is no robot `roomba`; the robots are pioneer, scout, create, ros; for your own robot, give the file of its module
  [2]
  $ frobc run good.frob --robot roomba
  error: there is no robot `roomba`; the robots are pioneer, scout, create, ros; for your own robot, give the file of its module
  [2]
  $ frobc run good.frob
  error: good is not a robot program; use `reactimateRobot` to make one
  [2]
  $ frobc build good.frob
  error: good is not a robot program; use `reactimateRobot` to make one
  [2]
  $ frobc build good.frob --target cortex-m
  error: good is not a robot program; use `reactimateRobot` to make one
  [2]
  $ frobc run good.frob --device /dev/null
  error: good is not a robot program; use `reactimateRobot` to make one
  [2]
  $ frobc export good.frob --platformio library
  error: good is not a robot program; use `reactimateRobot` to make one
  [2]

Recursion is also detected in modules without an entry:

  $ echo 'f x = f (x - 1)' > recursive.frob
  $ frobc check recursive.frob 2>&1 | head -1
  error[E0410]: `f` calls itself

Options for robots are rejected without one, and options of the simulator are rejected with one; a
picture that cannot be written prevents the run.

  $ cat > rest.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0 0))
  > FROB
  $ frobc run rest.frob --set max-speed=1
  error: --set only works on a robot: use it with --device or --ros2; to set a parameter of the program, use --param
  [2]
  $ frobc run rest.frob --priority 10
  error: --priority only works on a robot: use it with --device or --ros2
  [2]
  $ frobc run rest.frob --device /dev/null --picture rest.png
  error: --picture only works in the simulator: remove it, or remove --device
  [2]
  $ frobc run rest.frob --picture nowhere/rest.png
  error: cannot write nowhere/rest.png: No such file or directory
  [2]
  $ mkdir taken
  $ frobc build rest.frob -o taken
  error: cannot write taken: it is a directory
  [2]

A write error is reported, and is not a fault of frobc itself. A run whose results nobody could read
has failed. A rejected program is reported as rejected, whether or not somebody reads the reason.

  $ frobc explain E0205 > /dev/full
  error: cannot write to standard output: No space left on device
  [2]
  $ frobc compile good.frob --dump=c > /dev/full
  error: cannot write to standard output: No space left on device
  [2]
  $ frobc header scout >&-
  error: cannot write to standard output: Bad file descriptor
  [2]
  $ frobc run rest.frob --for 1s > /dev/full
  error: cannot write to standard output: No space left on device
  [2]
  $ frobc serve --robot pioneer > /dev/full
  error: cannot write to standard output: No space left on device
  [2]
  $ frobc check bad.frob 2> /dev/full
  [1]
  $ frobc check bad.frob 2>&-
  [1]
