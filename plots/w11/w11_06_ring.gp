# Oscillating ring: the largest error against mesh and against time step.
tall = 1.15
load plots.'/style.gp'
load dir.'/'.name.'.var'
set multiplot layout 1,2 margins 0.09,0.985,0.38,0.92 spacing 0.08
set logscale xy
set format y '10^{%T}'
set yrange [1e-5:5e-2]
order(m) = exists('order_'.m) ? value('order_'.m) : NaN
exists_in(m) = exists('order_'.m)
fit_text(m) = order(m) == order(m) ? ', order '.minus(sprintf('%.2f', order(m))) : ', lost'
runs(m, lay, x) = (strcol('method') eq m && strcol('layout') eq lay && strcol('status') eq 'ok') ? column(x) : NaN
# runs that did not reach the end stand at the upper edge, one line per method, so that each shows
edge(m) = 4.7e-2 * 0.91**place(m)
lost(m, lay, x) = (strcol('method') eq m && strcol('layout') eq lay && strcol('status') ne 'ok' \
                   && strcol('status') ne 'energy_growth') ? column(x) : NaN
usual(m) = strstrt(m, 'wls') ? 'radial' : 'cartesian'

set label 1 heading('(a) in space, CFL .3') at graph 0, graph 1.05
set xrange [7:150]
set xtics (8, 16, 32, 64, 128)
set xlabel 'cells over the outer radius, N'
set ylabel 'largest error of all particles and steps [m]'
set key at screen 0.09, screen 0.29 left top maxrows 9 samplen 2.2 width 1
plot for [m in METHODS] exists_in(m) ? csv : '/dev/null' \
         using (column('cfl') == 0.3 ? runs(m, usual(m), 'cells') : NaN):'error_linf' \
         with linespoints ls style(m) title label(m).fit_text(m), \
     csv using (column('cfl') == 0.3 ? runs('gimp', 'radial', 'cells') : NaN):'error_linf' \
         with linespoints ls style('gimp') dt 2 pt 6 title 'GIMP, fitted'.fit_text('gimp_radial'), \
     for [m in METHODS] csv using (column('cfl') == 0.3 ? lost(m, usual(m), 'cells') : NaN):(edge(m)) \
         with points ls style(m) pt 1 ps 1.2 notitle, \
     NaN with points pt 1 lc rgb '#444444' title 'lost', 0.5 / x**2 with lines ls 20 title 'N^{ −2}', 0.09 / x with lines ls 21 title 'N^{ −1}'

set label 1 heading('(b) in time, N = 32')
set xrange [0.045:1]
set xtics (0.05, 0.1, 0.2, 0.4, 0.8)
set xlabel 'time step, CFL'
unset ylabel
set format y ''
unset key
plot for [m in METHODS] csv using (column('cells') == 32 ? runs(m, usual(m), 'cfl') : NaN):'error_linf' \
         smooth unique with linespoints ls style(m), \
     csv using (column('cells') == 32 ? runs('gimp', 'radial', 'cfl') : NaN):'error_linf' \
         smooth unique with linespoints ls style('gimp') dt 2 pt 6, \
     for [m in METHODS] csv using (column('cells') == 32 ? lost(m, usual(m), 'cfl') : NaN):(edge(m)) \
         with points ls style(m) pt 1 ps 1.2
unset multiplot
