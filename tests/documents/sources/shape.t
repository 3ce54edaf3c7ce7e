No folder of the compiler holds more than thirty files.

  $ cd ../../../compiler
  $ find . -name '*.ml*' | wc -l | grep -qE '^[0-9]{3,}$' || echo "the sources are not here"
  $ find -L . -type f | sed 's|/[^/]*$||' | sort | uniq -c | awk '$1 > 30'

No page has the marks of a merge that was not finished.

  $ ls ../docs/language.md ../README.md
  ../README.md
  ../docs/language.md
  $ grep -RnE '^(<<<<<<<|>>>>>>>) ' --include='*.md' ../docs ../README.md
  [1]
