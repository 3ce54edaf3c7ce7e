Messages of `frobc view` before it shows a page. A run to view, of a program that computes a
distance:

  $ cat > way.frob <<EOF
  > main :: SF (Velocity, Bool) Distance
  > main = proc (v, hold) -> integral (if hold then 0 else v)
  > EOF
  $ cat > run.csv <<EOF
  > time,in.1,in.2,out
  > 0,1,false,0
  > 0.1,2,false,0.10000000000000001
  > 0.2,3,true,0.30000000000000004
  > EOF

A viewer serves until it is ended, so this test ends it as soon as it has printed its address, of
which only the form is always the same:

  $ view () {
  >   : > said; frobc view --print "$@" > said 2>&1 & viewer=$!
  >   for i in $(seq 100); do
  >     grep -q '^view: ' said || ! kill -0 $viewer 2> /dev/null && break; sleep 0.1
  >   done
  >   kill $viewer 2> /dev/null; wait $viewer; status=$?
  >   sed 's|127.0.0.1:[0-9]*/#[0-9a-f]*|127.0.0.1:PORT/#TOKEN|' said; echo "[$status]"
  > }

  $ view run.csv way.frob
  view: http://127.0.0.1:PORT/#TOKEN (press Ctrl-C to end)
  [0]

A missing recording, and a file that is not one:

  $ frobc view gone.csv way.frob
  error: there is no file gone.csv
  [2]
  $ frobc view way.frob way.frob
  error: cannot view way.frob: it is not a recording: the first column must be `time`; to choose the column with the times, add `--time-column NAME`
  [2]
  $ : > empty.csv
  $ frobc view empty.csv way.frob
  error: cannot view empty.csv: the file is empty
  [2]
  $ head -n 1 run.csv > header.csv
  $ frobc view header.csv way.frob
  error: cannot view header.csv: it contains no instant
  [2]

A truncated last line is omitted:

  $ head -c -5 run.csv > torn.csv
  $ view torn.csv way.frob
  torn.csv:4: the last line is incomplete (it does not end with a line feed) and is omitted
  view: http://127.0.0.1:PORT/#TOKEN (press Ctrl-C to end)
  [0]

A compressed recording, and one whose end is missing:

  $ gzip -k run.csv
  $ view run.csv.gz way.frob
  view: http://127.0.0.1:PORT/#TOKEN (press Ctrl-C to end)
  [0]
  $ head -c -8 run.csv.gz > cut.csv.gz
  $ view cut.csv.gz way.frob
  cut.csv.gz:5: the archive is truncated or damaged (`frobc convert` recovers its complete rows); this row and the rows after it are omitted
  view: http://127.0.0.1:PORT/#TOKEN (press Ctrl-C to end)
  [0]
  $ cp run.csv plain.csv.gz
  $ view plain.csv.gz way.frob
  error: cannot view plain.csv.gz: its name says that it is compressed by gzip, but it is not
  [2]

A recording of another program, or of another version of it, is shown as far as it matches:

  $ sed 's/in.2/in.stop/' run.csv > other.csv
  $ view other.csv way.frob
  other.csv:1: the program has no `in.stop`: the recording is from another program, or from another version of it
  other.csv:1: the recording has no column for the program's input `in.2`, so the viewer cannot run the program on it and only shows recorded signals; to read one from a column with another name, use `--column NAME=COLUMN`
  view: http://127.0.0.1:PORT/#TOKEN (press Ctrl-C to end)
  [0]
  $ sed 's/0.30000000000000004/0.25/' run.csv > diverged.csv
  $ view diverged.csv way.frob
  diverged at instant 2: `out` differs from the recording, so the recording is from another version of the program, or the program's C code depends on more than its input
  view: http://127.0.0.1:PORT/#TOKEN (press Ctrl-C to end)
  [0]
  $ sed 's/true/maybe/' run.csv > broken.csv
  $ view broken.csv way.frob
  broken.csv:4: column `in.2`: `maybe` is not a valid value; expected `true` or `false`; this row and the rows after it are omitted
  view: http://127.0.0.1:PORT/#TOKEN (press Ctrl-C to end)
  [0]
  $ sed 's/^0.2/0.05/' run.csv > back.csv
  $ view back.csv way.frob
  back.csv:4: the time goes backwards: `0.05` comes after a later time; this row and the rows after it are omitted
  view: http://127.0.0.1:PORT/#TOKEN (press Ctrl-C to end)
  [0]
  $ sed 's/time.*/time,a,b,c,d,e/; 1!s/$/,0,0/' run.csv > another.csv
  $ view another.csv way.frob
  another.csv:1: the program has no `a`, `b`, `c`, `d` and more: the recording is from another program, or from another version of it
  another.csv:1: the recording has no column for the program's input `in.1`, `in.2`, so the viewer cannot run the program on it and only shows recorded signals; to read one from a column with another name, use `--column NAME=COLUMN`
  view: http://127.0.0.1:PORT/#TOKEN (press Ctrl-C to end)
  [0]

A port that is in use, and an invalid one:

  $ : > first; frobc view --print run.csv way.frob > first & first=$!
  $ for i in $(seq 100); do grep -q '^view: ' first && break; sleep 0.1; done
  $ port=$(sed 's|.*127.0.0.1:\([0-9]*\)/.*|\1|' first)
  $ frobc view --print --port $port run.csv way.frob 2>&1 | sed "s/$port/PORT/"
  error: port PORT is in use; remove --port to use any free port
  $ kill $first; wait $first
  $ frobc view --print --port 70000 run.csv way.frob
  error: --port takes a number from 1 to 65535
  [2]

`--print` has the same meaning for a live run:

  $ frobc run --print way.frob
  error: --print only works with --view: add --view, or remove --print
  [2]

If the address cannot be printed:

  $ frobc view --print run.csv way.frob > /dev/full
  error: cannot write to standard output: No space left on device
  [2]
