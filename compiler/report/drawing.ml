(* Sizes in pixels. *)
let row = 36
let height = 22
let lane_width = 10
let border = 12

type line = {
  above : int;
  below : int;
  from : int;
  target : int;
  lane : int;
  arrow : Machines.arrow;
}
(** An arrow between two positions in the column, which are counted from the top. *)

(* The states in depth-first order from the initial state, followed by the unreachable ones. *)
let in_order (m : Machines.t) =
  let rec visit order source =
    List.fold_left
      (fun order (a : Machines.arrow) ->
        if a.source <> source || List.mem a.target order then order
        else visit (a.target :: order) (State a.target))
      order m.arrows
  in
  let reached = List.rev (visit [] Start) in
  let others =
    List.filter (fun k -> not (List.mem k reached)) (List.mapi (fun k _ -> k) m.states)
  in
  reached @ others

(* Arrows that differ only in their labels are drawn once. *)
let without_repeats arrows =
  let same (a : Machines.arrow) (b : Machines.arrow) =
    a.source = b.source && a.target = b.target
    && a.may_be_immediate = b.may_be_immediate
    && a.delayed = b.delayed
  in
  List.rev
    (List.fold_left (fun kept a -> if List.exists (same a) kept then kept else a :: kept) [] arrows)

(* Assigns lanes to arrows, short arrows first. Each arrow gets the first lane that is free along
   its whole length. *)
let in_lanes lines =
  let length line = line.below - line.above in
  let touches a b = a.above <= b.below && b.above <= a.below in
  let place placed line =
    let taken lane = List.exists (fun other -> other.lane = lane && touches line other) placed in
    let rec free lane = if taken lane then free (lane + 1) else lane in
    { line with lane = free 0 } :: placed
  in
  List.fold_left place [] (List.stable_sort (fun a b -> compare (length a) (length b)) lines)

let lanes lines = List.fold_left (fun most line -> max most (line.lane + 1)) 0 lines

(* An upper bound on the width of a UTF-8 string: 7.5 pixels per character. *)
let width_of text =
  let starts count c = if Char.code c land 0xC0 = 0x80 then count else count + 1 in
  15 * String.fold_left starts 0 text / 2

let escaped text =
  let out = Buffer.create 32 in
  String.iter
    (function
      | '<' -> Buffer.add_string out "&lt;"
      | '>' -> Buffer.add_string out "&gt;"
      | '&' -> Buffer.add_string out "&amp;"
      | '"' -> Buffer.add_string out "&quot;"
      | c -> Buffer.add_char out c)
    text;
  Buffer.contents out

(* The text next to a state. *)
let note machines (m : Machines.t) k (s : Machines.state) =
  let labels =
    List.filter_map
      (fun (a : Machines.arrow) ->
        if a.source = Machines.State k && a.label <> "" then Some a.label else None)
      m.arrows
  in
  let ends = List.sort_uniq compare labels in
  let inner number = "contains " ^ (List.nth machines number : Machines.t).title in
  String.concat "; "
    ((s.place :: (if ends = [] then [] else [ "ends with " ^ String.concat " or " ends ]))
    @ List.map inner s.inside)

let head (a : Machines.arrow) ~x ~y ~direction =
  let shape =
    match direction with
    | `Right -> Printf.sprintf "M%d,%dl-7,-4v8z" x y
    | `Left -> Printf.sprintf "M%d,%dl7,-4v8z" x y
    | `Down -> Printf.sprintf "M%d,%dl-4,-7h8z" x y
  in
  Printf.sprintf "<path class=\"%s\" d=\"%s\"/>" (if a.delayed then "hollow" else "head") shape

let shaft (a : Machines.arrow) d =
  Printf.sprintf "<path class=\"%s\" d=\"%s\"/>"
    (if a.may_be_immediate then "arrow dashed" else "arrow")
    d

type column = {
  top : int;
  left : int;
  order : int list;
  next : (int * Machines.arrow) list;
      (** arrows to the next state in the column, with the positions at which they start *)
  down : line list;
  up : line list;
  outside : (int * Machines.arrow) list;
      (** arrows that do not start at a state, with the positions of their targets *)
}
(** The column of a machine: the positions of its states, and the arrows next to them. *)

let position order k =
  let rec find place = function
    | [] -> 0
    | state :: rest -> if state = k then place else find (place + 1) rest
  in
  find 0 order

let column ~top (m : Machines.t) =
  let order = in_order m in
  let next, down, up, outside =
    List.fold_left
      (fun (next, down, up, outside) (a : Machines.arrow) ->
        let target = position order a.target in
        match a.source with
        | Start | Any -> (next, down, up, (target, a) :: outside)
        | State k ->
            let from = position order k in
            let line =
              {
                above = min from target;
                below = max from target;
                from;
                target;
                lane = 0;
                arrow = a;
              }
            in
            if target = from + 1 && not (List.mem_assoc from next) then
              ((from, a) :: next, down, up, outside)
            else if target > from then (next, line :: down, up, outside)
            else (next, down, line :: up, outside))
      ([], [], [], []) (without_repeats m.arrows)
  in
  let down = in_lanes (List.rev down) and up = in_lanes (List.rev up) in
  { top; left = border + 20 + (lanes up * lane_width); order; next; down; up; outside }

let middle column place = column.top + (place * row) + (height / 2)

let next_arrow column (place, a) =
  let x = column.left + 14 and y = middle column (place + 1) - (height / 2) in
  shaft a (Printf.sprintf "M%d,%dV%d" x (middle column place + (height / 2)) (y - 7))
  ^ head a ~x ~y ~direction:`Down

