(* A number for each run, together with the run's point, and the range of the numbers if it is known
   in advance. *)
type panel = {
  title : string;
  values : (string array * float) list;
  bounds : (float * float) option;
}

let width = 720.
let left = 90.
let right = 110.
let panel_height = 300.
let gap = 90.
let in_brackets unit_ = if unit_ = "" || unit_ = "1" then "" else Printf.sprintf " (%s)" unit_

let panels (t : Setup.t) rows =
  let cells n =
    let run = Runs.run t n in
    (run.point, Option.get (Rows.find rows run.key))
  in
  let all = List.init (Runs.count t) cells in
  let of_run ?bounds title value =
    let values = List.map (fun (point, cells) -> (point, value cells)) all in
    { title; bounds; values = List.filter (fun (_, x) -> Float.is_finite x) values }
  in
  let held cells =
    let fate = Table.fate cells in
    if fate.void then Float.nan else if fate.held then 1. else 0.
  in
  let measure (m : Measures.t) =
    of_run (m.name ^ in_brackets m.unit_) (fun cells -> Table.measured t cells m)
  in
  (of_run ~bounds:(0., 1.) "fraction of runs that held" held, List.map measure t.measures)

(* {1 Axes} *)

(* [place_of] maps a parameter's value to its coordinate: the number itself or, if not all values
   are numbers, the value's index. *)
type axis = { label : string; place_of : string -> float; name_of : (float * string) list }

let axis_of k (axis : Points.axis) values =
  let unit_ = in_brackets axis.unit_ in
  let texts = List.sort_uniq compare (List.map (fun (point, _) -> point.(k)) values) in
  let label = axis.name ^ unit_ in
  if List.for_all (fun text -> float_of_string_opt text <> None) texts then
    { label; place_of = float_of_string; name_of = [] }
  else
    let numbered = List.mapi (fun n text -> (text, float_of_int n)) texts in
    {
      label;
      place_of = (fun text -> List.assoc text numbered);
      name_of = List.map (fun (text, n) -> (n, text)) numbered;
    }

let ticks axis low high =
  if axis.name_of <> [] then axis.name_of
  else List.map (fun x -> (x, Plot.number x)) (Plot.ticks low high ~about:6)

let vertical_label out ~top words =
  let y = top +. (panel_height /. 2.) in
  Printf.bprintf out
    "<text x=\"18\" y=\"%.1f\" text-anchor=\"middle\" transform=\"rotate(-90 18 %.1f)\">%s</text>\n"
    y y (Xml.escaped words)

let frame out ~top ~across ~up ~bottom_label ~left_label ~columns ~rows =
  let bottom = top +. panel_height in
  List.iter
    (fun (x, name) ->
      let x = Plot.place across x in
      Plot.line out x bottom x (bottom +. 4.);
      Plot.text out ~anchor:"middle" x (bottom +. 18.) name)
    columns;
  List.iter
    (fun (y, name) ->
      let y = Plot.place up y in
      Plot.line out left y (width -. right) y;
      Plot.text out ~anchor:"end" (left -. 6.) (y +. 4.) name)
    rows;
  Plot.text out ~anchor:"middle" ((left +. width -. right) /. 2.) (bottom +. 36.) bottom_label;
  vertical_label out ~top left_label

(* {1 Heat maps} *)

(* Matplotlib's viridis: uniform in brightness, and suitable for colour-blind readers. *)
let stops =
  [| (68., 1., 84.); (59., 82., 139.); (33., 145., 140.); (94., 201., 98.); (253., 231., 37.) |]

let colour share =
  let at = Float.max 0. (Float.min 3.999 (share *. 4.)) in
  let k = int_of_float at in
  let part = at -. float_of_int k in
  let r, g, b = stops.(k) and r', g', b' = stops.(k + 1) in
  let mix x y = int_of_float (x +. (part *. (y -. x))) in
  Printf.sprintf "#%02x%02x%02x" (mix r r') (mix g g') (mix b b')

let mean values = List.fold_left ( +. ) 0. values /. float_of_int (List.length values)

(* Groups the values by a key computed from their points. *)
let grouped of_point values =
  let table = Hashtbl.create 64 in
  List.iter
    (fun (point, x) ->
      let key = of_point point in
      Hashtbl.replace table key (x :: Option.value (Hashtbl.find_opt table key) ~default:[]))
    values;
  List.sort compare (Hashtbl.fold (fun key values all -> (key, values) :: all) table [])

let extent values =
  (List.fold_left Float.min infinity values, List.fold_left Float.max neg_infinity values)

let scale out ~top (low, high) =
  let x = width -. right +. 24. in
  let steps = 40 in
  for k = 0 to steps - 1 do
    let share = float_of_int k /. float_of_int (steps - 1) in
    Printf.bprintf out "<rect x=\"%.1f\" y=\"%.1f\" width=\"16\" height=\"%.1f\" fill=\"%s\"/>\n" x
      (top +. ((1. -. share) *. (panel_height -. (panel_height /. float_of_int steps))))
      ((panel_height /. float_of_int steps) +. 0.5)
      (colour share)
  done;
  Plot.text out (x +. 22.) (top +. 10.) (Plot.number high);
  Plot.text out (x +. 22.) (top +. panel_height) (Plot.number low)

let heat out ~top (first : axis) (second : axis) (k, l) panel ~is_grid =
  let cells =
    grouped (fun point -> (first.place_of point.(k), second.place_of point.(l))) panel.values
    |> List.map (fun (place, values) -> (place, mean values))
  in
  let low, high = Option.value panel.bounds ~default:(extent (List.map snd cells)) in
  let share x = if high > low then (x -. low) /. (high -. low) else 1. in
  let along pick from upto =
    let places = List.sort_uniq compare (List.map (fun (place, _) -> pick place) cells) in
    let least, most = extent places in
    let count = float_of_int (max 1 (List.length places - 1)) in
    let half = if most > least then (most -. least) /. count /. 2. else 0.5 in
    ({ Plot.low = least -. half; high = most +. half; from; upto }, 2. *. half, least, most)
  in
  let across, wide, least_x, most_x = along fst left (width -. right) in
  let up, high_, least_y, most_y = along snd (top +. panel_height) top in
  frame out ~top ~across ~up ~bottom_label:first.label ~left_label:second.label
    ~columns:(ticks first least_x most_x) ~rows:(ticks second least_y most_y);
  List.iter
    (fun ((x, y), value) ->
      let fill = colour (share value) in
      if is_grid then
        let x1 = Plot.place across (x -. (wide /. 2.)) in
        let y1 = Plot.place up (y +. (high_ /. 2.)) in
        Printf.bprintf out
          "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" \
           fill=\"%s\"><title>%s</title></rect>\n"
          x1 y1
          (Plot.place across (x +. (wide /. 2.)) -. x1 +. 0.3)
          (Plot.place up (y -. (high_ /. 2.)) -. y1 +. 0.3)
          fill (Plot.number value)
      else
        Printf.bprintf out
          "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"5\" fill=\"%s\"><title>%s</title></circle>\n"
          (Plot.place across x) (Plot.place up y) fill (Plot.number value))
    cells;
  scale out ~top (low, high)

(* {1 Curves over one parameter} *)

let along out ~top (axis : axis) k panel =
  let groups = grouped (fun point -> axis.place_of point.(k)) panel.values in
  let least, most = extent (List.map fst groups) in
  let margin = if most > least then 0.03 *. (most -. least) else 0.5 in
  let across =
    { Plot.low = least -. margin; high = most +. margin; from = left; upto = width -. right }
  in
  let low, high = Option.value panel.bounds ~default:(Plot.range (List.concat_map snd groups)) in
  let up = { Plot.low; high; from = top +. panel_height; upto = top } in
  frame out ~top ~across ~up ~bottom_label:axis.label ~left_label:""
    ~columns:(ticks axis least most)
    ~rows:(List.map (fun y -> (y, Plot.number y)) (Plot.ticks low high ~about:5));
  List.iter
    (fun (x, values) ->
      let low, high = extent values and x = Plot.place across x in
      Plot.line out ~colour:"#0072b2" x (Plot.place up low) x (Plot.place up high))
    groups;
  let point (x, values) =
    Printf.sprintf "%.1f,%.1f" (Plot.place across x) (Plot.place up (mean values))
  in
  Printf.bprintf out
    "<polyline fill=\"none\" stroke=\"#d55e00\" stroke-width=\"2\" points=\"%s\"/>\n"
    (String.concat " " (List.map point groups))

(* {1 Histograms} *)

let bars = 30

let histogram out ~top panel =
  let values = List.map snd panel.values in
  let low, high = extent values in
  let low, high = if high > low then (low, high) else (low -. 0.5, high +. 0.5) in
  let counts = Array.make bars 0 in
  let bar x = min (bars - 1) (int_of_float ((x -. low) /. (high -. low) *. float_of_int bars)) in
  List.iter (fun x -> counts.(bar x) <- counts.(bar x) + 1) values;
  let most = float_of_int (Array.fold_left max 1 counts) in
  let across = { Plot.low; high; from = left; upto = width -. right } in
  let up = { Plot.low = 0.; high = most; from = top +. panel_height; upto = top } in
  frame out ~top ~across ~up ~bottom_label:panel.title ~left_label:"runs"
    ~columns:(List.map (fun x -> (x, Plot.number x)) (Plot.ticks low high ~about:6))
    ~rows:(List.map (fun y -> (y, Plot.number y)) (Plot.ticks 0. most ~about:5));
  let wide = (high -. low) /. float_of_int bars in
  Array.iteri
    (fun k count ->
      let x = Plot.place across (low +. (wide *. float_of_int k)) in
      let y = Plot.place up (float_of_int count) in
      if count > 0 then
        Printf.bprintf out
          "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"#0072b2\"/>\n" x y
          (Plot.place across (low +. (wide *. float_of_int (k + 1))) -. x -. 1.)
          (top +. panel_height -. y))
    counts

(* {1 The whole picture} *)

let svg (t : Setup.t) rows =
  let share, measures = panels t rows in
  let varies k =
    Array.exists (fun (point : string array) -> point.(k) <> t.points.(0).(k)) t.points
  in
  let varying = List.filter (fun (k, _) -> varies k) (List.mapi (fun k axis -> (k, axis)) t.axes) in
  (* If no parameter varies, the proportion of successful runs is a single number. Its histogram is
     drawn only if there is no other panel. *)
  let panels = match varying with [ _ ] | [ _; _ ] -> share :: measures | _ -> measures in
  let panels = List.filter (fun panel -> panel.values <> []) panels in
  let panels = if panels = [] then [ share ] else panels in
  let height = (float_of_int (List.length panels) *. (panel_height +. gap)) +. 40. in
  let out = Buffer.create 65536 in
  Printf.bprintf out
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f \
     %.0f\" font-family=\"sans-serif\" font-size=\"12\">\n\
     <rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n"
    width height width height;
  let panel n panel =
    let top = 40. +. (float_of_int n *. (panel_height +. gap)) in
    Plot.text out left (top -. 12.) (Printf.sprintf "%s: %s" t.label panel.title);
    match varying with
    | [ (k, first); (l, second) ] ->
        let is_grid = t.plan.sampling = Grid in
        heat out ~top (axis_of k first panel.values) (axis_of l second panel.values) (k, l) panel
          ~is_grid
    | [ (k, axis) ] -> along out ~top (axis_of k axis panel.values) k panel
    | _ -> histogram out ~top panel
  in
  List.iteri panel panels;
  Buffer.add_string out "</svg>\n";
  Buffer.contents out
