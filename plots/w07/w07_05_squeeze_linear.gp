# Error of projected velocity against particles per cell: lobes between exact points, and their slopes.
load plots.'/style.gp'
load dir.'/'.name.'.var'

set logscale xy
set xrange [0.5:10]
set yrange [1e-7:3e-2]
set xtics (0.5, 1, 2, 3, 4, 5, 6, 8, 10)
set format y '10^{%T}'
set xlabel 'particles per cell, PPC'
set ylabel 'largest relative error at interior nodes'
set label 1 heading('Squeeze, linear velocity field, 100 cells') at graph 0, graph 1.06
set key top right

slope(p) = 'PPC^{ '.minus(sprintf('%.2f', p)).'}'
guide(x, p) = 0.01 / pi**(-p) * x**p # h/(pi PPC)^-p, above which the lobes' tops lie

plot csv using (only('mpm', 'ppc')):'error_linf' with linespoints ls style('mpm') ps 0.35 \
         title label('mpm').', maxima fall as '.slope(W07_5_mpm_exponent), \
     csv using (only('gimp', 'ppc')):'error_linf' with linespoints ls style('gimp') ps 0.35 \
         title label('gimp').', maxima fall as '.slope(W07_5_gimp_exponent), \
     1.6 * guide(x, -2) with lines ls 21 title 'PPC^{ −2}', \
     1.1 * guide(x, -3) with lines ls 20 title 'PPC^{ −3}'
