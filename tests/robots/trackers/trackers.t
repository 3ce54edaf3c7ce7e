A robot drives and turns a little in front of a poster and a rolling ball, with a noisy camera. Each
tracker is compared with the object's position computed from the camera's geometry: the root mean
square in pixels, over all frames but the first.

  $ frobc run known.frob --world world.toml --for 8s --seed 1 --record run.csv > summary
  $ frobc trace known.frob --entry judged --input run.csv > judged.csv
  $ cat > mean.awk << 'AWK'
  > BEGIN { FS = "[{},= ]+"; split("poster 0.3 tower 0.3 best 0.3 edge 0.3 ball 1", limits, " ")
  >   for (i = 1; i < 10; i += 2) limit[limits[i]] = limits[i + 1] }
  > NF > 9 { if (!begun) { begun = 1; next }
  >   for (i = 3; i < NF; i += 2) { s[$i] += $(i + 1) ^ 2; n[$i]++ } }
  > END { for (i = 1; i < 10; i += 2) { k = limits[i]
  >   print k, (n[k] > 230 && sqrt(s[k] / n[k]) < limit[k] ? "within " limit[k] : sqrt(s[k] / n[k])) } }
  > AWK
  $ awk -f mean.awk judged.csv
  poster within 0.3
  tower within 0.3
  best within 0.3
  edge within 0.3
  ball within 1

The interpreter runs the same kernels; everything else in the trackers is the same, bit for bit.

  $ frobc trace known.frob --entry judged --input run.csv --engine interp | cmp - judged.csv

Another seed of noise:

  $ frobc run known.frob --world world.toml --for 8s --seed 2 --record run.csv > summary
  $ frobc trace known.frob --entry judged --input run.csv | awk -f mean.awk | grep -c within
  5

The ball is never visible after the first frame: the track is lost, and the estimate does not
change.

  $ cat > unseen.frob << 'FROB'
  > import Tracking
  > import Vision
  > import Pioneer
  > 
  > green :: ColourRange
  > green = ColourRange
  >     { hueFrom = 250[deg], hueTo = 280[deg], saturationFrom = 0.5, saturationTo = 1
  >     , valueFrom = 0.2, valueTo = 1 }
  > 
  > main :: SF PioneerInput (Sight, Int, Float)
  > main = proc i -> (t.sight, t.estimate.pixels, t.residual) where
  >     t = blobTracker green (camera i)
  > FROB
  $ frobc trace unseen.frob --input run.csv | cut -d, -f2- | sort -u
  Lost,0,1
  out.1,out.2,out.3

A camera that delivers no more frames: after its patience, the tracker reports that it has lost the
ball.

  $ awk -F, '$1 > 2 { gsub(/"Frame [^"]*"/, "") } { print }' run.csv > silent.csv
  $ cp -r run.frames silent.frames
  $ sed 's/hueFrom = 250\[deg\], hueTo = 280/hueFrom = 8[deg], hueTo = 40/' unseen.frob > ball.frob
  $ frobc trace ball.frob --input silent.csv | awk -F, '$2 != last { last = $2; print ($1 < 0.1 ? "at once" : $1 > 2.3 && $1 < 2.6 ? "after 2.4 s" : $1), $2 }'
  time out.1
  at once Seen
  after 2.4 s Lost
