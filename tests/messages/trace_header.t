A recording with other columns is told the whole header, once, by both engines.

  $ cat > eyes.frob <<'FROB'
  > data Eyes = Eyes { left :: Float, right :: Float }
  > main :: SF Eyes Float
  > main = proc e -> e.left - e.right
  > FROB
  $ printf 'time,left,right\n0,1,2\n' > eyes.csv
  $ frobc trace eyes.frob --input eyes.csv
  error: eyes.csv:1:6: the program's input has no `left`
  error: eyes.csv:1:11: the program's input has no `right`
  error: eyes.csv:1:1: missing: `in.left`, `in.right`; the header for this program is `time,in.left,in.right`
  [2]
  $ frobc trace eyes.frob --input eyes.csv --engine interp
  error: eyes.csv:1:6: the program's input has no `left`
  error: eyes.csv:1:11: the program's input has no `right`
  error: eyes.csv:1:1: missing: `in.left`, `in.right`; the header for this program is `time,in.left,in.right`
  [2]
