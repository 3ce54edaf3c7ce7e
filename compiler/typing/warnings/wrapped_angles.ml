open Basis
open Ir

type facts = {
  sink : Diagnostic.sink;
  resolved : Resolve.Ir.program;
  constants : Constant.t;
  program : program;
  values : expr Int_table.t;  (** of the variables that equations bind *)
  headings : unit Int_table.t;  (** variables that match the heading of a pose *)
  plain_uses : unit Int_table.t;  (** variables with a use that does not accept whole turns *)
  mutable differences : (Local.t * (unit -> unit)) list;
      (** equations that are a difference, each with its report *)
}

(* {1 Angles that wrap} *)

type kind = Heading | Rotation  (** from one heading to another, so small differences are fine *)

let is_heading (c : constructor) index =
  c.constructor = { Global.module_ = "Geometry"; name = "Pose" }
  && match List.nth_opt c.fields index with Some (name, _) -> name = "heading" | None -> false

let rec pattern facts (p : pattern) =
  match p.desc with
  | As (_, inner) -> pattern facts inner
  | Tuple_of ps | Array_of ps -> List.iter (pattern facts) ps
  | Constructed (c, ps) ->
      List.iteri
        (fun index (p : pattern) ->
          match p.desc with
          | (Bound x | As (x, _)) when is_heading c index ->
              Int_table.replace facts.headings x.id ()
          | _ -> pattern facts p)
        ps
  | _ -> ()

let rec collect facts (e : expr) =
  let binding (b : binding) =
    match b.pattern.desc with
    | Bound x -> Int_table.replace facts.values x.id b.value
    | _ -> pattern facts b.pattern
  in
  (match e.desc with
  | Let (bindings, _) -> List.iter binding bindings
  | Proc { input; equations; _ } ->
      pattern facts input;
      List.iter binding equations
  | Lambda (ps, _) -> List.iter (pattern facts) ps
  | Case (_, branches) -> List.iter (fun (b : branch) -> pattern facts b.pattern) branches
  | _ -> ());
  Walk.parts (collect facts) e

let called (e : expr) =
  match Constant.spine e with
  | { desc = Global (g, _) | Primitive (g, _); _ }, arguments -> Some (g, arguments)
  | _ -> None

(* The number of equations to follow. *)
let depth = 8

let rec kind facts depth (e : expr) =
  let kind = if depth = 0 then fun _ -> None else kind facts (depth - 1) in
  match e.desc with
  | Field (_, c, index) when is_heading c index -> Some Heading
  | Local (x, _) when Int_table.mem facts.headings x.id -> Some Heading
  | Local (x, _) -> Option.bind (Int_table.find_opt facts.values x.id) kind
  | Negate a -> kind a
  | If (_, a, b) -> if kind a = kind b then kind a else None
  | Run (f, input) -> (
      match called f with
      | Some ({ module_ = "Angles"; name }, _)
        when List.mem name
               [ "lowPassAngle"; "rateLimitAngle"; "movingAverageAngle"; "complementaryAngle" ] ->
          Some Heading
      | Some
          (({ module_ = "Control"; name = "previous" } | { module_ = "Prelude"; name = "delay" }), _)
        ->
          kind input
      | _ -> None)
  | Apply _ -> (
      match called e with
      | Some ({ module_ = "Geometry"; name = "angleDiff" }, [ _; _ ]) -> Some Rotation
      | Some ({ module_ = "Geometry"; name = "wrapAngle" | "direction" }, [ _ ])
      | Some ({ module_ = "Angles"; name = "meanAngle" | "halfOpen" }, [ _ ])
      | Some ({ module_ = "Prelude"; name = "atan2" }, [ _; _ ]) ->
          Some Heading
      | _ -> None)
  | _ -> None

let kind facts e = kind facts depth e

(* {1 Reports} *)

let is_atom (e : expr) =
  match e.desc with
  | Local _ | Global _ | Field _ | Number _ | Tuple _ | Array _ -> true
  | _ -> false

let after (e : expr) = Span.make ~file:e.span.file ~start:e.span.stop ~stop:e.span.stop
let before (e : expr) = Span.make ~file:e.span.file ~start:e.span.start ~stop:e.span.start

