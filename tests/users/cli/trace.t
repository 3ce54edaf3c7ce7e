`frobc trace` runs a signal function on recorded input.

  $ cat > sum.frob <<EOF
  > main :: SF Float[m/s] (Distance, Bool)
  > main = proc v -> (x, x > 0.3[m]) where
  >     x = integral v
  > EOF
  $ cat > in.csv <<EOF
  > time,in
  > 0,1
  > 0.1,2
  > 0.2,nan
  > 0.3,0
  > EOF
  $ frobc trace sum.frob --input in.csv
  time,out.1,out.2
  0.000000000,0,false
  0.100000000,0.10000000000000001,false
  0.200000000,0.30000000000000004,true
  0.300000000,nan,false
  $ frobc trace sum.frob --input in.csv --output out.csv && cat out.csv
  time,out.1,out.2
  0.000000000,0,false
  0.100000000,0.10000000000000001,false
  0.200000000,0.30000000000000004,true
  0.300000000,nan,false
  $ frobc trace sum.frob --input - < in.csv | tail -1
  0.300000000,nan,false

A recording with outputs can be replayed; columns may have any order; quotes,
CRLF and spaces are accepted:

  $ printf '\357\273\277time,out.1,in\r\n"0", 7,"1.5"\r\n0.5,7,2\r\n' > recorded.csv
  $ frobc trace sum.frob --input recorded.csv
  time,out.1,out.2
  0.000000000,0,false
  0.500000000,0.75,true

An event or a sum has one cell; each component of a tuple or record has a
column:

  $ cat > cells.frob <<EOF
  > import Geometry
  > data Side = LeftSide | RightSide | At Distance
  > main :: SF (Event Float, Side, Maybe (Int, Bool)) (Event (Float, Float), Side, Maybe Pose)
  > main = proc (e, side, m) -> (twice, other, pose) where
  >     twice = case e of
  >         NoEvent -> NoEvent
  >         Event x -> Event (x, -x)
  >     other = case side of
  >         LeftSide -> RightSide
  >         RightSide -> At (-0.5[m])
  >         At d -> At (2 * d)
  >     pose = case m of
  >         Just (n, True) -> Just Pose { position = Vec2 { x = 1[m], y = 2[m] }, heading = toFloat n }
  >         _ -> Nothing
  > EOF
  $ cat > cells.csv <<EOF
  > time,in.1,in.2,in.3
  > 0,,LeftSide,Nothing
  > 1,2.5,RightSide,"Just (3, true)"
  > 2,-1,At (-0.25),"Just (-3, True)"
  > EOF
  $ frobc trace cells.frob --input cells.csv
  time,out.1,out.2,out.3
  0.000000000,,RightSide,Nothing
  1.000000000,"(2.5, -2.5)",At (-0.5),"Just Pose {position = Vec2 {x = 1, y = 2}, heading = 3}"
  2.000000000,"(-1, 1)",At (-0.5),"Just Pose {position = Vec2 {x = 1, y = 2}, heading = -3}"

Mistakes in the input are reported with their places:

  $ trace() { cat > wrong.csv; frobc trace sum.frob --input wrong.csv; }
  $ trace < /dev/null
  error: wrong.csv:1:1: the file is empty: its first line must name the columns, `time` first
  [2]
  $ printf 't,in\n0,1\n' | trace
  error: wrong.csv:1:1: the first column must be `time`, but it is `t`; to choose the column with the times, add `--time-column t`
  [2]
  $ printf 'time,in,inn\n0,1,1\n' | trace
  error: wrong.csv:1:9: the program's input has no `inn`
  [2]
  $ printf 'time\n0\n' | trace
  error: wrong.csv:1:1: missing: `in`; the header for this program is `time,in`
  [2]
  $ printf 'time,in,in\n0,1,1\n' | trace
  error: wrong.csv:1:9: the column `in` occurs twice
  [2]
  $ printf 'time,in\n0,fast\n' | trace
  error: wrong.csv:2:3: column `in`: expected a number, found `fast`
  time,out.1,out.2
  [2]
  $ printf 'time,in\n0,1\n1\n' | trace
  error: wrong.csv:3:1: wrong number of cells: the header has 2 columns, but this row has 1
  time,out.1,out.2
  0.000000000,0,false
  [2]
  $ printf 'time,in\n0,1\n1,2,3\n' | trace
  error: wrong.csv:3:5: wrong number of cells: the header has 2 columns, but this row has 3; put a cell that contains a comma in double quotes
  time,out.1,out.2
  0.000000000,0,false
  [2]
  $ printf 'time,in\n1,1\n0.5,1\n' | trace
  error: wrong.csv:3:1: the time goes backwards: `0.5` comes after a later time
  time,out.1,out.2
  1.000000000,0,false
  [2]
  $ printf 'time,in\nsoon,1\n' | trace
  error: wrong.csv:2:1: `soon` is not a time in seconds
  time,out.1,out.2
  [2]
  $ printf 'time,in\n0,"1\n' | trace
  error: wrong.csv:2:1: a quoted cell that starts in this row is never closed
  time,out.1,out.2
  [2]
  $ printf 'time,in\n0,1\n0,2\n' | trace
  time,out.1,out.2
  0.000000000,0,false
  0.000000000,0,false
  $ frobc trace sum.frob --input nowhere.csv
  error: cannot read nowhere.csv: No such file or directory
  [2]
  $ frobc trace sum.frob --input in.csv --output no/such/folder.csv
  error: cannot write no/such/folder.csv: No such file or directory
  [2]

Input files are not overwritten: the recording, under any name, and the program.

  $ cp in.csv log.csv; ln -s log.csv link.csv
  $ frobc trace sum.frob --input log.csv --output log.csv
  error: --output would overwrite log.csv, which is an input: use another file name
  [2]
  $ frobc trace sum.frob --input log.csv --output link.csv --engine interp
  error: --output would overwrite log.csv, which is an input: use another file name
  [2]
  $ frobc trace sum.frob --input log.csv --output ./sum.frob
  error: --output would overwrite sum.frob, which is an input: use another file name
  [2]
  $ cmp in.csv log.csv

  $ frobc trace sum.frob --input in.csv --entry mian
  error[E0501]: this module has no `mian` to compile
   --> sum.frob:1:1
    |
  1 | main :: SF Float[m/s] (Distance, Bool)
    | ^
    |
    = hint: did you mean `--entry main`?
  
  1 error
  [2]
