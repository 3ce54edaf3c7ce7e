A new project immediately runs, checks, is formatted and passes its trials.

  $ frobc new rover
  created rover:
    rover.frob              the program, with a trial that checks its behaviour
    rover.test.frob         more trials
    world.toml              the room in which the trials run
    README.md               the files of the project and the commands to use
    .editorconfig           settings for editors
    .vscode/settings.json   settings for Visual Studio Code
    .gitignore              ignores the files that trials write
  
  next steps:
    cd rover
    frobc run rover.frob --view
    frobc test
  $ cd rover && find . -type f | sort && cat README.md .editorconfig
  ./.editorconfig
  ./.gitignore
  ./.vscode/settings.json
  ./README.md
  ./rover.frob
  ./rover.test.frob
  ./world.toml
  # rover
  
  A robot program in Frob: the robot drives around a room without touching anything.
  
  | | |
  | --- | --- |
  | `rover.frob` | the program, with a trial at its end that checks its behaviour |
  | `rover.test.frob` | more trials; the program is compiled without them |
  | `world.toml` | the room in which the trials run |
  | `.editorconfig`, `.vscode` | settings for editors |
  
  | | |
  | --- | --- |
  | `frobc run rover.frob --picture run.png` | drive for a minute in the simulator |
  | `frobc run rover.frob --view` | show every signal while the robot drives |
  | `frobc test` | run the trials, each with ten noise seeds |
  | `frobc check rover.frob` | check the program for mistakes |
  | `frobc fix rover.frob` | apply the fixes that messages suggest |
  | `frobc format rover.frob` | format spaces, indentation and long lines |
  | `frobc report rover.frob` | show the memory and operations that a step needs |
  
  To run it on a robot (the first time, lift the wheels off the ground):
  
      frobc run rover.frob --device /dev/ttyUSB0 --robot pioneer
  root = true
  
  [*]
  charset = utf-8
  end_of_line = lf
  insert_final_newline = true
  
  [*.frob]
  indent_style = space
  indent_size = 4
  max_line_length = 100
  $ frobc check --lint rover.frob && frobc format --check rover.frob rover.test.frob
  $ frobc run rover.frob --for 20s | head -4
  time simulated: 20.000 s
  distance driven: 6.335 m
  odometry error at the end: 0.053 m
  collisions: 0
  $ for robot in pioneer scout create; do frobc run rover.frob --robot $robot --for 30s | grep collisions; done
  collisions: 0
  collisions: 0
  collisions: 0
  $ frobc test
  ok    touches nothing: 10 seeds, 60 s
  ok    gets about: 10 seeds, 60 s
  2 tests: all hold
  $ ls -a
  .
  ..
  .editorconfig
  .gitignore
  .vscode
  README.md
  rover.frob
  rover.test.frob
  world.toml
  $ grep -r '@' . ; cd ..

The project may be in other folders, which are created too; its name is that of the last one.

  $ frobc new robots/big-one/ | head -2 && frobc compile robots/big-one/big-one.frob -o robots && ls robots
  created robots/big-one:
    big-one.frob            the program, with a trial that checks its behaviour
  big-one
  big-one.c
  big-one.h
  $ frobc new "my robots/r2" | tail -3
    cd 'my robots/r2'
    frobc run r2.frob --view
    frobc test

Without write permission nothing is left behind.

  $ touch taken; frobc new taken/rover; ls taken
  error: cannot create the folder taken/rover: Not a directory
  taken

Existing files are not changed.

  $ frobc new rover
  error: there is already a folder rover: use another name, or move it away
  [2]
  $ frobc new taken
  error: there is already a file taken: use another name, or move it away
  [2]
  $ ln -s nowhere link; frobc new link; frobc new .; frobc new robots/..; frobc new /
  error: there is already a file link: use another name, or move it away
  error: `.` cannot be the name of a project: use a name that begins with a letter and contains only letters, digits, `_` and `-`
  error: `..` cannot be the name of a project: use a name that begins with a letter and contains only letters, digits, `_` and `-`
  error: `/` cannot be the name of a project: use a name that begins with a letter and contains only letters, digits, `_` and `-`
  [2]

Names must be valid as names of files, in C and in the library.

  $ for name in '' 3pi 'my robot' rover.frob müller math Robot _x "$(printf 'a\033b')"; do frobc new "$name"; done
  error: `` cannot be the name of a project: use a name that begins with a letter and contains only letters, digits, `_` and `-`
  error: `3pi` cannot be the name of a project: use a name that begins with a letter and contains only letters, digits, `_` and `-`
  error: `my robot` cannot be the name of a project: use a name that begins with a letter and contains only letters, digits, `_` and `-`, such as my_robot
  error: `rover.frob` cannot be the name of a project: use a name that begins with a letter and contains only letters, digits, `_` and `-`, such as rover
  error: `müller` cannot be the name of a project: use a name that begins with a letter and contains only letters, digits, `_` and `-`
  error: a C program named math would hide the standard header <math.h>: rename math.frob
  error: Robot is the name of a library module: use another name
  error: `_x` cannot be the name of a project: use a name that begins with a letter and contains only letters, digits, `_` and `-`
  error: `a\027b` cannot be the name of a project: use a name that begins with a letter and contains only letters, digits, `_` and `-`, such as a_b
  [2]
  $ frobc new $(printf 'a%.0s' $(seq 241)) 2>&1 | sed 's/a\{100,\}/NAME/g'
  error: the name of NAME.frob is too long for C files: use at most 240 characters
  $ frobc new -- -x; frobc new; ls -I '*.t'
  error: `-x` cannot be the name of a project: use a name that begins with a letter and contains only letters, digits, `_` and `-`
  frobc: required argument NAME is missing
  Usage: frobc new [OPTION]… NAME
  Try 'frobc new --help' or 'frobc --help' for more information.
  link
  my robots
  robots
  rover
  taken
