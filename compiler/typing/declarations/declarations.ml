open Basis

(* {1 Units} *)

(* Accepts a scale only if its square fits in a double. *)
let usable scale =
  let magnitude = abs_float (Exact.to_float scale) in
  magnitude > 1e-150 && magnitude < 1e150

let scale (written : Syntax.Ir.scale) =
  match (Exact.of_literal written.factor, Exact.of_literal written.divided_by) with
  | Some factor, Some divisor when not (Exact.equal divisor Exact.zero) ->
      let quotient = Exact.divide factor divisor in
      Some (if written.times_pi then Exact.multiply quotient Exact.pi else quotient)
  | _ -> None

let unit_ (reader : Annotation.t) (declared : Resolve.Ir.unit_declaration) =
  let entry : Environment.unit_ =
    match declared.definition with
    | Base -> { measure = Units.base declared.unit_name; scale = Exact.one }
    | Scaled (written, unit_) -> (
        let of_unit = Annotation.unit_ reader Annotation.empty unit_ in
        let total = Option.map (Exact.multiply of_unit.scale) (scale written) in
        match total with
        | Some total when usable total -> { of_unit with scale = total }
        | Some _ | None ->
            Annotation.report_declaration reader (Scale_out_of_range declared);
            { of_unit with scale = Exact.one })
  in
  Environment.add_unit reader.environment declared.unit_name entry

(* {1 Types} *)

(* Nested aliases can expand a short declaration to a very large type. *)
let field_type (reader : Annotation.t) (f : Resolve.Ir.field) t =
  match Final.ty t with
  | ty -> ty
  | exception Final.Too_large ->
      Facts.report reader.facts (Too_large { at = f.ty.span; construct = Field });
      Tuple []

let constructor (reader : Annotation.t) tycon (parameters : Environment.parameters) scope result
    (written : Resolve.Ir.constructor) : Environment.constructor =
  let fields =
    List.map
      (fun (f : Resolve.Ir.field) -> (f.field_name, Annotation.ty reader scope f.ty))
      written.fields
  in
  let ir : Ir.constructor =
    {
      constructor = written.constructor;
      index = written.index;
      record = written.record;
      fields =
        List.map2
          (fun (f : Resolve.Ir.field) (name, t) -> (name, field_type reader f t))
          written.fields fields;
    }
  in
  let scheme : Type.scheme =
    {
      types = parameters.types;
      representations = [];
      units = parameters.units;
      context = [];
      body = List.fold_right (fun (_, t) rest -> Type.Function (t, rest)) fields result;
    }
  in
  Environment.make_constructor ir ~tycon scheme

(* Maximum number of steps for one declaration: enough for any type within the limits of
   {!Final}. *)
let most_steps = 200_000

let expansion (reader : Annotation.t) (declared : Resolve.Ir.type_declaration) scope body =
  match Work.within most_steps (fun () -> Annotation.any reader scope body) with
  | Some found -> found
  | None ->
      Facts.report reader.facts
        (Too_large { at = declared.span; construct = Declaration declared.tycon.name });
      Erroneous

let type_ (reader : Annotation.t) (declared : Resolve.Ir.type_declaration) =
  let variable (p : Resolve.Ir.parameter) : Ir.variable =
    { id = Type.next reader.supply; name = p.name }
  in
  let units =
    List.map
      (fun p -> (p, ({ variable = variable p; depth = 0 } : Units.rigid)))
      declared.unit_parameters
  in
  let kind =
    Annotation.parameter_kinds reader
      (match declared.definition with
      | Alias body -> [ body ]
      | Data constructors ->
          List.concat_map
            (fun (c : Resolve.Ir.constructor) ->
              List.map (fun (f : Resolve.Ir.field) -> f.ty) c.fields)
            constructors
      | Builtin | Foreign _ -> [])
  in
  let types =
    List.map
      (fun (p : Resolve.Ir.parameter) ->
        (p, ({ variable = variable p; kind = kind p.name; depth = 0 } : Type.rigid)))
      declared.type_parameters
  in
  let scope = Annotation.of_parameters units types in
  let parameters : Environment.parameters =
    { units = List.map snd units; types = List.map snd types }
  in
  let add definition =
    Environment.add_type reader.environment declared.tycon { parameters; definition }
  in
  let data constructors : Ir.data =
    {
      tycon = declared.tycon;
      unit_parameters = List.map (fun (r : Units.rigid) -> r.variable) parameters.units;
      type_parameters = List.map (fun (r : Type.rigid) -> r.variable) parameters.types;
      constructors;
      span = declared.span;
    }
  in
  match declared.definition with
  | Alias body ->
      add (Alias (expansion reader declared scope body));
      None
  | Foreign _ ->
      add Foreign;
      Some (data [])
  | Builtin ->
      add Builtin;
      let opaque = [ Environment.built_in "Program"; Environment.task; Environment.array ] in
      if List.mem declared.tycon opaque then Some (data []) else None
  | Data constructors ->
      let result : Type.t =
        Data
          {
            tycon = declared.tycon;
            units = List.map Units.of_rigid parameters.units;
            arguments = List.map (fun r -> Type.Rigid r) parameters.types;
          }
      in
      let constructors =
        List.map (constructor reader declared.tycon parameters scope result) constructors
      in
      List.iter (Environment.add_constructor reader.environment) constructors;
      let data = data (List.map (fun (c : Environment.constructor) -> c.ir) constructors) in
      add (Data data);
      Some data

let truth reader index name =
  Environment.add_constructor reader.Annotation.environment
    (Environment.make_constructor
       { constructor = Environment.built_in name; index; record = false; fields = [] }
       ~tycon:(Environment.built_in "Bool") (Type.monomorphic Bool))

let program reader (program : Resolve.Ir.program) =
  List.iter (unit_ reader) program.units;
  truth reader 0 "False";
  truth reader 1 "True";
  Annotation.together reader (fun () -> List.filter_map (type_ reader) program.types)
