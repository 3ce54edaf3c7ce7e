A project that has been made runs, checks, is formatted and passes its trials, at once.

  $ frobc new rover
  made rover:
    rover.frob              the program, with its trials
    world.toml              the room that it is tried in
    README.md               what there is, and which commands
    .editorconfig           what editors are to know
    .vscode/settings.json   the same for Visual Studio Code
    .gitignore              what trials leave behind
  
  now:
    cd rover
    frobc run rover.frob --view
    frobc test
  $ cd rover && find . -type f | sort && cat README.md .editorconfig
  ./.editorconfig
  ./.gitignore
  ./.vscode/settings.json
  ./README.md
  ./rover.frob
  ./world.toml
  # rover
  
  A robot that drives about a room and touches nothing, written in Frob.
  
  | | |
  | --- | --- |
  | `rover.frob` | the program, and at its end the trials that it has to pass |
  | `world.toml` | the room that it is tried in |
  | `.editorconfig`, `.vscode` | what editors are to know |
  
  | | |
  | --- | --- |
  | `frobc run rover.frob --picture run.png` | drive for a minute in the simulator |
  | `frobc run rover.frob --view` | look at every signal while it drives |
  | `frobc test` | run the trials, each with ten kinds of noise |
  | `frobc check rover.frob` | only say what is wrong |
  | `frobc fix rover.frob` | mend what a message says how to mend |
  | `frobc format rover.frob` | set blanks, indentation and long lines right |
  | `frobc report rover.frob` | state the memory and the operations of a step |
  
  On a robot, with its wheels off the ground at first:
  
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
  $ frobc check --lint rover.frob && frobc format --check rover.frob
  $ frobc run rover.frob --for 20s | head -4
  time simulated: 20.000 s
  distance driven: 5.439 m
  odometry error at the end: 0.054 m
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
  world.toml
  $ grep -r '@' . ; cd ..

It may be below other folders, which are made too, and the name is that of the last.

  $ frobc new robots/big-one/ | head -2 && frobc compile robots/big-one/big-one.frob -o robots && ls robots
  made robots/big-one:
    big-one.frob            the program, with its trials
  big-one
  big-one.c
  big-one.h
  $ frobc new "my robots/r2" | tail -3
    cd 'my robots/r2'
    frobc run r2.frob --view
    frobc test

Without the right to write nothing is left behind.

  $ touch taken; frobc new taken/rover; ls taken
  error: cannot make the folder taken/rover: Not a directory
  taken

What is there already stays as it is.

  $ frobc new rover
  error: there is a folder rover already: give another name, or move it away
  [2]
  $ frobc new taken
  error: there is a file taken already: give another name, or move it away
  [2]
  $ ln -s nowhere link; frobc new link; frobc new .; frobc new robots/..; frobc new /
  error: there is a file link already: give another name, or move it away
  error: `.` cannot be the name of a project: give it one of letters, digits, `_` and `-` that begins with a letter
  error: `..` cannot be the name of a project: give it one of letters, digits, `_` and `-` that begins with a letter
  error: `/` cannot be the name of a project: give it one of letters, digits, `_` and `-` that begins with a letter
  [2]

Names are those of files, C and the library.

  $ for name in '' 3pi 'my robot' rover.frob müller math Robot _x "$(printf 'a\033b')"; do frobc new "$name"; done
  error: `` cannot be the name of a project: give it one of letters, digits, `_` and `-` that begins with a letter
  error: `3pi` cannot be the name of a project: give it one of letters, digits, `_` and `-` that begins with a letter
  error: `my robot` cannot be the name of a project: give it one of letters, digits, `_` and `-` that begins with a letter, such as my_robot
  error: `rover.frob` cannot be the name of a project: give it one of letters, digits, `_` and `-` that begins with a letter, such as rover
  error: `müller` cannot be the name of a project: give it one of letters, digits, `_` and `-` that begins with a letter
  error: a program in C named math would hide C's own header <math.h>: give math.frob another name
  error: Robot is a module of the library, which programs import: give another name
  error: `_x` cannot be the name of a project: give it one of letters, digits, `_` and `-` that begins with a letter
  error: `a\027b` cannot be the name of a project: give it one of letters, digits, `_` and `-` that begins with a letter, such as a_b
  [2]
  $ frobc new $(printf 'a%.0s' $(seq 241)) 2>&1 | sed 's/a\{100,\}/NAME/g'
  error: the name of NAME.frob is too long for C files: 240 characters at most
  $ frobc new -- -x; frobc new; ls -I '*.t'
  error: `-x` cannot be the name of a project: give it one of letters, digits, `_` and `-` that begins with a letter
  frobc: required argument NAME is missing
  Usage: frobc new [OPTION]… NAME
  Try 'frobc new --help' or 'frobc --help' for more information.
  link
  my robots
  robots
  rover
  taken
