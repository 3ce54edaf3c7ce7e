open Basis
open Ir

type kind = Heading | Rotation | Scaled

type t = {
  docs : Doc_facts.t;
  values : expr Int_table.t;  (** values of the variables that equations bind *)
  headings : unit Int_table.t;  (** variables that match the heading of a pose *)
  kinds : kind option Int_table.t;  (** results for the variables that have been looked up *)
}

let is_heading (c : constructor) index =
  List.mem c.constructor
    [ { Global.module_ = "Geometry"; name = "Pose" }; { Global.module_ = "Imu"; name = "Imu" } ]
  && match List.nth_opt c.fields index with Some (name, _) -> name = "heading" | None -> false

let rec pattern t (p : pattern) =
  match p.desc with
  | As (_, inner) -> pattern t inner
  | Tuple_of ps | Array_of ps -> List.iter (pattern t) ps
  | Constructed (c, ps) ->
      List.iteri
        (fun index (p : pattern) ->
          match p.desc with
          | (Bound x | As (x, _)) when is_heading c index -> Int_table.replace t.headings x.id ()
          | _ -> pattern t p)
        ps
  | _ -> ()

let rec collect t (e : expr) =
  let binding (b : binding) =
    match b.pattern.desc with
    | Bound x -> Int_table.replace t.values x.id b.value
    | _ -> pattern t b.pattern
  in
  (match e.desc with
  | Let (bindings, _) -> List.iter binding bindings
  | Proc { input; equations; _ } ->
      pattern t input;
      List.iter binding equations
  | Lambda (ps, _) -> List.iter (pattern t) ps
  | Case (_, branches) -> List.iter (fun (b : branch) -> pattern t b.pattern) branches
  | _ -> ());
  Walk.parts (collect t) e

let of_program docs resolved program =
  let table () = Int_table.create 16 in
  let t = { docs; values = table (); headings = table (); kinds = table () } in
  Walk.own resolved (collect t) program;
  t

let called (e : expr) =
  match Constant.spine e with
  | { desc = Global (g, _) | Primitive (g, _); _ }, arguments -> Some (g, arguments)
  | _ -> None

(* Signal functions whose output consists of current or earlier inputs. *)
let passes_on (g : Global.t) =
  match (g.module_, g.name) with
  | "Prelude", ("delay" | "hold" | "dHold")
  | "Control", ("previous" | "delayBy" | "holdFinite" | "window")
  | "Filters", "recent" ->
      true
  | _ -> false

let is_plain (e : expr) =
  match e.ty with Number (_, { base = []; variables = [] }) -> true | _ -> false

let either a b =
  match (a, b) with
  | None, kind | kind, None -> kind
  | Some Rotation, Some Rotation -> Some Rotation
  | Some Scaled, _ | _, Some Scaled -> Some Scaled
  | Some Heading, _ | _, Some Heading -> Some Heading

(* The maximum depths for an expression and for a chain of equations. *)
let max_depth = 8
let max_equations = 32

let rec kind ~depth ~equations t (e : expr) =
  let kind e = if depth = 0 then None else kind ~depth:(depth - 1) ~equations t e in
  let any es = List.fold_left (fun found e -> either found (kind e)) None es in
  (* A multiple of a rotation has no kind: it is a command, and a command may jump. *)
  let multiple a = match kind a with Some (Heading | Scaled) -> Some Scaled | _ -> None in
  match (e.desc, Constant.operation e) with
  | Field (_, c, index), _ when is_heading c index -> Some Heading
  | Local (x, _), _ when Int_table.mem t.headings x.id -> Some Heading
  | Local (x, _), _ -> of_variable ~equations t x
  | (Negate a | Index (a, _)), _ -> kind a
  | If (_, a, b), _ -> any [ a; b ]
  | Guards (guarded, last), _ -> any (List.map snd guarded @ Option.to_list last)
  | Case (_, branches), _ -> any (List.map (fun (b : branch) -> b.value) branches)
  | Array es, _ -> any es
  | Let (_, body), _ -> kind body
  | Apply ({ desc = Constructor _; _ }, a), _ -> kind a
  | _, Some (("+" | "-"), [ a; b ]) -> (
      match (kind a, kind b) with
      (* a continuous angle plus a rotation is also continuous: it is a goal *)
      | None, Some Rotation | Some Rotation, None | Some _, Some _ -> None
      | None, found | found, None -> found)
  | _, Some ("*", [ a; b ]) when is_plain e -> either (multiple a) (multiple b)
  | _, Some ("/", [ a; _ ]) when is_plain e -> multiple a
  | Run (f, input), _ -> (
      match called f with
      | Some (g, _) when Doc_facts.wraps t.docs g -> Some Heading
      | Some (g, _) when passes_on g -> kind input
      | _ -> None)
  | Apply _, _ -> (
      match called e with
      | Some ({ module_ = "Geometry"; name = "angleDiff" }, [ _; _ ]) -> Some Rotation
      | Some ({ module_ = "Prelude"; name = "fromMaybe" }, ([ _; _ ] as es)) -> any es
      | Some ({ module_ = "Prelude"; name = "at" }, [ _; x; xs ]) -> any [ x; xs ]
      | Some (g, _) when Doc_facts.wraps t.docs g -> Some Heading
      | _ -> None)
  | _ -> None

(* Each variable is looked up once, because its value may be a large array. *)
and of_variable ~equations t (x : Local.t) =
  match Int_table.find_opt t.kinds x.id with
  | Some known -> known
  | None when equations = 0 -> None
  | None ->
      (* a variable that depends on itself has no kind *)
      Int_table.replace t.kinds x.id None;
      let found =
        Option.bind
          (Int_table.find_opt t.values x.id)
          (kind ~depth:max_depth ~equations:(equations - 1) t)
      in
      Int_table.replace t.kinds x.id found;
      found

let kind = kind ~depth:max_depth ~equations:max_equations

let rec output t (f : expr) =
  match (f.desc, called f) with
  | Proc { output; _ }, _ -> kind t output
  | _, Some ({ module_ = "Prelude"; name = ">>>" }, [ _; last ]) -> output t last
  | _, Some ({ module_ = "Prelude"; name = "arr" }, [ { desc = Lambda (_, body); _ } ]) ->
      kind t body
  | _, Some (g, _) when Doc_facts.wraps t.docs g -> Some Heading
  | _ -> None

let rec within t (e : expr) =
  match (e.desc, Constant.operation e) with
  | Run (f, input), _ when Option.fold ~none:false ~some:(fun (g, _) -> passes_on g) (called f) ->
      within t input
  | _, Some (("*" | "/"), [ a; b ]) -> within t (if kind t a = None then b else a)
  | _ -> e
