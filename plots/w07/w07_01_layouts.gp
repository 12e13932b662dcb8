# Two layouts of about a hundred particles in a block of cells.
tall = 0.8
load plots.'/style.gp'
load dir.'/'.name.'.var'

inside(v) = v * cells >= first_cell && v * cells <= last_cell
at(v, w) = inside(v) && inside(w) ? v * cells - first_cell : NaN
file(layout) = dir.'/'.name.'.'.layout.'.csv'

width = last_cell - first_cell
set border 15
set size square
set xrange [0:width]
set yrange [0:width]
set xtics 1
set ytics 1
set grid xtics ytics lt 1 dt 1 lw 1.2 lc rgb '#9a9a9a'
set xlabel 'x/h'
set ylabel 'y/h'
unset key
set multiplot layout 1,2 margins 0.08,0.98,0.13,0.92 spacing 0.1
set label 1 heading(sprintf('Ideal: %d particles', cartesian)) at graph 0, graph 1.05
plot file('cartesian') using (at(column('X'), column('Y'))):(column('Y') * cells - first_cell) \
     with points ls 22 ps 1
set label 1 heading(sprintf('Radial: %d particles', radial)) at graph 0, graph 1.05
plot file('radial') using (column('mass') > 0 ? at(column('X'), column('Y')) : NaN):(column('Y') * cells - first_cell) \
     with points ls 22 ps 1
unset multiplot
