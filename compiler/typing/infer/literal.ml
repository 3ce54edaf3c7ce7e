open Basis

let fits value = Option.is_some (Exact.to_int32 value)

let is_only_negative (n : Resolve.Ir.number) =
  (not n.decimal) && n.unit_ = None
  &&
  match Exact.of_literal n.digits with
  | Some value -> (not (fits value)) && fits (Exact.negate value)
  | None -> false

(* The value of a non-decimal literal if its bits are read as two's complement. *)
let as_bits digits =
  match Exact.of_literal digits with
  | Some value
    when String.length digits > 2 && Exact.base_of_prefix (digits.[0], digits.[1]) <> None ->
      Exact.(to_int32 (add value (negate (power (of_int 2) 32))))
  | Some _ | None -> None

(* A literal too large for [Int] becomes a [Float] if that is allowed. *)
let too_large (ctx : Context.t) ~at (n : Resolve.Ir.number) representation =
  let report () =
    Context.tell ctx (Int_out_of_range { at; number = n; same_bits = as_bits n.digits })
  in
  let attempt () =
    match Type.representation representation with
    | Float -> true
    | Flexible_representation _ -> false
    | Int | Rigid_representation _ ->
        report ();
        true
  in
  let guess () =
    match Type.representation representation with
    | Flexible_representation variable ->
        variable.found <- Some Type.Float;
        true
    | Int | Float | Rigid_representation _ -> attempt ()
  in
  Context.ask ctx { attempt; guess; give_up = ignore }

let tell_out_of_range (ctx : Context.t) ~at number =
  Context.tell ctx (Number_out_of_range { at; number; real = ctx.real })

(* Only literals of this kind can exceed the range of a Float. *)
let is_long digits = String.length digits > 25 || String.exists (fun c -> c = 'e' || c = 'E') digits

let number (ctx : Context.t) ~negative ~at (n : Resolve.Ir.number) =
  let magnitude =
    match Exact.of_literal n.digits with
    | Some value -> value
    | None ->
        tell_out_of_range ctx ~at n;
        Exact.one
  in
  let is_zero = Exact.equal magnitude Exact.zero in
  let signed = if negative then Exact.negate magnitude else magnitude in
  let { Environment.measure; scale } =
    match n.unit_ with
    | Some written -> Annotation.unit_ ctx.reader ctx.scope written
    | None when is_zero ->
        { measure = Type.fresh_unit ctx.reader.supply ~depth:ctx.depth; scale = Exact.one }
    | None -> { measure = Units.one; scale = Exact.one }
  in
  let scaled = not (Exact.equal scale Exact.one) in
  let representation =
    if n.decimal || scaled then Type.Float
    else Type.fresh_representation ctx.reader.supply ~depth:ctx.depth
  in
  let value = if scaled then Exact.multiply signed scale else signed in
  if not (n.decimal || scaled || fits signed) then too_large ctx ~at n representation;
  if is_long n.digits && Float.abs (Real.of_exact ctx.real value) = infinity then
    tell_out_of_range ctx ~at n;
  (Type.Number (representation, measure), value)
