type t =
  | Bool
  | Int
  | Float
  | Tuple of t list
  | Data of { is_event : bool; constructors : constructor list }

and constructor = { name : string; fields : (string * t) list }

let bug format = Basis.Diagnostic.bug ~stage:"Interp.Shape" format

let is_record constructor =
  match constructor.fields with [] -> false | (name, _) :: _ -> not (String.equal name "")

let event : Core.Ir.Global.t = { module_ = "Prelude"; name = "Event" }

let of_type (program : Core.Ir.program) ty =
  let data = Hashtbl.create 64 in
  List.iter (fun (d : Core.Ir.data) -> Hashtbl.replace data d.tycon d) program.data;
  (* [types]: what the parameters of the data type around stand for. *)
  let rec shape types (ty : Core.Ir.ty) =
    match ty with
    | Bool -> Bool
    | Int -> Int
    | Float -> Float
    | Tuple parts -> Tuple (List.map (shape types) parts)
    | Variable v -> (
        match List.find_opt (fun ((w : Core.Ir.variable), _) -> w.id = v.id) types with
        | Some (_, shape) -> shape
        | None -> bug "the type variable `%s`" v.name)
    | Data (tycon, arguments) -> (
        match Hashtbl.find_opt data tycon with
        | None -> bug "`%s` is no data type" tycon.name
        | Some d ->
            let types = List.combine d.parameters (List.map (shape types) arguments) in
            let constructors = List.map (constructor types) d.constructors in
            Data { is_event = tycon = event; constructors })
    | String | Function _ | Signal_function _ ->
        bug "functions and labels are not seen from outside"
  and constructor types (c : Core.Ir.constructor) =
    { name = c.name.name; fields = List.map (fun (name, ty) -> (name, shape types ty)) c.fields }
  in
  shape [] ty

(* The parts that have columns of their own, with their names in paths. *)
let parts = function
  | Tuple parts -> Some (List.mapi (fun i part -> (string_of_int (i + 1), part)) parts)
  | Data { constructors = [ record ]; _ } when is_record record -> Some record.fields
  | Bool | Int | Float | Data _ -> None

type column = { name : string; shape : t }

let columns root shape =
  let rec add found path shape =
    match parts shape with
    | None -> { name = path; shape } :: found
    | Some parts ->
        List.fold_left (fun found (name, part) -> add found (path ^ "." ^ name) part) found parts
  in
  List.rev (add [] root shape)

let cells shape value =
  let rec add found shape (value : Value.t) =
    match (parts shape, value) with
    | None, _ -> value :: found
    | Some parts, (Tuple values | Data { arguments = values; _ }) ->
        List.fold_left2
          (fun found (_, part) value -> add found part (Thunk.demand value))
          found parts (Array.to_list values)
    | Some _, (Bool _ | Int _ | Float _ | Text _ | Function _ | Signal_function _) ->
        bug "a value that is not of its type"
  in
  List.rev (add [] shape value)

let assemble shape cells =
  let rec take shape cells : Value.t * Value.t list =
    match (parts shape, cells) with
    | None, cell :: rest -> (cell, rest)
    | None, [] -> bug "fewer cells than columns"
    | Some parts, _ -> (
        let values, rest =
          List.fold_left
            (fun (values, cells) (_, part) ->
              let value, rest = take part cells in
              (Thunk.known value :: values, rest))
            ([], cells) parts
        in
        let values = Array.of_list (List.rev values) in
        match shape with
        | Data _ -> (Data { constructor = 0; arguments = values }, rest)
        | Bool | Int | Float | Tuple _ -> (Tuple values, rest))
  in
  fst (take shape cells)
