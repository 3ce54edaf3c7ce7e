module M = Step.Ir
module V = Cgen.Vocabulary

let f = Printf.sprintf
let lines = String.concat ""

(* Statements that mix the value of type [ty] at the C expression [at] into the hash. *)
let rec value (v : Cgen.Program_names.t) ~depth at (ty : M.ty) =
  match ty with
  | Bool | Int | Nanoseconds -> f "    mix_int(hash, (int64_t)%s);\n" at
  | Float -> f "    mix_real(hash, (double)%s);\n" at
  | Foreign _ -> ""
  | Array (n, element) ->
      let i = f "i%d" depth in
      f "    for (int %s = 0; %s < %d; %s++) {\n%s    }\n" i i n i
        (value v ~depth:(depth + 1) (f "%s.at[%s]" at i) element)
  | Sum k -> sum v ~depth at k

(* Mixes in the tag and all slots: unused slots have defined values too. *)
and sum v ~depth at k =
  let t = v.sums.(k) in
  let members = Cgen.Sum_type.members v.program.sums t in
  let is_array (_, (ty : Cgen.Ir.ty)) = match ty with Struct _ -> true | _ -> false in
  let arrays, scalars = List.partition is_array members in
  let scalar (name, (ty : Cgen.Ir.ty)) : string =
    value v ~depth (f "%s.%s" at name) (match ty with Real _ -> Float | _ -> Int)
  in
  let types =
    List.concat_map (fun (ty, n) -> List.init n (fun _ -> Step.Layout.ty ty)) t.slots.arrays
  in
  f "    mix_int(hash, %s.tag);\n" at
  ^ lines (List.map scalar scalars)
  ^ lines (List.map2 (fun (name, _) ty -> value v ~depth (f "%s.%s" at name) ty) arrays types)

let place (v : Cgen.Program_names.t) k (field : M.field) =
  "s->" ^ String.concat "." (Basis.Int_table.find v.nodes.(k).paths field.id)

let rec field (v : Cgen.Program_names.t) k (field_ : M.field) =
  let at () = place v k field_ in
  match field_.content with
  | Value ty -> value v ~depth:0 (at ()) ty
  | State_of inner when V.home v inner = V.home v k -> f "    node_%d(hash, s);\n" inner
  | State_of inner -> f "    node_%d(hash, &%s);\n" inner (at ())
  | States_of { node; count } ->
      f "    for (int i = 0; i < %d; i++) {\n    node_%d(hash, &%s[i]);\n    }\n" count node (at ())
  | Running_mode -> f "    mix_int(hash, (int64_t)%s);\n" (at ())
  | Modes modes -> of_modes v k modes
  | Component _ -> ""

and of_modes v k modes =
  let all (mode : M.mode) =
    lines (List.map (field v k) (List.map snd mode.parameters @ Option.to_list mode.state))
  in
  let is_running (field : M.field) = field.content = Running_mode in
  match (modes, List.find_opt is_running v.program.nodes.(k).state) with
  | [ only ], None -> all only
  | modes, Some running ->
      let case number mode =
        f "    case %s:\n%s        break;\n" v.nodes.(k).modes.(number).constant (all mode)
      in
      f "    switch (%s) {\n%s    default:\n        mix_int(hash, -1);\n    }\n" (place v k running)
        (lines (List.mapi case modes))
  | _, None -> invalid_arg "State.of_modes: modes without a number"

let node (v : Cgen.Program_names.t) k (node : M.node) =
  if Option.is_some node.foreign || not (V.has_state v k) then ""
  else
    f
      "static void node_%d(uint64_t *hash, const struct %s *s)\n\
       {\n\
      \    (void)hash;\n\
      \    (void)s;\n\
       %s}\n\n"
      k (V.state_struct v k)
      (lines (List.map (field v k) node.state))

let text (program : M.program) =
  let v = V.of_program program in
  let root = Array.length program.nodes - 1 in
  f
    "#include \"%s.h\"\n\
     #include \"expected.h\"\n\n\
     %svoid hash_state(uint64_t *hash, const void *state)\n\
     {\n\
    \    %s\n\
     }\n"
    program.name
    (lines (Array.to_list (Array.mapi (node v) program.nodes)))
    (if V.has_state v root then
       f "node_%d(hash, (const struct %s *)state);" root v.nodes.(root).state
     else "(void)hash;\n    (void)state;")
