# Time of a particle-step against the number of particles: one thread drawn through, two dashed; grey: other methods
# with one thread, and what the machine could do at best.
tall = 0.85
load plots.'/style.gp'
set datafile missing NaN # lines of one method go on over the rows of the others
file = csv
bars(s) = words(s) > 1 ? word(s, 1).'|'.bars(s[strstrt(s, ' ') + 1:]) : s
shown = 'mpm gimp ge_gimp apic wls2 ge_wls'
others = system("cut -d, -f1 ".csv." | tail -n +2 | sort -u | grep -vxE '".bars(shown)."' | tr '\n' ' '")
set multiplot layout 1,3 margins 0.075,0.985,0.3,0.9 spacing 0.05,0
set logscale xy
set format x '10^{%T}'
set xrange [600:8e6]
set yrange [3:5000]
set xlabel 'particles' offset 0,0.4
do for [d = 1:3] {
    set label 1 heading(sprintf('%dD', d)) at graph 0, graph 1.05
    if (d == 1) { set ylabel 'wall clock of a particle-step [ns]' } else { unset ylabel; set format y '' }
    if (d == 2) { set key at screen 0.5, screen 0.16 center top maxrows 2 samplen 1.6 width -4 } else { unset key }
    mine(m, t) = strcol('method') eq m && column('dim') == d && column('threads') == t ? column('wall_ns') : NaN
    plot for [m in others] file using 'particles':(mine(m, 1)) with lines lc rgb '#cccccc' lw 1 notitle, \
         for [k = 1:words(shown)] file using 'particles':(mine(word(shown, k), 1)) with linespoints \
             ls style(word(shown, k)) title plain(word(shown, k)), \
         for [k = 1:words(shown)] file using 'particles':(mine(word(shown, k), 2)) with lines ls style(word(shown, k)) dt 2 notitle, \
         d == 2 ? 500 / flops : NaN with lines ls 20 title 'flops (GIMP)', \
         d == 2 ? 350 / bytes : NaN with lines ls 21 title 'bytes (GIMP)'
}
unset multiplot
