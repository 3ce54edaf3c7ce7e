open Outcome

let rows text =
  let at = ref 0 in
  let next () =
    if !at >= String.length text then None
    else (
      incr at;
      Some text.[!at - 1])
  in
  let reader = Interp.Csv.reader next in
  let rec all found =
    match Interp.Csv.next reader with
    | Ok (Some row) -> all (List.map (fun (c : Interp.Csv.cell) -> c.text) row.cells :: found)
    | Ok None | Error _ -> List.rev found
  in
  List.filter (fun row -> not (String.starts_with ~prefix:"#" (List.hd row))) (all [])

(* {1 Tests without a robot} *)

type column = Judge | Asserted of string | Assumed of string | Other

(* Determines the kind of the column from the word that follows the path. The path contains no
   spaces. *)
let column name =
  let after word =
    let n = String.length word in
    let rec from i =
      if i + n > String.length name then None
      else if String.sub name i n = word then
        Some (String.sub name (i + n) (String.length name - i - n))
      else from (i + 1)
    in
    from 0
  in
  if name = "out" then Judge
  else
    match (after ".assert ", after ".assume ") with
    | Some label, _ -> Asserted label
    | None, Some label -> Assumed label
    | None, None -> Other

let without_seed fate at by : Outcome.run =
  { seed = None; fate; at; by; truth = []; collisions = 0; first = None; measured = [] }

let of_trace text =
  match rows text with
  | [] | [ _ ] -> without_seed Unasked 0. ""
  | header :: instants -> (
      let columns = List.map column header in
      let time row = float_of_string (List.hd row) in
      let failed row =
        let says test =
          List.find_map
            (fun (column, cell) -> if cell = "Fails" then test column else None)
            (List.combine columns row)
        in
        let assumed = says (function Assumed l -> Some l | _ -> None) in
        let asserted = says (function Asserted l -> Some l | _ -> None) in
        let judged = says (function Judge -> Some "judge" | _ -> None) in
        match (assumed, asserted, judged) with
        | Some label, _, _ -> Some (without_seed Void (time row) label)
        | None, Some label, _ -> Some (without_seed Violated (time row) label)
        | None, None, Some judge -> Some (without_seed Violated (time row) judge)
        | None, None, None -> None
      in
      let asked row =
        List.exists2
          (fun column cell -> column <> Other && cell <> "" && cell <> "NotAsked")
          columns row
      in
      let is_open row =
        List.exists2 (fun column cell -> column = Judge && cell = "Open") columns row
      in
      let last = List.nth instants (List.length instants - 1) in
      match List.find_map failed instants with
      | Some run -> run
      | None when is_open last -> without_seed Undecided (time last) "judge"
      | None ->
          let fate = if List.exists asked instants then Held else Unasked in
          without_seed fate (time last) "")

(* {1 Trials} *)

let fate = function
  | "held" -> Held
  | "violated" -> Violated
  | "undecided" -> Undecided
  | "void" -> Void
  | _ -> Unasked

let measured cell =
  match String.rindex_opt cell '=' with
  | None -> None
  | Some at ->
      let value = String.sub cell (at + 1) (String.length cell - at - 1) in
      Some (String.sub cell 0 at, Option.value (float_of_string_opt value) ~default:Float.nan)

let collision = function
  | [ time; x; y; clearance; with_ ] -> (
      match List.map float_of_string_opt [ time; x; y; clearance ] with
      | [ Some time; Some x; Some y; Some clearance ] -> Some { time; x; y; clearance; with_ }
      | _ -> None)
  | _ -> None

let of_trial text =
  let run line =
    match String.split_on_char '\t' line with
    | seed :: what :: at :: by :: x :: y :: heading :: clearance :: touches :: driven :: lost
      :: collisions :: time :: where_x :: where_y :: room :: with_ :: measures ->
        Some
          {
            seed = int_of_string_opt seed;
            fate = fate what;
            at = float_of_string at;
            by;
            truth = List.map float_of_string [ x; y; heading; clearance; touches; driven; lost ];
            collisions = int_of_string collisions;
            first = collision [ time; where_x; where_y; room; with_ ];
            measured = List.filter_map measured measures;
          }
    | _ -> None
  in
  List.filter_map run (String.split_on_char '\n' text)

let most_columns = 12

(* Rounds a number to six significant digits. *)
let short cell =
  match float_of_string_opt cell with
  | Some x -> Printf.sprintf "%.6g" x
  | None -> if cell = "" then "nothing" else cell

let around text =
  match rows text with
  | header :: (_ :: _ as instants) ->
      let last = List.rev instants in
      let before = match last with _ :: row :: _ -> row | _ -> List.hd last in
      let shown name =
        List.exists (fun prefix -> String.starts_with ~prefix name) [ "out"; "probe." ]
      in
      let line name (was, is) =
        if (not (shown name)) || (was = "" && is = "") then None
        else Some (Printf.sprintf "%s: %s, then %s" name (short was) (short is))
      in
      let lines =
        List.filter_map Fun.id (List.map2 line header (List.combine before (List.hd last)))
      in
      List.filteri (fun k _ -> k < most_columns) lines
  | _ -> []
