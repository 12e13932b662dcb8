# Four ways to integrate over cut cells: error of WLS2 on the ring, and an integral as a circle slides through a cell.
tall = 0.8
load plots.'/style.gp'
set multiplot layout 1,2 margins 0.1,0.985,0.24,0.91 spacing 0.11
rules = 'centroid exact gauss16 samples16'
name_of(k) = word('centroid exact 16\_Gauss\_points 16\_even\_points', k)
titles(k) = k == 1 ? 'centroid' : k == 2 ? 'exact' : k == 3 ? '16 Gauss points, those inside' : '16 even points, those inside'
colour(k) = VARIANT[k == 2 ? 1 : k == 1 ? 2 : k]
only_rule(k) = strstrt(strcol('params'), 'quadrature='.word(rules, k)) ? column('cells') : NaN
set logscale xy
set format y '10^{%T}'
set xrange [7:72]
set yrange [7e-5:2e-2]
set xtics (8, 16, 32, 64)
set xlabel 'cells over the outer radius, N'
set ylabel 'largest error [m]'
set key at screen 0.1, screen 0.12 left top maxrows 2 samplen 2.2 width 1
set label 1 heading('(a) ring, WLS2') at graph 0, graph 1.05
plot for [k = 1:4] csv using (only_rule(k)):'error_linf' with linespoints lc rgb colour(k) lw 1.6 pt 6 ps 0.8 title titles(k), \
     0.45 / x**2 with lines ls 20 title 'N^{ −2}'
unset logscale
unset key
set format y '%h'
set xrange [-0.2:2.2]
set yrange [-0.01:0.27]
set xtics auto
set xlabel 'way along the diagonal [cells]'
set ylabel 'integral of x y over the cell'
set label 1 heading('(b) circle sliding through a cell')
plot for [k = 1:4] dir.'/'.name.'.slide.csv' using 'way':word(rules, k) with lines lc rgb colour(k) lw (k == 2 ? 1 : 1.6)
unset multiplot
