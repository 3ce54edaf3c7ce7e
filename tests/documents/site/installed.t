Links in the pages of an installation lead only to installed files: pages, pictures, examples, the
library and the runtime. Other files are named by their paths in the sources.

  $ top=../../..
  $ mkdir -p share/frobc share/doc
  $ cp -RL $top/stdlib share/frobc/stdlib && cp -RL $top/runtime share/frobc/runtime
  $ rm -r share/frobc/runtime/include
  $ sh $top/compiler/package/documents.sh share/doc/frobc
  $ cd share/doc/frobc
  $ grep -o '[^ ]* (`compiler/[^)]*)' docs/editors.md
  vscode/frob.tmLanguage.json (`compiler/editors/vscode/frob.tmLanguage.json` of the sources)
  $ find . -name '*.md' | sort | while read -r page; do
  >   awk '/^ *```/ { code = !code } !code' $page | grep -o '](\([^)# ]*\)' | cut -c 3- |
  >   grep -v '^https\{0,1\}:' | sort -u |
  >   while read -r link; do
  >     [ -z "$link" ] || [ -e "$(dirname $page)/$link" ] || echo "$page: there is no $link"
  >   done
  > done
