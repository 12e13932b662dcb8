# A bursting ring: energies by WLS2 then GIMP and by GIMP alone, particles at t = .02 s.
tall = 0.62
load plots.'/style.gp'
part(p) = dir.'/'.name.'.'.p.'.csv'
set multiplot
set tmargin at screen 0.88
set lmargin at screen 0.08
set rmargin at screen 0.37
set key at screen 0.03, screen 0.1 left top maxrows 1 samplen 1.5
set bmargin at screen 0.32
set xlabel 'time t [s]'
set ylabel 'energy [J]'
set xtics 0.02
set xrange [0:0.04]
set label 1 heading('(a) energies') at graph 0, graph 1.05
plot part('relay') using 't':'kinetic' with lines lc rgb '#c0392b' title 'K, WLS2 then GIMP', \
     part('gimp') using 't':'kinetic' with lines lc rgb '#c0392b' dt 2 title 'dashed: GIMP alone', \
     part('relay') using 't':'strain' with lines lc rgb '#2e6da4' title 'S', \
     part('gimp') using 't':'strain' with lines lc rgb '#2e6da4' dt 2 notitle, \
     part('relay') using 't':'external_work' with lines lc rgb '#444444' title 'W less what broke', \
     part('gimp') using 't':'external_work' with lines lc rgb '#444444' dt 2 notitle
unset key
set xlabel 'x [m], t = .02 s'
unset ylabel
set size ratio -1
set xrange [0:1.4]
set yrange [0:1.4]
set xtics 0.5
set ytics 0.5
set palette defined (0 '#dddddd', 0.02 '#9ecae1', 1 '#08519c')
set cbrange [0:1500]
unset colorbox
do for [k = 1:2] {
    set lmargin at screen 0.45 + 0.28*(k - 1)
    set rmargin at screen 0.69 + 0.28*(k - 1)
    set label 1 heading(k == 1 ? '(b) WLS2, then GIMP' : '(c) GIMP') at graph 0, graph 1.05
    plot part((k == 1 ? 'relay' : 'gimp').'.points') using 'x':'y':'von_mises' with points pt 7 ps 0.3 lc palette notitle
}
unset multiplot
