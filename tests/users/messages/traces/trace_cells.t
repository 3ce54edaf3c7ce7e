A cell that does not fit its column: both engines say what was expected, and what was found.

  $ cat > stick.frob <<'FROB'
  > data Mode = Slow | Normal | Fast
  > data Input = Input { mode :: Event Mode, top :: Maybe (Float[m/s], Float[m/s]), side :: Float }
  > main :: SF Input Float
  > main = proc i -> if hold Slow i.mode == Fast then i.side else 0
  > FROB
  $ given() { { echo 'time,in.mode,in.top,in.side'; cat; } > in.csv; }
  $ both() { for engine in c interp; do frobc trace stick.frob --input in.csv --engine $engine > /dev/null || echo "[$?]"; done; }

The constructors that are possible.

  $ echo '0,Fst,Nothing,0' | given && both
  error: in.csv:2:3: column `in.mode`: expected `Slow`, `Normal` or `Fast`, found `Fst`
  [2]
  error: in.csv:2:3: column `in.mode`: expected `Slow`, `Normal` or `Fast`, found `Fst`
  [2]
  $ echo '0,Fast,None,0' | given && both
  error: in.csv:2:8: column `in.top`: expected `Nothing` or `Just`, found `None`
  [2]
  error: in.csv:2:8: column `in.top`: expected `Nothing` or `Just`, found `None`
  [2]

A number is in the unit of the program; the cell has no unit.

  $ echo '0,,Nothing,2 m/s' | given && both
  error: in.csv:2:12: column `in.side`: expected nothing after the number, found `2 m/s`
  [2]
  error: in.csv:2:12: column `in.side`: expected nothing after the number, found `2 m/s`
  [2]
  $ echo '0,,Nothing,' | given && both
  error: in.csv:2:12: column `in.side`: expected a number, found an empty cell
  [2]
  error: in.csv:2:12: column `in.side`: expected a number, found an empty cell
  [2]

A comma ends a cell, unless it is quoted.

  $ echo '0,,Just (1, 2),0' | given && both
  error: in.csv:2:16: wrong number of cells: the header has 4 columns, but this row has 5; put a cell that contains a comma in double quotes
  [2]
  error: in.csv:2:16: wrong number of cells: the header has 4 columns, but this row has 5; put a cell that contains a comma in double quotes
  [2]
  $ echo '0,,"Just (1, 2)",0' | given && both
