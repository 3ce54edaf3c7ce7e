open Basis
open Ir
module Global_table = Resolve.Global_table

type constants = {
  locals : expr Int_table.t;
  globals : expr Global_table.t;
  params : unit Global_table.t;
}

let create params =
  let table = Global_table.create 8 in
  List.iter (fun (p : param) -> Global_table.replace table p.param ()) params;
  { locals = Int_table.create 16; globals = Global_table.create 64; params = table }

let local c (x : Local.t) e = Int_table.replace c.locals x.id e

let global c name e =
  if not (Global_table.mem c.params name) then Global_table.replace c.globals name e

exception Problem of Level_fact.problem

let fail problem = raise_notrace (Problem problem)

let operation = function
  | "+" -> Some Int32.add
  | "-" -> Some Int32.sub
  | "*" -> Some Int32.mul
  | "div" -> Some Division.div
  | "mod" -> Some Division.mod_
  | "min" -> Some min
  | "max" -> Some max
  | _ -> None

(* Bounds the recursion. Cyclic definitions are reported elsewhere. *)
let longest_chain = 1_000

let value c e =
  let rec int depth (e : expr) =
    if depth > longest_chain then fail (Computed e.span);
    let int = int (depth + 1) in
    match e.desc with
    | Number n -> ( match Exact.to_int32 n with Some n -> n | None -> fail (Computed e.span))
    | Negate a -> Int32.neg (int a)
    | Apply ({ desc = Apply ({ desc = Primitive (g, _); _ }, a); _ }, b) -> (
        match operation g.name with
        | Some operation ->
            let a = int a in
            operation a (int b)
        | None -> fail (Computed e.span))
    | Local (x, _) -> (
        match Int_table.find_opt c.locals x.id with
        | Some value -> named x e (fun () -> int value)
        | None -> fail (Variable (x, e.span)))
    | Global (g, _) when Global_table.mem c.params g -> fail (Param (g, e.span))
    | Global (g, _) -> (
        match Global_table.find_opt c.globals g with
        | Some value -> (
            try int value with
            | Problem (Param (p, _)) -> fail (Param (p, e.span))
            | Problem (Variable _ | Computed _) -> fail (Computed e.span))
        | None -> fail (Computed e.span))
    | Primitive _ | Method _ | Constructor _ | String _ | Tuple _ | Array _ | Index _ | Apply _
    | Run _ | Power _ | If _ | Case _ | Let _ | Lambda _ | Guards _ | Proc _ | Record _ | Update _
    | Field _ ->
        fail (Computed e.span)
  (* Reports the problem at the place where the index mentions the name. *)
  and named x e evaluate =
    try evaluate () with
    | Problem (Param (p, _)) -> fail (Param (p, e.span))
    | Problem (Variable _ | Computed _) -> fail (Variable (x, e.span))
  in
  match int 0 e with n -> Ok n | exception Problem problem -> Error problem
