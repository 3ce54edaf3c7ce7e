open Printf

type topic = { field : string; name : string; type_ : string; is_counted : bool; is_command : bool }
type t = { rate : float; inputs : topic list; outputs : topic list }

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

let write out = function
  | None -> "NULL"
  | Some { rate; inputs; outputs } ->
      let inputs = topics out "subscribed" inputs in
      let outputs = topics out "published" outputs in
      bprintf out "static const struct frob_node node = {%.17g, %s, %s};\n" rate inputs outputs;
      "&node"