(* Adds the import of a library module to a fix at this place, unless the module is imported. *)
let with_import facts (at : Span.t) library_module edits =
  let is_here (m : Resolve.Ir.module_) = String.equal m.file at.file in
  match List.find_opt is_here facts.resolved.modules with
  | Some m when not (List.mem library_module m.imported) ->
      let { Resolve.Ir.place; before; after } = m.import_place in
      (place, before ^ "import " ^ library_module ^ after) :: edits
  | Some _ | None -> edits

let difference facts (e : expr) (a : expr) (b : expr) =
  let opening e = if is_atom e then "" else "(" and closing e = if is_atom e then "" else ")" in
  let between = Span.make ~file:e.span.file ~start:a.span.stop ~stop:b.span.start in
  Diagnostic.(
    warning ~code:"W0315" ~at:e.span "this difference of angles can be more than half a turn"
    |> note
         "from -179 degrees to 179 degrees, it is 358 degrees; the shortest rotation is -2 degrees"
    |> hint "write `angleDiff a b` (module Geometry) instead of `a - b`"
    |> fix "use `angleDiff`"
         (with_import facts e.span "Geometry"
            [
              (before e, "angleDiff " ^ opening a);
              (between, closing a ^ " " ^ opening b);
              (after e, closing b);
            ])
    |> emit facts.sink)

let jumps name =
  Printf.sprintf "where the angle jumps from pi to -pi, `%s` sees a rotation by 360 degrees" name

let replaced facts (head : expr) (input : expr) name other =
  Diagnostic.(
    warning ~code:"W0315" ~at:head.span "`%s` of an angle that wraps" name
    |> label ~at:input.span "this angle is between -pi and pi"
    |> note (jumps name)
    |> hint (Printf.sprintf "write `%s` (module Angles)" other)
    |> fix
         (Printf.sprintf "write `%s`" other)
         (with_import facts head.span "Angles" [ (head.span, other) ])
    |> emit facts.sink)

let unwrapped facts (head : expr) (input : expr) name =
  (* other arguments have parentheses already, outside their span *)
  let opening, closing = if is_atom input then ("(unwrap ", ")") else ("unwrap (", ")") in
  Diagnostic.(
    warning ~code:"W0315" ~at:head.span "`%s` of an angle that wraps" name
    |> label ~at:input.span "this angle is between -pi and pi"
    |> note (jumps name)
    |> hint "make the angle continuous with `unwrap` (module Angles)"
    |> fix "use `unwrap`"
         (with_import facts head.span "Angles" [ (before input, opening); (after input, closing) ])
    |> emit facts.sink)

(* {1 Filters} *)

let for_angles (g : Global.t) =
  match (g.module_, g.name) with
  | "Prelude", "derivative" -> Some "angularRate"
  | "Control", "lowPass" -> Some "lowPassAngle"
  | "Control", "rateLimit" -> Some "rateLimitAngle"
  | "Control", "movingAverage" -> Some "movingAverageAngle"
  | "Filters", "complementary" -> Some "complementaryAngle"
  | _ -> None

let needs_continuous (g : Global.t) =
  String.equal g.module_ "Filters"
  && List.mem g.name
       [
         "highPass";
         "lowPass2";
         "notch";
         "filteredDerivative";
         "alphaBeta";
         "rateLimitUpDown";
         "slew";
         "median3";
         "median5";
         "rejectJumps";
       ]

(* Whether a `pid` with these gains may use the derivative. *)
let has_derivative facts (gains : expr) =
  let is_pid (d : data) = d.tycon = { Global.module_ = "Control"; name = "Pid" } in
  let index (c : constructor) =
    List.assoc_opt "kd" (List.mapi (fun index (name, _) -> (name, index)) c.fields)
  in
  match List.find_opt is_pid facts.program.data with
  | Some { constructors = [ c ]; _ } -> (
      match (index c, gains.desc) with
      | Some kd, Record (_, fields) -> (
          match List.assoc_opt kd fields with
          | Some value -> Constant.float facts.constants value <> Some 0.
          | None -> true)
      | Some kd, _ ->
          Constant.float facts.constants { gains with desc = Field (gains, c, kd); ty = Bool }
          <> Some 0.
      | None, _ -> true)
  | _ -> true

let rec head (e : expr) = match e.desc with Apply (f, _) -> head f | _ -> e

