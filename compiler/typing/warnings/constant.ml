open Ir

type value = Float of float | Int of int

type t = {
  definitions : expr Resolve.Global_table.t;
  found : value Resolve.Global_table.t;
  of_ints : value Resolve.Global_table.t; (* values of number-polymorphic definitions used as Int *)
  as_int : bool; (* the current definition is number-polymorphic and is evaluated as Int *)
  given : (int * value) list; (* values of parameters, by the id of the local *)
}

let is_int (e : expr) = match e.ty with Ir.Number (Int, _) -> true | _ -> false

let spine (e : expr) =
  let rec go (e : expr) arguments =
    match e.desc with Apply (f, a) -> go f (a :: arguments) | _ -> (e, arguments)
  in
  go e []

let operation (e : expr) =
  match spine e with
  | { desc = Primitive ({ module_ = "Prelude"; name }, _); _ }, arguments -> Some (name, arguments)
  | _ -> None

let wrapped n = Int32.to_int (Int32.of_int n)

let compute name arguments =
  match (name, arguments) with
  | "+", [ Float a; Float b ] -> Some (Float (a +. b))
  | "-", [ Float a; Float b ] -> Some (Float (a -. b))
  | "*", [ Float a; Float b ] -> Some (Float (a *. b))
  | "/", [ Float a; Float b ] -> Some (Float (a /. b))
  | "**", [ Float a; Float b ] -> Some (Float (a ** b))
  | "sqrt", [ Float a ] -> Some (Float (sqrt a))
  | "exp", [ Float a ] -> Some (Float (exp a))
  | "log", [ Float a ] -> Some (Float (log a))
  | "sin", [ Float a ] -> Some (Float (sin a))
  | "cos", [ Float a ] -> Some (Float (cos a))
  | "asin", [ Float a ] -> Some (Float (asin a))
  | "acos", [ Float a ] -> Some (Float (acos a))
  | "abs", [ Float a ] -> Some (Float (Float.abs a))
  | "negate", [ Float a ] -> Some (Float (-.a))
  | "+", [ Int a; Int b ] -> Some (Int (wrapped a + wrapped b))
  | "-", [ Int a; Int b ] -> Some (Int (wrapped a - wrapped b))
  | "*", [ Int a; Int b ] -> Some (Int (wrapped a * wrapped b))
  | "negate", [ Int a ] -> Some (Int (-wrapped a))
  | "abs", [ Int a ] -> Some (Int (abs (wrapped a)))
  | "toFloat", [ Int a ] -> Some (Float (float_of_int (wrapped a)))
  | _ -> None

let rec all_known = function
  | [] -> Some []
  | Some x :: rest -> Option.map (fun xs -> x :: xs) (all_known rest)
  | None :: _ -> None

(* [depth]: the maximum depth of the evaluation. Deeper expressions count as unknown, so that long
   sums are not evaluated again for each of their parts. *)
let rec at depth t (e : expr) =
  let value e = if depth = 0 then None else at (depth - 1) t e in
  match e.desc with
  | Number exact -> literal t e.ty exact
  | Negate a -> Option.bind (value a) (fun a -> compute "negate" [ a ])
  | Power (a, n) -> (
      match value a with Some (Float a) -> Some (Float (a ** float_of_int n)) | _ -> None)
  | Global (g, _) -> (
      match Resolve.Global_table.find_opt t.found g with
      | Some found -> Some found
      | None when is_int e || t.as_int -> Resolve.Global_table.find_opt t.of_ints g
      | None -> None)
  | Local (x, _) -> List.assoc_opt x.id t.given
  | Field (record, constructor, index) -> Option.bind (field t record constructor index) value
  | Apply _ -> (
      Option.bind (operation e) (fun (name, arguments) ->
          Option.bind (all_known (List.map value arguments)) (compute name))
      |> function
      | None when is_int e -> call depth t e
      | found -> found)
  | _ -> None

(* Evaluates a call of one of the program's functions with constant arguments. *)
and call depth t (e : expr) =
  match spine e with
  | { desc = Global (g, _); _ }, arguments -> (
      match Resolve.Global_table.find_opt t.definitions g with
      | Some { desc = Lambda (parameters, body); _ }
        when List.compare_lengths parameters arguments = 0 ->
          let parameter (p : pattern) = match p.desc with Bound x -> Some x.id | _ -> None in
          let ids = List.filter_map parameter parameters in
          if List.compare_lengths ids parameters <> 0 then None
          else
            Option.bind
              (all_known (List.map (at (depth - 1) t) arguments))
              (fun values ->
                (* this limits the cost of nested calls *)
                at
                  (min (depth - 1) 8)
                  { t with as_int = true; given = List.combine ids values }
                  body)
      | _ -> None)
  | _ -> None

and literal t ty exact =
  match ty with
  | Ir.Number (Representation_variable _, _) when t.as_int ->
      Option.map (fun n -> Int (Int32.to_int n)) (Basis.Exact.to_int32 exact)
  | Ir.Number (Float, _) -> Some (Float (Basis.Exact.to_float exact))
  | Number (Int, _) -> Option.map (fun n -> Int (Int32.to_int n)) (Basis.Exact.to_int32 exact)
  | _ -> None

(* A field of a record, if that record is the whole value of a definition. *)
and field t (record : expr) constructor index =
  match record.desc with
  | Global (g, _) -> (
      match Resolve.Global_table.find_opt t.definitions g with
      | Some { desc = Record (built, fields); _ } when built = constructor ->
          List.assoc_opt index fields
      | _ -> None)
  | _ -> None

let value = at 32

let of_program (p : program) =
  let table () = Resolve.Global_table.create 64 in
  let t =
    { definitions = table (); found = table (); of_ints = table (); as_int = false; given = [] }
  in
  let params = table () in
  List.iter (fun (p : param) -> Resolve.Global_table.replace params p.param ()) p.params;
  (* Adds definitions in dependency order, so that the values of the definitions they use are known.
     *)
  let add (d : definition) =
    if not (Resolve.Global_table.mem params d.name) then (
      Resolve.Global_table.replace t.definitions d.name d.value;
      match value t d.value with
      | Some found -> Resolve.Global_table.replace t.found d.name found
      | None when d.scheme.representations <> [] ->
          value { t with as_int = true } d.value
          |> Option.iter (Resolve.Global_table.replace t.of_ints d.name)
      | None -> ())
  in
  List.iter add p.definitions;
  t

let is_of_any_numbers t (e : expr) =
  match e.desc with Global (g, _) -> Resolve.Global_table.mem t.of_ints g | _ -> false

let float t e = match value t e with Some (Float x) -> Some x | Some (Int _) | None -> None
