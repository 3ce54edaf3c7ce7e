The first random edits on the examples: each place that the server reports is correct, and the
server keeps running. `make fuzz-lsp` continues them.

  $ export PYTHONPATH=$PWD PYTHONDONTWRITEBYTECODE=1
  $ python3 random_edits.py 1 400 ../../../examples/*/*.frob
  400 edits
