Vision kernels: the maximum number of calls per step, the number of pixels that they examine, if it
is known before the program runs, and the stack that they need.

  $ cat > sees.frob <<'EOF'
  > import Robot
  > import Vision
  > 
  > orange :: ColourRange
  > orange = ColourRange
  >     { hueFrom = 10[deg], hueTo = 40[deg], saturationFrom = 0.5, saturationTo = 1
  >     , valueFrom = 0.2, valueTo = 1 }
  > 
  > below :: Region
  > below = Region { x = 0, y = 200[px], width = 320[px], height = 39.5[px] }
  > 
  > found :: Image -> Int
  > found i = (findBlob i below orange).pixels + (findBlob i (everywhere i) orange).pixels
  >     + (findBlobs i below orange).count + (findBlobs i below { height = 1[px] } orange).count
  > 
  > edges :: Image -> Float[1/px]
  > edges i = (findEdges i (Segment { x = 9[px], y = 9[px], angle = 0, length = 50[px], width = 4[px] })).rising.gradient
  > 
  > main = reactimateRobot (proc i -> look (camera i)) where
  >     look = proc frame -> roMake (setVelTR (hold 0 (mapE speed frame)) (hold 0 (mapE turn frame)))
  >     speed f = 0.001[m/s] * toFloat (found f.image)
  >     turn f = 1[rad px/s] * edges f.image
  > EOF
  $ frobc report sees.frob --robot pioneer | grep -e 'calls of frob' -e '^  step' -e stack
    calls of frob_find_blob   2  12800 pixels, at most the whole image in 1 of the calls
    calls of frob_find_blobs  2  13120 pixels
    calls of frob_find_edges  1  200 pixels
    calls of frob_image_lens  1
  stack, in bytes, at most, without the elementary functions
    step   259216  main > found > findBlobs
  $ frobc report sees.frob --robot pioneer --format=json | tr -d ' \n' | grep -o '"kernels":{[^}]*}[^}]*}[^}]*}'
  "kernels":{"frob_find_blob":{"pixels":12800,"whole_images":1},"frob_find_blobs":{"pixels":13120,"whole_images":0},"frob_find_edges":{"pixels":200,"whole_images":0}

For a call of a user's C function, the report states only that it is called.

  $ cat > own.frob <<'EOF'
  > foreign mean :: Float -> Float -> Float = "my_mean"
  > 
  > main :: SF Float Float
  > main = proc x -> mean x 1
  > EOF
  $ frobc report own.frob | grep -e 'calls of' -e '^  step'
    calls of my_mean         1
    step   288  main > mean
