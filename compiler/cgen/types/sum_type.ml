module F = Flow.Ir

type t = {
  struct_name : string;
  tags : string array;
  makers : string array;
  real : Basis.Real.t;
  slots : Step.Layout.slots;
  arrays : (F.ty * Ir.ty) list;
}

let name scope ~prefix ~real (sum : F.sum) ~slots ~arrays =
  let struct_name = Name.fresh scope (prefix ^ "_" ^ Name.short (Name.snake sum.name)) in
  let constructor (c : F.sum_constructor) = struct_name ^ "_" ^ Name.snake c.constructor in
  let all = Array.of_list (List.map constructor sum.constructors) in
  {
    struct_name;
    tags = Array.map (fun name -> Name.fresh scope (String.uppercase_ascii name)) all;
    makers = Array.map (Name.fresh scope) all;
    real;
    slots;
    arrays;
  }

type slot = Scalar of string | Inner of { sum : int; tag : string; first : Step.Layout.slots }

let float_slot k = "f" ^ string_of_int k
let int_slot k = "i" ^ string_of_int k
let bool_slot k = "b" ^ string_of_int k
let tag_slot k = "t" ^ string_of_int k

(* This name is the same in every program, because robots' headers use it. *)
let array_slot sums ty k = Printf.sprintf "%s_%d" (Array_type.name sums (Step.Layout.ty ty)) k

let payload sums ?(first = Step.Layout.none) (constructor : F.sum_constructor) =
  let place ((used : Step.Layout.slots), slots) (ty : F.ty) =
    let slot =
      match ty with
      | Float -> Scalar (float_slot used.floats)
      | Int -> Scalar (int_slot used.ints)
      | Bool -> Scalar (bool_slot used.bools)
      | Sum sum ->
          let first = { used with tags = used.tags + 1 } in
          Inner { sum; tag = tag_slot used.tags; first }
      | Array _ | Foreign _ -> Scalar (array_slot sums ty (Step.Layout.arrays_before used ty))
    in
    (Step.Layout.add used (Step.Layout.leaf sums ty), slot :: slots)
  in
  let _, slots = List.fold_left place (first, []) (Flow.Shape.payload constructor) in
  List.rev slots

type kind = Number | Whole | Truth | Inner_tag | Large of F.ty

let kinds sums ?(first = Step.Layout.none) (slots : Step.Layout.slots) =
  let some count start slot kind = List.init count (fun k -> (slot (start + k), kind)) in
  let large (ty, count) =
    some count (Step.Layout.arrays_before first ty) (array_slot sums ty) (Large ty)
  in
  List.concat
    [
      some slots.floats first.floats float_slot Number;
      some slots.ints first.ints int_slot Whole;
      some slots.bools first.bools bool_slot Truth;
      some slots.tags first.tags tag_slot Inner_tag;
      List.concat_map large slots.arrays;
    ]

let members sums ?first t =
  let ty : kind -> Ir.ty = function
    | Number -> Real t.real
    | Whole -> Int32
    | Truth -> Bool
    | Inner_tag -> Uint8
    | Large ty -> List.assoc ty t.arrays
  in
  List.map (fun (name, kind) -> (name, ty kind)) (kinds sums ?first t.slots)

let definition sums (sum : F.sum) t =
  let member (name, ty) : Ir.member = { name; ty; comment = "" } in
  [
    Ir.Constants { names = Array.to_list t.tags; comment = sum.name };
    Struct_definition
      {
        name = t.struct_name;
        overlaid = false;
        members = List.map member (("tag", Ir.Uint8) :: members sums t);
        comment = "";
      };
  ]

let rec zero real sums ~absent (ty : Step.Ir.ty) : Ir.expr =
  match ty with
  | Foreign ty -> absent ty
  | Float -> Float (real, 0.)
  | Bool -> Boolean false
  | Int | Nanoseconds -> Integer 0l
  | Sum k ->
      let slots = zeros real sums ~absent (Step.Layout.sum sums k) in
      Aggregate (Integer 0l :: List.map (fun zero -> zero ()) slots)
  | Array (_, element) -> Aggregate [ Aggregate [ zero real sums ~absent element ] ]

(* The initial values of the slots, in the order of the members. They are lazy because [absent]
   declares a variable. *)
and zeros real sums ~absent (slots : Step.Layout.slots) =
  let of_kind kind () : Ir.expr =
    match kind with
    | Number -> Float (real, 0.)
    | Whole | Inner_tag -> Integer 0l
    | Truth -> Boolean false
    | Large ty -> zero real sums ~absent (Step.Layout.ty ty)
  in
  List.map (fun (_, kind) -> of_kind kind) (kinds sums slots)

(* The body of a function that returns a struct with these members. *)
let return_struct ty values : Ir.statement list =
  [
    { desc = Initialize { ty; name = "value"; values }; comment = "" };
    { desc = Return (Name "value"); comment = "" };
  ]

let function_ ~result name parameters values : Ir.function_ =
  {
    linkage = Static_inline;
    result;
    name;
    parameters;
    body = return_struct result values;
    comment = "";
  }

let maker sums ~absent types sum constructor =
  let t = types.(sum) in
  let slots = payload sums (List.nth sums.(sum).F.constructors constructor) in
  let given = Hashtbl.create 8 in
  let give member e = Hashtbl.replace given member e in
  let parameter slot : Ir.ty * string =
    match slot with
    | Scalar member ->
        give member (Ir.Name member);
        (List.assoc member (members sums t), member)
    | Inner { sum; tag; first } ->
        let inner = types.(sum) in
        let name = "inner_" ^ tag in
        give tag (Member (Name name, "tag"));
        List.iter2
          (fun (outer, _) (own, _) -> give outer (Member (Name name, own)))
          (members sums ~first inner) (members sums inner);
        (Struct inner.struct_name, name)
  in
  let parameters = List.map parameter slots in
  let value (member, _) zero =
    match Hashtbl.find_opt given member with Some e -> e | None -> zero ()
  in
  function_ ~result:(Struct t.struct_name) t.makers.(constructor) parameters
    (Name t.tags.(constructor)
    :: List.map2 value (members sums t) (zeros t.real sums ~absent t.slots))

let projection sums types sum ~constructor ~leaf =
  let t = types.(sum) in
  match List.nth (payload sums (List.nth sums.(sum).F.constructors constructor)) leaf with
  | Scalar _ -> Basis.Diagnostic.bug ~stage:"Cgen.Sum_type" "a scalar needs no projection"
  | Inner { sum; tag; first } ->
      let inner = types.(sum) in
      let from member = Ir.Member (Name "outer", member) in
      function_ ~result:(Struct inner.struct_name)
        (Printf.sprintf "%s_part%d" t.makers.(constructor) (leaf + 1))
        [ (Struct t.struct_name, "outer") ]
        (from tag :: List.map (fun (member, _) -> from member) (members sums ~first inner))
