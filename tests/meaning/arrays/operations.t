The size of an array is part of its type; each element is a column of a trace.
Both engines agree.

  $ cat > ring.frob <<'EOF'
  > type N = 4
  > main :: SF (Array N Float[m]) (Float[m], Float[m], Array N Bool, Array N Float[m], Float[m])
  > main = proc xs -> (foldl (+) 0 xs, minimumBy id xs, map (> 1[m]) xs, mapSF (delay 0) xs, at 9 (-1[m]) xs)
  > EOF
  $ printf 'time,in[0],in[1],in[2],in[3]\n0,1,2,3,4\n1,0,5,1,2\n' > ring.csv
  $ frobc trace ring.frob --input ring.csv
  time,out.1,out.2,out.3[0],out.3[1],out.3[2],out.3[3],out.4[0],out.4[1],out.4[2],out.4[3],out.5
  0.000000000,10,1,false,true,true,true,0,0,0,0,-1
  1.000000000,8,0,false,true,false,true,1,2,3,4,-1
  $ frobc trace ring.frob --input ring.csv > c.csv
  $ frobc trace ring.frob --input ring.csv --engine interp | cmp - c.csv

A constant index outside the array is an error:

  $ cat > outside.frob <<'EOF'
  > main :: SF (Array 3 Float) Float
  > main = proc xs -> xs ! 3
  > EOF
  $ frobc check outside.frob
  error[E0332]: index 3 is out of range for an array of 3 elements
   --> outside.frob:2:24
    |
  2 | main = proc xs -> xs ! 3
    |                   --   ^
    |                   |
    |                   this is `Array 3 Float`
    |
    = hint: the first element is `xs ! 0`, the last `xs ! 2`; check the other indices too
  
  1 error
  [1]
