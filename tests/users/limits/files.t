Whatever a file contains, frobc ends with a result or reports the error.

  $ check() { timeout 120 frobc check "$@" 2>&1 | head -4; }

Modules that import each other, starting with any of them, and a module that
imports itself:

  $ echo 'import B' > A.frob; echo 'import C' > B.frob; echo 'import A' > C.frob
  $ echo 'import A' > Outside.frob; echo 'import Itself' > Itself.frob
  $ check A.frob
  error[E0202]: modules import each other: `A` → `B` → `C` → `A`
   --> C.frob:1:8
    |
  1 | import A
  $ check Outside.frob
  error[E0202]: modules import each other: `A` → `B` → `C` → `A`
   --> C.frob:1:8
    |
  1 | import A
  $ check Itself.frob
  error[E0202]: modules import each other: `Itself` → `Itself`
   --> Itself.frob:1:8
    |
  1 | import Itself

A missing module:

  $ echo 'import Contrl' > missing.frob
  $ frobc check missing.frob
  error[E0201]: there is no module `Contrl`
   --> missing.frob:1:8
    |
  1 | import Contrl
    |        ^^^^^^
    |
    = note: frobc looked for `Contrl.frob` in the folder of this file and in the library
    = hint: did you mean `Control`?
  
  1 error
  [1]

Byte order marks and CRLF are accepted; tabs and other encodings are not:

  $ printf '\357\273\277main :: SF Int Int\r\nmain = proc x -> y where\r\n    y = x + 1\r\n' > windows.frob
  $ frobc check windows.frob
  $ printf 'main = proc x -> y where\n\ty = x\n' > tab.frob
  $ frobc check tab.frob
  error[E0102]: tabs are not allowed, because indentation is significant
   --> tab.frob:2:1
    |
  2 |     y = x
    | ^^^^
    |
    = hint: set up your editor to insert spaces instead of tabs
  
  1 error
  [1]
  $ printf 'x = "M\374nchen"\n' > latin_1.frob
  $ check latin_1.frob | head -1
  error[E0101]: this file is not valid UTF-8: byte 252 is not allowed here
  $ printf 'x = 1\0\n' > zero.frob && frobc check zero.frob 2> message; echo $?; head -1 message
  1
  error[E0103]: unexpected character with code 0
  $ printf 'x = 1\rmain = 2\r' > old.frob && frobc check old.frob 2> message; echo $?; head -1 message
  1
  error[E0103]: unexpected character with code 13

An empty file, and one that contains only comments:

  $ : > empty.frob && frobc check empty.frob
  $ echo '-- later' > comments.frob && frobc check comments.frob

Files that cannot be read:

  $ mkdir folder.frob
  $ frobc check folder.frob
  error: cannot read folder.frob: it is a directory
  [2]
  $ ln -s ring.frob ring.frob
  $ frobc check ring.frob
  error: cannot read ring.frob: Too many levels of symbolic links
  [2]

For a file of another kind, the message says what it is for, whatever the
command:

  $ cp $(which true) binary; echo '[robot]' > world.toml; echo 'time,in' > in.csv; echo 'int x;' > near.c
  $ : > near.h; mkdir one many; : > one/drive.frob; : > many/b.frob; : > many/a.frob
  $ for file in world.toml in.csv near.c near.h binary one many; do frobc check $file; done
  error: world.toml is not a Frob program but a world; use it with a program: `frobc run PROGRAM.frob --world world.toml`
  error: in.csv is not a Frob program but a table of inputs, or a recording; use it with a program: `frobc trace PROGRAM.frob --input in.csv`
  error: near.c is not a Frob program but C or C++; use it with a program that calls it: `--with near.c`
  error: near.h is not a Frob program but a C header; include it in a program with `foreign include "near.h"`, and allow it on the command line with `--with near.h`
  error: binary is not a Frob program: it is not a text file
  error: cannot read one: it is a directory; did you mean one/drive.frob?
  error: cannot read many: it is a directory; choose a program in it, such as many/a.frob
  [2]
  $ frobc run world.toml
  error: world.toml is not a Frob program but a world; use it with a program: `frobc run PROGRAM.frob --world world.toml`
  [2]
  $ frobc trace in.csv --input in.csv
  error: in.csv is not a Frob program but a table of inputs, or a recording; use it with a program: `frobc trace PROGRAM.frob --input in.csv`
  [2]

A suggested command can be copied into a shell, whatever the file's name:

  $ touch "it's a world.toml"; frobc run "it's a world.toml"
  error: it's a world.toml is not a Frob program but a world; use it with a program: `frobc run PROGRAM.frob --world 'it'\''s a world.toml'`
  [2]

A pipe is not a module, nor is a device:

  $ mkfifo Pipe.frob && echo 'import Pipe' > uses_pipe.frob
  $ timeout 120 frobc check uses_pipe.frob
  error[E0201]: cannot read `Pipe.frob`: it is a pipe or a device, not a file
   --> uses_pipe.frob:1:8
    |
  1 | import Pipe
    |        ^^^^
  
  1 error
  [1]
  $ timeout 120 frobc check Pipe.frob
  error: cannot read Pipe.frob: it is a pipe or a device, not a file
  [2]
  $ timeout 120 frobc check /dev/null
  error: cannot read /dev/null: it is a pipe or a device, not a file
  [2]
