For a recording with other columns, both engines report the whole header, once.

  $ cat > eyes.frob <<'FROB'
  > data Eyes = Eyes { left :: Float, right :: Float }
  > main :: SF Eyes Float
  > main = proc e -> e.left - e.right
  > FROB
  $ printf 'time,left,right\n0,1,2\n' > eyes.csv
  $ frobc trace eyes.frob --input eyes.csv
  error: eyes.csv:1:6: the program's input has no `left`
  error: eyes.csv:1:11: the program's input has no `right`
  error: eyes.csv:1:1: missing: `in.left`, `in.right`; the header for this program is `time,in.left,in.right`; to read it from another column, add `--column in.left=NAME`
  [2]
  $ frobc trace eyes.frob --input eyes.csv --engine interp
  error: eyes.csv:1:6: the program's input has no `left`
  error: eyes.csv:1:11: the program's input has no `right`
  error: eyes.csv:1:1: missing: `in.left`, `in.right`; the header for this program is `time,in.left,in.right`; to read it from another column, add `--column in.left=NAME`
  [2]

A space next to a comma is part of the column's name or of a time, and both
engines point it out; other cells may have spaces.

  $ both () {
  >     frobc trace eyes.frob --input $1 >/dev/null
  >     frobc trace eyes.frob --input $1 --engine interp >/dev/null
  > }
  $ printf 'time, in.left,in.right\n0,1,2\n' > header.csv
  $ both header.csv
  error: header.csv:1:6: the program's input has no ` in.left`; remove the spaces next to the commas
  error: header.csv:1:1: missing: `in.left`; the header for this program is `time,in.left,in.right`
  error: header.csv:1:6: the program's input has no ` in.left`; remove the spaces next to the commas
  error: header.csv:1:1: missing: `in.left`; the header for this program is `time,in.left,in.right`
  [2]
  $ printf 'time ,in.left,in.right\n0,1,2\n' > first.csv
  $ both first.csv
  error: first.csv:1:1: the first column must be `time`, but it is `time `; remove the spaces next to the commas
  error: first.csv:1:1: the first column must be `time`, but it is `time `; remove the spaces next to the commas
  [2]
  $ printf 'time,in.left,in.right\n0\t,1,2\n' > time.csv
  $ both time.csv
  error: time.csv:2:1: `0\009` is not a time in seconds; remove the spaces next to the commas
  error: time.csv:2:1: `0\009` is not a time in seconds; remove the spaces next to the commas
  [2]
  $ printf 'time,in.left,in.right\n0, 1 , 2\n' > cell.csv
  $ both cell.csv
