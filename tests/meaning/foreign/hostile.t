Code by somebody else must not reach the C compiler without the user's
permission, wherever it is: headers, imported modules, labels, comments, file
names, recordings, Python modules. Each header here would write a file as soon
as a host loads the program.

  $ evil() { mkdir -p "$(dirname "$1")"; cat > "$1" <<C
  > #include <stdio.h>
  > __attribute__((constructor)) static void evil(void) { FILE *f = fopen("$PWD/pwned", "w"); if (f) fclose(f); }
  > static inline double half(double x) { return x / 2; }
  > C
  > }
  $ check() { if [ -e pwned ]; then echo 'THE HEADER WAS RUN'; rm pwned; fi; }
  $ refuses() { "$@" > out.txt 2>&1; echo "[$?]" $(grep '^error' out.txt | head -1); check; }
  $ short() { sed 's/, which the command line does not allow: C code can do anything on your computer; if you trust it,/ ... /'; }
  $ printf 'time,in\n0,1\n' > in.csv
  $ evil evil.h
  $ cat > header.frob <<'F'
  > foreign include "evil.h"
  > main :: SF Float Float
  > main = proc x -> x
  > F

The header has this effect if the user allows it.

  $ frobc trace header.frob --input in.csv --with evil.h && rm pwned
  time,out
  0.000000000,1

Otherwise no command compiles it, and each reports the same error.

  $ frobc trace header.frob --input in.csv
  error: the program includes the C header `evil.h`, which the command line does not allow: C code can do anything on your computer; if you trust it, add `--with evil.h` (or name a C file that includes it)
  [2]
  $ check
  $ cat > robot.frob <<'F'
  > import Robot
  > import Trial
  > foreign include "evil.h"
  > param v :: Velocity = 0.1[m/s]
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     assert "drives" (velocity i < 1[m/s]))
  > trial "touches nothing" = Trial { world = "room.toml", lasts = 1[s], seeds = 1 `to` 2, judge = neverTouches }
  > F
  $ printf 'program = "robot.frob"\nseeds = [1, 2]\n[params]\nv = ["0.1[m/s]"]\n' > plan.toml
  $ printf 'import Trial\n' > golden.frob
  $ printf 'test "gold" = trace "in.csv" "gold.csv"\n' | cat header.frob - >> golden.frob
  $ for command in 'view in.csv header.frob --only-build' 'view in.csv header.frob' \
  >   'trace header.frob --input in.csv --asserts stop' 'build --shared header.frob -o header.so' \
  >   'run robot.frob --robot pioneer --for 1s' 'run robot.frob --robot pioneer --view --for 1s' \
  >   'run robot.frob --robot pioneer --device tcp:127.0.0.1:9' \
  >   'build robot.frob --robot pioneer -o robot' 'build robot.frob --robot pioneer --target linux -o robot' \
  >   'export robot.frob --robot pioneer --platformio drive' 'test robot.frob --robot pioneer' \
  >   'test golden.frob' 'sweep plan.toml'; do
  >   echo "$command:"; refuses timeout 60 frobc $command | short
  > done
  view in.csv header.frob --only-build:
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  view in.csv header.frob:
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  trace header.frob --input in.csv --asserts stop:
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  build --shared header.frob -o header.so:
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  run robot.frob --robot pioneer --for 1s:
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  run robot.frob --robot pioneer --view --for 1s:
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  run robot.frob --robot pioneer --device tcp:127.0.0.1:9:
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  build robot.frob --robot pioneer -o robot:
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  build robot.frob --robot pioneer --target linux -o robot:
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  export robot.frob --robot pioneer --platformio drive:
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  test robot.frob --robot pioneer:
  [1] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  test golden.frob:
  [1] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  sweep plan.toml:
  [1] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  $ mkdir folder && cp robot.frob evil.h folder && frobc test folder; check
  skip  touches nothing: needs C code in evil.h
        frobc test folder/robot.frob --with folder/evil.h
  error: no test was run; see above for how to run the skipped tests

