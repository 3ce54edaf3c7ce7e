What `frobc view` says before it shows a page. A run to look at, of a program that computes
a distance:

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

A viewer serves until it is ended, so here it is, as soon as it has said its address; of
this only the form is always the same:

  $ view () {
  >   : > said; frobc view --print "$@" > said 2>&1 & viewer=$!
  >   for i in $(seq 100); do
  >     grep -q '^view: ' said || ! kill -0 $viewer 2> /dev/null && break; sleep 0.1
  >   done
  >   kill $viewer 2> /dev/null; wait $viewer; status=$?
  >   sed 's|127.0.0.1:[0-9]*/#[0-9a-f]*|127.0.0.1:PORT/#TOKEN|' said; echo "[$status]"
  > }

  $ view run.csv way.frob
  view: http://127.0.0.1:PORT/#TOKEN (ends with Ctrl-C)
  [0]

No recording, and what is none:

  $ frobc view gone.csv way.frob
  error: there is no file gone.csv
  [2]
  $ frobc view way.frob way.frob
  error: cannot view way.frob: it is no recording: its first line does not begin with `time`
  [2]
  $ : > empty.csv
  $ frobc view empty.csv way.frob
  error: cannot view empty.csv: the file is empty
  [2]
  $ head -n 1 run.csv > header.csv
  $ frobc view header.csv way.frob
  error: cannot view header.csv: there is no instant in it
  [2]

A torn last line is left out:

  $ head -c -5 run.csv > torn.csv
  $ view torn.csv way.frob
  torn.csv:4: the last line is torn (no line feed at its end), and left out
  view: http://127.0.0.1:PORT/#TOKEN (ends with Ctrl-C)
  [0]

One that is compressed, and one of which the end is missing:

  $ gzip -k run.csv
  $ view run.csv.gz way.frob
  view: http://127.0.0.1:PORT/#TOKEN (ends with Ctrl-C)
  [0]
  $ head -c -8 run.csv.gz > cut.csv.gz
  $ view cut.csv.gz way.frob
  cut.csv.gz:5: the archive is cut off or damaged (`frobc convert` keeps its whole rows); that row and what comes after it is left out
  view: http://127.0.0.1:PORT/#TOKEN (ends with Ctrl-C)
  [0]
  $ cp run.csv plain.csv.gz
  $ view plain.csv.gz way.frob
  error: cannot view plain.csv.gz: it is not compressed by gzip, as its name says
  [2]

A recording of another program, or of another version of it, is shown as far as it fits:

  $ sed 's/in.2/in.stop/' run.csv > other.csv
  $ view other.csv way.frob
  other.csv:1: the program has no `in.stop`: the recording is of another program, or of another version of it
  other.csv:1: no column of the program's input `in.2`; so the program cannot be run on it, and what was recorded is all that is shown
  view: http://127.0.0.1:PORT/#TOKEN (ends with Ctrl-C)
  [0]
  $ sed 's/0.30000000000000004/0.25/' run.csv > diverged.csv
  $ view diverged.csv way.frob
  diverged at 2: `out` is not as recorded, so the recording is of another version of the program, or its C depends on more than its input
  view: http://127.0.0.1:PORT/#TOKEN (ends with Ctrl-C)
  [0]
  $ sed 's/true/maybe/' run.csv > broken.csv
  $ view broken.csv way.frob
  broken.csv:4: column `in.2`: `maybe` is no value of it; that row and what comes after it is left out
  view: http://127.0.0.1:PORT/#TOKEN (ends with Ctrl-C)
  [0]
  $ sed 's/^0.2/0.05/' run.csv > back.csv
  $ view back.csv way.frob
  back.csv:4: time goes back: `0.05` comes after a later time; that row and what comes after it is left out
  view: http://127.0.0.1:PORT/#TOKEN (ends with Ctrl-C)
  [0]
  $ sed 's/time.*/time,a,b,c,d,e/; 1!s/$/,0,0/' run.csv > another.csv
  $ view another.csv way.frob
  another.csv:1: the program has no `a`, `b`, `c`, `d` and more: the recording is of another program, or of another version of it
  another.csv:1: no column of the program's input `in.1`, `in.2`; so the program cannot be run on it, and what was recorded is all that is shown
  view: http://127.0.0.1:PORT/#TOKEN (ends with Ctrl-C)
  [0]

A port that is taken, and one that is none:

  $ : > first; frobc view --print run.csv way.frob > first & first=$!
  $ for i in $(seq 100); do grep -q '^view: ' first && break; sleep 0.1; done
  $ port=$(sed 's|.*127.0.0.1:\([0-9]*\)/.*|\1|' first)
  $ frobc view --print --port $port run.csv way.frob 2>&1 | sed "s/$port/PORT/"
  error: port PORT is taken; without --port any that is free is used
  $ kill $first; wait $first
  $ frobc view --print --port 70000 run.csv way.frob
  error: --port takes a number from 1 to 65535
  [2]

Where the address cannot be told:

  $ frobc view --print run.csv way.frob > /dev/full
  error: cannot write standard output: No space left on device
  [2]
