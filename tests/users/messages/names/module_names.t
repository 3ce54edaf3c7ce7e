The name of a module begins with a capital letter; that of a program may be any.

  $ cat > wall.frob <<'FROB'
  > limit :: Float -> Float
  > limit x = min x 1
  > FROB
  $ cat > small.frob <<'FROB'
  > import wall
  > 
  > main :: SF Float Float
  > main = arr limit
  > FROB
  $ frobc check small.frob
  error[E0110]: expected the name of a module, starting with a capital letter, found `wall`
   --> small.frob:1:8
    |
  1 | import wall
    |        ^^^^
    |
    = hint: start the name of the module and of its file with a capital letter: `Wall`, in `Wall.frob`
  
  1 error
  [1]
  $ sed 's/import wall/import my-wall (limit)/' small.frob > dash.frob
  $ frobc check dash.frob
  error[E0110]: expected the name of a module, starting with a capital letter, found `my`
   --> dash.frob:1:8
    |
  1 | import my-wall (limit)
    |        ^^
    |
    = hint: start the name of the module and of its file with a capital letter: `MyWall`, in `MyWall.frob`
  
  1 error
  [1]
  $ (echo 'module wall where'; cat wall.frob) > head.frob
  $ frobc check head.frob
  error[E0110]: expected the name of this module, starting with a capital letter, found `wall`
   --> head.frob:1:8
    |
  1 | module wall where
    |        ^^^^
    |
    = hint: start the name of the module and of its file with a capital letter: `Wall`, in `Wall.frob`
  
  1 error
  [1]

The import begins with a capital letter, the file does not:

  $ sed 's/import wall/import Wall/' small.frob > my-robot.frob
  $ frobc check my-robot.frob
  error[E0201]: there is no module `Wall`
   --> my-robot.frob:1:8
    |
  1 | import Wall
    |        ^^^^
    |
    = note: frobc looked for `Wall.frob` in the folder of this file and in the library
    = hint: the file name of a module must start with a capital letter, too: rename `wall.frob` to `Wall.frob`
  
  1 error
  [1]

After the change that the hint suggests:

  $ mv wall.frob Wall.frob
  $ frobc check my-robot.frob
