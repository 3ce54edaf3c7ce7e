#!/bin/sh
# rules.sh PAGE…: prints dune rules that follow each page and compare the results.
set -eu
echo "; By rules.sh; see dune."
for page in "$@"; do
    case $page in *.md) ;; *) continue ;; esac
    from_docs=${page#*/docs/}
    name=$(echo "${from_docs%.md}" | tr / .)
    package=
    if grep -q '^```python' "$page"; then
        package="
  (source_tree %{project_root}/runtime/python)"
    fi
    cat <<END

(rule
 (action
  (with-stdout-to
   $name.done
   (run awk -v pages=$name.d -f %{dep:page.awk} %{project_root}/docs/$from_docs)))
 (deps
  %{project_root}/docs/$from_docs
  (package frobc)$package))

(rule
 (alias runtest)
 (action
  (diff %{project_root}/docs/$from_docs $name.done)))
END
done
