# The ring's volume at 10 ms as triangles, as GIMP's particle boxes, and as full and cut cells.
tall = 0.6
load plots.'/style.gp'
load dir.'/'.name.'.var'
set multiplot layout 1,3 margins 0.07,0.985,0.16,0.82 spacing 0.06
set size ratio -1
set xrange [0:1]
set yrange [0:1]
set xtics 0.25
set ytics 0.25
set grid noxtics noytics
set xlabel 'x [m]'
set ylabel 'y [m]' offset 1
unset key
set samples 200
set parametric
set trange [0:pi / 2]
percent(e) = minus(sprintf('%.2f %%', 100 * e))
part(p) = dir.'/'.name.'.'.p.'.csv'
set label 1 heading('(a) triangles') at graph 0, graph 1.13
set label 2 'area off by '.percent(error_fem) at graph 0, graph 1.05
plot part('fem') using 'x':'y' with filledcurves closed fc rgb COLOUR[style('fem')] fs transparent solid 0.12 border lc rgb '#444444', \
     0.9 * cos(t), 0.9 * sin(t) with lines ls 20, 0.375 * cos(t), 0.375 * sin(t) with lines ls 20
set label 1 heading('(b) GIMP''s particles')
set label 2 sprintf('gaps %.1f %%, overlaps %.1f %%', 100 * gaps, 100 * overlaps)
unset ylabel
l = 0.25 / cells
plot part('gimp') using 'x':'y':(l * column('Fxx')):(l * column('Fyy')) with boxxyerror fc rgb COLOUR[style('gimp')] fs transparent solid 0.3 border lc rgb COLOUR[style('gimp')] lw 0.7, \
     0.9 * cos(t), 0.9 * sin(t) with lines ls 20, 0.375 * cos(t), 0.375 * sin(t) with lines ls 20
set label 1 heading('(c) cells of WLS')
set label 2 'area off by '.percent(error_wls)
plot part('wls') using 'x':'y' with filledcurves closed fc rgb COLOUR[style('wls')] fs transparent solid 0.2 border lc rgb COLOUR[style('wls')], \
     0.9 * cos(t), 0.9 * sin(t) with lines ls 20, 0.375 * cos(t), 0.375 * sin(t) with lines ls 20
unset multiplot
