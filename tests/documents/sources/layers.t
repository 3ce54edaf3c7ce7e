Inside each library of the compiler, dependencies between folders run one way.

  $ python3 layers.py ../../../compiler

A cycle of any length is found, and with --files the files that make it.

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

The stages of the compiler know nothing of the layers above them: `build` makes a result of a
request, `tools` are the commands, `language_server` and `frobc` are the programs.

  $ uses() { sed -n 's/^ *(libraries \(.*\))$/\1/p' ../../../compiler/$1/dune | tr -d ')' | tr ' ' '\n'; }
  $ for stage in basis syntax resolve typing core specialize flow step cgen interp; do
  >   uses $stage | grep -wE 'probe|report|build|tools|language_server' | sed "s/^/$stage: /"; done
  $ uses build | grep -wE 'tools|language_server'
  [1]
  $ uses lsp | grep -wE 'tools'
  [1]
  $ uses lsp | grep -w build
  build
