open Basis

(* The call before the cursor: the name of the function, and the number of complete arguments
   between that name and the cursor. *)
type call = { head : string; arguments : int }

let closes : Syntax.Grammar.token -> bool = function
  | RPAREN | RBRACKET | RBRACE -> true
  | _ -> false

let opens : Syntax.Grammar.token -> bool = function
  | LPAREN | LBRACKET | UNIT_BRACKET | LBRACE -> true
  | _ -> false

let is_atom : Syntax.Grammar.token -> bool = function
  | LOWER _ | UPPER _ | QUALIFIED_LOWER _ | QUALIFIED_UPPER _ | NUMBER _ | STRING _ | UNDERSCORE ->
      true
  | _ -> false

let name : Syntax.Grammar.token -> string option = function
  | LOWER name | UPPER name -> Some name
  | QUALIFIED_LOWER (_, name) | QUALIFIED_UPPER (_, name) -> Some name
  | _ -> None

let call (tokens : Tokens.token array) ~from ~offset =
  let rec last i = if i >= 0 && tokens.(i).stop > offset then last (i - 1) else i in
  (* Finds the bracket that matches a closing bracket. *)
  let rec partner depth i =
    if i < 0 || tokens.(i).start < from then -1
    else if closes tokens.(i).token then partner (depth + 1) (i - 1)
    else if opens tokens.(i).token then if depth = 1 then i else partner (depth - 1) (i - 1)
    else partner depth (i - 1)
  in
  let rec back i head arguments =
    if i < 0 || tokens.(i).start < from then head
    else
      let t = tokens.(i).token in
      if closes t then
        let open_ = partner 0 i in
        if open_ < 0 then head
        else
          (* A unit or a record update belongs to the preceding expression. *)
          match tokens.(open_).token with
          | UNIT_BRACKET | LBRACE -> back (open_ - 1) head arguments
          | _ -> back (open_ - 1) None (arguments + 1)
      else
        match t with
        | FIELD _ -> back (i - 1) head arguments
        | _ when is_atom t ->
            (* In [x.y], the field is part of the argument [x]. *)
            let head = Option.map (fun head -> { head; arguments }) (name t) in
            back (i - 1) head (arguments + 1)
        | _ -> head
  in
  let i = last (Array.length tokens - 1) in
  (* A word that the cursor touches is still being typed. *)
  let touches = i >= 0 && tokens.(i).stop = offset && is_atom tokens.(i).token in
  if touches then match back (i - 1) None 0 with Some call -> Some call | None -> None
  else back i None 0

let answer ws (doc : Document.t) params : Json.t =
  let text = Text.contents doc.text in
  let offset = Workspace.offset ws doc.text (Json.member "position" params) in
  let tokens = Tokens.of_text text in
  let from, _ = Tokens.item text offset in
  match (call tokens ~from ~offset, Document.names doc) with
  | Some { head; arguments }, Some { view; _ } -> (
      let entries = Catalogue.in_scope ws doc (Catalogue.imports tokens) in
      let is_it (e : Catalogue.entry) = e.space = Value && String.equal e.name head in
      let global (e : Catalogue.entry) : Resolve.Ir.Global.t =
        { module_ = e.module_; name = e.name }
      in
      match Option.map global (List.find_opt is_it entries) with
      | None -> Null
      | Some g -> (
          match Description.signature view g with
          | None -> Null
          | Some type_ ->
              let parameters = Description.parameters type_ in
              (* A function that returns a signal function takes the input signal as one more
                 argument. *)
              let count = List.length parameters - 1 in
              let result = List.nth parameters count in
              let is_run = String.starts_with ~prefix:"SF " result in
              if arguments > count || (arguments = count && not is_run) then Null
              else
                let label = Printf.sprintf "%s :: %s" head type_ in
                let documentation =
                  Option.fold (Description.doc view g) ~none:[] ~some:(fun text ->
                      [
                        ( "documentation",
                          Json.Object [ ("kind", String "markdown"); ("value", String text) ] );
                      ])
                in
                let parameter text : Json.t = Object [ ("label", String text) ] in
                Object
                  [
                    ( "signatures",
                      List
                        [
                          Object
                            ([
                               ("label", Json.String label);
                               ("parameters", List (List.map parameter parameters));
                             ]
                            @ documentation);
                        ] );
                    ("activeSignature", Int 0);
                    ("activeParameter", Int arguments);
                  ]))
  | _ -> Null
