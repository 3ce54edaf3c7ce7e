The image that a camera sees is shown with marks on it, in pixels. The program
for a robot contains no code for this.

  $ cat > world.toml <<'TOML'
  > robot = "pioneer"
  > [start]
  > x = 0
  > y = 0
  > [camera]
  > width = 8
  > height = 8
  > [[wall]]
  > points = [[2, -3], [2, 3]]
  > colour = "red"
  > TOML
  $ cat > shows.frob <<'FROB'
  > import Display
  > import Geometry
  > import Robot
  > import Tracking
  > import Vision
  > 
  > red :: ColourRange
  > red = ColourRange
  >     { hueFrom = 330[deg], hueTo = 30[deg], saturationFrom = 0.5, saturationTo = 1
  >     , valueFrom = 0.1, valueTo = 1 }
  > 
  > patch :: Placement
  > patch = Placement { x = 4[px], y = 3[px], angle = 90[deg], scale = 0.125[px] }
  > 
  > edge :: Segment
  > edge = Segment { x = 4[px], y = 3[px], angle = 0, length = 2[px], width = 1[px] }
  > 
  > shows :: (HasCamera i, DiffDrive o, HasDisplay o) => SF i o
  > shows = proc i -> (showFrame (camera i) . drawTrack box wall . kinds) (roMake id) where
  >     wall  = blobTracker red (camera i)
  >     box b = regionOutline b.box
  >     kinds = draw (InImage Orange (patchOutline patch)) . draw (InImage Blue (segmentLine edge))
  >         . draw (InImage Grey (label (Vec2 { x = 1[px], y = 2[px] }) "wall"))
  > 
  > main = reactimateRobot shows
  > FROB
  $ frobc run shows.frob --record log.csv --for 0.1s > /dev/null
  $ frobc trace shows.frob --robot pioneer --input log.csv --probe draw > c.csv
  $ cut -d, -f1,4- c.csv
  time,probe.draw[0],probe.draw[1],probe.draw[2],probe.draw[3],probe.draw[4],probe.draw[5]
  0.000000000,"InImage Grey (Label Vec2 {x = 1, y = 2} ""wall"")","InImage Blue (Line Vec2 {x = 3, y = 3} Vec2 {x = 5, y = 3})","InImage Orange (Box Vec2 {x = 4, y = 3} 1.5707963267948966 4 4)","InImage Green (Box Vec2 {x = 3.5, y = 2} 0 8 5)","InImage Green (Cross Vec2 {x = 3.5, y = 2})",Picture 871694065
  0.020000000,"InImage Grey (Label Vec2 {x = 1, y = 2} ""wall"")","InImage Blue (Line Vec2 {x = 3, y = 3} Vec2 {x = 5, y = 3})","InImage Orange (Box Vec2 {x = 4, y = 3} 1.5707963267948966 4 4)","InImage Green (Box Vec2 {x = 3.5, y = 2} 0 8 5)","InImage Green (Cross Vec2 {x = 3.5, y = 2})",
  0.040000000,"InImage Grey (Label Vec2 {x = 1, y = 2} ""wall"")","InImage Blue (Line Vec2 {x = 3, y = 3} Vec2 {x = 5, y = 3})","InImage Orange (Box Vec2 {x = 4, y = 3} 1.5707963267948966 4 4)","InImage Green (Box Vec2 {x = 3.5, y = 2} 0 8 5)","InImage Green (Cross Vec2 {x = 3.5, y = 2})",Picture 1438181331
  0.060000000,"InImage Grey (Label Vec2 {x = 1, y = 2} ""wall"")","InImage Blue (Line Vec2 {x = 3, y = 3} Vec2 {x = 5, y = 3})","InImage Orange (Box Vec2 {x = 4, y = 3} 1.5707963267948966 4 4)","InImage Green (Box Vec2 {x = 3.5, y = 2} 0 8 5)","InImage Green (Cross Vec2 {x = 3.5, y = 2})",
  0.080000000,"InImage Grey (Label Vec2 {x = 1, y = 2} ""wall"")","InImage Blue (Line Vec2 {x = 3, y = 3} Vec2 {x = 5, y = 3})","InImage Orange (Box Vec2 {x = 4, y = 3} 1.5707963267948966 4 4)","InImage Green (Box Vec2 {x = 3.5, y = 2} 0 8 5)","InImage Green (Cross Vec2 {x = 3.5, y = 2})",Picture 1523029767
  0.100000000,"InImage Grey (Label Vec2 {x = 1, y = 2} ""wall"")","InImage Blue (Line Vec2 {x = 3, y = 3} Vec2 {x = 5, y = 3})","InImage Orange (Box Vec2 {x = 4, y = 3} 1.5707963267948966 4 4)","InImage Green (Box Vec2 {x = 3.5, y = 2} 0 8 5)","InImage Green (Cross Vec2 {x = 3.5, y = 2})",Picture 2085314751
  $ frobc trace shows.frob --robot pioneer --input log.csv --probe draw --engine interp | cmp - c.csv
  $ frobc trace shows.frob --robot pioneer --input log.csv --probe draw --real float > float.csv
  $ frobc trace shows.frob --robot pioneer --input log.csv --probe draw --real float --engine interp | cmp - float.csv
  $ frobc compile shows.frob --robot pioneer -o shows; grep -c -e image_key -e find_blobs shows/shows.c
  0
  [1]

Marks on the map require metres, and marks on the image require pixels.

  $ sed 's/InImage Grey/InWorld Grey/' shows.frob > metres.frob; frobc check metres.frob
  error[E0320]: expected the unit `m`, found `px`
    --> metres.frob:23:31
     |
  23 |         . draw (InWorld Grey (label (Vec2 { x = 1[px], y = 2[px] }) "wall"))
     |                 -------       ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Shape[px]`
     |                 |
     |                 argument 2 of `InWorld` is `Shape[m]`
     |
     = note: expected `Shape[m]`, found `Shape[px]`
  
  1 error
  [1]

A delayed output keeps its marks, but only the key of an image.

  $ cat > held.frob <<'FROB'
  > import Robot
  > import Vision
  > 
  > main = reactimateRobot (proc i -> delay (roMake id) (showFrame (camera i) (roMake id)))
  > FROB
  $ frobc trace held.frob --robot pioneer --input log.csv --probe draw | cut -d, -f1,4-
  time,probe.draw[0]
  0.000000000,
  0.020000000,Picture 871694065
  0.040000000,
  0.060000000,Picture 1438181331
  0.080000000,
  0.100000000,Picture 1523029767
