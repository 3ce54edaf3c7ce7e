(** The facts that name resolution reports, as values without text. The library [advice] translates
    each of them into a diagnostic. *)

open Basis
open Syntax.Ir

(** {1 Unresolved names} *)

type size = {
  variable : string;
  of_ : string;  (** the definition with this signature *)
  array : string option;  (** a parameter of that definition that is an array of this size *)
}
(** A size variable of a signature, such as the [n] of [Array n Float]. *)

type unresolved =
  | Unknown of {
      space : Interface.any_space;
      name : name;
      locals : string list Lazy.t;  (** the local names that are in scope *)
      around : right list;
          (** the enclosing right-hand sides that have a [where], innermost first, followed by the
              outermost right-hand side *)
    }
  | Unknown_qualifier of { qualifier : name; name : name }
      (** the qualifier does not refer to an imported module *)
  | Unknown_in_module of {
      space : Interface.any_space;
      qualifier : name;
      name : name;
      known : string list Lazy.t;  (** the names that the module provides *)
    }
  | Variable_for_unit of name  (** a unit variable in a number or in the declaration of a unit *)
  | Size_as_value of { size : size; name : name }
  | Unit_of_a_value of { head : expr; unit_ : expr; at : Span.t }
      (** [(k * x)[m/s]]; [at]: the brackets *)
  | Unit_apart of { head : expr; unit_ : expr; at : Span.t }
      (** [3 [m/s]]; [head] is the number, or an application of a function to it *)
  | Field_as_function of { whole : Span.t; field : name; record : name }
      (** [x p] instead of [p.x] *)
  | Not_exported of { name : name; module_ : string; known : string list Lazy.t }
  | Not_in_import of { name : name; module_ : string; known : string list Lazy.t }
      (** an import list contains a name that the module does not export *)

(** {1 Modules} *)

type import_place = { importer : string; at : Span.t; target : name }

type in_modules =
  | Missing_module of {
      target : name;
      imported : string list;  (** the modules that the importing module names in its imports *)
      known : string list;  (** the names of the files that could be modules, for suggestions *)
    }
  | Missing_file of { at : Span.t; file : string }
  | Unreadable_file of { at : Span.t; file : string; reason : string }
  | Import_cycle of { target : name; places : import_place list }
      (** the imports that lead from the target back to itself, in order *)
  | Other_file_name of { module_ : name; file : string }  (** [file] has no extension *)
  | Two_files of { target : name; earlier : string; later : string }
  | No_program of { tests : string; program : string; reason : string option }
      (** [reason]: why the program of the test file cannot be read; [None] if the program does not
          exist. *)
  | Header_in_tests of Span.t
  | Main_in_tests of Span.t
  | Primitive_outside_library of name

(** {1 Parameters that are set on the command line} *)

type setting =
  | No_parameter of { known : string list }
  | Several_modules of { qualified : string list }
      (** the parameters with that name, each qualified with its module *)
  | Invalid_value of { value : string }

(** {1 Definitions and names} *)

type defined = {
  first : Ir.Local.t;
  second : Ir.Local.t;
  is_equation : bool;
  text : string;  (** the source text of the module *)
}

type in_definitions =
  | Ambiguous of {
      namespace : Interface.namespace;
      name : name;
      candidates : candidate list;  (** at least two *)
    }
  | Declared_twice of {
      namespace : Interface.namespace;
      name : name;
      first : Span.t;
      is_function : bool;  (** whether the second definition has parameters *)
    }
  | Defined_twice of defined  (** local variables that come into scope together *)
  | Two_labels of { first : Span.t; second : Span.t }
  | Two_signatures of { first : name; second : name }
  | Signature_alone of { name : name; bound : string list Lazy.t }
  | Top_level_pattern of { at : Span.t; pattern : pattern }
  | Operator_defined of name
  | Misplaced_claim of { at : Span.t; kind : claim }
  | Bad_label of Span.t
  | Label_without_quotes of { label : name; kind : string }
  | Too_deep of Span.t

and candidate = { module_ : string; qualifier : string; place : Span.t }

(** {1 Types, units and classes} *)

