module V = Vocabulary

type t = { prototype : string; definition : string }

let of_program (v : V.t) =
  let root = v.nodes.(Array.length v.nodes - 1) in
  let name = Name.fresh v.file_scope (v.name ^ "_steps") in
  let dt_type, dt =
    match v.program.real with Double -> ("double", "dt") | Single -> ("int64_t", "dt_ns")
  in
  let head = Printf.sprintf "void %s(" name in
  let indent = String.make (String.length head) ' ' in
  let params, passed =
    match v.params with
    | None -> ([], "")
    | Some params ->
        ([ Printf.sprintf "const struct %s *params" (Param_struct.struct_name params) ], "params, ")
  in
  let parameters =
    (Printf.sprintf "struct %s *self" root.state :: params)
    @ [
        "int32_t count";
        Printf.sprintf "const %s *%s" dt_type dt;
        Printf.sprintf "const struct %s *in" v.input.struct_name;
        Printf.sprintf "struct %s *out" v.output.struct_name;
      ]
  in
  let signature = head ^ String.concat (",\n" ^ indent) parameters ^ ")" in
  {
    prototype =
      Printf.sprintf
        "/* Runs count steps, one after the other. Each step reads its %s and its input and\n\
        \ * writes its output; all three are arrays with count elements. */\n\
         %s;\n"
        dt signature;
    definition =
      Printf.sprintf
        "%s\n\
         {\n\
        \    for (int32_t i = 0; i < count; i++) {\n\
        \        %s(self, %s%s[i], &in[i], &out[i]);\n\
        \    }\n\
         }\n"
        signature root.step passed dt;
  }
