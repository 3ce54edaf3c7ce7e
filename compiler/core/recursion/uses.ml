open Basis
open Ir
module Global_table = Resolve.Global_table

type target =
  | Definition of Global.t * ty list
  | Method of { class_ : Global.t; name : string; ty : ty; types : ty list }

type use = { target : target; span : Span.t; later : bool }
type t = { definitions : definition array; index : int Global_table.t; uses : use list array }

let is_continuation = function
  | Function (_, (Signal_function _ | Data ({ module_ = "Prelude"; name = "Task" }, _))) -> true
  | _ -> false

let rec add ~later found (e : expr) =
  match e.desc with
  | Global (g, types) -> { target = Definition (g, types); span = e.span; later } :: found
  | Method { class_; name; ty; types } ->
      { target = Method { class_; name; ty; types }; span = e.span; later } :: found
  | Apply (f, argument) ->
      add ~later:(later || is_continuation argument.ty) (add ~later found f) argument
  | _ -> List.fold_left (add ~later) found (Term.parts e)

let of_program (program : program) =
  let definitions = Array.of_list program.definitions in
  let index = Global_table.create (Array.length definitions) in
  Array.iteri (fun i (d : definition) -> Global_table.replace index d.name i) definitions;
  let uses (d : definition) = List.rev (add ~later:false [] d.body) in
  { definitions; index; uses = Array.map uses definitions }

let cycle definitions ~use indices =
  let step a b =
    let d : definition = definitions.(a) in
    (d, Option.value (use a b) ~default:d.span)
  in
  match indices with [] -> [] | first :: rest -> List.map2 step indices (rest @ [ first ])
