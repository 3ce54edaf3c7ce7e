Every command reads compressed recordings like any other, and writes compressed ones if the name
says so.

  $ cat > way.frob <<END
  > main :: SF (Velocity, Bool) Distance
  > main = proc (v, hold) -> integral (if hold then 0 else v)
  > END
  $ awk 'BEGIN { print "time,in.1,in.2"; for (k = 0; k < 20000; k++) print k / 100 "," k % 7 / 3 "," (k % 5 ? "false" : "true") }' > in.csv
  $ gzip -k in.csv
  $ zstd -q in.csv
  $ frobc trace way.frob --input in.csv --output out.csv
  $ for ending in gz zst; do for engine in c interp; do
  >   frobc trace way.frob --engine $engine --input in.csv.$ending | cmp - out.csv
  >   frobc trace way.frob --engine $engine --input in.csv.$ending --output $engine.csv.$ending
  > done; done
  $ gzip -dc c.csv.gz | cmp - out.csv; gzip -dc interp.csv.gz | cmp - out.csv
  $ zstd -dqc c.csv.zst | cmp - out.csv; zstd -dqc interp.csv.zst | cmp - out.csv

The bytes are the same each time, whichever program writes them:

  $ cmp c.csv.gz interp.csv.gz
  $ cmp c.csv.zst interp.csv.zst

A picture of a compressed trace:

  $ frobc trace way.frob --input in.csv.gz --output drawn.csv.gz --picture drawn.svg
  $ head -c 20 drawn.svg; echo
  <svg xmlns="http://w

A golden trace:

  $ cat > golden.frob <<END
  > import Trial
  > main :: SF (Velocity, Bool) Distance
  > main = proc (v, hold) -> integral (if hold then 0 else v)
  > test "as it was" = trace "in.csv.gz" "golden.csv.zst"
  > END
  $ frobc test golden.frob --update | tail -n 1
  1 test: all hold
  $ zstd -dqc golden.csv.zst | cmp - out.csv
  $ frobc test golden.frob | tail -n 1
  1 test: all hold
  $ sed 's/^5.000000000,.*/5.000000000,7/' out.csv | zstd -qc > golden.csv.zst
  $ frobc test golden.frob | grep line
  FAIL  as it was: line 502 of golden.csv.zst is `5.000000000,7`, but the program returns `5.000000000,3.9833332999999964`; if the program is right, update the file with `--update`

A truncated archive is read up to its end; then there is an error. (Of the data that was being
compressed, the last part is lost: up to about 100 kB.)

  $ head -c 20000 in.csv.gz > cut.csv.gz
  $ frobc trace way.frob --input cut.csv.gz 2>&1 > cut.out | sed 's/:[0-9]*:1:/:LINE:1:/'
  error: cut.csv.gz:LINE:1: cannot read the file: the archive is truncated or damaged (`frobc convert` recovers its complete rows)
  $ test $(wc -l < cut.out) -gt 5000 && head -n $(wc -l < cut.out) out.csv | cmp - cut.out
  $ frobc trace way.frob --engine interp --input cut.csv.gz --output cut.interp.csv
  error: cannot read cut.csv.gz: the archive is truncated or damaged (`frobc convert` recovers its complete rows)
  [2]
  $ cmp cut.out cut.interp.csv
  $ { head -c 3000 in.csv.zst; printf 'damaged'; tail -c +3008 in.csv.zst; } > damaged.csv.zst
  $ frobc trace way.frob --input damaged.csv.zst 2>&1 > damaged.out | grep -o 'the archive is.*'
  the archive is truncated or damaged (`frobc convert` recovers its complete rows)
  $ frobc trace way.frob --engine interp --input damaged.csv.zst > damaged.out
  error: cannot read damaged.csv.zst: the archive is truncated or damaged (`frobc convert` recovers its complete rows)
  [2]

Names that do not match the contents:

  $ cp in.csv.gz packed.csv; cp in.csv plain.csv.gz; cp in.csv.gz other.csv.zst
  $ for file in packed.csv plain.csv.gz other.csv.zst; do for engine in c interp; do
  >   frobc trace way.frob --engine $engine --input $file
  > done; done
  error: cannot read packed.csv: it is compressed; rename it so that its name ends in .gz or .zst
  error: cannot read packed.csv: it is compressed; rename it so that its name ends in .gz or .zst
  error: cannot read plain.csv.gz: its name says that it is compressed by gzip, but it is not
  error: cannot read plain.csv.gz: its name says that it is compressed by gzip, but it is not
  error: cannot read other.csv.zst: its name says that it is compressed by zstd, but it is not
  error: cannot read other.csv.zst: its name says that it is compressed by zstd, but it is not
  [2]
  $ frobc check in.csv.gz
  error: in.csv.gz is not a Frob program but a table of inputs, or a recording; use it with a program: `frobc trace PROGRAM.frob --input in.csv.gz`
  [2]

No file that is not a trace is overwritten, whether or not it can be read:

  $ printf 'my notes\n' | gzip > notes.csv.gz
  $ frobc trace way.frob --input in.csv --output notes.csv.gz
  error: --output would overwrite notes.csv.gz, which is an existing file, but not a trace or a recording: move it away, or use another file name
  [2]
  $ frobc trace way.frob --input in.csv --output plain.csv.gz
  error: --output would overwrite plain.csv.gz, which is an existing file that frobc cannot check (cannot read plain.csv.gz: its name says that it is compressed by gzip, but it is not): move it away, or use another file name
  [2]
  $ frobc trace way.frob --input in.csv.gz --output in.csv.gz
  error: --output would overwrite in.csv.gz, which is an input: use another file name
  [2]

If zstd is missing, existing files are kept:

  $ mkdir bin; for tool in cc gcc as ld gzip; do
  >   tool=$(command -v $tool) && ln -s $tool bin/
  > done
  $ ln -s $(command -v frobc) bin/
  $ cp c.csv.zst before.csv.zst
  $ for engine in c interp; do
  >   PATH=$PWD/bin frobc trace way.frob --engine $engine --input in.csv.zst
  >   PATH=$PWD/bin frobc trace way.frob --engine $engine --input in.csv --output new.csv.zst
  > done
  error: cannot read in.csv.zst: this needs the program zstd, which is not installed (`apt install zstd`)
  error: cannot write new.csv.zst: this needs the program zstd, which is not installed (`apt install zstd`)
  error: cannot read in.csv.zst: this needs the program zstd, which is not installed (`apt install zstd`)
  error: cannot write new.csv.zst: this needs the program zstd, which is not installed (`apt install zstd`)
  [2]

A full disk, which the tool reports:

  $ ln -s /dev/full full.csv.gz; ln -s /dev/full full.csv.zst
  $ for ending in gz zst; do for engine in c interp; do
  >   frobc trace way.frob --engine $engine --input in.csv --output full.csv.$ending 2> said || echo "[$?]"
  >   grep -o 'No space left on device' said; grep error: said | grep -v 'error 70'
  > done; done
  [2]
  No space left on device
  error: cannot write full.csv.gz: gzip ended early
  [2]
  No space left on device
  error: cannot write full.csv.gz: gzip ended early
  [2]
  No space left on device
  error: cannot write full.csv.zst: zstd ended early
  [2]
  No space left on device
  error: cannot write full.csv.zst: zstd ended early
