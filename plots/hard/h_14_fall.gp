# Free fall from rest: error by method and integrator.
load plots.'/style.gp'
list_ = csv
load plots.'/methods.gp'
set lmargin 10
set bmargin 6
set logscale y
set xrange [-0.7:words(seen_) - 0.3]
set yrange [1e-17:1]
set format y '10^{%T}'
set ytics 1e-16, 100
set ylabel 'error of the displacement [m]'
set xtics () rotate by 40 right
do for [k = 1:words(seen_)] { set xtics add (label(word(seen_, k)) k - 1) }
KINDS = 'cd uvf musl usl usf'
array HUE[5] = ['#334155', '#0e7490', '#64748b', '#b45309', '#a855f7'] # integrators, which are no methods
array KIND[5] = [7, 5, 9, 6, 4]
set key top left maxrows 1 samplen 1
set label 1 heading('A block falls from rest: bar and plane, five integrators') at graph 0, graph 1.06
set label 2 'whole first step' at graph 0.985, graph 0.86 right textcolor rgb '#666666'
set label 3 'half first step' at graph 0.985, graph 0.2 right textcolor rgb '#666666'
plot for [k = 1:5] csv using (strcol('integrator') eq word(KINDS, k) ? at_(strcol('method')) + 0.12 * (k - 3) : NaN):\
         (column('error_linf') > 2e-17 ? column('error_linf') : 2e-17) with points pt KIND[k] ps 1 lc rgb HUE[k] title word(KINDS, k)
