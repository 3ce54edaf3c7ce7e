type t = { prototype : string; definition : string }

let of_program (v : Program_names.t) =
  let root = v.nodes.(Array.length v.nodes - 1) in
  let name = Name.fresh v.file_scope (v.name ^ "_steps") in
  let real = match v.program.real with Double -> "double" | Single -> "float" in
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
        "const int64_t *dt_ns";
        Printf.sprintf "const %s *dt" real;
        Printf.sprintf "const struct %s *in" v.input.struct_name;
        Printf.sprintf "struct %s *out" v.output.struct_name;
      ]
  in
  let signature = head ^ String.concat (",\n" ^ indent) parameters ^ ")" in
  {
    prototype =
      Printf.sprintf
        "/* Runs count steps. Each takes its times and its input from these arrays, as %s does,\n\
        \ * and writes its output to out. */\n\
         %s;\n"
        root.step signature;
    definition =
      Printf.sprintf
        "%s\n\
         {\n\
        \    for (int32_t i = 0; i < count; i++) {\n\
        \        %s(self, %sdt_ns[i], dt[i], &in[i], &out[i]);\n\
        \    }\n\
         }\n"
        signature root.step passed;
  }
