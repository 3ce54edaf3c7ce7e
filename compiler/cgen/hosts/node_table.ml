open Printf

type topic = { field : string; name : string; type_ : string; is_counted : bool; is_command : bool }
type texts = { module_ : string; type_ : string; texts : string list }
type enumeration = { constructors : string; module_ : string; type_ : string }
type t = { rate : float; inputs : topic list; outputs : topic list; texts : texts list }

let c_string = Basis.C_string.literal

let topics out name = function
  | [] -> "NULL, 0"
  | topics ->
      let row t =
        bprintf out "    {%s, %s, %s, %d, %d},\n" (c_string t.field) (c_string t.name)
          (c_string t.type_)
          (if t.is_counted then 1 else 0)
          (if t.is_command then 1 else 0)
      in
      bprintf out "static const struct frob_topic %s[] = {\n" name;
      List.iter row topics;
      bprintf out "};\n";
      sprintf "%s, %d" name (List.length topics)

(* Writes the strings for each enumeration that occurs in the tables of values. *)
let texts out enumerations (all : texts list) =
  let row k ((e : enumeration), (t : texts)) =
    let name = sprintf "texts_%d" (k + 1) in
    bprintf out "static const char *const %s[] = {%s};\n" name
      (String.concat ", " (List.map c_string t.texts));
    sprintf "    {%s, %s, %s},\n" e.constructors (c_string e.type_) name
  in
  let with_texts (e : enumeration) =
    let is_it (t : texts) = String.equal t.module_ e.module_ && String.equal t.type_ e.type_ in
    Option.map (fun t -> (e, t)) (List.find_opt is_it all)
  in
  match List.mapi row (List.filter_map with_texts enumerations) with
  | [] -> "NULL, 0"
  | rows ->
      bprintf out "static const struct frob_texts texts[] = {\n%s};\n" (String.concat "" rows);
      sprintf "texts, %d" (List.length rows)

let write out ~enumerations = function
  | None -> "NULL"
  | Some node ->
      let inputs = topics out "subscribed" node.inputs in
      let outputs = topics out "published" node.outputs in
      let texts = texts out enumerations node.texts in
      bprintf out "static const struct frob_node node = {%.17g, %s, %s, %s};\n" node.rate inputs
        outputs texts;
      "&node"
