# Particles of the plate at the start and half a period later.
tall = 0.8
load plots.'/style.gp'
load dir.'/'.name.'.var'

file(when) = dir.'/'.name.'.'.when.'.csv'
moved(x, X) = X + exaggeration * (x - X)
set size square
set border 15
set xrange [-0.15:1.15]
set yrange [-0.15:1.15]
set xtics 0.25
set ytics 0.25
set xlabel 'x [m]'
set ylabel 'y [m]'
unset key
set multiplot layout 1,2 margins 0.1,0.98,0.13,0.92 spacing 0.12
set label 1 heading(sprintf('Start (displacement × %g)', exaggeration)) at graph 0, graph 1.05
plot file('start') using (moved(column('x'), column('X'))):(moved(column('y'), column('Y'))) \
     with points ls 22 ps 1
set label 1 heading(sprintf('Half a period later (× %g)', exaggeration))
plot file('half') using (moved(column('x'), column('X'))):(moved(column('y'), column('Y'))) \
     with points ls 22 ps 1
unset multiplot