let outside_arrow column (target, (a : Machines.arrow)) =
  let x = column.left in
  let y = middle column target + if a.source = Start then -7 else 7 in
  let dot =
    if a.source = Start then Printf.sprintf "<circle cx=\"%d\" cy=\"%d\" r=\"4\"/>" (x - 18) y
    else ""
  in
  dot ^ shaft a (Printf.sprintf "M%d,%dH%d" (x - 18) y (x - 7)) ^ head a ~x ~y ~direction:`Right

let down_arrow column ~right ~outer line =
  let x = outer + (line.lane * lane_width) + 8 in
  let a = middle column line.from + 4 and b = middle column line.target - 4 in
  let tip = right line.target in
  shaft line.arrow
    (Printf.sprintf "M%d,%dH%dQ%d,%d %d,%dV%dQ%d,%d %d,%dH%d" (right line.from) a (x - 5) x a x
       (a + 5) (b - 5) x b (x - 5) b (tip + 7))
  ^ head line.arrow ~x:tip ~y:b ~direction:`Left

let up_arrow column line =
  let x = column.left - 18 - (line.lane * lane_width) in
  let a = middle column line.from - 3 and b = middle column line.target + 3 in
  let bend, turn = if line.from = line.target then (3, 3) else (5, -5) in
  shaft line.arrow
    (Printf.sprintf "M%d,%dH%dQ%d,%d %d,%dV%dQ%d,%d %d,%dH%d" column.left a (x + bend) x a x
       (a + turn) (b - turn) x b (x + bend) b (column.left - 7))
  ^ head line.arrow ~x:column.left ~y:b ~direction:`Right

(* Prints a machine. Returns the y coordinate of its bottom edge and the x coordinate of its right
   edge. *)
let machine ppf machines ~top (m : Machines.t) =
  let column = column ~top:(top + 28) m in
  let states = List.map (fun k -> (k, List.nth m.states k)) column.order in
  let width (s : Machines.state) = width_of s.name + 18 in
  let right place = column.left + width (snd (List.nth states place)) in
  let outer = List.fold_left (fun most (_, s) -> max most (column.left + width s)) 0 states in
  let beside = outer + (lanes column.down * lane_width) + 16 in
  Format.fprintf ppf "<text class=\"title\" x=\"%d\" y=\"%d\">%s</text>@." border (top + 12)
    (escaped m.title);
  let widest = ref (border + width_of m.title) in
  List.iteri
    (fun place (k, (s : Machines.state)) ->
      let y = middle column place and text = note machines m k s in
      widest := max !widest (beside + width_of text);
      Format.fprintf ppf "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"%d\"/>@."
        column.left
        (y - (height / 2))
        (width s) height (height / 2);
      Format.fprintf ppf "<text x=\"%d\" y=\"%d\">%s</text>@." (column.left + 9) (y + 4)
        (escaped s.name);
      Format.fprintf ppf "<text class=\"note\" x=\"%d\" y=\"%d\">%s</text>@." beside (y + 4)
        (escaped text))
    states;
  let each f = List.iter (fun arrow -> Format.fprintf ppf "%s@." (f arrow)) in
  each (outside_arrow column) (List.rev column.outside);
  each (next_arrow column) (List.rev column.next);
  each (down_arrow column ~right ~outer) column.down;
  each (up_arrow column) column.up;
  (column.top + (List.length states * row), !widest)

let style =
  {|<style>
svg { color: #222; background: #fff; font: 12px ui-monospace, "DejaVu Sans Mono", monospace }
text { fill: currentColor }
.title { font-weight: bold }
.note { opacity: 0.75 }
rect { fill: none; stroke: currentColor }
.arrow { fill: none; stroke: currentColor }
.dashed { stroke-dasharray: 4 3 }
.head, circle { fill: currentColor }
.hollow { fill: none; stroke: currentColor }
@media (prefers-color-scheme: dark) { svg { color: #ddd; background: #15191f } }
</style>|}

let print ppf ~name machines =
  let body = Buffer.create 4096 in
  let out = Format.formatter_of_buffer body in
  if machines = [] then
    Format.fprintf out "<text x=\"%d\" y=\"24\">%s has no switches or tasks</text>@." border
      (escaped name);
  let bottom, right =
    List.fold_left
      (fun (top, right) m ->
        let bottom, widest = machine out machines ~top m in
        (bottom + border, max right widest))
      (if machines = [] then (24 + border, 240 + width_of name) else (border, 0))
      (List.rev machines)
  in
  Format.pp_print_flush out ();
  Format.fprintf ppf
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" role=\"img\">@."
    (right + border) bottom;
  Format.fprintf ppf "<title>The states of %s</title>@.%s@.%s</svg>@." (escaped name) style
    (Buffer.contents body)
