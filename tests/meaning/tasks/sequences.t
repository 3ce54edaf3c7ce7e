Tasks in sequence. The next task starts at the instant at which the previous one
ends, on the same input.

  $ . ./trace.sh

  $ cat > patrol.frob <<'EOF'
  > drive :: Float -> Task Float Float Bool
  > drive v = mkTask (proc x -> (v, if x > v then Event (x > 5) else NoEvent))
  > 
  > patrol :: Float -> Task Float Float ()
  > patrol v = do
  >     far <- drive v
  >     if far then return () else do
  >         sleepT 1[s] (-v)
  >         patrol (v + 1)
  > 
  > main = runTask (patrol 1)
  > EOF
  $ printf '%s\n' 0 1 2 1 1 2 2.5 9 9 0 | rows in | trace patrol
  time,out
  0.000000000,Left 1
  0.500000000,Left 1
  1.000000000,Left (-1)
  1.500000000,Left (-1)
  2.000000000,Left 2
  2.500000000,Left 2
  3.000000000,Left (-2)
  3.500000000,Left (-2)
  4.000000000,Right ()
  4.500000000,Right ()

Patterns, `let`, `case` with guards, nested `do`, discarded results; `return` takes no time.

  $ cat > statements.frob <<'EOF'
  > data Seen = Seen { far :: Float, count :: Int }
  > 
  > look :: Task Float Float Seen
  > look = mkTask (proc x -> (0, tag (edge (x > 1)) (Seen { far = x, count = 3 })))
  > 
  > whole :: Task Float Float (Int, Float)
  > whole = do
  >     Seen { far = f, count = n } <- look
  >     _ <- return True
  >     (a, b) <- do
  >         let double = 2 * f
  >             again = double + f
  >         sleepT 0.5[s] again
  >         return (double, n)
  >     case b of
  >         2 -> return (0, 0)
  >         _ | a > 100 -> return (1, a)
  >           | otherwise -> do
  >             x <- snapT
  >             sleepT 0.5[s] x
  >             return (n, a + x)
  > 
  > main = runTask whole
  > EOF
  $ printf '%s\n' 0 0 3 4 5 6 7 8 | rows in | trace statements
  time,out
  0.000000000,Left 0
  0.500000000,Left 0
  1.000000000,Left 9
  1.500000000,Left 4
  2.000000000,"Right (3, 10)"
  2.500000000,"Right (3, 10)"
  3.000000000,"Right (3, 10)"
  3.500000000,"Right (3, 10)"

Tasks are values: polymorphic, passed, returned, chosen, built by functions, and
mutually recursive with parameters.

  $ cat > results.frob <<'EOF'
  > -- | Both in turn, n times.
  > alternate :: Int -> Task a b c -> Task a b d -> Task a b Int
  > alternate n s t = other n 0 s t
  > 
  > other :: Int -> Int -> Task a b c -> Task a b d -> Task a b Int
  > other n k s t = if k >= n then return k else do
  >     s
  >     another n (k + 1) s t
  > 
  > another :: Int -> Int -> Task a b c -> Task a b d -> Task a b Int
  > another n k s t = if k >= n then return (-k) else do
  >     t
  >     other n (k + 1) s t
  > 
  > pick :: Bool -> Float -> Task Float Float ()
  > pick quick y = if quick then sleepT 0.5[s] y else slow where
  >     slow = do
  >         sleepT 0.5[s] y
  >         sleepT 0.5[s] (-y)
  > 
  > main :: SF Float (Either Float Int)
  > main = runTask (do
  >     quick <- mapT (> 1) snapT
  >     n <- alternate 3 (pick quick 1) (pick (not quick) 2)
  >     sleepT 0.5[s] 10
  >     return n)
  > EOF
  $ printf '%s\n' 0 0 3 4 5 6 7 8 9 | rows in | trace results
  time,out
  0.000000000,Left 1
  0.500000000,Left (-1)
  1.000000000,Left 2
  1.500000000,Left 1
  2.000000000,Left (-1)
  2.500000000,Left 10
  3.000000000,Right (-3)
  3.500000000,Right (-3)
  4.000000000,Right (-3)
  $ printf '%s\n' 2 0 3 4 5 6 7 8 9 | rows in | trace results
  time,out
  0.000000000,Left 1
  0.500000000,Left 2
  1.000000000,Left (-2)
  1.500000000,Left 1
  2.000000000,Left 10
  2.500000000,Right (-3)
  3.000000000,Right (-3)
  3.500000000,Right (-3)
  4.000000000,Right (-3)

A task in a `proc` is static, so it runs there like a signal function.

  $ cat > inside.frob <<'EOF'
  > main :: SF Float (Float, Bool)
  > main = proc x -> (either id (const (-1)) r, delay False (x > 2)) where
  >     pause = do
  >         sleepT 1[s] 5
  >         mkTask (proc y -> (y, edge (y > 3)))
  >     r = runTask pause (2 * x)
  > EOF
  $ printf '%s\n' 0 1 1 1 3 1 | rows in | trace inside
  time,out.1,out.2
  0.000000000,5,false
  0.500000000,5,false
  1.000000000,2,false
  1.500000000,2,false
  2.000000000,-1,false
  2.500000000,-1,true
