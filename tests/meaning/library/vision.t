From pixels to metres, compared with values computed by hand: a camera 0.2 m ahead, 0.3 m up, with a
focal length of 300 px and its axis at (160, 120).

  $ . ./trace.sh
  $ cat > pixels.frob << FROB
  > import Geometry
  > import Vision
  > 
  > seeing :: Angle -> Angle -> Angle -> Lens
  > seeing yaw pitch roll = Lens
  >     { width = 320[px], height = 240[px], focalX = 300[px], focalY = 300[px]
  >     , centreX = 160[px], centreY = 120[px], k1 = 0, k2 = 0, k3 = 0, p1 = 0, p2 = 0
  >     , ahead = 0.2[m], left = 0, up = 0.3[m], yaw = yaw, pitch = pitch, roll = roll }
  > 
  > main :: SF (Vec2[px], Vec3[1]) (Float, Distance, Distance, Vec3[1], Maybe Point2)
  > main = proc (p, turns) ->
  >     (bearing l p.x / 1[deg], distanceByWidth l 0.3[m] p.x, distanceByHeight l 0.3[m] p.y, rayOf l p, groundPoint l p)
  >   where
  >     l = seeing (turns.x * 1[deg]) (turns.y * 1[deg]) (turns.z * 1[deg])
  > FROB
  $ show() { trace pixels | cells | awk -F, -v OFS=, '{ for (i = 1; i <= NF; i++) if ($i ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) { $i = sprintf("%.4f", $i); sub(/^-0.0000$/, "0.0000", $i) } print }' | sed 's/"//g; s/-*[0-9.]*e-1[0-9]/0/g; s/\(\.[0-9][0-9][0-9][0-9]\)[0-9]*/\1/g'; }
  $ columns=in.1.x,in.1.y,in.2.x,in.2.y,in.2.z

Straight ahead; 100 px below the axis, the floor is 0.3 * 300 / 100 = 0.9 m in front of the camera;
at and above the horizon there is no floor; 45 degrees to the left.

  $ printf '%s\n' 160,220,0,0,0 160,120,0,0,0 160,20,0,0,0 -140,220,0,0,0 | rows $columns | show
  0.0000,0.5625,0.4091,1.0000,0.0000,-0.3333,Just Vec2 {x = 1.1000, y = 0}
  0.0000,0.5625,0.7500,1.0000,0.0000,0.0000,Nothing
  0.0000,0.5625,4.5000,1.0000,0.0000,0.3333,Nothing
  45.0000,-0.6429,0.4091,1.0000,1.0000,-0.3333,Just Vec2 {x = 1.1000, y = 0.9000}

A camera turned to the left, down, and clockwise as seen from behind: pitched down by 90 degrees,
the image's centre shows the floor below; with a roll of 90 degrees, right in the image is down.

  $ printf '%s\n' 160,120,90,0,0 160,120,0,90,0 260,120,0,0,90 160,120,0,45,0 | rows $columns | show
  90.0000,0.5625,0.7500,0.0000,1.0000,0.0000,Nothing
  0.0000,0.5625,0.7500,0.0000,0.0000,-1.0000,Just Vec2 {x = 0.2000, y = 0}
  -18.4349,0.3462,0.7500,1.0000,0.0000,-0.3333,Just Vec2 {x = 1.1000, y = 0}
  0.0000,0.5625,0.7500,0.7071,0.0000,-0.7071,Just Vec2 {x = 0.5, y = 0}
