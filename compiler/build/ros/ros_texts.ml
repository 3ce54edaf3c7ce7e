open Ros_declarations
module Ir = Typing.Ir

let enumeration c tycon =
  match data c tycon with
  | Some ({ constructors = _ :: _ as all; type_parameters = []; unit_parameters = []; _ } as data)
    when List.for_all (fun (k : Ir.constructor) -> k.fields = [] && not k.record) all ->
      Some data
  | Some _ | None -> None

let of_type c (ty : Ir.ty) =
  match ty with
  | Data { tycon; arguments = [ Data { tycon = inner; _ } ]; _ } when tycon = in_prelude "Maybe" ->
      enumeration c inner
  | Data { tycon; _ } -> enumeration c tycon
  | _ -> None

let is_enumeration c ty = Option.is_some (of_type c ty)

(* The string literal that the branches of a [case] return for a constructor. *)
let text_among branches (k : Ir.constructor) =
  let is_for (b : Ir.branch) =
    match b.pattern.desc with
    | Constructed (other, []) -> other.constructor = k.constructor
    | Any | Bound _ -> true
    | Constructed _ | As _ | Tuple_of _ | Array_of _ | Literal _ -> false
  in
  match List.find_opt is_for branches with
  | Some { value = { desc = String text; _ }; _ } -> Some text
  | Some _ | None -> None

let texts c (i : Ir.instance) (data : Ir.data) =
  match method_ c i with
  | Some (_, { desc = String text; _ }) -> Some (List.map (fun _ -> text) data.constructors)
  | Some ({ desc = Bound x; _ }, { desc = Case ({ desc = Local (y, _); _ }, branches); _ })
    when x = y ->
      let found = List.filter_map (text_among branches) data.constructors in
      if List.compare_lengths found data.constructors = 0 then Some found else None
  | Some _ | None -> None

let rec repeated = function
  | first :: others -> if List.mem first others then Some first else repeated others
  | [] -> None

let check c ~at ~in_ ty =
  let data = Option.get (of_type c ty) in
  let name = data.tycon.name in
  match instance c "RosText" data.tycon with
  | None ->
      refuse c ~at
        (Printf.sprintf "%s cannot be a string in messages: `%s` has no instance of `RosText`" in_
           name)
        (Printf.sprintf "write `instance RosText %s where`, with a string for each constructor" name)
  | Some i -> (
      match texts c i data with
      | None ->
          refuse c ~at:i.span
            (Printf.sprintf "the instance of `%s` does not list its strings" name)
            (Printf.sprintf
               "write `rosText x = case x of`, and below it a line for each constructor, as in `%s \
                -> \"%s\"`"
               (List.hd data.constructors).constructor.name
               (String.lowercase_ascii (List.hd data.constructors).constructor.name))
      | Some texts ->
          Option.iter
            (fun text ->
              refuse c ~at:i.span
                (Printf.sprintf "two constructors of `%s` have the string \"%s\"" name text)
                "give each constructor a different string")
            (repeated texts))

let all c =
  let of_instance (i : Ir.instance) =
    match i.head with
    | Data { tycon; _ } when i.class_ = in_ros "RosText" ->
        Option.bind (enumeration c tycon) (fun data ->
            Option.map
              (fun texts -> { Cgen.Node_table.module_ = tycon.module_; type_ = tycon.name; texts })
              (texts c i data))
    | _ -> None
  in
  List.filter_map of_instance c.typed.instances
