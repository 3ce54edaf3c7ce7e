Vectors, angles and poses, compared with values computed by hand.

  $ . ./trace.sh

Vectors in the plane:

  $ cat > plane.frob << FROB
  > import Geometry
  > main :: SF (Vec2[m], Vec2[m]) (Vec2[m], Vec2[m], Vec2[m^2], Vec2[m], Float[m^2], Float[m^2], Float[m], Float[m])
  > main = proc (a, b) -> (a ^+^ b, a ^-^ b, 2[m] *^ a, zeroVec, dot a b, cross a b, norm a, distance a b)
  > FROB
  $ printf '%s\n' 3,4,0,0 3,4,-1,2 1,0,0,1 | rows in.1.x,in.1.y,in.2.x,in.2.y | trace plane | cells
  3,4,3,4,6,8,0,0,0,0,5,5
  2,6,4,2,6,8,0,0,5,10,5,4.4721359549995796
  1,1,1,-1,2,0,0,0,0,1,1,1.4142135623730951
  $ single plane

Directions; the vector with a given length and angle; rotations, in degrees:

  $ cat > directions.frob << FROB
  > import Geometry
  > main :: SF (Vec2[m], Angle) (Float, Vec2[m], Vec2[m])
  > main = proc (a, degrees) -> (direction a / 1[deg], polar 2[m] (degrees * 1[deg]), rotate (degrees * 1[deg]) a)
  > FROB
  $ printf '%s\n' 1,0,0 0,1,90 -1,0,180 0,-1,-90 1,1,45 0,0,30 | rows in.1.x,in.1.y,in.2 |
  > trace directions | cells | tr ',' '\n' | awk '{ printf "%.6f%s", $1 + 0, NR % 5 ? " " : "\n" }' | sed 's/-0\.000000/0.000000/g'
  0.000000 2.000000 0.000000 1.000000 0.000000
  90.000000 0.000000 2.000000 -1.000000 0.000000
  180.000000 -2.000000 0.000000 1.000000 0.000000
  -90.000000 0.000000 -2.000000 -1.000000 0.000000
  45.000000 1.414214 1.414214 0.000000 1.414214
  0.000000 1.732051 1.000000 0.000000 0.000000
  $ single directions

Vectors in space: the cross product of x and y is z, and is perpendicular to
both.

  $ cat > space.frob << FROB
  > import Geometry
  > main :: SF (Vec3[m], Vec3[m]) (Vec3[m^2], Float[m^2], Float[m], Float[m^3])
  > main = proc (a, b) -> (c, dot3 a b, norm3 a, dot3 c a) where
  >     c = cross3 a b
  > FROB
  $ printf '%s\n' 1,0,0,0,1,0 2,3,6,1,-1,2 | rows in.1.x,in.1.y,in.1.z,in.2.x,in.2.y,in.2.z | trace space | cells
  0,0,1,0,1,0
  12,2,-5,11,7,0
  $ single space

Angles wrap into (-180, 180] degrees; the shortest turn may cross the end of the
range:

  $ cat > angles.frob << FROB
  > import Geometry
  > main :: SF (Float, Float) (Int, Int)
  > main = proc (a, b) -> (round (wrapAngle (a * 1[deg]) / 1[deg]), round (angleDiff (a * 1[deg]) (b * 1[deg]) / 1[deg]))
  > FROB
  $ printf '%s\n' 0,0 190,10 -190,10 170,-170 -170,170 540.1,0 3599,1 -3599,1 | rows in.1,in.2 | trace angles | cells | xargs
  0,0 -170,-180 170,160 170,-20 -170,20 -180,-180 -1,-2 1,0
  $ cat > ends.frob << FROB
  > import Geometry
  > main :: SF Angle (Bool, Bool, Angle)
  > main = proc a -> (wrapAngle pi == pi, wrapAngle (-pi) == pi, wrapAngle a)
  > FROB
  $ printf '%s\n' 0.5 -0.5 nan | rows in | trace ends | cells
  true,true,0.5
  true,true,-0.5
  true,true,nan
  $ single ends

also after more turns than an Int can count:

  $ cat > turns.frob << FROB
  > import Geometry
  > main :: SF Float Angle
  > main = proc n -> wrapAngle (2 * pi * n + 0.5)
  > FROB
  $ printf '%s\n' 0 3 -3 3000000000 -3000000000 | rows in | trace turns | cells | awk '{ printf "%.4f\n", $1 }'
  0.5000
  0.5000
  0.5000
  0.5000
  0.5000

Poses as frames: from (1, 2), looking left, the point 3 ahead and 1 to the left
is (0, 5), and back. The composition of a pose and its inverse is the origin.

  $ cat > poses.frob << FROB
  > import Geometry
  > frame :: Pose
  > frame = Pose { position = Vec2 { x = 1[m], y = 2[m] }, heading = 90[deg] }
  > main :: SF Pose (Pose, Vec2[m], Pose)
  > main = proc p -> (compose frame p, toFrame frame (fromFrame frame p.position), compose p (inverse p))
  > FROB
  $ printf '%s\n' 3,1,0.5 -2,0,3 | rows in.position.x,in.position.y,in.heading |
  > trace poses | cells | tr ',' '\n' | awk '{ printf "%.6f%s", $1 + 0, NR % 8 ? " " : "\n" }' | sed 's/-0\.000000/0.000000/g'
  0.000000 5.000000 2.070796 3.000000 1.000000 0.000000 0.000000 0.000000
  1.000000 0.000000 -1.712389 -2.000000 0.000000 0.000000 0.000000 0.000000
  $ single poses
