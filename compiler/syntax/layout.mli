(** Layout: turns indentation into explicit tokens (language reference, section 11).

    It uses a stack of openers to insert tokens, and does not depend on the parser's state. It
    encloses blocks in [OPEN] and [CLOSE], separates their items with [SEMICOLON], and ends each
    top-level item with [END]. A closing token ([in then else of , )] and similar ones) closes all
    blocks opened since its partner, whatever its column. Takes amortized constant time per token.
*)

type block = Top | Let | Where | Do | Of | Rec

type opener =
  | Block of block
  | Paren
  | Bracket
  | Brace
  | If  (** expects [then] *)
  | Then  (** expects [else]; its origin is the [if] *)
  | Case  (** expects [of] *)

type origin = {
  by : Lexer.token;  (** the token that opened it *)
  column : int;
      (** the column of the items in this block or, for a bracket, in the enclosing block *)
}

type context = (opener * origin) list
(** The open blocks and brackets, innermost first. *)

type entry
(** An open block or bracket. *)

type token = {
  token : Grammar.token;
  start : Lexing.position;
  stop : Lexing.position;
      (** the span of the token; for an inserted token, an empty span at the end of the preceding
          token *)
  made : bool;  (** whether layout inserted it *)
  column : int;  (** 0 if inserted by layout *)
  first : bool;  (** whether it is the first token on its line *)
  around : entry list;
      (** the blocks and brackets that are open before this token; see {!context} *)
  last : bool;  (** whether this is the [END] of the whole file *)
}

val context : token -> context

type t

exception Too_deep of Lexer.token
(** Raised if more than {!deepest} openers are nested. *)

val deepest : int
val create : Lexer.t -> t
val next : t -> token

val copy : t -> t
(** A copy of the state, for reading the same tokens twice. *)
