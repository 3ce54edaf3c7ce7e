One behaviour for several robots: their sensors are a class. Its methods are
values, functions and signal functions, with state and with defaults; both
engines agree.

  $ cat > Sensors.frob <<EOF
  > class HasSonar i where
  >     frontDistance :: SF i Distance
  >     unseen :: i
  >     blocked :: SF i Bool
  >     blocked = proc i -> frontDistance i < 0.5[m]
  > 
  > class HasSonar i => Careful i where
  >     margin :: i -> Distance
  >     margin _ = 0.25[m]
  > 
  > -- A sensor that may be silent.
  > instance HasSonar i => HasSonar (Maybe i) where
  >     frontDistance = proc m -> frontDistance (fromMaybe unseen m)
  >     unseen = Nothing
  > 
  > instance Careful i => Careful (Maybe i) where
  >     margin m = case m of
  >         Nothing -> 2[m]
  >         Just i -> margin i
  > EOF
  $ frobc check --lint Sensors.frob
  $ cat > robots.frob <<EOF
  > import Sensors (HasSonar, Careful)
  > data Little = Little { echo :: Distance }
  > data Big = Big { left, right :: Distance, pressed :: Bool }
  > 
  > instance HasSonar Little where
  >     frontDistance = proc i -> i.echo
  >     unseen = Little { echo = 9[m] }
  > 
  > instance HasSonar Big where
  >     frontDistance = proc i -> (near + delay 1[m] near) / 2 where
  >         near = min i.left i.right
  >     unseen = Big { left = 8[m], right = 8[m], pressed = False }
  >     blocked = proc i -> i.pressed
  > 
  > instance Careful Little
  > instance Careful Big where
  >     margin b = if b.pressed then 1[m] else 0.5[m]
  > 
  > drive :: Careful i => SF i (Velocity, Bool)
  > drive = proc i -> (v, stop) where
  >     stop = blocked i
  >     d = frontDistance i
  >     v = if stop then 0 else (d - margin i) / 1[s]
  > 
  > main :: SF (Little, Big, Maybe Big) ((Velocity, Bool), (Velocity, Bool), (Velocity, Bool))
  > main = proc (l, b, m) -> (drive l, drive b, drive m)
  > EOF
  $ cat > in.csv <<EOF
  > time,in.1.echo,in.2.left,in.2.right,in.2.pressed,in.3
  > 0,2,3,4,false,Nothing
  > 0.1,1,2,4,false,"Just Big { left = 1, right = 2, pressed = true }"
  > 0.2,0.25,nan,1,false,"Just Big { left = 1, right = 2, pressed = false }"
  > 0.3,1,1,1,true,Nothing
  > EOF
  $ frobc trace robots.frob --input in.csv
  time,out.1.1,out.1.2,out.2.1,out.2.2,out.3.1,out.3.2
  0.000000000,1.75,false,1.5,false,2.5,false
  0.100000000,0.75,false,2,false,3.5,false
  0.200000000,0,true,nan,false,0.5,false
  0.300000000,0.75,false,0,true,2.5,false
  $ frobc trace --engine interp robots.frob --input in.csv > interp.csv
  $ frobc trace robots.frob --input in.csv | diff - interp.csv

If the constructor is known, the instance's definition is used directly; a
method at a type variable is resolved when its type is known.

  $ frobc check --lint --dump=core robots.frob | sed -n '/^drive/,$p'
  drive @i :: SF i (Float, Bool)
  drive =
    proc drive (i : i) where
      stop : Bool <- blocked @i -< i
      d : Float <- frontDistance @i -< i
      v : Float = if stop then 0 else (d - margin @i i) / 1
      -> (v, stop)
  
  main :: SF (Little, Big, Prelude.Maybe Big) ((Float, Bool),
                                               (Float, Bool),
                                               (Float, Bool))
  main =
    proc main (_1 : (Little, Big, Prelude.Maybe Big)) where
      l : Little = _1.0
      b : Big = _1.1
      m : Prelude.Maybe Big = _1.2
      _2 : (Float, Bool) <- drive @Little -< l
      _3 : (Float, Bool) <- drive @Big -< b
      _4 : (Float, Bool) <- drive @(Prelude.Maybe Big) -< m
      -> (_2, _3, _4)
  
  frontDistance@Little :: SF Little Float
  frontDistance@Little =
    proc frontDistance@Little (i : Little) where
      -> i.Little.0
  
  unseen@Little :: Little
  unseen@Little =
    Little 9
  
  frontDistance@Big :: SF Big Float
  frontDistance@Big =
    proc frontDistance@Big (i : Big) where
      near : Float = min @Float i.Big.0 i.Big.1
      _1 : Float <- delay @Float 1 -< near
      -> (near + _1) / 2
  
  unseen@Big :: Big
  unseen@Big =
    Big 8 8 False
  
  blocked@Big :: SF Big Bool
  blocked@Big =
    proc blocked@Big (i : Big) where
      -> i.Big.2
  
  margin@Big :: Big -> Float
  margin@Big =
    \(b : Big) -> if b.Big.2 then 1 else 0.5
  
  instance Sensors.HasSonar Little
    frontDistance = frontDistance@Little
    unseen = unseen@Little
    default Sensors.blocked
  
  instance Sensors.HasSonar Big
    frontDistance = frontDistance@Big
    unseen = unseen@Big
    blocked = blocked@Big
  
  instance Sensors.Careful Big
    margin = margin@Big
