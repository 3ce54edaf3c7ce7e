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
          (** the letters directly after the number, with the rest of a unit; empty if digits are
              missing, as in [0x] *)
      has_unit : bool;  (** whether the letters are a unit *)
    }
  | No_fraction of { number : string }  (** the number without its decimal point *)
  | No_whole_part of { fraction : string }  (** the fraction with its decimal point *)
  | Unexpected_character of {
      character : string;
      offset : int;  (** byte offset in the text *)
      is_first : bool;  (** whether it is the first unexpected character on its line *)
    }

type t = { at : Span.t; problem : problem }
