# Time of a particle-step against the number of particles: one thread drawn through, two dashed.
tall = 0.8
load plots.'/style.gp'
heads = 'one two three'
file = csv
known = system("cut -d, -f1 ".csv." | tail -n +2 | awk '!seen[$0]++'")
set multiplot layout 1,3 margins 0.075,0.985,0.3,0.88 spacing 0.05,0
set logscale xy
set format x '10^{%T}'
set xrange [600:8e6]
set yrange [3:2000]
set xlabel 'particles' offset 0,0.4
do for [d = 1:3] {
    set label 1 heading(sprintf('%dD', d)) at graph 0, graph 1.05
    if (d == 1) { set ylabel 'wall clock of a particle-step [ns]' } else { unset ylabel; set format y '' }
    if (d == 2) { set key at screen 0.5, screen 0.17 center top maxrows 5 samplen 1.6 width 1 } else { unset key }
    mine(m, t) = strcol('method') eq m && column('dim') == d && column('threads') == t ? column('wall_ns') : NaN
    plot for [k = 1:words(known)] file using 'particles':(mine(word(known, k), 1)) with linespoints \
             lc k pt k ps 0.6 lw 1.4 title plain(word(known, k)), \
         for [k = 1:words(known)] file using 'particles':(mine(word(known, k), 2)) with lines lc k dt 2 lw 1 notitle, \
         d == 2 ? 500 / flops : NaN with lines ls 20 title 'GIMP: multiply-adds at best', \
         d == 2 ? 350 / bytes : NaN with lines ls 21 title 'GIMP: memory at best'
}
unset multiplot