let filter facts (f : expr) (input : expr) =
  let input =
    (* the absolute reading of a complementary filter *)
    match (called f, input.desc) with
    | Some ({ module_ = "Filters"; name = "complementary" }, _), Tuple [ _; reading ] -> reading
    | _ -> input
  in
  match (called f, kind facts input) with
  | Some (g, arguments), Some _ -> (
      match (for_angles g, g, arguments) with
      | Some other, _, _ -> replaced facts (head f) input g.name other
      | None, { module_ = "Control"; name = "pid" }, [ gains ] ->
          if has_derivative facts gains then unwrapped facts (head f) input g.name
      | None, _, _ -> if needs_continuous g then unwrapped facts (head f) input g.name)
  | _ -> ()

(* {1 The walk} *)

(* The arguments, from 0, that may be any number of turns away. *)
let accepts_turns (g : Global.t) index =
  match (g.module_, g.name, index) with
  | "Prelude", ("sin" | "cos" | "tan"), _
  | "Geometry", ("wrapAngle" | "angleDiff"), _
  | "Geometry", "rotate", 0
  | "Geometry", "polar", 1
  | "Angles", _, _ ->
      true
  | _ -> false

type place =
  | Plain
  | Turns  (** accepts any number of turns *)
  | Equation of Local.t  (** the value of this variable *)

let rec expr facts place (e : expr) =
  let plain = expr facts Plain in
  let inner = match place with Turns -> Turns | Plain | Equation _ -> Plain in
  match (e.desc, Constant.operation e) with
  | Local (x, _), _ -> if inner = Plain then Int_table.replace facts.plain_uses x.id ()
  | _, Some ("-", [ a; b ]) ->
      (match (kind facts a, kind facts b) with
      | None, None | Some Rotation, None | None, Some Rotation -> ()
      | _ -> (
          match place with
          | Turns -> ()
          | Plain -> difference facts e a b
          | Equation x ->
              facts.differences <- (x, fun () -> difference facts e a b) :: facts.differences));
      List.iter (expr facts inner) [ a; b ]
  | _, Some (("+" | "*"), [ a; b ]) -> List.iter (expr facts inner) [ a; b ]
  | Negate a, _ -> expr facts inner a
  | If (condition, a, b), _ ->
      plain condition;
      List.iter (expr facts place) [ a; b ]
  | Guards (guarded, last), _ ->
      List.iter
        (fun (condition, value) ->
          plain condition;
          expr facts place value)
        guarded;
      Option.iter (expr facts place) last
  | Case (scrutinee, branches), _ ->
      plain scrutinee;
      List.iter (fun (b : branch) -> expr facts place b.value) branches
  | Array es, _ -> List.iter (expr facts inner) es
  | Let (bindings, body), _ ->
      List.iter (binding facts) bindings;
      expr facts place body
  | Proc { equations; output; _ }, _ ->
      List.iter (binding facts) equations;
      plain output
  | Record (c, fields), _ -> List.iter (field facts c) fields
  | Update (record, c, fields), _ ->
      plain record;
      List.iter (field facts c) fields
  | Run (f, input), _ ->
      filter facts f input;
      plain f;
      let of_angles = match called f with Some (g, _) -> g.module_ = "Angles" | None -> false in
      expr facts (if of_angles then Turns else Plain) input
  | Apply _, _ -> (
      match called e with
      | Some (g, arguments) ->
          let argument index = expr facts (if accepts_turns g index then Turns else Plain) in
          List.iteri argument arguments
      | None -> Walk.parts plain e)
  | _ -> Walk.parts plain e

(* The heading of a pose may be any number of turns away. *)
and field facts c (index, value) = expr facts (if is_heading c index then Turns else Plain) value

and binding facts (b : binding) =
  let place = match b.pattern.desc with Bound x -> Equation x | _ -> Plain in
  expr facts place b.value

let warn sink resolved program =
  let table () = Int_table.create 16 in
  let facts =
    {
      sink;
      resolved;
      constants = Constant.of_program program;
      program;
      values = table ();
      headings = table ();
      plain_uses = table ();
      differences = [];
    }
  in
  Walk.own resolved (collect facts) program;
  Walk.own resolved (expr facts Plain) program;
  List.iter
    (fun ((x : Local.t), report) -> if Int_table.mem facts.plain_uses x.id then report ())
    facts.differences
