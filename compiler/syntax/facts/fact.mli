(** The facts that the parser reports, as values without text. The library [advice] translates each
    of them into a diagnostic. *)

open Basis

type problem =
  | Not_utf8 of { at : Span.t; byte : char }
  | Tabs of { at : Span.t; count : int }
  | Too_deep of Span.t
  | Lexical of Lexical_fact.t
  | Unexpected of {
      state : int;  (** the automaton's state *)
      before : Layout.token option;  (** the preceding token, if it belongs to the same item *)
      token : Layout.token;  (** the token that the parser cannot accept *)
    }
  | Rejected of Rejection.t
  | Command_in_task of {
      command : Span.t;
      block : Lexing.position;  (** the start of the [do] that contains the command *)
      token : Layout.token;  (** the token that the parser had read when it rejected the command *)
    }
  | Misplaced_header of Span.t
  | Misplaced_import of Span.t

type t = { text : string;  (** the whole source *) problem : problem }
