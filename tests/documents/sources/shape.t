No folder of the compiler contains more than thirty files.

  $ cd ../../../compiler
  $ find . -name '*.ml*' | wc -l | grep -qE '^[0-9]{3,}$' || echo "the sources are not here"
  $ find -L . -type f | sed 's|/[^/]*$||' | sort | uniq -c | awk '$1 > 30'

No page contains merge conflict markers.

  $ ls ../docs/language.md ../README.md
  ../README.md
  ../docs/language.md
  $ grep -RnE '^(<<<<<<<|>>>>>>>) ' --include='*.md' ../docs ../README.md
  [1]