`compile`, `check`, `report` and the interpreter run no C; neither does the language server.

  $ frobc compile header.frob -o generated && grep evil generated/header.h
  #include "evil.h"
  $ frobc check header.frob && frobc report header.frob > report.txt && frobc trace header.frob --engine interp --input in.csv
  time,out
  0.000000000,1
  $ check
  $ cat > editor.py <<'P'
  > import json, os, subprocess
  > def message(m): text = json.dumps({"jsonrpc": "2.0", **m}); return f"Content-Length: {len(text)}\r\n\r\n{text}"
  > where = "file://" + os.path.abspath("header.frob")
  > document = {"uri": where, "languageId": "frob", "version": 1, "text": open("header.frob").read()}
  > told = "".join(map(message, [
  >     {"id": 1, "method": "initialize", "params": {"capabilities": {}, "rootUri": "file://" + os.getcwd()}},
  >     {"method": "initialized", "params": {}},
  >     {"method": "textDocument/didOpen", "params": {"textDocument": document}},
  >     {"id": 2, "method": "textDocument/codeLens", "params": {"textDocument": {"uri": where}}},
  >     {"id": 3, "method": "shutdown"}, {"method": "exit"}]))
  > done = subprocess.run(["frobc", "lsp"], input=told.encode(), capture_output=True, timeout=60,
  >                       env={**os.environ, "CC": os.path.abspath("compiler.sh")})
  > print(done.returncode, done.stdout.count(b"textDocument/publishDiagnostics"))
  > P
  $ printf '#!/bin/sh\ntouch "%s/pwned"\n' "$PWD" > compiler.sh && chmod +x compiler.sh
  $ python3 editor.py
  0 1
  $ check

Python imports no modules from the user's working directory.

  $ for module in frob numpy scipy argparse; do echo 'open("pwned", "w")' > $module.py; done
  $ timeout 60 frobc falsify robot.frob --robot pioneer > out.txt 2>&1
  [2]
  $ check; rm *.py

The header of an unused imported module, of a user-defined robot's module, in a subfolder, behind a
symbolic link, a pipe, and a folder:

  $ printf 'module Helper (one) where\nforeign include "evil.h"\none :: Int\none = 1\n' > Helper.frob
  $ printf 'import Helper\nmain :: SF Float Float\nmain = proc x -> x\n' > imports.frob
  $ trace() { refuses timeout 60 frobc trace "$@" --input in.csv | short; }
  $ names() { printf 'foreign include "%s"\nmain :: SF Float Float\nmain = proc x -> x\n' "$1" > named.frob; trace named.frob; }
  $ trace imports.frob
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  $ evil below/deep.h && names below/deep.h
  [2] error: the program includes the C header `below/deep.h` ...  add `--with below/deep.h` (or name a C file that includes it)
  $ ln -s evil.h link.h && names link.h
  [2] error: the program includes the C header `link.h` ...  add `--with link.h` (or name a C file that includes it)
  $ mkfifo pipe.h && names pipe.h
  [2] error: the program includes the C header `pipe.h` ...  add `--with pipe.h` (or name a C file that includes it)
  $ mkdir folder.h && names folder.h
  [2] error: the program includes the C header `folder.h` ...  add `--with folder.h` (or name a C file that includes it)
  $ names ./evil.h
  [2] error: the program includes the C header `./evil.h` ...  add `--with ./evil.h` (or name a C file that includes it)
  $ names .//evil.h
  [2] error: the program includes the C header `.//evil.h` ...  add `--with .//evil.h` (or name a C file that includes it)

The file itself counts, not its name: allowing one header does not allow another one with the same
name. Nor does a C file that does not include it.

  $ echo '/* harmless */' > good.h && echo '#include "good.h"' > good.c && echo 'int x;' > other.c
  $ trace header.frob --with good.h
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  $ trace header.frob --with good.c
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  $ evil below/good.h && names below/good.h
  [2] error: the program includes the C header `below/good.h` ...  add `--with below/good.h` (or name a C file that includes it)
  $ trace named.frob --with good.h
  [2] error: the program includes the C header `below/good.h` ...  add `--with below/good.h` (or name a C file that includes it)
  $ trace named.frob --with good.c
  [2] error: the program includes the C header `below/good.h` ...  add `--with below/good.h` (or name a C file that includes it)
  $ gcc -c other.c -o other.o && trace header.frob --with other.o
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  $ printf 'foreign include "good.h"\nforeign include "evil.h"\nmain :: SF Float Float\nmain = proc x -> x\n' > both.frob
  $ trace both.frob --with good.h
  [2] error: the program includes the C header `evil.h` ...  add `--with evil.h` (or name a C file that includes it)
  $ printf 'foreign include "good.h"\nmain :: SF Float Float\nmain = proc x -> x\n' > uses.frob
  $ for with in good.h ./good.h $PWD/good.h good.c; do frobc trace uses.frob --with $with --input in.csv | tail -1; done
  0.000000000,1
  0.000000000,1
  0.000000000,1
  0.000000000,1

A header in a folder where the compiler searches for standard headers, which standard headers
include:

  $ for name in math stdio stdint stdbool stddef string features; do evil $name.h; done
  $ names math.h
  [2] error: the program includes the C header `math.h` ...  add `--with math.h` (or name a C file that includes it)
  $ frobc trace uses.frob --with good.h --input in.csv | tail -1; check
  0.000000000,1
  $ echo '#include <stdio.h>' > good.c && frobc trace uses.frob --with good.c --with good.h --input in.csv | tail -1; check
  0.000000000,1
  $ rm math.h st*.h features.h
  $ names stdio.h
  [0]
  $ names linux/../stdio.h
  [1] error[E0232]: `linux/../stdio.h` is outside this module's folder

