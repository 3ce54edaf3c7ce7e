A local definition can be lifted to the top level. The names that it uses from its surroundings
become its parameters, and it gets a signature.

  $ export PYTHONPATH=$PWD PYTHONDONTWRITEBYTECODE=1
  $ cat > lift.py <<'END'
  > import sys
  > from client import *
  > def applied(text, edits):
  >     starts = [0]
  >     for line in text.split("\n"):
  >         starts.append(starts[-1] + len(line) + 1)
  >     at = lambda p: starts[p["line"]] + p["character"]
  >     for e in sorted(edits, key=lambda e: -at(e["range"]["start"])):
  >         text = text[:at(e["range"]["start"])] + e["newText"] + text[at(e["range"]["end"]):]
  >     return text
  > client = Client(".")
  > def lift(file, mark):
  >     uri = client.open(file)
  >     at = client.at(uri, mark)["position"]
  >     found = client.ask_all("codeAction", uri, range={"start": at, "end": at}, context={"diagnostics": [], "only": ["refactor.extract"]})
  >     for a in found:
  >         print(a["title"], file=sys.stderr)
  >         return applied(client.texts[uri][0], a["edit"]["changes"][uri])
  > END
  $ cat > drive.frob <<'END'
  > import Robot
  > 
  > vMax = 0.5[m/s]
  > 
  > -- | Slower, the nearer it is.
  > approach :: Distance -> SF Distance Velocity
  > approach d = proc x -> v where
  >     -- | What is left.
  >     way = x - d
  >     slow y = bounded (0.5[1/s] * y)
  >       where bounded = max 0 . min top  -- not back
  >     v = slow way
  >     -- At most this.
  >     top :: Velocity
  >     top = vMax / 2
  > 
  > -- | Twice as far.
  > main = reactimateRobot (proc i -> roMake (setVelTR (approach twice (frontSonar i)) 0) where
  >     twice = let half = 0.5[m] in 2 * half)
  > END
  $ for mark in 'way =' 'slow y' 'bounded =' 'top =' 'twice =' 'half =' 'v = slow' 'x - d'; do
  >   echo "-- $mark"
  >   python3 -c "from lift import *; text = lift('drive.frob', '''$mark'''); print(text or 'not offered\n', end=''); client.end()" > after.frob 2>&1
  >   if grep -q '^lift' after.frob; then
  >     sed 1d after.frob > lifted.frob; diff drive.frob lifted.frob
  >     frobc check lifted.frob; frobc format --check lifted.frob
  >   else
  >     cat after.frob
  >   fi
  > done
  -- way =
  8,9d7
  <     -- | What is left.
  <     way = x - d
  12c10
  <     v = slow way
  ---
  >     v = slow (way x d)
  15a14,17
  > 
  > -- | What is left.
  > way :: n[u] -> n[u] -> n[u]
  > way x d = x - d
  -- slow y
  10,12c10
  <     slow y = bounded (0.5[1/s] * y)
  <       where bounded = max 0 . min top  -- not back
  <     v = slow way
  ---
  >     v = slow top way
  15a14,17
  > 
  > slow :: Float[u] -> Float[u s] -> Float[u]
  > slow top y = bounded (0.5[1/s] * y)
  >   where bounded = max 0 . min top  -- not back
  -- bounded =
  10,11c10
  <     slow y = bounded (0.5[1/s] * y)
  <       where bounded = max 0 . min top  -- not back
  ---
  >     slow y = bounded top (0.5[1/s] * y)
  15a15,17
  > 
  > bounded :: n[u] -> n[u] -> n[u]
  > bounded top = max 0 . min top  -- not back
  -- top =
  13,15c13,16
  <     -- At most this.
  <     top :: Velocity
  <     top = vMax / 2
  ---
  > 
  > -- At most this.
  > top :: Velocity
  > top = vMax / 2
  -- twice =
  18,19c18,21
  < main = reactimateRobot (proc i -> roMake (setVelTR (approach twice (frontSonar i)) 0) where
  <     twice = let half = 0.5[m] in 2 * half)
  ---
  > main = reactimateRobot (proc i -> roMake (setVelTR (approach twice (frontSonar i)) 0))
  > 
  > twice :: Float[m]
  > twice = let half = 0.5[m] in 2 * half
  -- half =
  not offered
  -- v = slow
  7c7
  < approach d = proc x -> v where
  ---
  > approach d = proc x -> v slow way where
  12d11
  <     v = slow way
  15a15,17
  > 
  > v :: (a -> b) -> a -> b
  > v slow way = slow way
  -- x - d
  not offered

A formatted program stays formatted: a line that becomes too long because of the name's arguments is
broken.

  $ cat > drive.frob <<'END'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR speed 0) where
  >     wantedDistance = 0.6[m] + 0 * frontSonar i
  >     gainOfTheController = 0.5[1/s]
  >     slow y = gainOfTheController * (y - wantedDistance)
  >     speed = max (slow (sideSonar i)) (min (slow (frontSonar i)) (slow (rightSonar i))))
  > END
  $ frobc format drive.frob
  $ python3 -c "from lift import *; text = lift('drive.frob', 'slow y'); print(text, end=''); client.end()" > lifted.frob
  lift `slow` to the top level
  $ frobc check lifted.frob; frobc format --check lifted.frob; cat lifted.frob
  import Robot
  
  main = reactimateRobot (proc i -> roMake (setVelTR speed 0) where
      wantedDistance = 0.6[m] + 0 * frontSonar i
      gainOfTheController = 0.5[1/s]
      speed = max (slow gainOfTheController wantedDistance (sideSonar i))
          (min (slow gainOfTheController wantedDistance (frontSonar i))
              (slow gainOfTheController wantedDistance (rightSonar i))))
  
  slow :: n[u] -> n[v] -> n[v] -> n[u v]
  slow gainOfTheController wantedDistance y = gainOfTheController * (y - wantedDistance)
