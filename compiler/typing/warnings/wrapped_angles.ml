open Basis
open Ir

type facts = {
  into : Fact.t Facts.t;
  resolved : Resolve.Ir.program;
  constants : Constant.t;
  program : program;
  docs : Doc_facts.t;
  origins : Angle_origins.t;
  plain_uses : unit Int_table.t;
      (** variables with at least one use whose result changes if full turns are added *)
  mutable differences : (Local.t * Warning_fact.t) list;
      (** variables defined as a difference, each with the fact to report *)
}

let called = Angle_origins.called
let is_heading = Angle_origins.is_heading
let kind facts e = Angle_origins.kind facts.origins e
let report facts warning = Facts.report facts.into (Warning warning)

(* {1 Filters} *)

(* Whether a `pid` with these gains may have a derivative term. *)
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

let is_plain_pid facts (g : Global.t) arguments =
  match (g, arguments) with
  | { module_ = "Control"; name = "pid" }, [ gains ] -> not (has_derivative facts gains)
  | _ -> false

(* The function to use for angles instead of [f], if [f] is unsuitable for them. *)
let for_angles facts (f : expr) =
  match called f with
  | Some (g, arguments) when not (is_plain_pid facts g arguments) ->
      Option.map (fun other -> (g, other)) (Doc_facts.for_angles facts.docs g)
  | _ -> None

(* Reports an angle that wraps and is the input or an argument of a function that is unsuitable for
   such angles. *)
let unsuitable facts (f : expr) (function_, (other : Doc_facts.for_angles)) angle kind ~unwrap =
  let { Doc_facts.name = instead; module_; same_arguments } = other in
  report facts
    (Wrapped_angle
       {
         resolved = facts.resolved;
         function_;
         head = head f;
         angle;
         scaled = kind = Angle_origins.Scaled;
         instead;
         module_;
         same_arguments;
         unwrap;
       })

let unwrapped facts input =
  let input = Angle_origins.within facts.origins input in
  Warning_fact.Around (if kind facts input = Some Scaled then None else Some input)

let check facts (f : expr) inputs =
  let with_kind e = Option.map (fun kind -> (e, kind)) (kind facts e) in
  match for_angles facts f with
  | None -> ()
  | Some other -> (
      match List.find_map with_kind inputs with
      | Some (angle, kind) -> unsuitable facts f other angle kind ~unwrap:(unwrapped facts angle)
      | None -> ())

let run facts (f : expr) (input : expr) =
  check facts f (match input.desc with Tuple es -> es | _ -> [ input ])

(* Checks the arguments of an application, unless its value is a function or signal function. *)
let application facts (e : expr) arguments =
  match e.ty with Signal_function _ | Function _ -> () | _ -> check facts e arguments

let composition facts (f : expr) (g : expr) =
  let rec first (g : expr) =
    match called g with Some ({ module_ = "Prelude"; name = ">>>" }, [ g; _ ]) -> first g | _ -> g
  in
  let g = first g in
  match (for_angles facts g, Angle_origins.output facts.origins f) with
  | Some other, Some kind -> unsuitable facts g other f kind ~unwrap:(Before g)
  | _ -> ()

(* {1 Traversal} *)

(* Whether the function accepts an angle with extra full turns as the argument with this index (from
   0). *)
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
  | Turns  (** a place where extra full turns make no difference *)
  | Equation of Local.t  (** the right-hand side of this variable's equation *)

let rec expr facts place (e : expr) =
  let plain = expr facts Plain in
  let inner = match place with Turns -> Turns | Plain | Equation _ -> Plain in
  match (e.desc, Constant.operation e) with
  | Local (x, _), _ -> if inner = Plain then Int_table.replace facts.plain_uses x.id ()
  | _, Some ("-", [ a; b ]) ->
      (match (kind facts a, kind facts b) with
      | (None | Some Scaled), (None | Some Scaled) | Some Rotation, None | None, Some Rotation -> ()
      | _ -> (
          let difference : Warning_fact.t =
            Angle_difference { resolved = facts.resolved; difference = e; left = a; right = b }
          in
          match place with
          | Turns -> ()
          | Plain -> report facts difference
          | Equation x -> facts.differences <- (x, difference) :: facts.differences));
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
      run facts f input;
      plain f;
      let of_angles = match called f with Some (g, _) -> g.module_ = "Angles" | None -> false in
      expr facts (if of_angles then Turns else Plain) input
  | Apply _, _ -> (
      match called e with
      | Some (g, arguments) ->
          (match (g, arguments) with
          | { module_ = "Prelude"; name = ">>>" }, [ f; g ] -> composition facts f g
          | _ -> application facts e arguments);
          let argument index = expr facts (if accepts_turns g index then Turns else Plain) in
          List.iteri argument arguments
      | None -> Walk.parts plain e)
  | _ -> Walk.parts plain e

(* The heading of a pose may contain additional full turns. *)
and field facts c (index, value) = expr facts (if is_heading c index then Turns else Plain) value

and binding facts (b : binding) =
  let place = match b.pattern.desc with Bound x -> Equation x | _ -> Plain in
  expr facts place b.value

let warn into resolved program =
  let docs = Doc_facts.of_program resolved in
  let facts =
    {
      into;
      resolved;
      constants = Constant.of_program program;
      program;
      docs;
      origins = Angle_origins.of_program docs resolved program;
      plain_uses = Int_table.create 16;
      differences = [];
    }
  in
  Walk.own resolved (expr facts Plain) program;
  List.iter
    (fun ((x : Local.t), difference) ->
      if Int_table.mem facts.plain_uses x.id then report facts difference)
    facts.differences
