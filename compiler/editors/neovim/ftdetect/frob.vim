autocmd BufRead,BufNewFile *.frob setfiletype frob
