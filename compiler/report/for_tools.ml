open Basis

let string s = Json.String s
let file name = string (Filename.basename name)
let line (span : Span.t) = Json.Int (Span.line span.start)
let list f xs = Json.List (Long_list.map f xs)

let rec member index (m : State_layout.member) =
  let holds =
    match m.holds with
    | State_layout.Value purpose -> [ ("holds", string "value"); ("purpose", string purpose) ]
    | Structs { node = k; count } ->
        [
          ("holds", string "structs");
          ("struct", Json.Int (Hashtbl.find index k));
          ("count", Json.Int count);
        ]
    | Struct k -> [ ("holds", string "struct"); ("struct", Json.Int (Hashtbl.find index k)) ]
    | Running_mode -> [ ("holds", string "mode") ]
    | Largest modes -> [ ("holds", string "modes"); ("modes", list (alternative index) modes) ]
  in
  Json.Object
    ([
       ("name", string m.name);
       ("line", line m.span);
       ("offset", Json.Int m.offset);
       ("bytes", Json.Int m.bytes);
     ]
    @ holds)

and alternative index (a : State_layout.alternative) =
  Json.Object
    [
      ("name", string a.mode);
      ("bytes", Json.Int a.bytes);
      ("members", list (member index) a.members);
    ]

let definition index (d : State_layout.definition) =
  Json.Object
    [
      ("name", string d.name);
      ("file", file d.file);
      ("line", line d.span);
      ("bytes", Json.Int d.bytes);
      ("members", list (member index) d.members);
    ]

let key name = String.map (fun c -> if c = ' ' then '_' else c) name

let operations cost =
  let kind (name, kind) = (key name, Json.Int (Cost.count cost kind)) in
  let call (name, n) = (name, Json.Int n) in
  let kernel (name, _) =
    let count what = Json.Int (Cost.count cost what) in
    match Kernels.find name with
    | None -> None
    | Some _ ->
        let looks = [ ("pixels", count (Pixels name)); ("whole_images", count (Images name)) ] in
        Some (name, Json.Object looks)
  in
  let kernels =
    match List.filter_map kernel (Cost.calls cost) with
    | [] -> []
    | kernels -> [ ("kernels", Json.Object kernels) ]
  in
  Json.Object
    (List.map kind Bounds.operations
    @ (("calls", Json.Object (List.map call (Cost.calls cost))) :: kernels))

let transition (t : Hops.transition) =
  let at_entry =
    match t.at_entry with
    | Possible -> [ ("at_first_instant", Json.Bool true) ]
    | Impossible None -> [ ("at_first_instant", Json.Bool false) ]
    | Impossible (Some (event, _)) ->
        [ ("at_first_instant", Json.Bool false); ("event", string event) ]
  in
  Json.Object
    ([ ("from", string t.leaves); ("to", string t.enters); ("line", line t.at) ] @ at_entry)

let machine (m : Hops.machine) =
  Json.Object
    [
      ("name", string m.name);
      ("file", file m.file);
      ("line", line m.span);
      ("modes", list string m.modes);
      ("transitions", list transition m.transitions);
      ("steps", Json.Int m.steps);
    ]

let control (c : Core.Ir.control) =
  let number name x = (name, Json.Float x) in
  let rest =
    match c.kind with
    | Button -> [ ("kind", string "button") ]
    | Hold -> [ ("kind", string "hold") ]
    | Map -> [ ("kind", string "map") ]
    | Camera -> [ ("kind", string "camera") ]
    | Tags -> [ ("kind", string "tags") ]
    | Lidar { rays } -> [ ("kind", string "lidar"); ("rays", Json.Int rays) ]
    | Imu -> [ ("kind", string "imu") ]
    | Toggle { first } -> [ ("kind", string "toggle"); ("first", Json.Bool first) ]
    | Knob { least; most; first } ->
        [
          ("kind", string "knob");
          number "least" least;
          number "most" most;
          number "first" first;
          ("unit", string c.unit_);
        ]
  in
  Json.Object ((("label", string c.label) :: rest) @ [ ("line", line c.span) ])

let param (p : Flow.Ir.param) =
  let default =
    match p.default with
    | Bool b -> Json.Bool b
    | Int n -> Int (Int32.to_int n)
    | Float x -> if Float.abs x < infinity then Float x else Null
    | Signal _ -> Null
  in
  Json.Object
    [
      ("name", string p.label);
      ("unit", string p.unit_);
      ("default", default);
      ("doc", string (Option.value p.doc ~default:""));
      ("line", line p.declared);
    ]

let on_the_wire (wire : Wire.t option) =
  let step (s : Wire.step) =
    Json.Object
      [ ("quantity", string s.quantity); ("size", Json.Float s.size); ("unit", string s.unit_) ]
  in
  match wire with
  | None -> Json.Null
  | Some w -> Object [ ("robot", string w.robot); ("steps", list step w.steps) ]

let to_string ?judged ?wire (t : Bounds.t) =
  let structs = State.in_use t.state in
  let index = Hashtbl.create 16 in
  List.iteri (fun i k -> Hashtbl.replace index k i) structs;
  let root = State.definition t.state (State.root t.state) in
  Json.to_string
    (Object
       [
         ("program", string t.program.name);
         ( "entry",
           Object [ ("name", string root.name); ("file", file root.file); ("line", line root.span) ]
         );
         ("state_bytes", Int root.bytes);
         ("foreign_structs", list string (State.foreign t.program));
         ("structs", list (fun k -> definition index (State.definition t.state k)) structs);
         ("step_operations", operations t.operations.step);
         ("reset_stack_bytes", Int t.stack.reset.bytes);
         ("step_stack_bytes", Int t.stack.step.bytes);
         ("library", list string (Bounds.library t));
         ("machines", list machine t.machines);
         ("console", list control t.program.console);
         ("params", list param t.program.params);
         ("params_bytes", Int (State.params_bytes t.program));
         ("marks", Int t.program.marks);
         ("wire", on_the_wire wire);
         ("assertions", match judged with None -> Int 0 | Some (j : Judged.t) -> Int j.count);
         ( "assertion_operations",
           match judged with None -> Int 0 | Some (j : Judged.t) -> Int j.operations );
         ("assertion_bytes", match judged with None -> Int 0 | Some (j : Judged.t) -> Int j.bytes);
       ])
