# Forces inside a uniformly stressed body: at the nodes of a bar, and the largest by method.
load plots.'/style.gp'
force_ = dir.'/'.name.'.force.csv'
dots_ = dir.'/'.name.'.dots.csv'
list_ = force_
load plots.'/methods.gp'
HERE = 'mpm bspline gimp wls'
set multiplot
set lmargin at screen 0.1
set rmargin at screen 0.46
set bmargin at screen 0.2
set tmargin at screen 0.9
set xrange [-0.48:0.48]
set yrange [-0.75:0.95]
set xtics 0.2
set xlabel 'node, from the middle of the bar [m]'
set ylabel 'internal force / (|σ| A)' offset 1
set key top left maxrows 2 samplen 1
set label 1 heading('Moving bar, uniform stress: nodes inside') at graph 0, graph 1.05
plot for [m in HERE] dots_ using (strcol('method') eq m ? column('x') : NaN):'force' with points \
         ls style(m) ps 0.55 title label(m)

set lmargin at screen 0.55
set rmargin at screen 0.985
set logscale y
set yrange [1e-16:1e3]
set format y '10^{%T}'
set ytics 1e-16, 100
set xlabel ''
set ylabel 'largest force / (|σ| A)' offset 1
set xtics () rotate by 40 right
set xrange [-0.7:words(seen_) - 0.3]
do for [k = 1:words(seen_)] { set xtics add (label(word(seen_, k)) k - 1) }
KINDS = 'bar stretch turned'
array SAYS[3] = ['bar', 'plane, stretched', 'turned by 30°']
set key top right maxrows 2 samplen 1
set label 1 heading('Largest, all offsets and meshes')
plot for [k = 1:3] force_ using (strcol('kind') eq word(KINDS, k) ? at_(strcol('method')) + 0.2 * (k - 2) : NaN):\
         (column('largest') > 1e-16 ? column('largest') : 1e-16) with points pt 4 + k ps 1 \
         lc rgb VARIANT[k] title SAYS[k]
unset multiplot
