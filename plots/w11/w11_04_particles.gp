# The quarter ring filled with particles, on the lattice and fitted to it.
tall = 0.78
load plots.'/style.gp'
set multiplot layout 1,2 margins 0.085,0.98,0.12,0.92 spacing 0.09
set size ratio -1
set xrange [0:1.12]
set yrange [0:1.12]
set xlabel 'X [m]'
set ylabel 'Y [m]'
set xtics 0.25
set ytics 0.25
set grid noxtics noytics
set samples 200
unset key
do for [k = 0:18] { # the grid, h = 1/16
    set arrow k + 1 from k / 16.0, graph 0 to k / 16.0, graph 1 nohead lc rgb '#dddddd' lw 0.6 back
    set arrow k + 31 from graph 0, first k / 16.0 to graph 1, first k / 16.0 nohead lc rgb '#dddddd' lw 0.6 back
}
set parametric
set trange [0:pi / 2]
do for [layout in 'cartesian radial'] {
    set label 1 heading(layout eq 'cartesian' ? '(a) on the lattice' : '(b) fitted to the ring') at graph 0, graph 1.05
    plot dir.'/'.name.'.'.layout.'.csv' using 'X':'Y' with points pt 7 ps 0.35 lc rgb COLOUR[style('gimp')], \
         cos(t), sin(t) with lines ls 20, 0.5 * cos(t), 0.5 * sin(t) with lines ls 20
}
unset multiplot
