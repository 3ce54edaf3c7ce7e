Whichever process is killed, and whenever, running the same command again continues the sweep, and
the table is the same.

  $ . ./follow.sh && follow 5 60
  $ cat > gaps.toml << 'PLAN'
  > program = "follow.frob"
  > robots = ["pioneer"]
  > [params]
  > gap = ["0.2[m]", "0.3[m]", "0.4[m]"]
  > PLAN
  $ frobc sweep gaps.toml --rows whole --table whole.csv > /dev/null

The command itself is killed again and again.

  $ for pause in 0.15 0.3 0.2 0.4 0.25; do
  >   frobc sweep gaps.toml -j 3 > told 2>&1 & sweep=$!
  >   sleep $pause; kill -9 $sweep 2> killed; wait $sweep 2> killed
  > done
  > frobc sweep gaps.toml > told && cmp gaps.csv whole.csv

Its processes are killed while it runs: others perform their runs.

  $ rm -r gaps.rows
  $ frobc sweep gaps.toml -j 2 > told 2>&1 & sweep=$!
  $ for time in 1 2 3; do
  >   for look in $(seq 100); do
  >     child=$(ps -o pid=,args= --ppid $sweep 2> no_child | awk '/--for 5/ { print $1; exit }')
  >     test -n "$child" && break; sleep 0.05
  >   done; test -n "$child" && kill -9 $child 2> no_child
  > done; wait $sweep && cmp gaps.csv whole.csv

A row that is incomplete or was changed is computed again.

  $ for file in gaps.rows/*.rows; do sed -i '1s/held/hell/; $s/.$//' "$file"; done
  $ frobc sweep gaps.toml > told && cmp gaps.csv whole.csv

If the disk is full, finished rows are kept.

  $ rm -r gaps.rows && mkdir small
  $ (ulimit -f 8; frobc sweep gaps.toml -j 1 --rows small) 2>&1 | sed 's/[0-9][0-9]*/N/g'
  error: cannot write the result of a run: File too large
  N runs done, N left; run the same command to continue
  $ test $(cat small/*.rows | wc -l) -gt 10 && frobc sweep gaps.toml --rows small > told && cmp gaps.csv whole.csv

The same if there is no room for the table.

  $ frobc sweep gaps.toml --rows small --table /dev/full
  error: cannot write /dev/full: No space left on device
  [2]
  $ frobc sweep gaps.toml --rows small --merge > told && cmp gaps.csv whole.csv
