Files that are kept of a failed run: no test overwrites the files of another, even if their labels
have the same slug, or their programs the same name.

  $ program () {
  >   printf 'import Robot\nimport Trial\nimport WallFollow\n'
  >   printf 'main :: (HasSonar i, DiffDrive o) => Program i o\n'
  >   printf 'main = reactimateRobot (wallFollow1 0.4[m])\n'
  > }
  > labelled () { printf 'test "%s" = during 1[s] (proc () -> False)\n' "$1"; }
  > trial () { printf 'trial "%s" = Trial { world = "%s", lasts = 1[s], seeds = 1 `to` 3, judge = %s }\n' "$1" "$2" "$3"; }
  $ mkdir other
  $ { program; labelled 'a b'; labelled 'a-b'; labelled 'A b'; labelled 'äö'; labelled 'öä'; } > one.frob
  $ { program; labelled 'a b'; labelled 'unique'; } > two.frob
  $ cp two.frob other/two.frob
  $ frobc test one.frob two.frob other/two.frob --robot pioneer > told
  [1]
  $ sed -n 's/^ *frobc view \([^ ]*\).*--entry \(.*\) --at.*/\1 \2/p' told
  failed/a-b.csv 'judge test a b'
  failed/a-b-one.csv 'judge test a-b'
  failed/a-b-one-2.csv 'judge test A b'
  failed/----.csv 'judge test äö'
  failed/-----one.csv 'judge test öä'
  failed/a-b-two.csv 'judge test a b'
  failed/unique.csv 'judge test unique'
  failed/a-b-two-2.csv 'judge test a b'
  failed/unique-two.csv 'judge test unique'
  $ ls failed
  -----one.csv
  ----.csv
  a-b-one-2.csv
  a-b-one.csv
  a-b-two-2.csv
  a-b-two.csv
  a-b.csv
  unique-two.csv
  unique.csv
  $ { program; trial 'runs' room.toml 'comesFar 1[km] 0.5[s]'; labelled 'runs 1'; } > seeds.frob
  $ frobc test seeds.frob --robot pioneer --keep seeds | grep -o 'seeds/[^ ]* seeds.frob'
  seeds/runs-1.csv seeds.frob
  seeds/runs-1-simpler.csv seeds.frob
  seeds/runs-1-seeds.csv seeds.frob

The printed commands repeat each option that changes the program.

  $ mkdir 'my c' && printf '/* nothing */\n' > 'my c/evil.h' && cp 'my c/evil.h' ./-evil.h
  $ frobc test seeds.frob --robot pioneer --real float --specialization-limit 5000 --with 'my c/evil.h' --with=-evil.h | grep -o 'frobc view.*' | sed 's|world /[^ ]*/|world |' | tee commands
  frobc view failed/runs-1.csv seeds.frob --robot pioneer --real float --specialization-limit 5000 --with 'my c/evil.h' --with ./-evil.h --world room.toml --seed 1 --at 0.52s
  frobc view failed/runs-1-simpler.csv seeds.frob --robot pioneer --real float --specialization-limit 5000 --with 'my c/evil.h' --with ./-evil.h --world failed/runs-1-simpler.toml --seed 1 --at 0.52s
  frobc view failed/runs-1-seeds.csv seeds.frob --robot pioneer --real float --specialization-limit 5000 --with 'my c/evil.h' --with ./-evil.h --entry 'judge test runs 1' --at 0s
  $ head -1 commands | sed 's/frobc view/& --only-build/' > again.sh && sh again.sh > built && test -s "$(cat built)"

A suggested name is not interpreted as an option.

  $ sed 's|^main ::|foreign include "-evil.h"\n&|' one.frob > evil.frob
  $ frobc test evil.frob --robot pioneer -k 'A b' 2>&1 | grep -o 'add `[^`]*`'
  add `--with ./-evil.h`

An existing file in the way is not changed. The report omits only what cannot be written.

  $ mkdir taken && echo mine | tee taken/runs-1.csv > taken/runs-1-1.csv
  $ frobc test seeds.frob --robot pioneer --keep taken --rate 20 > told
  [1]
  $ shown () { grep -e picture -e frobc -e simpler -e "$1" told | sed 's|world /[^ ]*/|world |'; }
  $ shown taken
        picture: taken/runs-1.png
        frobc run seeds.frob --robot pioneer --world room.toml --seed 1 --for 1s --rate 20
        a simpler run, without any of the world's disturbances, also fails: seed 1: failed at 0.550 s
          world: taken/runs-1-simpler.toml
          picture: taken/runs-1-simpler.png
          frobc view taken/runs-1-simpler.csv seeds.frob --robot pioneer --world taken/runs-1-simpler.toml --seed 1 --at 0.55s
        --keep would overwrite taken/runs-1.csv, which is an existing file, but not a trace or a recording: move it away, or use another file name
        frobc view taken/runs-1-seeds.csv seeds.frob --robot pioneer --entry 'judge test runs 1' --at 0s
  $ cat taken/runs-1.csv
  mine
  $ echo mine > file && frobc test seeds.frob --robot pioneer --keep file > told
  [1]
  $ shown file
        frobc run seeds.frob --robot pioneer --world room.toml --seed 1 --for 1s
        cannot create the folder file: there is a file with this name
        frobc test seeds.frob --robot pioneer -k 'runs 1'
        cannot create the folder file: there is a file with this name
  $ eval "$(sed -n 's/^ *\(frobc run .*\)/\1/p' told | head -1)" | head -1
  time simulated: 1.000 s

A signal ends the simulator in the second run of a process: the report names the signal and the
seed, and has a command that repeats the run.

  $ cat > crash.h << 'C'
  > #include <signal.h>
  > static inline double crash(double x)
  > {
  >     static double last;
  >     if (x < last)
  >         raise(SIGKILL);
  >     last = x;
  >     return x;
  > }
  > C
  $ program | sed '/^main =/d' > crashing.frob
  $ cat >> crashing.frob << 'FROB'
  > foreign include "crash.h"
  > foreign crash :: Float -> Float = "crash"
  > main = reactimateRobot (proc i -> wallFollow1 0.4[m] i where
  >     assert "alive" (crash (time () / 1[s]) >= 0))
  > FROB
  $ trial 'a b' room.toml neverTouches | sed 's/1 `to` 3/1 `to` 8/' >> crashing.frob
  $ frobc test crashing.frob --robot pioneer --with crash.h -j 1 > told
  [1]
  $ sed 's|world /[^ ]*/|world |' told
  FAIL  a b: SIGKILL ended the simulator during the run with seed 2; `frobc run crashing.frob --robot pioneer --with crash.h --world room.toml --seed 2 --for 1s` repeats that run
  1 test: 1 failed
  $ eval "$(sed -n 's/.*`\(frobc run .*\)`.*/\1/p' told)" | head -1
  time simulated: 1.000 s
