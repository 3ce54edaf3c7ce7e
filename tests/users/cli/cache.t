  $ cat > add.frob <<'F'
  > main :: SF Float Float
  > main = proc x -> x + 1
  > F
  $ printf 'time,in\n0,1\n' > in.csv

Build results are cached in a folder that belongs to the user alone; a second run uses them.

  $ export XDG_CACHE_HOME=$PWD/cache
  $ frobc trace add.frob --input in.csv
  time,out
  0.000000000,2
  $ stat -c %a cache/frobc
  700
  $ ls cache/frobc | sed 's/-[0-9a-f]*\./-KEY./'
  add-KEY.so
  add-KEY.so.md5
  $ CC=false frobc trace add.frob --input in.csv > /dev/null 2>&1; echo $?
  2

A damaged entry is rebuilt.

  $ truncate -s 100 cache/frobc/add-*.so
  $ frobc trace add.frob --input in.csv
  time,out
  0.000000000,2

The next command that builds removes the leftovers of a killed command.

  $ mkdir cache/frobc/work-0123.99999999
  $ touch cache/frobc/work-0123.99999999/add.c
  $ rm cache/frobc/add-*; frobc trace add.frob --input in.csv > /dev/null
  $ ls cache/frobc | sed 's/-[0-9a-f]*\./-KEY./'
  add-KEY.so
  add-KEY.so.md5

A folder that others can write to, or that belongs to another user, is not trusted: results are
removed when the command ends.

  $ mkdir tmp; export TMPDIR=$PWD/tmp
  $ rm -r cache/frobc; mkdir -m 777 cache/frobc; chmod 777 cache/frobc
  $ gone() { for i in $(seq 600); do [ -z "$(ls tmp)" ] && break; sleep 0.1; done; ls tmp; }
  $ frobc trace add.frob --input in.csv
  time,out
  0.000000000,2
  $ ls cache/frobc; gone
  $ rm -r cache/frobc; ln -s ../tmp cache/frobc
  $ frobc trace add.frob --input in.csv
  time,out
  0.000000000,2
  $ gone
  $ unset XDG_CACHE_HOME
  $ HOME= frobc trace add.frob --input in.csv
  time,out
  0.000000000,2
  $ gone

If nothing can be written, that is reported.

  $ HOME= TMPDIR=/dev/null frobc trace add.frob --input in.csv 2>&1 | sed 's/frobc-[0-9a-f]*/frobc-N/'
  error: cannot store build results in /dev/null/frobc-N: Not a directory; free some space there, or set TMPDIR and XDG_CACHE_HOME to writable folders
  $ CC=true HOME=$PWD frobc trace add.frob --input in.csv
  error: the C compiler `true` reported no error but produced no program; install one (on Debian: apt-get install gcc), or set the environment variable CC
  [2]
  $ name=$(printf 'a%.0s' $(seq 230)); cp add.frob $name.frob
  $ HOME=$PWD frobc trace $name.frob --input in.csv
  time,out
  0.000000000,2
