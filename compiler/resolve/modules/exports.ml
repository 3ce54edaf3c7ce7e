open Basis
open Interface

let texts names =
  List.fold_left
    (fun set (name : Syntax.Ir.name) -> String_set.add name.text set)
    String_set.empty names

let of_module (scope : Scope.t) (header : Syntax.Ir.header option) =
  let visible = scope.visible in
  match header with
  | None | Some { exports = None; _ } -> visible.own
  | Some { exports = Some listed; _ } ->
      let wanted = texts listed in
      let add names (import : Visible.import) =
        if import.unqualified then union names (select import.names wanted) else names
      in
      let exported = List.fold_left add (select visible.own wanted) visible.imports in
      let check (name : Syntax.Ir.name) =
        String_table.replace scope.used name.text ();
        if scope.complete && not (mem exported name.text) then
          Context.report_unresolved scope.context
            (Not_exported { name; module_ = visible.module_; known = lazy (all visible.own) })
      in
      List.iter check listed;
      exported

let imported context (declaration : Syntax.Ir.import option) ~module_ names : Visible.import =
  match declaration with
  | None -> { module_; qualifiers = [ module_ ]; unqualified = true; names }
  | Some import ->
      let names =
        match import.items with
        | None -> names
        | Some items ->
            let check (name : Syntax.Ir.name) =
              if not (mem names name.text) then
                Context.report_unresolved context
                  (Not_in_import { name; module_; known = lazy (all names) })
            in
            List.iter check items;
            select names (texts items)
      in
      let alias = Option.map (fun (alias : Syntax.Ir.name) -> alias.text) import.alias in
      {
        module_;
        qualifiers = Option.value (Option.map (fun a -> [ a ]) alias) ~default:[ module_ ];
        unqualified = not import.qualified;
        names;
      }

let idle (scope : Scope.t) (declaration : Syntax.Ir.import option) ~module_ names =
  let idle_import listed at whole : Ir.idle = { of_module = module_; listed; at; whole } in
  (* The span of the import, including the line break after it. *)
  let lines (import : Syntax.Ir.import) =
    let next = Span.position ~line:(Span.line import.span.stop + 1) ~column:1 in
    { import.span with stop = next }
  in
  let is_used names = List.exists (String_table.mem scope.used) (all names) in
  match declaration with
  | None -> []
  | Some ({ items = Some (_ :: _ as items); _ } as import) ->
      let is_idle item = not (is_used (select names (texts [ item ]))) in
      let items = Long_list.map (fun item -> (item, is_idle item)) items in
      let all_idle = List.for_all snd items in
      let rec with_comma found before = function
        | ((item : Syntax.Ir.name), true) :: rest ->
            let whole : Span.t =
              match (before, rest) with
              | _ when all_idle -> lines import
              | Some (previous : Syntax.Ir.name), _ -> { item.span with start = previous.span.stop }
              | None, ((next : Syntax.Ir.name), _) :: _ -> { item.span with stop = next.span.start }
              | None, [] -> item.span
            in
            with_comma (idle_import (Some item.text) item.span whole :: found) (Some item) rest
        | (item, false) :: rest -> with_comma found (Some item) rest
        | [] -> List.rev found
      in
      with_comma [] None items
  | Some import -> if is_used names then [] else [ idle_import None import.span (lines import) ]
