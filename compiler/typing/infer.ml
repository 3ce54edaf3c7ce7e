open Basis
open Context

type declared = { scheme : Type.scheme; inner : Context.t; at : Span.t }
(* by a top-level signature; [inner] is where the definition is checked *)

let top (b : Resolve.Ir.binding) =
  match b.name with
  | Top (name, at) -> (name, at)
  | Inner _ | Destructure _ ->
      Diagnostic.bug ~stage:"Typing.Infer" "a local binding at top level"

let primitive ctx (p : Resolve.Ir.primitive) =
  let scheme, _ = with_signature ctx ~name:p.name.name p.scheme in
  Hashtbl.replace ctx.globals p.name { scheme; primitive = true; recursive = false };
  (p.name, Final.scheme scheme)

(* All signatures first: what has one can be used before it is checked. *)
let signature ctx declared (b : Resolve.Ir.binding) =
  let name, _ = top b in
  match b.signature with
  | None -> ()
  | Some written ->
      let scheme, inner = with_signature ctx ~name:name.name written in
      Hashtbl.replace ctx.globals name { scheme; primitive = false; recursive = false };
      Hashtbl.replace declared name { scheme; inner; at = written.span }

let expectation ctx declared ~recursive (b : Resolve.Ir.binding) : Context.t * Mistake.expected =
  let name, at = top b in
  match Hashtbl.find_opt declared name with
  | Some { scheme; inner; at } ->
      Classes.give scheme;
      ( { inner with group = ctx.group },
        { ty = scheme.body; because = Signature { name = name.name; at } } )
  | None ->
      let ty = Context.fresh ctx in
      let scheme = Type.monomorphic ty in
      Hashtbl.replace ctx.globals name { scheme; primitive = false; recursive = true };
      let because = if recursive then Mistake.Uses { name = name.name; at } else Unknown in
      (ctx, { ty; because })

let check (b : Resolve.Ir.binding) (inner, expected) =
  let name, _ = top b in
  Infer_binding.abstraction inner ~at:b.span ~name:(Some name.name) b.parameters expected
    (fun expected -> Infer_binding.right Infer_expression.expressions inner b.body expected)

(* The schemes of those without a signature; what they share, all of them
   quantify. *)
let generalize ctx declared bindings expectations =
  let unsigned =
    List.filter
      (fun (b, _) -> not (Hashtbl.mem declared (fst (top b))))
      (List.combine bindings expectations)
  in
  let types = List.map (fun (_, (_, (e : Mistake.expected))) -> e.ty) unsigned in
  let quantified = Generalize.types ctx.reader.supply ~depth:ctx.depth types in
  let context = Classes.solve ctx quantified.types in
  List.iter2
    (fun (b, _) body ->
      let scheme : Type.scheme =
        {
          types = quantified.types;
          representations = quantified.representations;
          units = quantified.units;
          context;
          body;
        }
      in
      Hashtbl.replace ctx.globals (fst (top b)) { scheme; primitive = false; recursive = false })
    unsigned types

let group ctx declared (g : Resolve.Ir.binding_group) : Ir.definition list =
  let ctx = in_group ctx in
  let expectations = List.map (expectation ctx declared ~recursive:g.recursive) g.bindings in
  let values = List.map2 check g.bindings expectations in
  settle ctx;
  generalize ctx declared g.bindings expectations;
  let definition (b : Resolve.Ir.binding) value : Ir.definition =
    let name, _ = top b in
    let { Context.scheme; _ } = Hashtbl.find ctx.globals name in
    { name; scheme = Final.scheme scheme; value = value (); doc = b.doc; span = b.span }
  in
  List.map2 definition g.bindings values

let program sink (program : Resolve.Ir.program) : Ir.program =
  let reader : Written.t =
    { environment = Environment.create (); supply = Type.supply (); sink }
  in
  let data = Declarations.program reader program in
  let ctx = Context.start reader in
  let primitives = List.rev (List.rev_map (primitive ctx) program.primitives) in
  let declared = Hashtbl.create 1024 in
  List.iter
    (fun (g : Resolve.Ir.binding_group) -> List.iter (signature ctx declared) g.bindings)
    program.groups;
  let add reversed g = List.rev_append (group ctx declared g) reversed in
  let definitions = List.rev (List.fold_left add [] program.groups) in
  { main_module = program.main_module; data; primitives; definitions }
