type t =
  | Bool
  | Int
  | Float of Basis.Real.t
  | Tuple of t list
  | Array of int * t
  | Text
  | Drawing
  | Image
  | Data of { is_event : bool; constructors : constructor list }
  | Console of (string * t * Value.t) list

and constructor = { name : string; fields : (string * t) list }

let bug format = Basis.Diagnostic.bug ~stage:"Interp.Shape" format

let is_record constructor =
  match constructor.fields with [] -> false | (name, _) :: _ -> not (String.equal name "")

let event : Core.Ir.Global.t = { module_ = "Prelude"; name = "Event" }

let of_type (program : Core.Ir.program) ty =
  let data = Hashtbl.create 64 in
  List.iter (fun (d : Core.Ir.data) -> Hashtbl.replace data d.tycon d) program.data;
  let images =
    List.filter_map
      (fun (t : Core.Ir.foreign_type) ->
        if String.equal t.c_type "struct frob_image" then Some t.foreign_type else None)
      program.foreign.types
  in
  let rec shape (ty : Core.Ir.ty) =
    match ty with
    | Bool -> Bool
    | Int -> Int
    | Float -> Float program.real
    | Tuple parts -> Tuple (List.map shape parts)
    | Variable v -> bug "the type variable `%s` was not replaced" v.name
    | Data _ when ty = Core.Signature.text -> Text
    | Data _ when ty = Core.Signature.drawing -> Drawing
    | Data (tycon, []) when List.mem tycon images -> Image
    | Data (tycon, arguments) -> (
        match Hashtbl.find_opt data tycon with
        | None -> bug "`%s` is not a data type" tycon.name
        | Some { constructors = [ { fields; _ } ]; _ } when Core.Console.is_console tycon ->
            Console (List.map2 control fields program.console)
        | Some d ->
            let close = Core.Erasure.substitute (List.combine d.parameters arguments) in
            let constructors = List.map (constructor close) d.constructors in
            Data { is_event = tycon = event; constructors })
    | Array (Size n, element) -> Array (n, shape element)
    | String | Function _ | Signal_function _ | Array _ | Size _ ->
        bug "functions and labels cannot be inputs or outputs"
  and control (label, ty) (c : Core.Ir.control) = (label, shape ty, Operator.control_at_rest c)
  and constructor close (c : Core.Ir.constructor) =
    { name = c.name.name; fields = List.map (fun (name, ty) -> (name, shape (close ty))) c.fields }
  in
  shape ty

(* The parts that have columns of their own, each with the suffix to append to the path. *)
let parts = function
  | Tuple parts -> Some (List.mapi (fun i part -> ("." ^ string_of_int (i + 1), part)) parts)
  | Array (n, element) -> Some (List.init n (fun i -> (Printf.sprintf "[%d]" i, element)))
  | Data { constructors = [ record ]; _ } when is_record record ->
      Some (List.map (fun (name, part) -> ("." ^ name, part)) record.fields)
  | Console controls -> Some (List.map (fun (label, part, _) -> ("." ^ label, part)) controls)
  | Drawing -> Some []
  | Bool | Int | Float _ | Text | Image | Data _ -> None

type column = { name : string; shape : t; at_rest : Value.t option }

let columns root shape =
  let rec add found path shape =
    match (shape, parts shape) with
    | Console controls, _ ->
        let column (label, shape, at_rest) =
          { name = path ^ "." ^ label; shape; at_rest = Some at_rest }
        in
        List.rev_append (List.map column controls) found
    | _, None -> { name = path; shape; at_rest = None } :: found
    | _, Some parts ->
        List.fold_left (fun found (name, part) -> add found (path ^ name) part) found parts
  in
  List.rev (add [] root shape)

let cells shape value =
  let rec add found shape (value : Value.t) =
    match (parts shape, value) with
    | None, _ -> value :: found
    | Some _, Drawing _ -> found
    | Some parts, (Tuple values | Array values | Data { arguments = values; _ }) ->
        List.fold_left2
          (fun found (_, part) value -> add found part (Thunk.demand value))
          found parts (Array.to_list values)
    | ( Some _,
        ( Bool _ | Int _ | Float _ | Text _ | Image _ | Function _ | Signal_function _ | Task _
        | Ending _ ) ) ->
        bug "a value that does not match its type"
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
        | Data _ | Console _ -> (Data { constructor = 0; arguments = values }, rest)
        | Array _ -> (Array values, rest)
        | Drawing -> (Drawing [], rest)
        | Bool | Int | Float _ | Text | Image | Tuple _ -> (Tuple values, rest))
  in
  fst (take shape cells)

let rec drawings shape (value : Value.t) : Value.thunk list list =
  match (shape, value) with
  | Drawing, Drawing marks -> [ List.rev marks ]
  | _, (Tuple values | Array values | Data { arguments = values; _ }) -> (
      match parts shape with
      | Some parts ->
          let inside (_, part) value = drawings part (Thunk.demand value) in
          List.concat (List.map2 inside parts (Array.to_list values))
      | None -> [])
  | _, _ -> []

let rec count_drawings = function
  | Drawing -> 1
  | shape ->
      List.fold_left
        (fun count (_, part) -> count + count_drawings part)
        0
        (Option.value (parts shape) ~default:[])
