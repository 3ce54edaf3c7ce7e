type row = { depth : int; label : string; amount : string; note : string; place : string }

(* The indentation is limited to this depth, so that the text does not become too wide. *)
let deepest = 24
let indentation row = 2 * min row.depth deepest
let width column rows = List.fold_left (fun most row -> max most (column row)) 0 rows

(* A name longer than this does not widen the column; it only shifts its own line. *)
let widest_label = 48

let table rows =
  let left row = indentation row + String.length row.label in
  let fitting row =
    let n = left row in
    if n > widest_label then 0 else n
  in
  let labels = width fitting rows in
  let amounts = width (fun row -> String.length row.amount) rows in
  let notes = width (fun row -> String.length row.note) rows in
  let line row =
    let label = String.make (indentation row) ' ' ^ row.label in
    let text =
      Printf.sprintf "%-*s  %*s  %-*s  %s" labels label amounts row.amount notes row.note row.place
    in
    (* Removes trailing spaces: the last columns of some rows are empty. *)
    let rec length n = if n > 0 && text.[n - 1] = ' ' then length (n - 1) else n in
    String.sub text 0 (length (String.length text)) ^ "\n"
  in
  String.concat "" (Basis.Long_list.map line rows)

let number n = if n >= Basis.Saturating_int.most then "2^53 or more" else string_of_int n

(* {1 The state} *)

(* Builds the rows in reverse order. The members of a struct are listed where the struct first
   occurs. *)
let state_rows (t : State.t) =
  let shown = Hashtbl.create 16 in
  let rec members depth ~bytes:whole ~place rows list =
    let rows = List.fold_left (member depth ~place) rows list in
    match State.padding ~bytes:whole list with
    | 0 -> rows
    | n -> { depth; label = "(padding)"; amount = number n; note = ""; place = "" } :: rows
  and member depth ~place rows (m : State_layout.member) =
    let row note = { depth; label = m.name; amount = number m.bytes; note; place = place m.span } in
    match m.holds with
    | Value purpose -> row purpose :: rows
    | Running_mode -> row "number of the active mode" :: rows
    | Struct k | Structs { node = k; count = _ } ->
        let inner = State.definition t k in
        let name = if String.equal inner.name m.name then "" else inner.name in
        let name =
          match m.holds with
          | Structs { count; _ } -> Printf.sprintf "%d times %s" count inner.name
          | Struct _ | Value _ | Running_mode | Largest _ -> name
        in
        if Hashtbl.mem shown k then
          row (if String.equal name "" then "as above" else name ^ ", as above") :: rows
        else definition k (depth + 1) (row name :: rows)
    | Largest alternatives ->
        let rows = row "memory shared by these modes" :: rows in
        List.fold_left (alternative (depth + 1) ~place) rows alternatives
  and alternative depth ~place rows (a : State_layout.alternative) =
    let inner = State.definition t a.node in
    let at = Bounds.place ~file:inner.file inner.span in
    let row = { depth; label = a.mode; amount = number a.bytes; note = "mode"; place = at } in
    members (depth + 1) ~bytes:a.bytes ~place (row :: rows) a.members
  and definition k depth rows =
    Hashtbl.replace shown k ();
    let d = State.definition t k in
    let place (span : Basis.Span.t) = Bounds.place ~file:span.file span in
    members depth ~bytes:d.bytes ~place rows d.members
  in
  let root = State.definition t (State.root t) in
  let row =
    {
      depth = 1;
      label = root.name;
      amount = number root.bytes;
      note = "";
      place = Bounds.place ~file:root.file root.span;
    }
  in
  List.rev (definition (State.root t) 2 [ row ])

(* {1 Operations, stack and machines} *)

let plain label amount note = { depth = 1; label; amount; note; place = "" }

(* Describes how many pixels the calls of a kernel read. *)
let looks cost name calls =
  let whole = Cost.count cost (Images name) and pixels = Cost.count cost (Pixels name) in
  let images =
    match whole with
    | 0 -> []
    | _ when calls = 1 -> [ "at most the whole image" ]
    | _ when whole = calls -> [ "at most the whole image in each call" ]
    | n -> [ Printf.sprintf "at most the whole image in %s of the calls" (number n) ]
  in
  let known = if pixels = 0 then [] else [ Printf.sprintf "%s pixels" (number pixels) ] in
  String.concat ", " (known @ images)

let operation_rows cost =
  let kind (name, kind) = plain name (number (Cost.count cost kind)) "" in
  let call (name, n) = plain ("calls of " ^ name) (number n) (looks cost name n) in
  List.map kind Bounds.operations @ List.map call (Cost.calls cost)

(* Shows only the beginning and the end of a long chain. *)
let shown_at_ends = 4

let chain (program : Step.Ir.program) nodes =
  let names = List.map (fun k -> program.nodes.(k).origin) nodes in
  let count = List.length names in
  let ends = List.filteri (fun i _ -> i < shown_at_ends || i >= count - shown_at_ends) names in
  let cut = count - List.length ends in
  let names =
    if cut = 0 then ends
    else
      List.concat
        (List.mapi
           (fun i name ->
             if i = shown_at_ends then [ Printf.sprintf "… (%d more)" cut; name ] else [ name ])
           ends)
  in
  String.concat " > " names

