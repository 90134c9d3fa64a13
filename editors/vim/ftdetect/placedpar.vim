" Netlists of transputer networks, and occam.
autocmd BufRead,BufNewFile *.cfs setfiletype netlist
autocmd BufRead,BufNewFile *.occ,*.pgm setfiletype occam
