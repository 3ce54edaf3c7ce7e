(** Layout: indentation made explicit (language reference, section 11).

    A function from tokens to tokens with a stack of openers; the grammar has no say in it. Blocks
    get [OPEN] and [CLOSE], their items [SEMICOLON]; items at the top of the file end with [END]. A
    token that closes something ([in then else of , )] and the like) closes the blocks opened since
    its partner, whatever its column. Constant time per token, amortized. *)

type block = Top | Let | Where | Do | Of | Rec

type opener =
  | Block of block
  | Paren
  | Bracket
  | Brace
  | If  (** waits for [then] *)
  | Then  (** waits for [else]; opened by its [if] too *)
  | Case  (** waits for [of] *)

type origin = {
  by : Lexer.token;  (** what opened it *)
  column : int;  (** of the innermost block's items: of this one, or of the one around it *)
}

type context = (opener * origin) list
(** What is open, innermost first. *)

type entry
(** Something that is open. *)

type token = {
  token : Grammar.token;
  start : Lexing.position;
  stop : Lexing.position;  (** a token that layout made is empty, at the end of the one before *)
  made : bool;  (** by layout *)
  column : int;  (** 0 if layout made it *)
  first : bool;  (** on its line *)
  around : entry list;  (** what was open before this token; see {!context} *)
  last : bool;  (** the [END] of the whole file *)
}

val context : token -> context

type t

exception Too_deep of Lexer.token
(** More than {!deepest} openers in each other. *)

val deepest : int
val create : Lexer.t -> t
val next : t -> token

val copy : t -> t
(** To read on from the same place twice. *)
