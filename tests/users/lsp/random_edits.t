The first random edits on the examples: each place that the server speaks of is so, and it lives.
`make fuzz-lsp` goes on.

  $ export PYTHONPATH=$PWD PYTHONDONTWRITEBYTECODE=1
  $ python3 random_edits.py 1 400 ../../../examples/*/*.frob
  400 edits
