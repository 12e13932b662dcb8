# squeeze.gp: axes of the squeeze figures: error at interior nodes against particles per cell.
set logscale xy
set xrange [0.5:10]
set xtics (0.5, 1, 2, 3, 4, 5, 6, 8, 10)
set format y '10^{%T}'
set xlabel 'particles per cell, PPC'
set ylabel 'largest relative error at interior nodes'
set key top right
