open Basis
open Declared_class

(* {1 Classes} *)

let check_method (ctx : Context.t) (written : Resolve.Ir.method_) (variable : Ir.variable)
    (scheme : Type.scheme) =
  if not (Type.mentions variable scheme.body) then
    Context.tell_of_declaration ctx (Method_without_variable { method_ = written; variable });
  let check (c : Resolve.Ir.constraint_) (_, argument) =
    match Type.expand argument with
    | Rigid r when r.variable.id = variable.id ->
        Context.tell_of_declaration ctx (Constrained_variable { constraint_ = c; variable })
    | _ -> ()
  in
  List.iter2 check written.scheme.context scheme.context

let method_ (ctx : Context.t) class_ (variable : Type.rigid) (written : Resolve.Ir.method_) =
  let scheme, inner = Context.with_signature ctx ~name:written.name.name written.scheme in
  check_method ctx written variable.variable scheme;
  let scheme =
    {
      scheme with
      types = variable :: scheme.types;
      context = (Ir.Declared class_, Type.Rigid variable) :: scheme.context;
    }
  in
  let signature = written.scheme.span in
  Resolve.Global_table.replace ctx.globals written.name
    { scheme; kind = Method class_; at = Some signature };
  { name = written.name; scheme; inner; signature; default = written.default }

let class_ (ctx : Context.t) (written : Resolve.Ir.class_) =
  let environment = ctx.reader.environment in
  let superclasses = List.map (fun (g, span) -> (Annotation.class_ g, span)) written.superclasses in
  let all =
    List.concat_map (fun (c, _) -> c :: Environment.superclasses environment c) superclasses
  in
  Environment.add_class environment written.class_
    { superclasses = List.sort_uniq compare all; place = written.span };
  let variable : Type.rigid =
    {
      variable = { id = Type.next ctx.reader.supply; name = written.variable.name };
      kind = Of_types;
      depth = ctx.depth + 1;
    }
  in
  Hashtbl.replace ctx.owners variable.variable.id
    { by = Class written.class_.name; place = written.span };
  let inside = { ctx with scope = Annotation.with_type written.variable.name variable ctx.scope } in
  {
    class_ = written.class_;
    variable;
    superclasses;
    methods = List.map (method_ inside written.class_ variable) written.methods;
  }

let classes ctx (program : Resolve.Ir.program) = List.map (class_ ctx) program.classes

(* {1 Instances} *)

(* Enters an instance of the class. Its head becomes a scheme, with the variables in the order in
   which they occur in the head. *)
let of_class (ctx : Context.t) of_class (written : Resolve.Ir.instance) =
  let as_scheme : Resolve.Ir.scheme =
    { context = written.context; ty = written.head; span = written.span }
  in
  let by = Surroundings.Instance written.class_.name in
  let scheme, inner = Context.with_variables ctx ~by as_scheme in
  let head = scheme.body in
  match (Head.of_type head, Head.parameters head) with
  | Some (constructor, _), Some types -> (
      let environment = ctx.reader.environment in
      let position t =
        let rec find k : Type.rigid list -> int option = function
          | [] -> None
          | r :: _ when Type.mentions r.variable t -> Some k
          | _ :: rest -> find (k + 1) rest
        in
        find 0 types
      in
      let context =
        List.filter_map
          (fun (class_, t) -> Option.map (fun k -> (class_, k)) (position t))
          scheme.context
      in
      match Environment.instance environment of_class.class_ constructor with
      | Some first ->
          Context.tell_of_declaration ctx
            (Second_instance { instance = written; head; first = first.place });
          None
      | None ->
          Environment.add_instance environment of_class.class_ constructor
            { context; place = written.span };
          let is_missing (m : method_) =
            Option.is_none m.default && not (List.mem_assoc m.name written.definitions)
          in
          (match List.filter is_missing of_class.methods with
          | [] -> ()
          | missing ->
              let missing = List.map (fun (m : method_) -> (m.name, m.signature)) missing in
              Context.tell_of_declaration ctx
                (Missing_methods { instance = written; head; missing }));
          Some
            {
              of_class;
              head;
              scheme = { scheme with types };
              inner;
              definitions = written.definitions;
              place = written.span;
            })
  | None, _ | _, None ->
      (match Type.expand head with
      | Erroneous -> ()
      | _ -> Context.tell_of_declaration ctx (Instance_head { instance = written; head }));
      None

let instances ctx classes (program : Resolve.Ir.program) =
  let by_name = Hashtbl.create 16 in
  List.iter (fun c -> Hashtbl.replace by_name c.class_ c) classes;
  let instance (written : Resolve.Ir.instance) =
    match Hashtbl.find_opt by_name written.class_ with
    | Some found -> of_class ctx found written
    | None ->
        Context.tell_of_declaration ctx (Built_in_class written);
        None
  in
  List.filter_map instance program.instances

let method_of instance (m : method_) : Type.scheme =
  let substitute =
    Type.substitute ~types:[ (instance.of_class.variable, instance.head) ] ~units:[]
  in
  match (m.scheme.types, m.scheme.context) with
  | _ :: types, _ :: context ->
      {
        types = instance.scheme.types @ types;
        representations = m.scheme.representations;
        units = instance.scheme.units @ m.scheme.units;
        context = instance.scheme.context @ List.map (fun (c, t) -> (c, substitute t)) context;
        body = substitute m.scheme.body;
      }
  | _, _ ->
      Diagnostic.bug ~stage:"Typing.Class_declarations"
        "the scheme of a method does not begin with its class"
