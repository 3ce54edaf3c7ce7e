type column = { name : string; unit_ : string; cells : string array }

let width = 960.
let left = 80.
let right = 20.
let panel_height = 150.
let band_height = 20.
let legend_height = 18.
let most_in_panel = 5

(* The colour palette of Okabe and Ito; its black is used for text. *)
let colours = [| "#0072b2"; "#d55e00"; "#009e73"; "#cc79a7"; "#e69f00"; "#56b4e9" |]
let dashes = [| ""; "7 3"; "2 2"; "9 3 2 3"; "4 4"; "1 3" |]
let pick choices k = choices.(k mod Array.length choices)

(* {1 Scales} *)

let ticks low high ~about =
  let rough = (high -. low) /. float_of_int about in
  let magnitude = 10. ** Float.floor (Float.log10 rough) in
  let step =
    match rough /. magnitude with
    | r when r <= 1. -> magnitude
    | r when r <= 2. -> 2. *. magnitude
    | r when r <= 5. -> 5. *. magnitude
    | _ -> 10. *. magnitude
  in
  let first = Float.ceil ((low /. step) -. 1e-9) in
  let last = Float.floor ((high /. step) +. 1e-9) in
  List.init (max 0 (int_of_float (last -. first) + 1)) (fun k -> (first +. float_of_int k) *. step)

let number x =
  let x = if Float.abs x < 1e-12 then 0. else x in
  Printf.sprintf "%.6g" x

type frame = { low : float; high : float; from : float; upto : float }

let place f x = f.from +. ((x -. f.low) /. (f.high -. f.low) *. (f.upto -. f.from))

let range values =
  let low = List.fold_left min infinity values and high = List.fold_left max neg_infinity values in
  if low > high then (0., 1.)
  else
    let margin = if high > low then 0.06 *. (high -. low) else max 1. (Float.abs high) *. 0.5 in
    (low -. margin, high +. margin)

(* {1 Columns} *)

let finite cell =
  match float_of_string_opt cell with
  | Some x when Float.is_finite x -> Some x
  | Some _ | None -> None

let is_number column =
  let cells = List.filter (fun cell -> cell <> "") (Array.to_list column.cells) in
  cells <> [] && List.for_all (fun cell -> float_of_string_opt cell <> None) cells

(* Groups columns by unit, in the order in which each unit first occurs. *)
let rec panels = function
  | [] -> []
  | first :: _ as columns ->
      let same, others = List.partition (fun c -> c.unit_ = first.unit_) columns in
      let here, later = Basis.Long_list.split_at most_in_panel same in
      here :: panels (later @ others)

(* Splits the instants into intervals in which the cells have values. *)
let stretches times cells =
  let add stretches now =
    match (now, stretches) with
    | None, [] :: _ -> stretches
    | None, _ -> [] :: stretches
    | Some point, here :: others -> (point :: here) :: others
    | Some point, [] -> [ [ point ] ]
  in
  let point k cell = Option.map (fun x -> (times.(k), x)) (finite cell) in
  let points = Array.mapi point cells in
  Array.fold_left add [ [] ] points
  |> List.filter (fun stretch -> stretch <> [])
  |> List.rev_map List.rev

(* Keeps only the extreme points of each pixel column, since the others would be invisible. *)
let thinned points =
  let flush (_, low, high) kept = if low = high then low :: kept else high :: low :: kept in
  let add (kept, bucket) ((x, y) as point) =
    let key = int_of_float x in
    match bucket with
    | Some (k, ((_, l) as low), ((_, h) as high)) when k = key ->
        (kept, Some (k, (if y < l then point else low), if y > h then point else high))
    | Some full -> (flush full kept, Some (key, point, point))
    | None -> (kept, Some (key, point, point))
  in
  let kept, last = List.fold_left add ([], None) points in
  List.rev (Option.fold ~none:kept ~some:(fun full -> flush full kept) last)

(* {1 Drawing} *)

let line out ?(colour = "#dddddd") x1 y1 x2 y2 =
  Printf.bprintf out "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n" x1 y1
    x2 y2 colour

let text out ?(anchor = "start") ?(colour = "#222222") x y words =
  Printf.bprintf out "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">%s</text>\n" x y
    anchor colour (Xml.escaped words)

let curve out ~colour ~dash points =
  match points with
  | [ (x, y) ] ->
      Printf.bprintf out "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2.5\" fill=\"%s\"/>\n" x y colour
  | points ->
      let pair (x, y) = Printf.sprintf "%.1f,%.1f" x y in
      Printf.bprintf out
        "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\" stroke-dasharray=\"%s\" \
         points=\"%s\"/>\n"
        colour dash
        (String.concat " " (List.map pair (thinned points)))

(* Draws the legend, in rows: a sample of each line, followed by its name. Returns the position
   below the rows. *)
