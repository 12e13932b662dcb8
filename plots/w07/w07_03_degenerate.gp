# Four arrangements of particles and what MPM's nodes get of a linear field.
load plots.'/style.gp'
load dir.'/'.name.'.var'

particles(a) = dir.'/'.name.'.'.a.'.gimp.csv'
nodes(a) = dir.'/'.name.'.'.a.'.mpm.csv'
KINDS = 'shifted centred unequal clustered'
TITLES = "'Shifted in every second cell' 'Centred' 'Unequal masses' 'Clustered'"
ERRORS = sprintf('%.4f %.4f %.4f %.4f', shifted, centred, unequal, clustered)

stats csv using 'h' nooutput
h = STATS_min
set xrange [0:1]
set yrange [0.9:2.1]
set xtics h
set ytics 0.25
set format x '%.2f'
set grid xtics noytics lt 1 dt 1 lw 1.2 lc rgb '#9a9a9a'
set key top left width -2
set multiplot layout 2,2 margins 0.1,0.98,0.11,0.93 spacing 0.09,0.15
do for [k = 1:4] {
    a = word(KINDS, k)
    set label 1 heading(word(TITLES, k)).sprintf(': error %s', word(ERRORS, k)) at graph 0, graph 1.07
    if (k > 2) { set xlabel 'x [m]' } else { unset xlabel }
    if (k % 2) { set ylabel 'v [m/s]' } else { unset ylabel }
    if (k == 1) { set key } else { unset key }
    plot 1 + x with lines ls 21 title 'true', \
         particles(a) using 'x':'vx':(0.6 + 1.2 * column('mass') / h) with points ls 22 ps variable \
             title 'particles', \
         nodes(a) using 'x':(column('x') > 0 && column('x') < 1 ? column('vx') : NaN) \
             with points ls style('mpm') pt 12 ps 1.8 lw 2 title 'MPM nodes'
}
unset multiplot
