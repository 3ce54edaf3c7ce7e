open Basis
module Ir = Core.Ir

type position = Evaluator.position

let atom_at_rest (rest : Core.Console.rest) : Value.t =
  match rest with
  | No_event -> Constructed { constructor = 0; arguments = [] }
  | Off b -> Atom (Bool b)
  | At x -> Atom (Float x)

let at_rest (c : Context.t) : Value.t =
  match c.console with
  | Sought _ -> Product [||]
  | Declared controls ->
      let rest (control : Ir.control) = atom_at_rest (Core.Console.at_rest control.kind) in
      Product (Array.of_list (List.map rest controls))

let is_looked_for (c : Context.t) body =
  match c.console with Sought _ -> Core.Console.asks_itself body | Declared _ -> false

(* {1 Requested controls} *)

let place (p : position) = Context.own_place p.context p.trail ~span:p.span

let refuse p problem =
  Context.report_control p.Evaluator.context { at = place p; problem };
  None

let longest_label = 40

(* A label is used as a column name, as a C string, and as text next to a button. *)
let fault_of_label text : Control_fact.problem option =
  let is_odd c = c < ' ' || c = '\127' || c = ',' || c = '"' || c = '\\' in
  if String.equal text "" then Some Empty_label
  else if String.exists is_odd text then Some Odd_character
  else if text.[0] = ' ' || text.[String.length text - 1] = ' ' then Some Space_at_an_end
  else if String.length text > longest_label then Some (Long_label { limit = longest_label })
  else None

let label p (value : Value.t) =
  match value with
  | Unspecified -> None
  | Text text -> (
      match fault_of_label text with None -> Some text | Some fault -> refuse p fault)
  | _ -> refuse p Unknown_label

let numbers p values =
  let known (value : Value.t) = match value with Atom (Float x) -> Some x | _ -> None in
  match List.map known values with
  | _ when List.mem Value.Unspecified values -> None
  | [ Some least; Some most; Some first ] ->
      if List.exists (fun x -> not (Float.is_finite x)) [ least; most; first ] then
        refuse p Not_finite
      else if least >= most then refuse p (Limits { least; most })
      else if first < least || first > most then refuse p (Initial { least; most; first })
      else Some (Ir.Knob { least; most; first })
  | _ -> refuse p Unknown_knob

(* The number of directions of a scan, from its type. *)
let rays : Ir.ty -> int = function
  | Data (_, [ Data (_, [ Size n ]) ]) -> n
  | _ -> Diagnostic.bug ~stage:"Specialize.Operator" "a scan without a size"

let control p (kind : Core.Primitive.console) ~result (arguments : Value.argument list) =
  let open Basis.Let_syntax.Option in
  match (kind, List.map (fun (a : Value.argument) -> a.value) arguments) with
  | Button, text :: _ ->
      let* label = label p text in
      Some (label, Ir.Button)
  | Hold, text :: _ ->
      let* label = label p text in
      Some (label, Ir.Hold)
  | Knob, [ text; least; most; first; _ ] ->
      let* label = label p text in
      let* kind = numbers p [ least; most; first ] in
      Some (label, kind)
  | Toggle, [ text; first; _ ] -> (
      let* label = label p text in
      match first with
      | Atom (Bool first) -> Some (label, Ir.Toggle { first })
      | Unspecified -> None
      | _ -> refuse p Unknown_toggle)
  | Camera, text :: _ ->
      let* label = label p text in
      Some (label, Ir.Camera)
  | Tags, text :: _ ->
      let* camera = label p text in
      Some (Core.Console.tags_label camera, Ir.Tags)
  | Lidar, text :: _ ->
      let* lidar = label p text in
      let rays = rays result in
      Some (Core.Console.lidar_label lidar rays, Ir.Lidar { rays })
  | Imu, text :: _ ->
      let* label = label p text in
      Some (label, Ir.Imu)
  | Map, _ -> Some (Core.Console.map_label, Ir.Map)
  | (Button | Hold | Knob | Toggle | Camera | Tags | Lidar | Imu), _ ->
      Diagnostic.bug ~stage:"Specialize.Operator" "a control without a label"

let note (p : position) (found : Ir.control list) (label, kind) =
  let span = place p in
  let has_label (c : Ir.control) = String.equal c.label label in
  match List.find_opt has_label found with
  | None -> { Ir.label; kind; unit_ = ""; span } :: found
  | Some { kind = known; _ } when known = kind ->
      let is_here (c : Ir.control) = has_label c && c.span = span in
      if List.exists is_here found then found else { Ir.label; kind; unit_ = ""; span } :: found
  | Some by ->
      ignore (refuse p (Taken { label; kind; by }));
      found

(* {1 Values of controls} *)

(* An unknown value of this type. *)
let unknown (p : position) result =
  let leaf (leaf : Types.leaf) = Node.define p.node Unnamed ~span:p.span leaf.leaf Absent in
  Leaves.value p.types result (List.map leaf (Types.layout p.types result).leaves)

let apply (p : position) kind ~result (arguments : Value.argument list) =
  match (p.context.console, arguments) with
  | Sought sought, _ ->
      Option.iter
        (fun found -> sought.found <- note p sought.found found)
        (control p kind ~result arguments);
      unknown p result
  | Declared controls, _ -> (
      match control p kind ~result arguments with
      | None -> Unspecified
      | Some (label, _) ->
          let console = (List.nth arguments (List.length arguments - 1)).value in
          Leaves.component console (Core.Console.field controls label))
