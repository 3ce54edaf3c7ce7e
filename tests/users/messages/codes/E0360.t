  $ ../../explain/message.exe E0360
  main.frob:
  class HasSonar i where
      frontDistance :: SF i Distance
  
  data Sonars = Sonars { front :: Distance }
  data Bumpers = Bumpers { pressed :: Bool }
  
  instance HasSonar Sonars where
      frontDistance = proc i -> i.front
  
  careful :: HasSonar i => SF i Bool
  careful = proc i -> frontDistance i < 0.5[m]
  
  main :: SF Bumpers Bool
  main = proc i -> careful i
  
  error[E0360]: there is no instance `HasSonar Bumpers`
    --> main.frob:14:18
     |
  10 | careful :: HasSonar i => SF i Bool
     |            ----------------------- `careful` requires `HasSonar i` here
  ...
  14 | main = proc i -> careful i
     |                  ^^^^^^^ `careful` needs it
     |
     = hint: add `instance HasSonar Bumpers where`, and define the methods below it
  
  1 error