A header has the name of a header that frobc generates, in this run or an
earlier one. The user's C, which includes that name, gets the generated header.

  $ mkdir mine && echo '#include "header.h"' > mine/mine.c && cp header.frob evil.h mine
  $ printf '#include "evil.h"\n' > mine/header.h
  $ trace mine/header.frob --with mine/mine.c
  [2] error: the program includes the C header `mine/evil.h` ...  add `--with mine/evil.h` (or name a C file that includes it)
  $ echo 'int system(const char *);' > mine/header.h
  $ printf 'foreign run :: Array 8 Int -> Int = "system"\nmain :: SF Float Int\nmain = proc x -> run [1, 1, 1, 1, 1, 1, 1, floor x]\n' > mine/header.frob
  $ trace mine/header.frob --with mine/mine.c
  [2] error: the program calls `system` in C, but none of its C files mentions it: add the C files with `--with FILE.c` (only the functions of <math.h> that docs/foreign.md lists need no file)

Invalid header names:

  $ says() { names "$1" > /dev/null; grep -h '^error' out.txt; check; }
  $ says 'evil.h\"\n#include \"evil.h'
  error[E0232]: `evil.h"
  $ says '../evil.h'
  error[E0232]: `../evil.h` is outside this module's folder
  $ says "$PWD/evil.h"
  error[E0232]: `$TESTCASE_ROOT/evil.h` is outside this module's folder
  $ says 'evil.h??/'
  error: the program includes the C header `evil.h??/`, but there is no such file
  $ evil 'evil~.h' && says 'evil??-.h'
  error: the program includes the C header `evil??-.h`, but there is no such file

Labels, comments, units and texts cannot contain C. In C, `??/` is a backslash.

  $ code='__attribute__((constructor)) static void evil(void) { __builtin_puts(__FILE__); }'
  $ cat > texts.frob <<F
  > -- | */ $code /*
  > -- *??/
  > --/ $code
  > param v :: Float = 1
  > main :: SF Float Float
  > main = proc x -> out where
  >     out = delay v x
  >     assert "x??/" (x > 0)
  >     assert ", 0, 0, 0}}; $code //" (x > 0)
  >     assert "*/ $code /*" (x > 0)
  >     assert "\\\\\" $code" (x > 0)
  > F
  $ frobc trace texts.frob --input in.csv
  time,out
  0.000000000,1
  assert "x??/": held
  assert ", 0, 0, 0}}; __attribute__((constructor)) static void evil(void) { __builtin_puts(__FILE__); } //": held
  assert "*/ __attribute__((constructor)) static void evil(void) { __builtin_puts(__FILE__); } /*": held
  assert "\" __attribute__((constructor)) static void evil(void) { __builtin_puts(__FILE__); }": held
  $ frobc view in.csv texts.frob --only-build > out.txt
  $ frobc compile texts.frob -o generated && gcc -std=c99 -Wall -Wextra -Wpedantic -Werror -I $(dirname "$(command -v frobc)")/../share/frobc/include -c generated/texts.c -o texts.o

File names:

  $ for name in '*' '*??' 'a";int b;' "\$(touch pwned)" '`touch pwned`' "a'; touch pwned;'" '-o pwned' '@evil' 'a
  > #include "evil.h"'; do
  >   cp -- uses.frob "./$name.frob"
  >   frobc trace ./"$name.frob" --with good.h --input in.csv 2>&1 | tail -1; check
  > done
  0.000000000,1
  0.000000000,1
  0.000000000,1
  0.000000000,1
  0.000000000,1
  0.000000000,1
  0.000000000,1
  0.000000000,1
  0.000000000,1

Symbols and types:

  $ symbol() { printf 'foreign f :: Float -> Float = "%s"\nmain :: SF Float Float\nmain = proc x -> f x\n' "$1" > symbol.frob; frobc trace symbol.frob --input in.csv 2>&1 | grep '^error'; check; }
  $ symbol 'sin); system(\"touch pwned\"'
  error[E0232]: `sin); system("touch pwned"` is not a name in C
  $ symbol 'sin /*'
  error[E0232]: `sin /*` is not a name in C
  $ symbol system
  error: the program calls `system` in C, but there is no C file: add the C files with `--with FILE.c` (only the functions of <math.h> that docs/foreign.md lists need no file)
  $ symbol dlopen
  error: the program calls `dlopen` in C, but there is no C file: add the C files with `--with FILE.c` (only the functions of <math.h> that docs/foreign.md lists need no file)
  $ printf 'foreign type T = "struct t; int evil"\nmain :: SF Float Float\nmain = proc x -> x\n' > type.frob
  $ frobc trace type.frob --input in.csv 2>&1 | grep '^error'
  error[E0232]: `struct t; int evil` is not the name of a type in C

The text of a recording is never compiled.

  $ printf '# param v=1; foreign include "evil.h"\ntime,in,out\n0,1,1\n' > run.csv
  $ frobc trace texts.frob --input run.csv 2>&1 | tail -1; check
  error: run.csv: the parameter `v` is a number in 1, not `1; foreign include "evil.h"`; to override the recorded value, use `--param`

Allowing a header does not allow others in its folder. Here the user's own C includes the standard
header in quotes, and the C compiler finds the stranger's header.

  $ mkdir stranger own
  $ echo 'static inline double fine(double x) { return x; }' > stranger/fine.h
  $ evil stranger/string.h
  $ cat > stranger/program.frob <<'F'
  > foreign include "fine.h"
  > foreign fine :: Float -> Float = "fine"
  > foreign mine :: Float -> Float = "mine"
  > main :: SF Float Float
  > main = proc x -> fine (mine x)
  > F
  $ with() { frobc trace stranger/program.frob --input in.csv "$@"; echo "[$?]"; check; }
  $ printf '#include "string.h"\ndouble mine(double x) { return x; }\n' > own/mine.c
  $ with --with stranger/fine.h --with own/mine.c
  error: the C compiler includes the file `stranger/string.h`, which the command line does not allow: C code can do anything on your computer; if you trust it, add `--with stranger/string.h`; otherwise rename your header, or include the standard one as <string.h>
  [2]

The same with other spellings of the include:

  $ for include in '%:include "string.h"' '??=include "string.h"' '#inc\
  > lude "string.h"' '#define NAME "string.h"
  > #include NAME' '#/* */include /* */ "string.h"'; do
  >   printf '%s\ndouble mine(double x) { return x; }\n' "$include" > own/mine.c
  >   with --with stranger/fine.h --with own/mine.c 2>&1 | cut -c 1-64
  > done
  error: the C compiler includes the file `stranger/string.h`, whi
  [2]
  error: the C compiler includes the file `stranger/string.h`, whi
  [2]
  error: the C compiler includes the file `stranger/string.h`, whi
  [2]
  error: the C compiler includes the file `stranger/string.h`, whi
  [2]
  error: the C compiler includes the file `stranger/string.h`, whi
  [2]

C++ and clang do not circumvent the check.

  $ printf '#include "string.h"\nextern "C" double mine(double x) { return x; }\n' > own/mine.cc
  $ with --with stranger/fine.h --with own/mine.cc 2>&1 | cut -c 1-64
  error: the C compiler includes the file `stranger/string.h`, whi
  [2]
  $ CC=clang with --with stranger/fine.h --with own/mine.c 2>&1 | cut -c 1-64
  error: the C compiler includes the file `stranger/string.h`, whi
  [2]

If a C compiler accepts the option but lists no files, its result is rejected, because it cannot be
checked.

  $ printf '#!/bin/sh\nexec cc "$@" 2>/dev/null\n' > silent && chmod +x silent
  $ CC=./silent with --with stranger/fine.h --with own/mine.c
  error: the C compiler `./silent` does not list the files that it includes, so frobc cannot check whether the command line allows them: use gcc or clang, which list them with the option -H
  [2]

A comment, or code that no compiler reads, does not allow a header.

  $ echo 'double mine(double x) { return x; }' > own/mine.c
  $ evil stranger/evil.h
  $ sed -i '1i foreign include "evil.h"' stranger/program.frob
  $ for text in '/* not for use:
  > #include "evil.h"
  > */' '// \
  > #include "evil.h"' '#if 0
  > #include "evil.h"
  > #endif'; do
  >   printf '%s\nstatic inline double fine(double x) { return x; }\n' "$text" > stranger/fine.h
  >   with --with stranger/fine.h --with own/mine.c 2>&1 | cut -c 1-61
  > done
  error: the program includes the C header `stranger/evil.h`, w
  [2]
  error: the program includes the C header `stranger/evil.h`, w
  [2]
  error: the program includes the C header `stranger/evil.h`, w
  [2]

A header next to a file that includes it is allowed together with that file; so are headers in
subfolders.

  $ sed -i '/evil.h/d' stranger/program.frob
  $ mkdir own/parts
  $ echo '#include "parts/two.h"' > own/one.h
  $ echo '#define TWO 2' > own/parts/two.h
  $ printf '#include "one.h"\ndouble mine(double x) { return TWO * x; }\n' > own/mine.c
  $ echo 'static inline double fine(double x) { return x; }' > stranger/fine.h
  $ with --with stranger/fine.h --with own/mine.c
  time,out
  0.000000000,2
  [0]
