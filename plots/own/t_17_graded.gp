# Graded grids and particles in 1D: error of a linear field, orders, and the condition number of WLS's moments.
tall = 1.1
load plots.'/style.gp'
set datafile missing NaN
set multiplot layout 2,2 margins 0.1,0.985,0.17,0.93 spacing 0.11,0.13
errors = dir.'/'.name.'.errors.csv'
ALL5 = 'mpm gimp ge_mpm ge_gimp wls'
sel(m, k, f, n) = (strcol('method') eq m && strcol('kind') eq k && strcol('field') eq f && column('cells') == n) ? column('ratio') : NaN
ord(m, f) = (strcol('method') eq m && strcol('kind') eq 'cells' && strcol('field') eq f && column('ratio') == 1.5) ? column('cells') : NaN
floor_at(y) = y < 1e-17 ? 1e-17 : y
set logscale y
set format y '10^{%T}'
set yrange [1e-17:1]
set ytics 1e3
set xrange [0.98:1.52]
set xlabel 'ratio of neighbouring cells'
set ylabel 'error, linear field' offset 1
set key at screen 0.1, screen 0.06 left top maxrows 1 samplen 2.2 width 1
set label 1 heading('(a) cells differ, N = 48') at graph 0, graph 1.06
plot for [m in ALL5] errors using (sel(m, 'cells', 'linear', 48)):(floor_at(column('error'))) with linespoints ls style(m) title label(m)
unset key
unset ylabel
set xlabel 'ratio of the two particles of a cell'
set label 1 heading('(b) particles differ, N = 48')
plot for [m in ALL5] errors using (sel(m, 'sizes', 'linear', 48)):(floor_at(column('error'))) with linespoints ls style(m)
set logscale x
set xrange [20:230]
set xtics (24, 48, 96, 192)
set yrange [1e-6:0.05]
set ytics 10
set xlabel 'cells, ratio 1.5'
set ylabel 'error, quadratic field' offset 1
set label 1 heading('(c) refined')
plot for [m in ALL5] errors using (ord(m, 'quadratic')):'error' smooth unique with linespoints ls style(m), \
     3.0 / x**2 with lines ls 20, 0.3 / x with lines ls 21
unset logscale
set format y '%h'
set xrange [-0.02:0.52]
set xtics auto
set ytics auto
set yrange [0:*]
set xlabel 'jitter of particles [spacing]'
set ylabel 'condition number of moments' offset 1
set key at graph 0.03, graph 0.98 left top maxrows 3
set label 1 heading('(d) WLS, 2D, H-6')
plot for [g = 1:2] dir.'/'.name.'.condition.csv' using (column('grading') == g ? column('jitter') : NaN):'condition' \
     with linespoints lc rgb VARIANT[g == 1 ? 2 : 3] pt 6 lw 1.6 title (g == 1 ? 'lattice' : 'graded, x^2')
unset multiplot
