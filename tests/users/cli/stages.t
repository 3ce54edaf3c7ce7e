Options show the program after each stage of the compiler.

  $ cat > gain.frob <<EOF
  > main :: SF Float[m] Float[m/s]
  > main = proc x -> 2 * derivative x
  > EOF
  $ for stage in parse types core specialize flow step; do
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
  == step
  node main
    self.x_derivative#0 : Float  -- derivative
    self.x_derivative_input#1 : Float  -- previous input
    self.started#2 : Bool  -- true after the first instant
    reset ()
      self.x_derivative#0 := 0.0  -- 2
      self.x_derivative_input#1 := 0.0  -- 2
      self.started#2 := false  -- 2
    step (x)
      if 0.0 < dt  -- 2
        self.x_derivative#0 := (x - self.x_derivative_input#1) / dt  -- 2
      self.x_derivative_input#1 := x  -- 2
      result.0 := 2.0 * self.x_derivative#0  -- 2
  $ ls gain*
  gain.frob

With a dump, no files are written:

  $ frobc compile gain.frob --dump=c | grep -c derivative
  7
  $ ls gain*
  gain.frob

The optimizer's passes, each with the reason for its position, and the program after each pass that
changes it:

  $ cat > twice.frob <<END
  > main :: SF Float (Float, Float)
  > main = proc x -> (2 * double x, if delay False False then 1 else 3 * double x)
  > 
  > double :: Float -> Float
  > double x = x + x
  > END
  $ frobc compile twice.frob --dump=passes --stop-after=passes
  constant-propagation: first, because literals can decide which branch of a choice is taken
  program twice
  function double (x : Float)
    _1 : Float = x + x
    -> (out = _1)
  signal function main (x : Float)
    _1 : Bool = delay False False
    _2 : Float = 2.0 * _5
    _3 : Float = 3.0 * _6
    _4 : Float = if _1 then 1.0 else _3
    (_5 : Float) = double as double(x)
    (_6 : Float) = double as double_2(x)
    -> (out.1 = _2, out.2 = _4)
  
  simplify: after constant propagation, so that all known operands are literals
  program twice
  function double (x : Float)
    _1 : Float = x + x
    -> (out = _1)
  signal function main (x : Float)
    _1 : Float = 2.0 * _3
    _2 : Float = 3.0 * _4
    (_3 : Float) = double as double(x)
    (_4 : Float) = double as double_2(x)
    -> (out.1 = _1, out.2 = _2)
  
  common-subexpressions: after simplification, which turns equivalent expressions into equal ones
  program twice
  function double (x : Float)
    _1 : Float = x + x
    -> (out = _1)
  signal function main (x : Float)
    _1 : Float = 2.0 * _3
    _2 : Float = 3.0 * _3
    (_3 : Float) = double as double(x)
    -> (out.1 = _1, out.2 = _2)
  
  inline: after the nodes are simplified, so that their sizes are final and repeated calls are inlined once
  program twice
  function double (x : Float)
    _1 : Float = x + x
    -> (out = _1)
  signal function main (x : Float)
    _1 : Float = 2.0 * _2
    _2 : Float = x + x
    _3 : Float = 3.0 * _2
    -> (out.1 = _1, out.2 = _3)
  
  dead-code: last, because every other pass leaves unused equations behind
  program twice
  signal function main (x : Float)
    _1 : Float = 2.0 * _2
    _2 : Float = x + x
    _3 : Float = 3.0 * _2
    -> (out.1 = _1, out.2 = _3)
  

The passes after the optimizer, in Step:

  $ frobc compile gain.frob --dump=passes --stop-after=step | grep -A1 'instant:\|resets:\|order:'
  first-instant: first, because it may add a field to the root's state
  node main
