The compiler can be watched at work, stage by stage.

  $ cat > gain.frob <<EOF
  > main :: SF Float[m] Float[m/s]
  > main = proc x -> 2 * derivative x
  > EOF
  $ for stage in parse types core specialize flow machine; do
  >   echo "== $stage"; frobc compile gain.frob --lint --dump=$stage --stop-after=$stage
  > done
  == parse
  main :: SF Float[m] Float[m/s]
  main = proc x -> 2 * derivative x
  == types
  module Main
  
  main :: SF Float[m] Float[m/s]
  main =
    proc x -> 2 * run derivative x
  == core
  module Main
  
  main :: SF Float Float
  main =
    proc main (x : Float) where
      _1 : Float <- derivative -< x
      -> 2 * _1
  == specialize
  program gain
  signal function main (x : Float)
    _1 : Float = derivative x
    _2 : Float = 2.0 * _1
    -> (out = _2)
  == flow
  program gain
  signal function main (x : Float)
    _1 : Float = derivative x
    _2 : Float = 2.0 * _1
    -> (out = _2)
  == machine
  node main
    self.x_derivative#0 : Float  -- derivative
    self.x_derivative_input#1 : Float  -- its last input
    self.started#2 : Bool  -- past the first instant
    reset ()
      self.x_derivative#0 := 0.0  -- 2
      self.x_derivative_input#1 := 0.0  -- 2
      self.started#2 := false  -- 2
    step (x)
      if self.started#2 && (0.0 < dt)  -- 2
        self.x_derivative#0 := (x - self.x_derivative_input#1) / dt  -- 2
      self.started#2 := true  -- 2
      self.x_derivative_input#1 := x  -- 2
      result.0 := 2.0 * self.x_derivative#0  -- 2
  $ ls gain*
  gain.frob

A dump takes the place of the files:

  $ frobc compile gain.frob --dump=c | grep -c derivative
  7
  $ ls gain*
  gain.frob
