# Two disks, two bars, a block on an incline: energies, errors, velocities.
tall = 1.35
load plots.'/style.gp'
load dir.'/'.name.'.var'
small = fmt eq 'png' ? ',15' : ',10'
file(m) = dir.'/'.name.'.'.m.'.csv'
set multiplot
set lmargin at screen 0.09
set rmargin at screen 0.46
set tmargin at screen 0.95
set bmargin at screen 0.58
set xrange [0:3]
set xtics 1
set xlabel 't [s]'
set yrange [0:2.9]
set ylabel 'energy [J/m]'
set key at graph 0.99, graph 0.62 right samplen 1.4 font small
set label 1 heading('(a) two disks, GIMP') at graph 0, graph 1.05
plot file('gimp') using 't':'total' with lines lc rgb '#222222' lw 2 title 'total', \
     '' using 't':'kinetic' with lines lc rgb '#555555' dt 2 lw 2 title 'kinetic', \
     '' using 't':'strain' with lines lc rgb '#999999' lw 2 title 'strain', \
     file('gimp_none') using 't':'kinetic' with lines lc rgb '#b45309' dt 3 lw 2 title 'kinetic, one field'
set lmargin at screen 0.55
set rmargin at screen 0.84
set yrange [1.8:3.6]
set ylabel 'total energy [J/m]'
set key at screen 0.85, screen 0.95 left top maxcols 1 spacing 0.95 samplen 1.6 font small
set label 1 heading('(b) total, every method (cd)')
plot for [m in METHODS] file(m) using 't':'total' with lines ls style(m) lw 2 title label(m), \
     file('gimp_musl') using 't':'total' with lines ls style('gimp') dt 3 title 'GIMP, musl'
set lmargin at screen 0.09
set rmargin at screen 0.46
set tmargin at screen 0.44
set bmargin at screen 0.09
set logscale xy
set xrange [20:500]
set xtics (25, 50, 100, 200, 400)
set yrange [1e-3:1]
set format y '10^{%T}'
set ytics 1e-3, 10
set xlabel 'cells per metre'
set ylabel 'rms error / (v_0 L/c)'
unset key
set label 1 heading('(c) two bars')
plot for [m in METHODS] file('bars') using (strcol('method') eq m ? column('cells') : NaN):'error' \
     with linespoints ls style(m) lw 1.5 ps 0.7, 1.2/x**(2/3.) with lines dt 2 lc rgb '#888888'
set lmargin at screen 0.55
set rmargin at screen 0.84
unset logscale
set format y '%g'
set xrange [0:0.5]
set xtics 0.1
set yrange [-0.1:1.8]
set ytics 0.5
set xlabel 't [s]'
set ylabel 'velocity of the block [m/s]'
set key at screen 0.85, screen 0.44 left top maxcols 1 spacing 1.1 samplen 1.6 font small
set label 1 heading('(d) a block on 20 degrees, GIMP')
array HUE[4] = ['#334155', '#0e7490', '#b45309', '#a855f7'] # friction, no methods
N = exists('fine') ? '16' : '8'
g(mu) = 10*(sin(pi/9) - mu*cos(pi/9)) > 0 ? 10*(sin(pi/9) - mu*cos(pi/9)) : 0
plot for [k = 1:4] file('slide.'.word('0 0.1 0.3 0.4', k).'.'.N) using 't':(column('px')/500) \
     with lines lc rgb HUE[k] lw 2 title 'mu = '.word('0 0.1 0.3 0.4', k), \
     for [k = 1:4] g(real(word('0 0.1 0.3 0.4', k)))*x with lines dt 3 lc rgb '#222222' title (k == 1 ? 'rigid block' : '')
unset multiplot
