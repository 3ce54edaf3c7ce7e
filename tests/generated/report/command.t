One JSON object for tools:

  $ cat > twice.frob <<EOF
  > main :: SF Float Float
  > main = proc x -> 2 * delay 0 (hypot x 1)
  > EOF
  $ frobc report twice.frob --format=json
  {"program":"twice","entry":{"name":"main","file":"twice.frob","line":2},"state_bytes":8,"foreign_structs":[],"structs":[{"name":"main","file":"twice.frob","line":2,"bytes":8,"members":[{"name":"delay","line":2,"offset":0,"bytes":8,"holds":"value","purpose":"delay"}]}],"step_operations":{"additions":0,"multiplications":1,"divisions":0,"comparisons_and_choices":0,"conversions":0,"loads_of_state":1,"stores_of_state":1,"calls":{"hypot":1}},"reset_stack_bytes":56,"step_stack_bytes":104,"library":["hypot"],"machines":[],"console":[],"params":[],"params_bytes":0,"marks":0,"wire":null,"assertions":0,"assertion_operations":0,"assertion_bytes":0}

An entry other than main:

  $ cat >> twice.frob <<EOF
  > 
  > other :: SF Float Float
  > other = delay 1
  > EOF
  $ frobc report twice.frob --entry other | head -3
  state, in bytes
    other    8         twice.frob:5
      delay  8  delay  twice.frob:5

A rejected program has no report:

  $ cat > wrong.frob <<EOF
  > main :: SF Float Float
  > main = proc x -> y where
  >   y = y + x
  > EOF
  $ frobc report wrong.frob
  error[E0401]: the signal `y` needs its own value in the same instant
   --> wrong.frob:3:3
    |
  3 |   y = y + x
    |   ^   ----- `y` reads `y` here
    |
    = hint: let `y` read its own previous value: write `y = delay 0 y + x`, where 0 is the initial value
  
  1 error
  [1]
  $ frobc report wrong.frob --entry nothing
  error[E0501]: this module has no `nothing` to compile
   --> wrong.frob:1:1
    |
  1 | main :: SF Float Float
    | ^
    |
    = hint: define `main`, or name a signal function of this module with `--entry NAME`
  
  1 error
  [2]
  $ frobc report missing.frob
  error: there is no file missing.frob
  [2]

With --dump, the command prints the dump instead:

  $ frobc report twice.frob --dump=step | head -2
  node main
    self.delay#0 : Float  -- delay