type in_types =
  | Parameter_missing of { name : name; owner : string; is_unit : bool }
  | Wrong_arity of {
      at : Span.t;
      tycon : Interface.tycon;
      of_units : bool;
          (** true if the number of unit arguments is wrong; false if the number of type arguments
              is wrong *)
      expected : int;
      found : int;
      text : string;  (** the text of the file *)
    }
  | Ungrouped_arguments of {
      at : Span.t;
      tycon : Interface.tycon;
      found : int;
      places : Span.t list;  (** the arguments that need parentheses, such as [Event ()] *)
      text : string;  (** the text of the file *)
    }  (** [SF Bool Event ()] *)
  | Representation_without_parameter of { name : name; owner : string }
  | Size_not_a_number of { at : Span.t; alias : string option }
  | Size_of_variable of { at : Span.t; variable : string; text : string  (** of the file *) }
  | Type_circle of { main : Ir.type_declaration; circle : Ir.type_declaration list }
      (** [circle] contains [main] *)
  | Unit_circle of { main : Ir.unit_declaration; others : Ir.unit_declaration list }
  | Class_circle of { main : Ir.class_; others : Ir.class_ list }
  | Parameter_twice of { first : name; second : name }
  | Field_twice of { first : name; second : name }
  | Parameter_is_a_unit of name
  | Unit_of_one_letter of name
  | Pattern_in_instance of Span.t
  | Method_twice of { first : name; second : name }
  | Not_a_method of { class_ : Interface.class_; name : name }
  | Signature_in_instance of { class_ : Interface.class_; name : name }

(** {1 Constructors and records} *)

type in_records =
  | Unknown_fields of {
      constructor : Interface.constructor;
      known : string list;
      first : name;
      others : name list;
    }
  | No_fields of { constructor : Interface.constructor; at : Span.t }
  | Field_repeated of { first : name; second : name }
  | Field_set_twice of { first : name; second : name }
  | Wrong_number_of_arguments of { constructor : Interface.constructor; at : Span.t; found : int }
  | Fields_missing of {
      constructor : Interface.constructor;
      at : Span.t;
      absent : string list;
      last : Span.t option;  (** the span of the last value that was given *)
    }

(** {1 Foreign code} *)

type in_foreign_code =
  | Not_a_name of name
  | Reserved_name of { name : name; meaning : c_meaning }
  | Not_a_type of name
  | Not_a_header of name
  | Header_elsewhere of name
  | State_without_header of { name : name; symbol : string }
  | Type_without_header of { name : name; c_type : string }

and c_meaning = Reserved_by_c | In_c_headers | Of_generated_c | Main_function

(** {1 Warnings} *)

type variable = {
  name : string;
  at : Span.t;
  is_parameter : bool;  (** whether it is a parameter of a named function *)
  zero : Span.t option;
      (** a literal 0 in a command, where one would expect a variable with this name *)
}

type warning =
  | Hides_local of { outer : Ir.Local.t; inner : Ir.Local.t }
  | Hides_parameter of { param : name; inner : Ir.Local.t }
  | Unused_equation of {
      at : Span.t;
      name : string option;  (** [None] for a pattern *)
      circle : string list;
          (** the names of a cycle that nothing else uses; empty if there is no cycle *)
      zero : Span.t option;  (** see {!variable} *)
    }
  | Unused_variables of variable * variable list  (** variables of the same pattern *)
  | Unused_import of Ir.idle
  | Deprecated of {
      name : Ir.Global.t;
      at : Span.t;
      text : string;  (** the text after [Deprecated:] in its documentation *)
      is_visible : bool;
          (** Can the module use all names of the declaring module without a qualifier? *)
    }

type t =
  | Syntax of Syntax.Fact.t
  | In_modules of in_modules
  | Setting of { name : string; at : Span.t; problem : setting }
  | Unresolved of { visible : Visible.t; names : unresolved list }
      (** all undefined names of one module, in the order in which they were found *)
  | In_definitions of in_definitions
  | In_types of in_types
  | In_records of in_records
  | In_foreign_code of in_foreign_code
  | Warning of warning
