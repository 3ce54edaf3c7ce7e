Inside each library of the compiler, dependencies between folders run one way.

  $ python3 layers.py ../../../compiler

The script finds a cycle of any length and, with --files, lists the files that
cause it.

  $ mkdir -p lib/typing/types lib/typing/infer lib/typing/levels
  $ echo 'let x = Infer.x' > lib/typing/types/unify.ml
  $ echo 'let x = Levels.x' > lib/typing/infer/infer.ml
  $ echo 'let x = Unify.x' > lib/typing/levels/levels.ml
  $ echo 'let x = Infer.x' > lib/typing/pass.ml
  $ python3 layers.py lib --files
  typing: infer, levels, types
      infer -> levels: infer.ml
      levels -> types: levels.ml
      types -> infer: unify.ml

The compiler's stages do not depend on the layers above them: `advice` turns the facts that they
report into messages, `build` computes the result of a request, `tools` implements the commands, and
`language_server` and `frobc` are the programs.

  $ uses() { sed -n 's/^ *(libraries \(.*\))$/\1/p' ../../../compiler/$1/dune | tr -d ')' | tr ' ' '\n'; }
  $ for stage in basis syntax resolve typing core specialize flow step cgen interp; do
  >   uses $stage | grep -wE 'advice|probe|report|build|tools|language_server' | sed "s/^/$stage: /"; done
  $ uses advice | grep -wE 'probe|report|build|tools|language_server'
  [1]
  $ uses build | grep -wE 'tools|language_server'
  [1]
  $ uses lsp | grep -wE 'tools'
  [1]
  $ uses lsp | grep -w build
  build

No module has a mutable table of its own: state is in values that functions are given.

  $ tables() { grep -rnE '^let [a-z_]+( *:[^=]*)? *= *(lazy *\(?)?[A-Za-z_.]*(create|Array\.make)' --include='*.ml' "$1"; }
  $ echo 'let known : (string, int) Hashtbl.t = Hashtbl.create 16' > lib/typing/known.ml
  $ tables lib
  lib/typing/known.ml:1:let known : (string, int) Hashtbl.t = Hashtbl.create 16
  $ tables ../../../compiler
  [1]

Only the code that shows messages to users reads their text. All other code asks for the topics of a
diagnostic.

  $ cd ../../../compiler
  $ grep -Rlw for_display --include='*.ml' . | sort
  ./basis/diagnostics/diagnostic.ml
  ./basis/diagnostics/render_json.ml
  ./basis/diagnostics/render_text.ml
  ./lsp/features/code_actions.ml
  ./lsp/features/diagnostics.ml
  ./tools/fix/fix_files.ml

A stage reports facts, and never builds a diagnostic. It may only raise `Diagnostic.Bug`, for an
internal error.

  $ ls syntax/parse.ml typing/of_resolved.ml
  syntax/parse.ml
  typing/of_resolved.ml
  $ grep -RnwE 'Diagnostic|Render_text' --include='*.ml*' syntax resolve typing core specialize flow step cgen interp |
  >   grep -vE 'Diagnostic\.(bug|Bug)|\{!'
  [1]
