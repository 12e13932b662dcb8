# Rows of particles over the cells that they are squeezed into.
load plots.'/style.gp'

file(n) = dir.'/'.name.'.'.n.'.csv'
stats csv using 'h' nooutput
h = STATS_min
stats csv using 'particles' nooutput
rows = STATS_records
set xrange [0:1]
set yrange [rows + 0.5:0.5]
set xtics h
set format x '%.1f'
set grid xtics noytics lt 1 dt 1 lw 1.2 lc rgb '#9a9a9a'
unset key
set border 1
set xlabel 'x [m]'
set ylabel 'particles per cell, PPC' offset 0.5
set label 1 heading('The squeeze: even spacing, ten cells') at graph 0, graph 1.06
array N[rows]
stats csv using (N[int(column(0)) + 1] = column('particles'), 1) nooutput
set ytics scale 0 ()
do for [k = 1:rows] { set ytics add (sprintf('%.1f', N[k] * h) k) }
plot for [k = 1:rows] file(sprintf('%d', N[k])) using 'x':(k) with points ls 22 ps 1
