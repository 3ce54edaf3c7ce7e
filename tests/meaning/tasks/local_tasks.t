A task may continue as itself in a `where`, and use names of the enclosing definition.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > local.frob <<'EOF'
  > data Lamp = Off | On
  > 
  > main :: SF Float (Either Lamp Int)
  > main = runTask (blinks 0.5[s] 3)
  > 
  > blinks :: Time -> Int -> Task Float Lamp Int
  > blinks half most = go 1 where
  >     go :: Int -> Task Float Lamp Int
  >     go n = do
  >         sleepT (max 1[ms] half) On
  >         sleepT pause Off
  >         if n >= most then return n else go (n + 1)
  >     pause = max 1[ms] (half * 2)
  > EOF
  $ printf 'time,in\n0,0\n1,2\n2,-1\n3,4\n4,0\n5,1\n6,-2\n7,3\n' > in.csv
  $ both local.frob in.csv
  time,out
  0.000000000,Left On
  1.000000000,Left Off
  2.000000000,Left On
  3.000000000,Left Off
  4.000000000,Left On
  5.000000000,Left Off
  6.000000000,Right 3
  7.000000000,Right 3
