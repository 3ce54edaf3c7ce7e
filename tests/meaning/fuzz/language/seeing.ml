open Choice

let f = Printf.sprintf
let imports = "import Geometry\nimport Tracking\nimport Vision\n"

let rec px random =
  match Random.State.int random 12 with
  | 0 -> "(0.0[px] / 0.0)"
  | 1 -> f "(%s + 1000000.0[px])" (px random)
  | _ -> f "%.2f[px]" (Random.State.float random 40. -. 5.)

(* In parentheses, because it may be negative and an argument. *)
let share random = f "(%.2f)" (Random.State.float random 1.2 -. 0.1)
let angle random = f "%d[deg]" (Random.State.int random 400 - 20)

let region random =
  let side () = px random in
  if chance random 3 then "(everywhere f.image)"
  else
    f "(Region { x = %s, y = %s, width = %s, height = %s })" (side ()) (side ()) (side ()) (side ())

let colours random =
  let ends name limit =
    let a = limit () in
    f "%sFrom = %s, %sTo = %s" name a name (limit ())
  in
  f "(ColourRange { %s, %s, %s })"
    (ends "hue" (fun () -> angle random))
    (ends "saturation" (fun () -> share random))
    (ends "value" (fun () -> share random))

let placement random =
  f "(Placement { x = %s, y = %s, angle = %s, scale = %s[px] })" (px random) (px random)
    (angle random)
    (one_of random [ "0.5"; "1.0"; "0.3"; "2.5"; "-1.0"; "0.0" ])

let segment random =
  f "(Segment { x = %s, y = %s, angle = %s, length = %s, width = %s })" (px random) (px random)
    (angle random) (px random) (px random)

let search random =
  f "(Search { from = %s, level = %d, iterations = %d, freedom = %d })" (placement random)
    (Random.State.int random 4) (Random.State.int random 6)
    (1 + Random.State.int random 4)

let point random = f "(Vec2 { x = %s, y = %s })" (px random) (px random)

(* A number that a kernel computes from the frame [f]. *)
let found random =
  match Random.State.int random 13 with
  | 0 | 1 ->
      f "(getStatistics f.image %s).%s" (region random)
        (one_of random [ "mean"; "stdev"; "min"; "lq"; "median"; "uq"; "max" ])
  | 2 ->
      f "(findBlob f.image %s %s).%s" (region random) (colours random)
        (one_of random [ "cx / 1[px]"; "major / 1[px]"; "rotation / 1[rad]"; "box.width / 1[px]" ])
  | 3 ->
      f "((findBlobs f.image %s %s).largest ! %d).cy / 1[px]" (region random) (colours random)
        (Random.State.int random 8)
  | 4 ->
      f "(findEdges f.image %s).%s" (segment random)
        (one_of random [ "rising.offset / 1[px]"; "falling.gradient * 1[px]" ])
  | 5 -> f "(findCorner f.image %s).x / 1[px]" (region random)
  | 6 -> f "(getPatch f.image %s) ! %d" (placement random) (Random.State.int random 1024)
  | 7 ->
      f "(matchPatch f.image (getPatch f.image %s) %s).residual" (placement random) (search random)
  | 8 ->
      f "(findTemplate f.image %s (getPatch f.image %s) %s).place.x / 1[px]" (region random)
        (placement random) (placement random)
  | 9 -> f "(%s f.image %s).y / 1[px]" (one_of random [ "undistort"; "distort" ]) (point random)
  | 10 ->
      f "(stereoDepths f.image f.image (Stereo { roi = %s, disparities = %d, window = %d })).known"
        (region random)
        (one_of random [ 16; 40; 0 ])
        (one_of random [ 5; 11; 4 ])
  | 11 ->
      one_of random
        [
          "(lens f.image).k1";
          "(lens f.image).focalX / 1[px]";
          "bearing (lens f.image) 3.5[px] / 1[rad]";
        ]
  | _ -> one_of random [ "f.age / 1[s]"; "toFloat f.number" ]

let counted random =
  one_of random
    [
      "f.number";
      f "(findBlobs f.image %s %s).count" (region random) (colours random);
      f "(findBlob f.image %s %s).pixels" (region random) (colours random);
      f "(getHistogram f.image %s) ! %d" (region random) (Random.State.int random 256);
    ]

(* A numeric signal that uses something remembered from earlier frames. *)
let followed random =
  let learned k =
    f
      "switch (proc e -> (%s, learn %s e)) (\\patch -> proc e -> hold %s (mapE (\\f -> (%s)) e)) \
       frame"
      (share random) (placement random) (share random) k
  in
  match Random.State.int random 8 with
  | 0 -> f "hold %s (mapE (\\f -> %s) frame)" (share random) (found random)
  | 1 -> learned (f "(matchPatch f.image patch %s).residual" (search random))
  | 2 -> f "(blobTracker %s frame).estimate.cx / 1[px]" (colours random)
  | 3 -> f "(edgeTracker %s frame).residual" (segment random)
  | 4 ->
      f
        "switch (proc e -> (0.0, learn %s e)) (\\patch -> proc e -> (ssdTracker patch %s \
         e).estimate.x / 1[px]) frame"
        (placement random) (placement random)
  | 5 ->
      f "(squareTracker %s %s frame).estimate.scale / 1[px]"
        (one_of random [ "Brighter"; "Darker" ])
        (placement random)
  | 6 ->
      f
        "(smoothTrack 0.1[s] (cornerTracker (Meeting { one = %s, other = %s }) \
         frame)).estimate.one.x / 1[px]"
        (segment random) (segment random)
  | _ -> f "frameAge frame / 1[s]"

let definition random ~number ~input =
  let name = f "seen%d" number in
  let pick choices = one_of random choices in
  let of_frame otherwise text = f "fromEvent %s (mapE (\\f -> %s) frame)" otherwise text in
  let text =
    String.concat ",\n     "
      [
        pick [ "x"; of_frame "x" (found random); followed random ];
        pick [ "n"; of_frame "n" (counted random) ];
        pick [ "b"; "isEvent frame"; "(b || isEvent frame)" ];
        pick
          [
            "e";
            f "mergeE (mapE (\\f -> %s) frame) e" (found random);
            f "(case frame of\n        Event f | b -> Event (%s)\n        _ -> e)" (found random);
          ];
        pick
          [
            "m";
            f "(case frame of\n        Event f -> Just (%s, b)\n        NoEvent -> m)"
              (counted random);
          ];
        pick [ "y"; followed random ];
        f "[x, %s, xs ! 1]" (pick [ of_frame "y" (found random); followed random ]);
        "d";
      ]
  in
  ( name,
    f
      "%s :: SF (Console, %s) %s\n\
       %s = proc (c, (x, n, b, e, m, y, xs, d)) ->\n\
      \    (%s) where\n\
      \    frame = consoleCamera \"eye %d\" c\n\n"
      name (Type.text input) (Type.text input) name text
      (number + Random.State.int random 2) )