let stack_rows (t : Bounds.t) =
  let row name (stack : Stack.t) = plain name (number stack.bytes) (chain t.program stack.chain) in
  [ row "reset" t.stack.reset; row "step" t.stack.step ]

let machine_line (m : Hops.machine) =
  let count = List.length m.modes in
  Printf.sprintf "  %s, %s: %d %s (%s); maximum number of steps within one instant: %d\n" m.name
    (Bounds.place ~file:m.file m.span)
    count
    (if count = 1 then "mode" else "modes")
    (String.concat ", " m.modes) m.steps

(* Explains why a transition takes time, or states that it may take none. *)
let first_instant (t : Hops.transition) =
  match t.at_entry with
  | Possible -> "may occur"
  | Impossible (Some (event, _)) -> Printf.sprintf "cannot occur: `%s`" event
  | Impossible None -> "cannot occur"

let transition_row (t : Hops.transition) =
  let span = match t.at_entry with Impossible (Some (_, span)) -> span | _ -> t.at in
  {
    depth = 1;
    label = Printf.sprintf "from %s to %s" t.leaves t.enters;
    amount = "";
    note = first_instant t;
    place = Bounds.place ~file:span.file span;
  }

let control_row (c : Core.Ir.control) =
  let amount, note =
    match c.kind with
    | Button -> ("button", "")
    | Hold -> ("button held", "")
    | Map -> ("map", "")
    | Camera -> ("camera", "")
    | Tags -> ("tags", "")
    | Lidar { rays } -> ("lidar", Printf.sprintf "%d directions" rays)
    | Imu -> ("imu", "")
    | Toggle { first } -> ("toggle", if first then "initially on" else "initially off")
    | Knob { least; most; first } ->
        let unit_ = if c.unit_ = "" then "" else " " ^ c.unit_ in
        ("knob", Printf.sprintf "%g to %g%s, initially %g" least most unit_ first)
  in
  { depth = 1; label = c.label; amount; note; place = Bounds.place ~file:c.span.file c.span }

let param_row (p : Flow.Ir.param) =
  let first =
    match p.default with
    | Bool b -> string_of_bool b
    | Int n -> Int32.to_string n
    | Float x -> Printf.sprintf "%.15g" x
    | Signal _ -> ""
  in
  let unit_ = if List.mem p.unit_ [ ""; "1" ] then "" else "[" ^ p.unit_ ^ "]" in
  let doc = match p.doc with None -> "" | Some doc -> List.hd (String.split_on_char '\n' doc) in
  {
    depth = 1;
    label = p.label;
    amount = first ^ unit_;
    note = doc;
    place = Bounds.place ~file:p.declared.file p.declared;
  }

let assertions = function
  | None -> []
  | Some (j : Judged.t) ->
      [
        Printf.sprintf
          "\n\
           assertions: %d; checking them adds %d operations to a step (%.2f times the operations \
           without checks) and %d bytes to the state; if checking is off, the generated C does not \
           contain them\n"
          j.count j.operations j.share j.bytes;
      ]

let wire_rows (wire : Wire.t) =
  let row (s : Wire.step) = plain s.quantity (Printf.sprintf "%.3g %s" s.size s.unit_) "" in
  List.map row wire.steps

let on_the_wire = function
  | None -> []
  | Some (wire : Wire.t) ->
      [
        Printf.sprintf "\nresolution of speed on the wire of a %s, averaged over commands\n"
          wire.robot;
        table (wire_rows wire);
      ]

let to_string ?judged ?wire (t : Bounds.t) =
  let params =
    match t.program.params with
    | [] -> []
    | params ->
        [
          Printf.sprintf "\nparameters, %d bytes\n" (State.params_bytes t.program);
          table (List.map param_row params);
        ]
  in
  let machines =
    match t.machines with [] -> [] | machines -> "\nmodes\n" :: List.map machine_line machines
  in
  let events =
    match List.concat_map (fun (m : Hops.machine) -> m.transitions) t.machines with
    | [] -> []
    | transitions ->
        [
          "\nswitching events in the first instant of their mode\n";
          table (List.map transition_row transitions);
        ]
  in
  let console =
    match t.program.console with
    | [] -> []
    | controls -> [ "\nthe operator's console\n"; table (List.map control_row controls) ]
  in
  let marks =
    match t.program.marks with
    | 0 -> []
    | n ->
        [
          Printf.sprintf
            "\n\
             maximum number of marks drawn in an instant: %d; the generated C does not draw them\n"
            n;
        ]
  in
  let foreign =
    match State.foreign t.program with
    | [] -> ""
    | structs -> Printf.sprintf ", without %s from the user's C code" (String.concat ", " structs)
  in
  let library =
    match Bounds.library t with [] -> "" | _ :: _ -> ", without the elementary functions"
  in
  String.concat ""
    ([
       Printf.sprintf "state, in bytes%s\n" foreign;
       table (state_rows t.state);
       "\noperations of a step, at most\n";
       table (operation_rows t.operations.step);
       Printf.sprintf "\nstack, in bytes, at most%s\n" library;
       table (stack_rows t);
     ]
    @ machines @ events @ console @ params @ marks @ on_the_wire wire @ assertions judged)
