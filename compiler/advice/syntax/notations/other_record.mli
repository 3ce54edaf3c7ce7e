(** Records in the notation of Elm, OCaml, JavaScript, Python or Rust, and their equivalents in
    Frob. *)

val changed_copy : string -> int -> Basis.Diagnostic.hint option
(** The hint that suggests [p { x = 1 }] for the braces at this offset, if they contain a record
    update: [{ p | x = 1 }], [{ p with x = 1 }], [{ ...p, x: 1 }] or [P { x: 1, ..p }]. *)

val value : string -> int -> string option
(** [P { x = 1, y = 2 }] for [P { x: 1, y: 2 }], if a constructor or a record precedes the braces at
    this offset. *)
