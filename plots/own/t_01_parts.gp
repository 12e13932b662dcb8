# GE-WLS with one part removed at a time: the ring beside FEM; errors of seven scenes over the whole's.
load plots.'/style.gp'
load dir.'/'.name.'.var'
gains = dir.'/'.name.'.gains.csv'
PART = 'average distance hermite mass motion return velocity'
LESS = '"forces not folded" "straight cuts" "no gradients" "lumped mass" "lagged motion" "linear return" "plain velocity"'
set multiplot layout 1,2 margins 0.085,0.98,0.36,0.92 spacing 0.11
set logscale xy
set xrange [7:75]
set xtics (8, 16, 32, 64)
set yrange [0.4:2]
set ytics (0.5, 0.7, 1, 1.5, 2)
set xlabel 'cells over the outer radius, N'
set ylabel "largest error over FEM's" offset 1.8
set label 1 heading('(a) ring') at graph 0, graph 1.05
set key at screen 0.08, screen 0.24 left top maxrows 4 samplen 2.2 width 2
of(p) = strcol('part') eq p && strcol('what') eq 'share' ? column('at') : NaN
plot gains using (of('all')):'value' with linespoints ls style('ge_wls') lw 2.2 title label('ge_wls'), \
     for [k=1:7] gains using (of(word(PART, k))):'value' with linespoints ls (k < 7 ? k : 8) title word(LESS, k), \
     1 with lines ls 20 title 'FEM'

unset logscale x
set key off
set xrange [-0.6:6.6]
set xtics ('ring' 0, 'axis\_mms' 1, 'vortex' 2, 'plate' 3, 'disk' 4, 'block' 5, 'bar' 6) rotate by -35
set yrange [0.2:3000]
set ytics (0.2, 0.5, 1, 2, 5, 10, 100, 1000)
set xlabel ''
set ylabel 'error without the part over error with it' offset 0.5
set label 1 heading('(b) every scene, one part less')
at(p) = strcol('part') eq p && strcol('what') ne 'share' ? column('at') : NaN
plot for [k=1:7] gains using (at(word(PART, k)) + 0.09 * (k - 4)):'value' with points ls (k < 7 ? k : 8), \
     1 with lines ls style('ge_wls') lw 2.2
unset multiplot
