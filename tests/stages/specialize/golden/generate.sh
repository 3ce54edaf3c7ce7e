# Prints dune rules that compare the dump of each program here with the file next to it.
for program in *.frob; do
    name=${program%.frob}
    cat <<END
(rule
 (deps
  (glob_files %{project_root}/stdlib/*.frob))
 (action
  (with-stdout-to
   $name.flow.now
   (run ./specialize_file.exe %{project_root}/stdlib %{dep:$program}))))

(rule
 (alias runtest)
 (action
  (diff $name.flow $name.flow.now)))

END
done
