Arithmetic on known sizes, in types and in expressions.

  $ cat > sizes.frob << 'FROB'
  > type N = 4
  > type Pairs = N - 1
  > type Grid = 2 * N * N + (N - 1)
  > 
  > -- | The differences of neighbours.
  > steps :: Array N Float -> Array Pairs Float
  > steps xs = generate (\i -> at (i + 1) 0 xs - at i 0 xs)
  > 
  > ends :: Array (N - 1) Float -> (Float, Float)
  > ends xs = (xs ! 0, xs ! (Pairs - 1))
  > 
  > main :: SF (Array 4 Float) ((Float, Float), Int, Int, Array (5 - Pairs) Int)
  > main = proc xs -> (ends (steps xs), Grid, length grid, [Pairs, N * Pairs]) where
  >     grid = (generate id :: Array Grid Int)
  > FROB
  $ frobc format --check sizes.frob
  $ printf 'time,in[0],in[1],in[2],in[3]\n0,1,4,9,16\n' > in.csv
  $ for engine in c interp; do frobc trace sizes.frob --engine $engine --input in.csv; done
  time,out.1.1,out.1.2,out.2,out.3,out.4[0],out.4[1]
  0.000000000,3,7,35,35,3,12
  time,out.1.1,out.1.2,out.2,out.3,out.4[0],out.4[1]
  0.000000000,3,7,35,35,3,12

A size from the library, and one of another module:

  $ printf 'type Half = 8\ntype Rest = Half - 3\n' > Other.frob
  $ cat > imported.frob << 'FROB'
  > import Other
  > import Pioneer
  > main :: SF () (Array (PioneerSonars - Half) Int, Int, Int)
  > main = proc () -> (generate id, Other.Half, Rest)
  > FROB
  $ printf 'time\n0\n' | frobc trace imported.frob --input -
  time,out.1[0],out.1[1],out.1[2],out.1[3],out.1[4],out.1[5],out.1[6],out.1[7],out.2,out.3
  0.000000000,0,1,2,3,4,5,6,7,8,5

Mistakes:

  $ check () { cat > "$1.frob" && frobc check "$1.frob"; }
  $ check variable << 'FROB'
  > rest :: Array n a -> Array (n - 1) a
  > rest xs = generate (\i -> at (i + 1) (xs ! 0) xs)
  > FROB
  error[E0330]: `n` is a variable, but arithmetic on sizes needs known numbers
   --> variable.frob:1:29
    |
  1 | rest :: Array n a -> Array (n - 1) a
    |                             ^
    |
    = hint: use another variable for the result, as in `rest :: Array n a -> Array k a`
  
  1 error
  [1]
  $ check none << 'FROB'
  > type N = 4
  > main :: SF (Array (N - 4) Float) Float
  > main = proc xs -> xs ! 0
  > FROB
  error[E0333]: the size of an array must be from 1 to 1048576, not 0
   --> none.frob:2:20
    |
  2 | main :: SF (Array (N - 4) Float) Float
    |                    ^^^^^
  
  1 error
  [1]
  $ check type << 'FROB'
  > type N = 4
  > main :: SF (Array (N * Bool) Float, Array (N + Array 2 Int) Float) Float
  > main = proc (xs, _) -> xs ! 0
  > FROB
  error[E0330]: `Bool` is part of a size, but it is not a number
   --> type.frob:2:24
    |
  2 | main :: SF (Array (N * Bool) Float, Array (N + Array 2 Int) Float) Float
    |                        ^^^^
    |
    = hint: define the size as a number, as in `type N = 25`
  
  error[E0330]: this type is part of a size, but it is not a number
   --> type.frob:2:48
    |
  2 | main :: SF (Array (N * Bool) Float, Array (N + Array 2 Int) Float) Float
    |                                                ^^^^^^^^^^^
    |
    = hint: define the size as a number, as in `type N = 25`
  
  2 errors
  [1]
  $ check operator << 'FROB'
  > type N = 4
  > main :: SF (Array (N / 2) Float) Float
  > main = proc xs -> xs ! 0
  > FROB
  error[E0110]: expected a type argument, `->`, or the end of the type, found `/`
   --> operator.frob:2:22
    |
  2 | main :: SF (Array (N / 2) Float) Float
    |                      ^
    |
    = hint: a size can contain only the operators `+`, `-` and `*`: write the result as a number, or name it, as in `type Half = 8`
  
  1 error
  [1]
  $ check other << 'FROB'
  > type N = 4
  > main :: SF (Array (N <> 2) Float) Float
  > main = proc xs -> xs ! 0
  > FROB
  error[E0110]: type arguments are separated by spaces, as in `Event Distance`, not enclosed in `<>`
   --> other.frob:2:22
    |
  2 | main :: SF (Array (N <> 2) Float) Float
    |                      ^
  
  1 error
  [1]
  $ check bare << 'FROB'
  > type N = 4
  > main :: SF (Array N - 1 Float) Float
  > main = proc xs -> xs ! 0
  > FROB
  error[E0110]: expected an operator or the end of this size, found `Float`
   --> bare.frob:2:25
    |
  2 | main :: SF (Array N - 1 Float) Float
    |                         ^^^^^
    |
    = hint: put arithmetic on sizes in parentheses, as in `Array (N - 1) Float`
  
  1 error
  [1]
  $ check outside << 'FROB'
  > type N = 4
  > f :: Array N - 1 -> Float
  > f xs = 0
  > FROB
  error[E0110]: expected `->` or the end of this type, found `-`
   --> outside.frob:2:14
    |
  2 | f :: Array N - 1 -> Float
    |              ^
    |
    = hint: put arithmetic on sizes in parentheses, as in `Array (N - 1) Float`
  
  1 error
  [1]
  $ check end << 'FROB'
  > type N = 4
  > main :: SF (Array (N - ) Float) Float
  > main = proc xs -> xs ! 0
  > FROB
  error[E0110]: expected a size after this operator, found `)`
   --> end.frob:2:24
    |
  2 | main :: SF (Array (N - ) Float) Float
    |                        ^
    |
    = hint: write, for example, `Array (N - 1) Float`
  
  1 error
  [1]
  $ check huge << 'FROB'
  > type N = 1000000
  > type M = N * N * N * N
  > main :: SF (Array M Float) Float
  > main = proc xs -> xs ! 0
  > FROB
  error[E0333]: the size of an array must be from 1 to 1048576, not 1073741824
   --> huge.frob:2:10
    |
  2 | type M = N * N * N * N
    |          ^^^^^^^^^^^^^
  
  1 error
  [1]
