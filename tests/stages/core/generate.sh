# Prints dune rules that compare the dump of each program in this folder with the expected file next
# to it.
for program in *.frob; do
    name=${program%.frob}
    cat <<END
(rule
 (deps
  (glob_files %{project_root}/stdlib/*.frob))
 (action
  (with-stdout-to
   $name.core.now
   (run ./elaborate_file.exe core %{project_root}/stdlib %{dep:$program}))))

(rule
 (alias runtest)
 (action
  (diff $name.core $name.core.now)))

END
done
