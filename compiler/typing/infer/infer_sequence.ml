open Basis
open Context

(* The types in a [do], from the statement being checked onwards. *)
type sequence = {
  input : Type.t;
  output : Type.t;
  whole : Type.t; (* the type of the remaining statements, which does not depend on earlier ones *)
}

let task s result = Environment.task_of s.input s.output result

(* The place that determines the input and output types, which all tasks of the [do] share: the
   enclosing code, otherwise the first task. *)
let rec place ~first (reason : Expected.reason) =
  match reason with
  | Signature { at; _ }
  | Annotation at
  | Parameter { at; _ }
  | Branch at
  | Uses { at; _ }
  | Field { at; _ }
  | Element at ->
      Some at
  | Last_statement reason -> place ~first reason
  | Statement (Some at) -> Some at
  | Unknown | Operand _ | Condition | Value _ | Pattern _ | Output _ | Statement None -> first

(* Applies the primitive for [do] to a task and to a function that represents the remaining
   statements. *)
let join ctx s ~result ~at (first : Ir.expr) pattern (rest : Ir.expr) : Ir.expr =
  match Resolve.Global_table.find_opt ctx.globals Environment.sequence with
  | None -> Diagnostic.bug ~stage:"Typing.Infer" "no primitive for `do`"
  | Some _ ->
      let types = [ s.input; s.output; result ] in
      let continuation : Type.t = Type.shared (Function (result, s.whole)) in
      let applied : Type.t = Type.shared (Function (continuation, s.whole)) in
      let primitive : Type.t = Type.shared (Function (task s result, applied)) in
      let last =
        match (Final.ty s.whole : Ir.ty) with
        | Data { arguments = [ _; _; last ]; _ } -> last
        | _ -> Tuple []
      in
      let instantiation : Ir.instantiation =
        { types = List.map Final.ty types @ [ last ]; representations = [] }
      in
      let rest = node rest.span continuation (Lambda ([ pattern ], rest)) in
      let head = node at primitive (Primitive (Environment.sequence, instantiation)) in
      let head = node at applied (Apply (head, first)) in
      node at s.whole (Apply (head, rest))

let whatever ty (span : Span.t) : Ir.pattern later =
 fun () -> { desc = Any; ty = Final.ty ty; span = { span with stop = span.start } }

(* The start of the code after a statement. *)
let next (others : Resolve.Ir.statement list) (last : Resolve.Ir.expr) =
  match others with
  | [] -> Some last.span
  | Task { pattern = Some p; _ } :: _ -> Some p.span
  | Task { pattern = None; task } :: _ -> Some task.span
  | Values _ :: _ -> None

(* [first]: the place of the first task, if it has already been checked. *)
let rec from expressions ctx s (e : Resolve.Ir.expr) ~first (expected : Expected.t) statements last
    : Ir.expr later =
  match (statements : Resolve.Ir.statement list) with
  | [] ->
      let because : Expected.reason =
        match expected.because with
        | Unknown -> Statement (place ~first Unknown)
        | because -> Last_statement because
      in
      expressions.check ctx last { ty = s.whole; because; parts = expected.parts }
  | Values declarations :: others ->
      let bindings = Infer_binding.declarations expressions ctx declarations in
      let rest = from expressions ctx s e ~first expected others last in
      fun () ->
        let bindings = bindings () in
        node e.span s.whole (Let (bindings, rest ()))
  | Task { pattern; task = written } :: others ->
      let result = Context.fresh ctx in
      Early_return.warn_of_end ctx written ~next:(next others last);
      if pattern = None then Early_return.warn ctx written ~next:(next others last);
      let before = errors ctx in
      let value =
        expressions.check ctx written
          { ty = task s result; because = Statement (place ~first expected.because); parts = [] }
      in
      (* If the task has an error, the pattern is not checked against its type. *)
      let result = if errors ctx > before then Type.Erroneous else result in
      let pattern =
        match pattern with
        | None -> whatever result written.span
        | Some p ->
            Infer_pattern.check ctx p { ty = result; because = Value written.span; parts = [] }
      in
      let first = match first with None -> Some written.span | Some _ -> first in
      let rest = from expressions ctx s e ~first expected others last in
      fun () ->
        let value = value () in
        let pattern = pattern () in
        join ctx s ~result ~at:written.span value pattern (rest ())

let check expressions ctx (e : Resolve.Ir.expr) statements last (expected : Expected.t) =
  let input, output, whole =
    match Type.expand expected.ty with
    | Data { tycon; arguments = [ input; output; _ ]; _ } when tycon = Environment.task ->
        (input, output, expected.ty)
    | _ ->
        let input = Context.fresh ctx and output = Context.fresh ctx in
        let whole = Environment.task_of input output (Context.fresh ctx) in
        expect ctx ~subject:e ~at:e.span expected whole;
        (input, output, whole)
  in
  from expressions ctx { input; output; whole } e ~first:None expected statements last
