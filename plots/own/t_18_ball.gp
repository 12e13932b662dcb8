# Energies of the ball through its impact: WLS and FEM, and the total of every method.
load plots.'/style.gp'
load dir.'/'.name.'.var'
file(m) = dir.'/'.name.'.'.m.'.csv'
SHOWN = 'gimp wls wls2 ge_wls fem'
array E0[6]
do for [k = 1:6] {
    m = word(SHOWN.' wls_unilateral', k)
    stats [*:*][*:*] file(m) using (column('total')) every ::0::0 nooutput
    E0[k] = STATS_max
}
back(m) = exists('back_'.m) && value('back_'.m) == value('back_'.m) ? sprintf(', %.1f %%', 100 * value('back_'.m)) : ', lost'
set multiplot
set xrange [0:3]
set xtics 0.5
set xlabel 't [s]'
set tmargin at screen 0.92
set bmargin at screen 0.13
set lmargin at screen 0.08
set rmargin at screen 0.42
set label 1 heading('(a) GE-WLS') at graph 0, graph 1.05
set yrange [0:1.15]
set ylabel 'energy / E_0' offset 1
set key at graph 0.78, graph 0.5 right center
plot file('ge_wls') using 't':(column('total') / E0[4]) with lines lc rgb '#222222' lw 2 title 'total', \
     '' using 't':(column('kinetic') / E0[4]) with lines lc rgb '#555555' dt 2 lw 2 title 'kinetic', \
     '' using 't':(column('strain') / E0[4]) with lines lc rgb '#999999' lw 2 title 'strain'
set lmargin at screen 0.5
set rmargin at screen 0.79
set label 1 heading('(b) total energy')
set yrange [0.9:1.1]
set arrow 1 from 2.3, graph 0 to 2.3, graph 1 nohead ls 21
set key at screen 0.795, screen 0.92 left top maxcols 1 samplen 1.8 title 'left at t = 2.3' left
plot for [k = 1:5] file(word(SHOWN, k)) using 't':(column('total') / E0[k]) \
         with lines ls style(word(SHOWN, k)) lw 2 title label(word(SHOWN, k)).back(word(SHOWN, k)), \
     file('wls_unilateral') using 't':(column('total') / E0[6]) with lines ls style('wls') dt 2 title 'WLS, wall lets go'
unset multiplot