let legend out ~top columns =
  let next (x, y) (k, column) =
    let needed = 44. +. (7. *. float_of_int (String.length column.name)) in
    let x, y = if x > left && x +. needed > width then (left, y +. legend_height) else (x, y) in
    Printf.bprintf out
      "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"2.5\" \
       stroke-dasharray=\"%s\"/>\n"
      x (y +. 8.) (x +. 22.) (y +. 8.) (pick colours k) (pick dashes k);
    text out (x +. 27.) (y +. 12.) column.name;
    (x +. needed, y)
  in
  let _, y = List.fold_left next (left, top) (List.mapi (fun k c -> (k, c)) columns) in
  y +. legend_height

let panel out ~top ~across times columns =
  let top = legend out ~top columns in
  let low, high =
    range (List.concat_map (fun c -> List.filter_map finite (Array.to_list c.cells)) columns)
  in
  let up = { low; high; from = top +. panel_height; upto = top } in
  let tick y =
    line out left (place up y) (width -. right) (place up y);
    text out ~anchor:"end" (left -. 6.) (place up y +. 4.) (number y)
  in
  List.iter tick (ticks low high ~about:5);
  (match columns with
  | { unit_ = ""; _ } :: _ | [] -> ()
  | { unit_; _ } :: _ ->
      let y = top +. (panel_height /. 2.) in
      Printf.bprintf out
        "<text x=\"16\" y=\"%.1f\" text-anchor=\"middle\" transform=\"rotate(-90 16 \
         %.1f)\">%s</text>\n"
        y y (Xml.escaped unit_));
  List.iteri
    (fun k column ->
      let curve stretch =
        curve out ~colour:(pick colours k) ~dash:(pick dashes k)
          (List.map (fun (t, x) -> (place across t, place up x)) stretch)
      in
      List.iter curve (stretches times column.cells))
    columns;
  top +. panel_height +. 14.

(* {1 Bands} *)

(* Intervals of instants with the same text. Each interval ends where the next one starts. *)
let runs times cells =
  let count = Array.length cells in
  let rec from k found =
    if k >= count then List.rev found
    else
      let rec upto j = if j < count && String.equal cells.(j) cells.(k) then upto (j + 1) else j in
      let next = upto (k + 1) in
      from next ((times.(k), times.(min next (count - 1)), cells.(k)) :: found)
  in
  from 0 []

(* The colours of a band and of the text in it. True is dark, false is light, and every other value
   has its own colour. *)
let fill known cell =
  match cell with
  | "true" -> ("#0072b2", "#ffffff")
  | "false" -> ("#eeeeee", "#222222")
  | cell ->
      let number =
        match Hashtbl.find_opt known cell with
        | Some number -> number
        | None ->
            let number = Hashtbl.length known in
            Hashtbl.replace known cell number;
            number
      in
      let colours = [| "#56b4e9"; "#e69f00"; "#7fd4b5"; "#e3b5cf"; "#f0e442"; "#c8c8c8" |] in
      (pick colours number, "#222222")

let band out ~top ~across times column =
  text out left (top +. 12.) column.name;
  let top = top +. legend_height in
  let known = Hashtbl.create 8 in
  let run (start, stop, cell) =
    let x1 = place across start and x2 = place across stop in
    let colour, ink = fill known cell in
    if cell <> "" then (
      Printf.bprintf out
        "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"/>\n" x1 top
        (max 1.5 (x2 -. x1))
        band_height colour;
      if (7. *. float_of_int (String.length cell)) +. 6. < x2 -. x1 then
        text out ~colour:ink (x1 +. 4.) (top +. 14.) cell)
  in
  List.iter run (runs times column.cells);
  top +. band_height +. 8.

let time_axis out ~top ~across =
  let tick t =
    let x = place across t in
    line out ~colour:"#888888" x top x (top +. 5.);
    text out ~anchor:"middle" x (top +. 18.) (number t)
  in
  line out ~colour:"#888888" left top (width -. right) top;
  List.iter tick (ticks across.low across.high ~about:10);
  text out ~anchor:"end" (width -. right) (top +. 36.) "time in s";
  top +. 46.

let svg ~times columns =
  let out = Buffer.create 65536 in
  let count = Array.length times in
  let low, high = if count = 0 then (0., 1.) else (times.(0), times.(count - 1)) in
  let high = if high > low then high else low +. 1. in
  let across = { low; high; from = left; upto = width -. right } in
  let numbers, others = List.partition is_number columns in
  let seen = List.filter (fun c -> Array.exists (fun cell -> cell <> "") c.cells) others in
  let below =
    List.fold_left (fun top columns -> panel out ~top ~across times columns) 10. (panels numbers)
  in
  let below = List.fold_left (fun top c -> band out ~top ~across times c) below seen in
  let height = time_axis out ~top:below ~across in
  Printf.sprintf
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f \
     %.0f\" font-family=\"sans-serif\" font-size=\"12\">\n\
     <rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n\
     %s</svg>\n"
    width height width height (Buffer.contents out)
