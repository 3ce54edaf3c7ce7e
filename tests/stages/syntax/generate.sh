# The rules that compare what each program here comes out as with the file beside it.
for program in *.frob; do
    name=${program%.frob}
    cat <<END
(rule
 (action
  (with-stdout-to
   $name.out.now
   (run ../parse_file.exe %{dep:$program}))))

(rule
 (alias runtest)
 (action
  (diff $name.out $name.out.now)))

END
done
