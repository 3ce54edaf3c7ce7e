open Basis
open Argument
open Context

(* Is an argument at this place the whole of the mistake? *)
let is_at (span : Span.t) (fact : Fact.t) =
  match fact with
  | Inference { fact = Mismatch { at; _ } | Exchanged_pair { at; _ }; _ } ->
      Span.compare at span = 0
  | Inference { fact = Not_a_function { argument; _ }; _ } -> Span.compare argument.span span = 0
  | _ -> false

(* The orders of the arguments in which their types fit, and the number of missing arguments, for
   {!Application_fact.call}. *)
let orders ctx ~(head : Resolve.Ir.expr) arguments ~types ~failed =
  let entry =
    match head.desc with Global name -> Resolve.Global_table.find_opt ctx.globals name | _ -> None
  in
  match entry with
  | None -> (None, None, None)
  | Some { scheme; _ } ->
      let instance = Type.instantiate ctx.reader.supply ~depth:ctx.depth scheme in
      (* an input never has type `String`: if one does, this application has just inferred it *)
      let is_input (e : Resolve.Ir.expr) =
        match e.desc with Local x -> List.mem_assoc x.name ctx.inputs | _ -> false
      in
      let is_other (a : Argument.t) = a.position <> failed in
      let given =
        List.map2
          (fun a ty ->
            if is_other a && Type.expand ty = String && is_input a.value then Type.Erroneous else ty)
          arguments types
      in
      let parameters = Argument_order.parameters instance.ty in
      let unfit ~wanted given =
        let lacks (class_, argument) =
          Type.expand argument == Type.expand wanted && has_no_instance ctx class_ given
        in
        List.exists lacks instance.required
      in
      (* an input of the proc is probably meant as the input of the signal function *)
      let runs_on_an_input =
        let rec is_run (t : Type.t) =
          match Type.expand t with
          | Function (_, t) -> is_run t
          | Signal_function _ -> true
          | _ -> false
        in
        is_run instance.ty && is_input (List.nth arguments (failed - 1)).value
      in
      let is_constrained ty =
        runs_on_an_input
        || List.exists
             (fun (_, argument) -> Type.expand argument == Type.expand ty)
             instance.required
      in
      ( Argument_order.exchanged ~unfit ~parameters ~given ~position:failed,
        Argument_order.rotated ~unfit ~parameters ~given,
        Argument_order.shifted ~unfit ~is_constrained ~parameters ~given ~position:failed )

(* The application, if it may explain the mistake better than the failing argument does. *)
let call expressions ctx (e : Resolve.Ir.expr) ~head arguments ~types ~takes ~failed result mistake
    : Application_fact.call option =
  let failing = (List.nth arguments (failed - 1)).value in
  let juxtaposed = List.for_all (fun a -> a.style = Juxtaposed) arguments in
  let is_whole = is_at failing.span mistake in
  let is_field =
    match mistake with
    | Inference { fact = Missing_field _ | Unknown_field _; _ } -> true
    | _ -> false
  in
  if not (juxtaposed && (is_whole || is_field || List.length arguments >= 3)) then None
  else
    let own, is_right_alone = trial ctx (fun () -> (expressions.infer ctx failing).ty) in
    let types = List.mapi (fun i ty -> if i + 1 = failed then own else ty) types in
    let exchanged, rotated, lacking =
      if is_whole then orders ctx ~head arguments ~types ~failed else (None, None, None)
    in
    Some
      {
        at = e.span;
        head;
        arguments = List.map2 (fun a ty -> (a.value, ty)) arguments types;
        failed;
        is_right_alone;
        takes;
        result;
        exchanged;
        rotated;
        lacking;
      }

(* Explains the only error among the arguments. *)
let explain expressions ctx e ~head arguments ~types ~takes ~failed ty held =
  match List.rev held with
  | [] -> ()
  | last :: others -> (
      let result =
        match Type.expand ty with
        | Function (_, output) | Signal_function (_, output) -> output
        | _ -> Type.Erroneous
      in
      match
        call expressions ctx e ~head arguments ~types ~takes ~failed result (Facts.fact last)
      with
      | Some call ->
          pass_on ctx (List.rev others);
          replace ctx (Misapplied { around = surroundings ctx; call; mistake = last })
      | None -> pass_on ctx held)

(* `xs.map f`, an array function that is called like a method. *)
let tell_method ctx (e : Resolve.Ir.expr) ~(head : Resolve.Ir.expr) arguments held =
  match (head.desc, List.rev held) with
  | Field { record; field; _ }, last :: others -> (
      match Facts.fact last with
      | Fact.Inference
          { fact = Missing_field { field = missing; _ } | Unknown_field { field = missing; _ }; _ }
        when missing == field ->
          pass_on ctx (List.rev others);
          let arguments = List.map (fun a -> a.value) arguments in
          let call : Application_fact.method_call = { at = e.span; record; field; arguments } in
          replace ctx (Called_as_method { around = surroundings ctx; call; mistake = last })
      | _ -> pass_on ctx held)
  | _ -> pass_on ctx held

(* `foldl (\x n -> n + x) 0 xs`, whose function takes its parameters in the order of another
   language. Checks whether the other order would be correct. *)
let other_fold expressions ctx ~(head : Resolve.Ir.expr) arguments : Inference_fact.t option =
  match (head.desc, arguments) with
  | ( Global
        {
          name = ("foldl" | "scanl" | "accumBy" | "accumHoldBy" | "dAccumHoldBy") as name;
          module_ = "Prelude";
        },
      ({ value = { desc = Lambda { parameters = [ a; b ]; body }; _ } as lambda; _ } as first)
      :: (_ :: _ as others) )
    when Span.compare a.span b.span < 0 ->
      let value = { lambda with desc = Resolve.Ir.Lambda { parameters = [ b; a ]; body } } in
      let apply head { value; style; span; _ } : Resolve.Ir.expr =
        { desc = Apply { head; argument = value; style }; span }
      in
      let other = List.fold_left apply head ({ first with value } :: others) in
      let _, is_right = trial ctx (fun () -> expressions.infer ctx other) in
      if is_right then Some (Parameters_in_other_order { head; name; first = a; second = b })
      else None
  | _ -> None

let is_mapped_range ~(head : Resolve.Ir.expr) arguments =
  match (head.desc, arguments) with
  | Global { name = "map"; module_ = "Prelude" }, [ _; _; _; _; _ ] -> true
  | _ -> false

type mistake = {
  failed : int;
  types : Type.t list;
  of_first : Fact.t Facts.held list;
  is_only : bool;
}

let tell expressions ctx (e : Resolve.Ir.expr) ~(head : Resolve.Ir.expr) arguments ~function_ ~takes
    { failed; types; of_first; is_only } held =
  let replace_by fact ~kept =
    pass_on ctx kept;
    replace ctx (Inference { around = surroundings ctx; fact })
  in
  if is_mapped_range ~head arguments then
    let arguments = List.map (fun a -> a.value) arguments in
    replace_by (Mapped_range { at = e.span; head = head.span; arguments }) ~kept:[]
  else
    match other_fold expressions ctx ~head arguments with
    | Some fact ->
        let is_kept h = not (List.memq h of_first) in
        replace_by fact ~kept:(List.filter is_kept held)
    | None when is_only ->
        explain expressions ctx e ~head arguments ~types ~takes ~failed function_ held
    | None -> pass_on ctx held
