The interpreter reads and writes traces like the host of compiled programs, with
the same error messages.

  $ export XDG_CACHE_HOME=$PWD/cache
  $ cat > turn.frob <<EOF
  > data Side = LeftSide | RightSide | At Float
  > data Request = Request { side :: Side, urgent :: Bool }
  > main :: SF (Request, Event (Maybe Int)) (Event (Maybe Int), Request)
  > main = proc (r, e) -> (e, delay Request { side = LeftSide, urgent = False } r)
  > EOF
  $ both() {
  >   frobc trace turn.frob --input $1 > c.out 2> c.err; c=$?
  >   frobc trace turn.frob --input $1 --engine interp > interp.out 2> interp.err; i=$?
  >   cmp c.out interp.out && cmp c.err interp.err && test $c -eq $i
  >   cat interp.out interp.err
  >   return $i
  > }

Cells are written in Frob's syntax, and quoted if they contain a comma.

  $ cat > in.csv <<EOF
  > time,in.1.urgent,in.2,in.1.side,out.1
  > 0,true,,At (-0.5),ignored
  > 0.0000000015,False,Just 3,"((At 1e3))",
  > 1e0,false,Nothing,RightSide,
  > EOF
  $ both in.csv
  time,out.1,out.2.side,out.2.urgent
  0.000000000,,LeftSide,false
  0.000000002,Just 3,At (-0.5),true
  1.000000000,Nothing,At 1000,false

An invalid header: all errors are reported.

  $ printf 'tim,in.2,in.2,speed\n' > header.csv
  $ both header.csv
  error: header.csv:1:1: the first column must be `time`, but it is `tim`; to choose the column with the times, add `--time-column NAME`
  error: header.csv:1:10: the column `in.2` occurs twice
  error: header.csv:1:15: the program's input has no `speed`
  error: header.csv:1:1: missing: `in.1.side`, `in.1.urgent`; the header for this program is `time,in.1.side,in.1.urgent,in.2`; to read it from another column, add `--column in.1.side=speed`
  [2]

Invalid rows; the rows before them are written.

  $ row() { printf 'time,in.1.side,in.1.urgent,in.2\n0,LeftSide,true,\n%b' "$1" > row.csv; both row.csv | tail -n 1; }
  $ row '1,At,true,\n'
  error: row.csv:3:3: column `in.1.side`: expected a number, found `At`
  $ row '1,LeftSide,yes,\n'
  error: row.csv:3:12: column `in.1.urgent`: expected `true` or `false`, found `yes`
  $ row '1,LeftSide,true,Just 3000000000\n'
  error: row.csv:3:17: column `in.2`: expected an integer from -2147483648 to 2147483647, found `Just 3000000000`
  $ row '1,LeftSide,true\n'
  error: row.csv:3:1: wrong number of cells: the header has 4 columns, but this row has 3
  $ row '-1,LeftSide,true,\n'
  error: row.csv:3:1: the time goes backwards: `-1` comes after a later time
  $ row 'noon,LeftSide,true,\n'
  error: row.csv:3:1: `noon` is not a time in seconds
  $ row '1,"LeftSide,true,\n'
  error: row.csv:3:1: a quoted cell that starts in this row is never closed
  $ row '1,LeftSide,true, \t"Just 3"\n'
  error: row.csv:3:17: there is a space before a quote; remove the spaces next to the commas
  $ row '1, "LeftSide",true,\n'
  error: row.csv:3:3: there is a space before a quote; remove the spaces next to the commas
  $ row '1,"  " ",true,\n'
  error: row.csv:3:4: column `in.1.side`: expected `LeftSide`, `RightSide` or `At`, found `   "`

Missing files.

  $ both missing.csv
  error: cannot read missing.csv: No such file or directory
  [2]
  $ frobc trace turn.frob --input in.csv --engine interp --output no/such/folder.csv
  error: cannot write no/such/folder.csv: No such file or directory
  [2]

A program is rejected for the same reasons, whichever engine would run it.

  $ printf 'main :: SF Float Float\nmain = proc x -> y where\n    y = y + x\n' > loop.frob
  $ frobc trace loop.frob --input in.csv --engine interp 2>&1 | head -n 1
  error[E0401]: the signal `y` needs its own value in the same instant
