open Basis

(* {1 The compiler's tables} *)

(* Keywords used in declarations; all others are used in expressions. *)
let declaring =
  [
    "module";
    "import";
    "qualified";
    "as";
    "data";
    "type";
    "unit";
    "primitive";
    "class";
    "instance";
    "foreign";
    "param";
  ]

let declarations, expressions = List.partition (fun w -> List.mem w declaring) Syntax.Lexer.keywords

let operators =
  let brackets = [ "("; ")"; "{"; "}"; "]"; ","; ";"; "`" ] in
  List.filter (fun s -> not (List.mem s brackets)) Syntax.Lexer.punctuation_symbols
  @ Syntax.Operators.symbols
  |> List.sort_uniq (fun a b ->
         match Int.compare (String.length b) (String.length a) with
         | 0 -> String.compare a b
         | order -> order)

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let prelude path =
  let text = read path in
  match Syntax.Parse.program (Facts.ignored ()) ~file:path text with
  | Some tree -> tree
  | None -> failwith "cannot parse the prelude"

let units (tree : Syntax.Ir.program) =
  List.filter_map
    (fun (d : Syntax.Ir.declaration) ->
      match d.desc with Base_unit n | Scaled_unit { name = n; _ } -> Some n.text | _ -> None)
    tree.declarations

let built_in = [ "Float"; "Int"; "Bool"; "String"; "Array"; "SF"; "Task"; "Program"; "Eq"; "Ord" ]

let types (tree : Syntax.Ir.program) =
  built_in
  @ List.filter_map
      (fun (d : Syntax.Ir.declaration) ->
        match d.desc with
        | Type_alias { name; _ } | Data { name; _ } | Class { name; _ } -> Some name.text
        | _ -> None)
      tree.declarations

let constants (tree : Syntax.Ir.program) =
  [ "True"; "False" ]
  @ List.concat_map
      (fun (d : Syntax.Ir.declaration) ->
        match d.desc with
        | Data { constructors; _ } ->
            List.map (fun (c : Syntax.Ir.constructor) -> c.name.text) constructors
        | _ -> [])
      tree.declarations

(* {1 TextMate} *)

let quoted symbol =
  let special = "\\^$.|?*+()[]{}/" in
  String.concat ""
    (List.map
       (fun c -> if String.contains special c then Printf.sprintf "\\%c" c else String.make 1 c)
       (List.of_seq (String.to_seq symbol)))

let any words = "(?:" ^ String.concat "|" (List.map quoted words) ^ ")"
let word words = "(?<![A-Za-z0-9_'.])" ^ any words ^ "(?![A-Za-z0-9_'])"
let rule name pattern : Json.t = Object [ ("name", String name); ("match", String pattern) ]
let include_ name : Json.t = Object [ ("include", String ("#" ^ name)) ]

let region ?(patterns = []) name ~from ~upto : Json.t =
  Object
    [
      ("name", String name);
      ("begin", String from);
      ("end", String upto);
      ("patterns", List patterns);
    ]

let textmate tree : Json.t =
  let repository =
    [
      ( "comments",
        [
          rule "comment.line.double-dash.documentation.frob" "--\\s?\\|.*$";
          rule "comment.line.double-dash.frob" "--.*$";
          region "comment.block.frob" ~from:"\\{-" ~upto:"-\\}" ~patterns:[ include_ "block" ];
        ] );
      ( "block",
        [ region "comment.block.frob" ~from:"\\{-" ~upto:"-\\}" ~patterns:[ include_ "block" ] ] );
      ( "strings",
        [
          region "string.quoted.double.frob" ~from:"\"" ~upto:"\"|$"
            ~patterns:[ rule "constant.character.escape.frob" "\\\\[\"\\\\nt]" ];
        ] );
      ( "units",
        [
          Object
            [
              ("name", String "meta.unit.frob");
              ("begin", String "(?<=[A-Za-z0-9_'])\\[");
              ("end", String "\\]|$");
              ( "patterns",
                List
                  [
                    rule "support.constant.unit.frob" (word (units tree));
                    rule "constant.other.unit.frob" "[A-Za-z][A-Za-z0-9_']*";
                    rule "constant.numeric.frob" "[0-9]+";
                    rule "keyword.operator.unit.frob" "[/^*]";
                  ] );
            ];
        ] );
      ( "numbers",
        [
          rule "constant.numeric.frob"
            "(?<![A-Za-z0-9_'])(?:0[xX][0-9A-Fa-f_]+|0[oO][0-7_]+|0[bB][01_]+|[0-9][0-9_]*(?:\\.[0-9][0-9_]*)?(?:[eE][+-]?[0-9]+)?)";
        ] );
      ( "keywords",
        [
          rule "keyword.other.declaration.frob" (word declarations);
          rule "keyword.control.frob" (word expressions);
        ] );
      ( "definitions",
        [
          rule "entity.name.function.frob" "^[a-z_][A-Za-z0-9_']*(?=\\s*(?:,[^=]*)?::)";
          rule "entity.name.function.frob" "^[a-z_][A-Za-z0-9_']*(?=[^=<>|/]*=(?![=>]))";
        ] );
      ( "names",
        [
          rule "variable.other.member.frob" "(?<=[A-Za-z0-9_')\\]}]\\.)[a-z_][A-Za-z0-9_']*";
          rule "constant.language.frob" (word (constants tree));
          rule "support.type.frob" (word (types tree));
          rule "entity.name.type.frob" "(?<![A-Za-z0-9_'])[A-Z][A-Za-z0-9_']*";
          rule "variable.other.frob" "(?<![A-Za-z0-9_'])[a-z_][A-Za-z0-9_']*";
        ] );
      ("operators", [ rule "keyword.operator.frob" (any operators) ]);
    ]
  in
  Object
    [
      ( "$schema",
        String "https://raw.githubusercontent.com/martinring/tmlanguage/master/tmlanguage.json" );
      ("name", String "Frob");
      ("scopeName", String "source.frob");
      ("fileTypes", List [ String "frob" ]);
      ( "patterns",
        List
          (List.filter_map
             (fun (name, _) -> if name = "block" then None else Some (include_ name))
             repository) );
      ( "repository",
        Object
          (List.map
             (fun (name, patterns) -> (name, Json.Object [ ("patterns", List patterns) ]))
             repository) );
    ]

(* Prints each member on its own line, so that changes are easy to review. *)
let rec pretty indent (json : Json.t) =
  let lines open_ close elements =
    let inner = indent ^ "  " in
    Printf.sprintf "%s\n%s\n%s%s" open_
      (String.concat ",\n" (List.map (fun e -> inner ^ e inner) elements))
      indent close
  in
  match json with
  | Object (_ :: _ as members) ->
      lines "{" "}"
        (List.map
           (fun (name, value) inner ->
             Printf.sprintf "%s: %s" (Json.to_string (String name)) (pretty inner value))
           members)
  | List (_ :: _ as elements) -> lines "[" "]" (List.map (fun e inner -> pretty inner e) elements)
  | other -> Json.to_string other

(* {1 Vim} *)

let vim tree =
  let line = String.concat " " in
  let symbol s =
    String.concat ""
      (List.map
         (fun c ->
           if String.contains "\\/*.$^~[]\"" c then Printf.sprintf "\\%c" c else String.make 1 c)
         (List.of_seq (String.to_seq s)))
  in
  String.concat "\n"
    [
      "\" Frob: generated from the compiler's tables (compiler/editors/generate).";
      "if exists('b:current_syntax')";
      "  finish";
      "endif";
      "";
      "syntax match frobName /\\<[a-z_][A-Za-z0-9_']*/";
      "syntax match frobType /\\<[A-Z][A-Za-z0-9_']*/";
      "syntax match frobOperator /" ^ String.concat "\\|" (List.map symbol operators) ^ "/";
      "syntax match frobNumber \
       /\\<\\(0[xX][0-9A-Fa-f_]\\+\\|0[oO][0-7_]\\+\\|0[bB][01_]\\+\\|[0-9][0-9_]*\\(\\.[0-9][0-9_]*\\)\\?\\([eE][+-]\\?[0-9]\\+\\)\\?\\)/";
      "syntax region frobUnit matchgroup=frobOperator start=/[A-Za-z0-9_']\\@<=\\[/ end=/\\]/ \
       oneline";
      "syntax match frobFunction /^[a-z_][A-Za-z0-9_']*\\ze\\s*\\(,[^=]*\\)\\?::/";
      "syntax keyword frobDeclaration " ^ line declarations;
      "syntax keyword frobKeyword " ^ line expressions;
      "syntax keyword frobPreludeType " ^ line (types tree);
      "syntax keyword frobConstant " ^ line (constants tree);
      "syntax region frobString start=/\"/ skip=/\\\\./ end=/\"/ oneline";
      "syntax region frobComment start=/--/ end=/$/ oneline contains=@Spell";
      "syntax region frobComment start=/{-/ end=/-}/ contains=frobComment,@Spell";
      "";
      "highlight default link frobType Type";
      "highlight default link frobPreludeType Type";
      "highlight default link frobOperator Operator";
      "highlight default link frobNumber Number";
      "highlight default link frobUnit Special";
      "highlight default link frobFunction Function";
      "highlight default link frobDeclaration Keyword";
      "highlight default link frobKeyword Keyword";
      "highlight default link frobConstant Constant";
      "highlight default link frobString String";
      "highlight default link frobComment Comment";
      "";
      "let b:current_syntax = 'frob'";
      "";
    ]

(* {1 Emacs} *)

let emacs tree =
  let list name words =
    Printf.sprintf "(defconst %s\n  '(%s))\n" name
      (String.concat " " (List.map Text_literal.written words))
  in
  String.concat "\n"
    [
      ";;; frob-words.el --- the words of Frob -*- lexical-binding: t -*-";
      "";
      ";; Generated from the compiler's tables (compiler/editors/generate).";
      "";
      list "frob-words-declarations" declarations;
      list "frob-words-keywords" expressions;
      list "frob-words-types" (types tree);
      list "frob-words-constants" (constants tree);
      "(provide 'frob-words)";
      ";;; frob-words.el ends here";
      "";
    ]

let () =
  let tree = prelude Sys.argv.(2) in
  match Sys.argv.(1) with
  | "textmate" -> print_endline (pretty "" (textmate tree))
  | "vim" -> print_string (vim tree)
  | "emacs" -> print_string (emacs tree)
  | _ -> exit 2
