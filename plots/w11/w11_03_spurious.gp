# Contours of a node's weight, and the nodes of the ring that no particle is near enough to.
tall = 0.8
load plots.'/style.gp'
load dir.'/'.name.'.var'
set multiplot layout 1,2 margins 0.085,0.98,0.14,0.84 spacing 0.09
set size ratio -1
set grid noxtics noytics
spline(r) = abs(r) < 0.5 ? 0.75 - r**2 : abs(r) < 1.5 ? 0.5 * (1.5 - abs(r))**2 : 0
set table $contours
set contour base
unset surface
set cntrparam levels discrete 0.01, 0.05, 0.25, 0.5
set isosamples 121
set samples 121
splot [-1.5:1.5] [-1.5:1.5] spline(x) * spline(y)
unset table
set table $trigger
set cntrparam levels discrete trigger
splot [-1.5:1.5] [-1.5:1.5] spline(x) * spline(y)
unset table
set surface
unset contour
set datafile separator whitespace
set xrange [-1.6:1.6]
set yrange [-1.6:1.6]
set xtics 0.5
set ytics 0.5
set xlabel '(x − x_i)/h'
set ylabel '(y − y_i)/h'
set label 1 heading('(a) weight around a node') at graph 0, graph 1.12
do for [w in '0.05 0.25 0.5'] {
    d = w eq '0.05' ? 1.08 : w eq '0.25' ? 0.64 : 0.27
    set label w[3:3] + 2 w at d, 0 center font ',9' front tc rgb '#444444'
}
set key at graph 1, graph 1.1 right top samplen 1.5
plot $contours using 1:2 with lines ls 20 notitle, \
     $trigger using 1:2 with lines lw 2.5 lc rgb COLOUR[1] title sprintf('trigger weight %.2f', trigger)
set datafile separator ','
unset for [k = 2:12] label k
set xrange [0:1.25]
set yrange [0:1.25]
set xtics 0.25
set ytics 0.25
set xlabel 'x [m]'
set ylabel 'y [m]'
set label 1 heading(sprintf('(b) %d spurious nodes', spurious))
nodes = dir.'/'.name.'.nodes.csv'
set parametric
set trange [0:pi / 2]
set samples 200
plot dir.'/'.name.'.particles.csv' using 'x':'y' with points pt 7 ps 0.2 lc rgb '#9db8d0' title 'particles', \
     nodes using (column('spurious') == 0 ? column('x') : NaN):'y' with points pt 6 ps 0.5 lc rgb '#444444' title 'nodes', \
     nodes using (column('spurious') == 1 ? column('x') : NaN):'y' with points pt 7 ps 0.7 lc rgb COLOUR[1] title 'spurious', \
     1.1 * cos(t), 1.1 * sin(t) with lines ls 20 notitle, 0.625 * cos(t), 0.625 * sin(t) with lines ls 20 notitle
unset multiplot
