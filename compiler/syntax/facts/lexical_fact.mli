(** The facts that the lexer reports. *)

open Basis

type problem =
  | Comment_not_closed
  | Text_not_closed
  | Unknown_escape
  | Long_name of { most : int; length : int }
  | Long_number of { most : int; length : int }
  | Number_followed of {
      base : int;
      number : string;
      rest : string;
          (** the letters after it, with the rest of a unit; empty if it has no digits *)
      has_unit : bool;  (** Are the letters a unit? *)
    }
  | No_fraction of { number : string }  (** the number without its point *)
  | No_whole_part of { fraction : string }  (** the fraction with its point *)
  | Unexpected_character of {
      character : string;
      offset : int;  (** place in the text, in bytes *)
      is_first : bool;  (** whether this is the first one on its line *)
    }

type t = { at : Span.t; problem : problem }
